// color_scheme.h — the colour schemes of OpenSCAD's preview, by their names.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// sRGB 0..1: what is behind the solid, what names no colour, and what a cutter that names none leaves.
struct ColorScheme {
    Vec3 background{0}, face{0}, cut{0};
    bool operator==(const ColorScheme&) const = default;
};

std::optional<ColorScheme> color_scheme_named(std::string_view name);
// "Cornfield", "Metallic", ...
std::vector<std::string_view> color_scheme_names();

}  // namespace whittle
