#include "csg/base/degrees.h"

#include <cmath>
#include <limits>

namespace whittle {
namespace {

constexpr double kSqrtHalf = 0.70710678118654752440;
constexpr double kHalfSqrt3 = 0.86602540378443864676;
constexpr double kLargestAngleDeg = 360.0 * 4503599627370496.0;  // above it one ulp is a turn or more

// An unevaluated sum of two doubles, |low| <= ulp(high)/2. std::fma is correctly rounded on every target.
struct Pair {
    double high, low;
};

Pair sum_ordered(double a, double b) {  // requires |a| >= |b| or a == 0
    const double s = a + b;
    return {s, b - (s - a)};
}
Pair product(Pair a, Pair b) {
    const double p = a.high * b.high;
    return sum_ordered(p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high));
}
Pair plus(double a, Pair b) {  // requires |a| >= |b|
    const Pair s = sum_ordered(a, b.high);
    return sum_ordered(s.high, s.low + b.low);
}
// a/n for a small integer n.
Pair over(Pair a, double n) {
    const double q = a.high / n;
    return sum_ordered(q, (std::fma(-q, n, a.high) + a.low) / n);
}

// Taylor series about 0 in Horner form, 0 <= x <= pi/4: 1 - y/(k(k+1)) (1 - y/((k+2)(k+3)) (...)), y = x^2, first k given. The innermost levels
// weigh less than 2^-20 of the sum and are summed in double; the outer four keep 100 bits: the rounding of the result is wrong only where the
// true value lies within 2^-70 of a midpoint of two doubles.
Pair alternating_series(double x, int first) {
    const double p = x * x;
    const Pair square{p, std::fma(x, x, -p)};
    double tail = 1;
    for (int k = first + 18; k >= first + 8; k -= 2) tail = 1 - p / static_cast<double>(k * (k + 1)) * tail;
    Pair sum{tail, 0};
    for (int k = first + 6; k >= first; k -= 2) {
        const Pair term = over(product(square, sum), static_cast<double>(k * (k + 1)));
        sum = plus(1, {-term.high, -term.low});
    }
    return sum;
}

// The exact square; cheaper than std::fma where that is a call. Source: T. J. Dekker, A floating-point technique (1971).
Pair square_of(double x) {
    const double t = 134217729.0 * x, high = t - (t - x), low = x - high, p = x * x;
    return {p, ((high * high - p) + 2 * high * low) + low * low};
}

// A value known to within a relative 2^-58, rounded, if no double lies so near that the error could matter (Ziv's test); else NaN.
double rounded_if_safe(double high, double low) {
    const double error = high * 0x1p-58;
    const double r = high + low;
    return high + (low + error) == r && high + (low - error) == r ? r : std::numeric_limits<double>::quiet_NaN();
}

// First tries, for 0 <= x <= pi/4. The leading corrections -x^2/6 (of the sine, relative) and -x^2/2 + x^4/24 (of the cosine) carry 100 bits; the rest
// weighs less than 0.0032 (0.0004) and has a relative error below 8 ulp: together below 2^-58 of the result.
double quick_sine(double x) {
    const Pair y = square_of(x);
    constexpr double kSixth = 1.0 / 6, kSixthLow = 9.25185853854297e-18;  // their sum is 1/6 to 106 bits
    const double p = y.high;
    const double p2 = p * p;
    const double rest = p2 * ((1.0 / 120 + p * (-1.0 / 5040)) + p2 * ((1.0 / 362880 + p * (-1.0 / 39916800)) +
                        p2 * ((1.0 / 6227020800 + p * (-1.0 / 1307674368000)) + p2 * (1.0 / 355687428096000))));
    const Pair c = product(y, {-kSixth, -kSixthLow});
    const Pair factor = sum_ordered(1, c.high);                        // 1 - x^2/6 + rest
    const Pair s = product({x, 0}, sum_ordered(factor.high, factor.low + (c.low + rest)));
    return rounded_if_safe(s.high, s.low);
}
double quick_cosine(double x) {
    const Pair y = square_of(x);
    const double p = y.high;
    constexpr double k24th = 1.0 / 24, k24thLow = 2.3129646346357427e-18;
    const double p2 = p * p;
    const double rest = p * p2 * ((-1.0 / 720 + p * (1.0 / 40320)) + p2 * ((-1.0 / 3628800 + p * (1.0 / 479001600)) +
                        p2 * ((-1.0 / 87178291200 + p * (1.0 / 20922789888000)) + p2 * (-1.0 / 6402373705728000))));
    const Pair quartic = product(product(y, y), {k24th, k24thLow});
    const Pair first = sum_ordered(1, -y.high / 2);
    const Pair second = sum_ordered(first.high, quartic.high);
    return rounded_if_safe(second.high, second.low + (first.low - y.low / 2 + quartic.low + rest));
}

double sine_of_small(double x) {
    if (const double quick = quick_sine(x); quick == quick) return quick;
    const Pair s = product({x, 0}, alternating_series(x, 2));
    return s.high + s.low;
}
double cosine_of_small(double x) {
    if (const double quick = quick_cosine(x); quick == quick) return quick;
    const Pair s = alternating_series(x, 1);
    return s.high + s.low;
}

// Into [0, 360); NaN where no digit of the angle is left.
double reduced_turn(double x_deg) {
    if (x_deg >= 0 && x_deg < 360) return x_deg;
    if (!(x_deg < kLargestAngleDeg && x_deg > -kLargestAngleDeg)) return std::numeric_limits<double>::quiet_NaN();
    return x_deg - 360 * std::floor(x_deg / 360);
}

}  // namespace

double sind(double x_deg) {
    double x = reduced_turn(x_deg);
    if (std::isnan(x)) return x;
    const bool negative = x >= 180;
    if (negative) x -= 180;
    if (x > 90) x = 180 - x;
    double s;
    if (x < 45) {
        s = x == 30 ? 0.5 : sine_of_small(x * kRadiansPerDegree);
    } else if (x == 45) {
        s = kSqrtHalf;
    } else {
        s = x == 60 ? kHalfSqrt3 : cosine_of_small((90 - x) * kRadiansPerDegree);
    }
    return negative ? -s : s;
}

double cosd(double x_deg) {
    double x = reduced_turn(x_deg);
    if (std::isnan(x)) return x;
    bool negative = x >= 180;
    if (negative) x -= 180;
    if (x > 90) {
        x = 180 - x;
        negative = !negative;
    }
    double c;
    if (x > 45) {
        c = x == 60 ? 0.5 : sine_of_small((90 - x) * kRadiansPerDegree);
    } else if (x == 45) {
        c = kSqrtHalf;
    } else {
        c = x == 30 ? kHalfSqrt3 : cosine_of_small(x * kRadiansPerDegree);
    }
    return negative ? -c : c;
}

}  // namespace whittle
