// round_limits.cpp — when the rays of a tile surely meet, or miss, a ball or cylinder, and how far off their crossings are at most.
#include <algorithm>
#include <cmath>

#include "tracer/engine/tile_cell.h"
#include "tracer/engine/tile_magnitudes.h"

namespace whittle {

using namespace tile_magnitudes;

namespace {

// Lanes that graze by less than this cosine are undecided (tile_cell.cpp).
constexpr double kLeastCosine = 0x1p-8;
constexpr double kLeastAcross = 0x1p-8;  // of the square of the direction across an axis

}  // namespace

// The names here are those of round_crossing (crossing_kernel.inc), each the largest it takes on a lane that is met: there p^2 <= r^2 but for rounding.
RoundDirections round_directions(const TileLine& line, bool ball, std::size_t axis, double unit) {
    RoundDirections w;
    double a_lo = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!ball && i == axis) continue;
        const double most = largest(line.d_lo[i], line.d_hi[i]), least = smallest(line.d_lo[i], line.d_hi[i]);
        w.d += most;
        a_lo += least * least;
        w.a += most * most;
        w.ed = std::max(w.ed, line.ed[i]);
    }
    w.still = w.a == 0 && w.ed == 0;
    // The square of the shortest direction, as the lanes round it, is no less.
    w.least_a = w.still ? 1 : std::max(a_lo / (unit == kFineUnit ? kRoom : kCoarseRoom * kCoarseRoom), kLeastAcross * w.a);
    w.root_a = std::sqrt(w.least_a);
    w.ea = (2 * w.d * w.ed + 3 * w.ed * w.ed + 4 * unit * w.a) * kRoom;
    w.unit = unit;
    return w;
}

RoundLimits round_limits(const RoundDirections& way, double o, double eo, double r, double horizon) {
    const auto& [d, ed, a, least_a, root_a, ea, unit, still] = way;
    RoundLimits limits;
    o *= kRoom;
    const double ep = (eo + o / root_a * ed) * kRoom + 10 * unit * o;  // |o| + |step| <= (1 + sqrt 3) |o|, three units each
    if (!(least_a > 8 * ea) || !(ep <= 0.0625 * r)) return limits;
    const double p = 2 * r;  // sum of |p_i|: sqrt 3 times 1.125 r
    const double eb = (d * ep + p * ed + 3 * ep * ed + 4 * unit * d * p) * kRoom;
    const double ec = (2 * p * ep + 3 * ep * ep + 16 * unit * r * r) * kRoom;
    const double off = (8 * unit * o * d + d * eo + o * ed + o / root_a * ea) * kRoom;  // a times the distance from the closest approach
    const double b = off + eb, rr = 1.27 * r * r;
    const double ec_far = (4 * p * ep + 3 * ep * ep + 32 * unit * r * r) * kRoom;  // as far out as p = 2 r; beyond, c leaves no doubt
    limits.missed = (ec_far + off * off / least_a) * kRoom;
    limits.least_a = still ? HUGE_VAL : least_a;
    if (still) return limits;
    const double edisc = (2 * b * eb + eb * eb + a * ec + rr * ea + ea * ec + 4 * unit * (b * b + a * rr)) * kRoom;
    const double cube = horizon < HUGE_VAL ? 40 * edisc / (least_a * root_a * r * horizon) : 0;
    const double cosine = cube > kLeastCosine * kLeastCosine * kLeastCosine ? std::cbrt(cube) : kLeastCosine;
    limits.met = std::max(cosine * cosine * least_a * r * r, 4 * edisc);
    const double half = 1.2 * r / root_a + b / least_a;
    limits.error = 1.1 * ((eb + 0.625 * edisc / std::sqrt(limits.met)) / least_a + half * (ea / least_a + 8 * unit));
    if (unit != kFineUnit) limits.missed *= kCoarseRoom, limits.met *= kCoarseRoom, limits.least_a *= kCoarseRoom;
    return limits;
}

RoundLimits round_limits(const TileLine& line, const std::array<double, 3>& centre, double r, bool ball, std::size_t axis) {
    double o = 0, eo = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!ball && i == axis) continue;
        o += largest(line.o_lo[i] - centre[i], line.o_hi[i] - centre[i]);
        eo = std::max(eo, line.eo[i]);
    }
    return round_limits(round_directions(line, ball, axis, kFineUnit), o, eo, r, HUGE_VAL);
}

}  // namespace whittle
