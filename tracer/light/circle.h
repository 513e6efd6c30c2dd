// circle.h — the polynomials of sine and cosine by which points are drawn on circles: one set for single samples and for lanes of them (lanes.h).
//
// Of an eighth of a turn at most, by Taylor: what they leave out is below 2^-56. Only products and sums, each rounded once, so that a lane's bits are a single
// sample's on every processor; library functions differ between vectors with and without fused operations.
#pragma once

#include <array>
#include <cmath>

#include "csg/base/vec.h"

namespace whittle {

// sin x = x (1 + z (S0 + z (S1 + ...))), cos x = 1 + z (C0 + z (C1 + ...)), z = x^2.
inline constexpr std::array<double, 8> kSineSeries{-1.0 / 6,           1.0 / 120,           -1.0 / 5040,          1.0 / 362880,
                                                   -1.0 / 39916800.0,  1.0 / 6227020800.0,  -1.0 / 1307674368e3,  1.0 / 355687428096e3};
inline constexpr std::array<double, 8> kCosineSeries{-1.0 / 2,           1.0 / 24,            -1.0 / 720,           1.0 / 40320,
                                                     -1.0 / 3628800.0,   1.0 / 479001600.0,   -1.0 / 87178291200.0, 1.0 / 20922789888e3};
inline constexpr double kTurn = 6.28318530717958647692;

// (cos, sin) of so many turns, each within 2^-51. Requires: |turns| < 2^50.
inline Vec2 on_circle(double turns) {
    const double quarters = std::floor(4 * turns + 0.5), x = (turns - 0.25 * quarters) * kTurn, z = x * x;
    double s = kSineSeries.back(), c = kCosineSeries.back();
    for (std::size_t i = kSineSeries.size() - 1; i-- > 0;) s = kSineSeries[i] + z * s, c = kCosineSeries[i] + z * c;
    s = x + x * (z * s);
    c = 1 + z * c;
    const double side = quarters - 4 * std::floor(0.25 * quarters);
    if (side == 0) return {c, s};
    if (side == 1) return {-s, c};
    return side == 2 ? Vec2(-c, -s) : Vec2(s, -c);
}

}  // namespace whittle
