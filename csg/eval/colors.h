// colors.h — colours by name and by hexadecimal digits.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "csg/base/vec.h"

namespace whittle {

// sRGB and alpha, 0..1, of a CSS name in any case, "xkcd:" and a name of the survey's, "transparent", "#rgb", "#rgba", "#rrggbb" or "#rrggbbaa".
std::optional<Vec4> color_of_text(std::string_view text);

// A hint for a name that is none.
std::string nearest_color(std::string_view text);

}  // namespace whittle
