// survey_colors.h — the names of colours that people agreed on in a survey, which later versions of OpenSCAD know as "xkcd:name". Internal to colors.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace whittle {

struct NamedColor {
    std::string_view name;  // in small letters, with its spaces
    std::uint32_t rgb;
};

// Sorted by name.
std::span<const NamedColor> survey_colors();

}  // namespace whittle
