// curve_rule.h — into how many segments a curve is cut so that no chord is farther from it than the tolerance.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace whittle {

// Lengths in the frame the curve is drawn in; `scale` says how much longer they are, at most, in the root frame.
struct CurveRule {
    double largest = 0;             // tolerance in the root frame: 1e-3 of the model's diagonal, or what was asked
    double share_of_radius = 1e-3;  // 0 when the tolerance was asked for
    std::optional<double> angle_deg;
    double scale = 1;

    double chord(double radius) const {
        return share_of_radius > 0 ? std::min(largest / scale, share_of_radius * radius) : largest / scale;
    }
    // Segments of a whole turn, a multiple of 4 from 8 up, so that the extreme points on the axes are vertices. The chord of one turn by a is
    // radius*(1 - cos(a/2)) from its arc.
    int turn(double radius) const { return turn_within(radius, chord(radius)); }
    int turn_within(double radius, double error) const {
        const double share = std::min(error / radius, 1.0);
        double n = std::numbers::pi / (2 * std::asin(std::sqrt(share / 2)));  // 1 - cos(a) = 2 sin(a/2)^2 keeps all digits of a small share
        if (angle_deg) n = std::max(n, 360 / *angle_deg);
        constexpr double kMost = 1 << 16;
        constexpr double kRounding = kMost * 0x1p-50;  // of n: a count that rounding alone has lifted over a whole one is that one
        return std::max(8, 4 * static_cast<int>(std::ceil((std::min(n, kMost) - kRounding) / 4)));
    }
};

}  // namespace whittle
