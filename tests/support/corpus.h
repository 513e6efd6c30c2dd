// corpus.h — the scenes of tests/corpus and where Whittle answers otherwise than OpenSCAD on purpose.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace whittle::test {

inline std::filesystem::path corpus_folder() { return std::filesystem::path(WHITTLE_SOURCE_DIR) / "tests" / "corpus"; }

// Names without ".scad", sorted.
inline std::vector<std::string> corpus_scenes() {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(corpus_folder()))
        if (entry.path().extension() == ".scad") out.push_back(entry.path().stem().string());
    std::sort(out.begin(), out.end());
    return out;
}

// Names of the scenes whose "echo", "csg" or "file" differ (differences.txt). A line without a reason is passed over, so that its scene is compared.
inline std::set<std::string> corpus_differences(const std::string& what) {
    std::set<std::string> out;
    std::ifstream in(corpus_folder() / "differences.txt");
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string first, name, bar, reason;
        if (words >> first >> name >> bar >> reason && first == what && bar == "|") out.insert(name);
    }
    return out;
}

}  // namespace whittle::test
