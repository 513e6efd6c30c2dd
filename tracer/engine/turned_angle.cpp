// turned_angle.cpp — see turned_angle.h.
#include "tracer/engine/turned_angle.h"

#include <array>
#include <type_traits>

namespace whittle::turned {

Near half_pi(const Near&) { return Near::within(0x1.921fb54442d18p+0, 0x1.2p-54); }
Bounded half_pi(const Bounded&) { return Bounded::about(0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, 0x1p-107); }

namespace {

// Sine and cosine of what is at most pi/4 by their series.
template <std::size_t terms>
double series(double square, const std::array<double, terms>& k) {
    double sum = k[terms - 1];
    for (std::size_t i = terms - 1; i-- > 0;) sum = sum * square + k[i];
    return sum;
}

void small_angle(const Near& r, Near& cosine, Near& sine) {
    constexpr std::array<double, 8> kSine{-1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    constexpr std::array<double, 9> kCosine{-1.0 / 2, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000,
                                            -1.0 / 6402373705728000};
    const double x = r.high(), q = x * x;
    // The series end below 2^-62; its roundings are under two units.
    const double error = r.error() + (x == 0 ? 0 : 0x1p-51);
    cosine = Near::within(1 + q * series(q, kCosine), error);
    sine = Near::within(x + x * q * series(q, kSine), error);
}

void small_angle(const Bounded& r, Bounded& cosine, Bounded& sine) {
    constexpr int kTerms = 34;  // (pi/4)^35 / 35! < 2^-145
    const Bounded q = without_error(r) * without_error(r);
    Bounded even(1.0), odd = without_error(r);
    cosine = even;
    sine = odd;
    for (int n = 2; n < kTerms; n += 2) {
        even = -(even * q) / Bounded(static_cast<double>(n * (n - 1)));
        odd = -(odd * q) / Bounded(static_cast<double>(n * (n + 1)));
        cosine = cosine + even;
        sine = sine + odd;
    }
    const double rest = r.is_zero() ? 0 : r.error() + 0x1p-130;
    cosine = Bounded::about(cosine.high(), cosine.low(), cosine.error() + rest);
    sine = Bounded::about(sine.high(), sine.low(), sine.error() + rest);
}

template <class N>
bool turn_by(const N& angle, N& cosine, N& sine) {
    constexpr double kMostQuarters = 0x1p30;
    const double quarters = std::nearbyint(angle.high() / 0x1.921fb54442d18p+0);
    if (!(std::abs(quarters) < kMostQuarters)) return false;
    N rest = angle;
    if (quarters != 0) {
        // Exact but for the last places: double has the quarter turn in two parts.
        if constexpr (std::is_same_v<N, Near>) {
            const double first = std::fma(-quarters, 0x1.921fb54442d18p+0, angle.high()), second = std::fma(-quarters, 0x1.1a62633145c07p-54, first);
            rest = Near::within(second, angle.error() + 0x1p-52 * std::abs(second) + 0x1p-105 * std::abs(quarters));
        } else {
            rest = angle - N(quarters) * half_pi(angle);
        }
    }
    if (!(std::abs(rest.high()) < 0.8) || !(rest.error() < 0x1p-8)) return false;
    N c, s;
    small_angle(rest, c, s);
    switch (static_cast<long long>(quarters) & 3) {
        case 0: cosine = c, sine = s; break;
        case 1: cosine = -s, sine = c; break;
        case 2: cosine = -c, sine = -s; break;
        default: cosine = s, sine = -c; break;
    }
    return true;
}

}  // namespace

bool turn(const Near& angle, Near& cosine, Near& sine) { return turn_by(angle, cosine, sine); }
bool turn(const Bounded& angle, Bounded& cosine, Bounded& sine) { return turn_by(angle, cosine, sine); }

}  // namespace whittle::turned
