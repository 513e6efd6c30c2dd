// source.h — where in the author's text a thing stands.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace whittle {

// A place in a source file. `file` indexes SourceTable; line and column count from 1; line 0 means "nowhere in a text".
struct SourcePlace {
    std::uint32_t file = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    bool operator==(const SourcePlace&) const = default;
};

// One file as it was read. `name` is how messages call it (relative to the main file's folder).
struct SourceFile {
    std::string path;
    std::string name;
    std::string text;
};

// All files of one run, main file first.
struct SourceTable {
    std::vector<SourceFile> files;
};

}  // namespace whittle
