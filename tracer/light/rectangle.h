// rectangle.h — a rectangular lamp as places see it: its solid angle, and points on it that are drawn evenly over that.
//
// With the corners in the lamp's own frame, x0 or x1 by y0 or y1 at distance z, the angle of the spherical rectangle at a corner is that of the complex number
// (+-x y, z r), r the distance of the corner; so the solid angle is the argument of the product of four, and no inverse cosine is asked for. The same text
// is compiled for single places and for lanes of them (rectangle_kernel.inc), with products, sums, quotients and roots only: their bits agree.
// Source: Urena, Fajardo, King, An Area-Preserving Parametrization for Spherical Rectangles (2013).
#pragma once

#include <array>
#include <optional>

#include "tracer/light/circle.h"

namespace whittle {

// Unit vectors along the sides from corner `p`, and across.
struct RectangleSides {
    Vec3 p, x, y, z;
    double width, height;
};

// Nothing where the sides are oblique by more than rounding.
inline std::optional<RectangleSides> sides_of(Vec3 p, Vec3 u, Vec3 v) {
    constexpr double kSquare = 1e-12;
    RectangleSides s{p, {}, {}, {}, std::sqrt(glm::dot(u, u)), std::sqrt(glm::dot(v, v))};
    if (!(std::abs(glm::dot(u, v)) <= kSquare * s.width * s.height)) return std::nullopt;
    s.x = u / s.width;
    s.y = v / s.height;
    s.z = glm::cross(s.x, s.y);
    return s;
}

// Below this a hundred-thousandth of the solid angle is rounding: the angles it is made of are of size pi.
inline constexpr double kLeastSolidAngle = 1e-9;

// atan r = r (1 + z (A0 + z (A1 + ...))), z = r^2, for r up to tan(pi / 8): what is left out is below 2^-57.
inline constexpr double kTanEighth = 0.41421356237309503;
inline constexpr std::array<double, 20> kArcSeries{-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,  -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17, -1.0 / 19, 1.0 / 21,
                                                   -1.0 / 23, 1.0 / 25, -1.0 / 27, 1.0 / 29, -1.0 / 31, 1.0 / 33, -1.0 / 35, 1.0 / 37, -1.0 / 39, 1.0 / 41};

}  // namespace whittle
