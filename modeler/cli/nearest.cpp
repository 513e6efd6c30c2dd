// nearest.cpp — edit distance by one row. Source: Wagner and Fischer, The String-to-String Correction Problem (1974).
#include "modeler/cli/nearest.h"

#include <algorithm>
#include <numeric>

namespace whittle {

namespace {

std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t kept = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({kept, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known) {
    std::optional<std::string> best;
    std::size_t least = word.size() / 3 + 1;
    for (const auto& candidate : known)
        if (const std::size_t d = edits(word, candidate); d < least) {
            least = d;
            best = candidate;
        }
    return best;
}

}  // namespace whittle
