// directed.h — sums and products of doubles rounded down or up, without touching the processor's rounding mode.
//
// The rounded result is moved to its neighbour only where the exact error says it must be: exact operations stay exact, so the box of a cube moved
// by whole millimetres is the cube. Source: Knuth (two-sum), Dekker (two-product, here by fma).
#pragma once

#include <cmath>
#include <limits>

namespace whittle {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Below it the error of a product may be lost to underflow.
inline constexpr double kProductErrorExact = 0x1p-960;

inline double next_down(double x) { return std::nextafter(x, -kInfinity); }
inline double next_up(double x) { return std::nextafter(x, kInfinity); }

// a + b == sum + error exactly, unless the sum overflows (the error is then not a number).
inline double sum_error(double a, double b, double sum) {
    const double bb = sum - a;
    return (a - (sum - bb)) + (b - bb);
}
inline double add_down(double a, double b) {
    const double s = a + b;
    return sum_error(a, b, s) < 0 ? next_down(s) : s;
}
inline double add_up(double a, double b) {
    const double s = a + b;
    return sum_error(a, b, s) > 0 ? next_up(s) : s;
}
// Zero times infinity is zero: a coefficient of zero ignores an unbounded coordinate.
inline double multiply_down(double a, double b) {
    if (a == 0 || b == 0) return 0;
    const double p = a * b;
    return std::fabs(p) < kProductErrorExact || std::fma(a, b, -p) < 0 ? next_down(p) : p;
}
inline double multiply_up(double a, double b) { return -multiply_down(-a, b); }

}  // namespace whittle
