#include "modeler/io/heights.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace whittle {
namespace {

constexpr double kWhite = 100;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

}  // namespace

Result<HeightMap> read_heights(const std::string& text) {
    std::vector<std::vector<double>> rows;
    std::size_t columns = 0, line_number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const char* p = text.data() + at;
        const char* last = text.data() + end;
        at = end + 1;
        ++line_number;
        std::vector<double> row;
        while (true) {
            while (p < last && is_blank(*p)) ++p;
            if (p == last || *p == '#') break;
            double z = 0;
            const auto [next, error] = std::from_chars(*p == '+' ? p + 1 : p, last, z);
            if (error != std::errc() || !std::isfinite(z) || (next < last && !is_blank(*next) && *next != '#'))
                return fail(Fault::kWorld, fmt::format("line {} holds something that is no number", line_number));
            row.push_back(z);
            p = next;
        }
        if (row.empty()) continue;
        columns = std::max(columns, row.size());
        rows.push_back(std::move(row));
    }
    HeightMap map;
    map.columns = static_cast<std::uint32_t>(columns);
    map.rows = static_cast<std::uint32_t>(rows.size());
    // One long row among many short ones must not become a table of the product.
    if (columns * rows.size() > text.size() * 2 + 16) return fail(Fault::kWorld, "rows differ too much in length");
    for (auto& row : rows) {
        row.resize(columns, 0);
        map.z.insert(map.z.end(), row.begin(), row.end());
    }
    return map;
}

HeightMap heights_of_picture(const Image& image, bool invert) {
    HeightMap map;
    map.columns = static_cast<std::uint32_t>(std::max(image.width, 0));
    map.rows = static_cast<std::uint32_t>(std::max(image.height, 0));
    const std::size_t channels = image.channels.size();
    const bool grey = channels < 3;
    for (std::uint32_t row = 0; row < map.rows; ++row)
        for (std::uint32_t column = 0; column < map.columns; ++column) {
            const std::size_t at = ((std::size_t{map.rows} - 1 - row) * map.columns + column) * channels;
            const auto value = [&](std::size_t c) { return std::round(static_cast<double>(image.floats[at + (grey ? 0 : c)]) * 255); };
            const double bright = 0.2126 * value(0) + 0.7152 * value(1) + 0.0722 * value(2);
            map.z.push_back(kWhite / 255 * (invert ? 1 - bright : bright));
        }
    return map;
}

}  // namespace whittle
