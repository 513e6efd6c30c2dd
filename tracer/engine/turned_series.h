// turned_series.h — a turned side along the window of a ray as a power series, with bounds of what it leaves out and of what is rounded. Private to the engine.
//
// Over a piece of at most 45 degrees the angle swings by less than half a radian to either side of the window's middle: fourteen terms of sine and cosine leave
// 2^-55 of them. Series are Taylor models with bounds in the norm of the sum of the coefficients' magnitudes, which products respect; the derivative's bound is
// carried beside the value's. What two sides of a piece have in common, the ray in the turning frame, is made once.
// Source: Makino and Berz, Taylor models and other validated functional inclusion methods (2003).
#pragma once

#include <array>
#include <cmath>

#include "tracer/engine/turned.h"
#include "tracer/engine/turned_function.h"

namespace whittle {

// sum of c[k] s^k for s in [-1, 1]. For the exact function's coefficients x[k], also those beyond: sum |x[k] - c[k]| <= error, sum k |x[k] - c[k]| <= slope_error.
class Series {
public:
    using Number = Near;
    static constexpr std::size_t kTerms = 16;

    std::array<double, kTerms> c{};
    std::size_t degree = 0;  // c beyond is 0
    double error = 0, slope_error = 0;

    Series() = default;
    Series(const Near& constant) : error(constant.error()) { c[0] = constant.high(); }  // NOLINT
    Series(const Near& constant, const Near& slope) : degree(1), error(constant.error() + slope.error()), slope_error(slope.error()) {
        c[0] = constant.high();
        c[1] = slope.high();
    }

    // Sums of the magnitudes |c[k]| and k |c[k]|, rounded a little.
    double size() const;
    double steepness() const;

    friend Series operator+(const Series& a, const Series& b);
    friend Series operator-(const Series& a, const Series& b);
    friend Series operator*(const Series& a, const Series& b);
    friend Series operator*(const Near& k, const Series& a);
};

// The window of a ray in a piece, its middle and half its length in t; and the ray there in homogeneous coordinates of the profile.
struct TurnedSeries {
    TurnedWindow window;
    double middle = 0, half = 0;
    Near rate;  // of turning, if it turns
    Series x, y, unit;
};

// False: out of proportion to double.
bool turned_series(const Twist& twist, const FrameRay& ray, TurnedSeries& out);

// The crossings of one side of the piece with the ray that the series are of, as roots.h promises. False: double cannot tell.
bool series_crossings(const Support& support, const Twist& twist, const TurnedSeries& series, const FrameRay& ray, bool leaving, Crossings& out);

}  // namespace whittle
