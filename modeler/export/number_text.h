// number_text.h — numbers as the shortest text that reads back to the same double, in every locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "csg/base/vec.h"

namespace whittle {

inline std::string shortest(double x) {
    std::array<char, 32> buffer;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x + 0.0);  // no -0
    return {buffer.data(), end};
}
inline std::string pov_vector(const Vec3& v) { return "<" + shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z) + ">"; }
inline std::string pov_vector(const Vec2& v) { return "<" + shortest(v.x) + "," + shortest(v.y) + ">"; }

}  // namespace whittle
