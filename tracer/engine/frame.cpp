// frame.cpp — the rounded inverse of a placement, each entry to a unit of roundoff however ill-conditioned it is.
#include <cmath>

#include "tracer/engine/bounded.h"
#include "tracer/engine/dyadic.h"
#include "tracer/engine/support.h"

namespace whittle {

namespace {

Bounded value_of(const Bounded& x) { return x; }
// To more than 2^-90 of itself.
Bounded value_of(const exact::Dyadic& x) {
    const double high = x.approximate();
    if (!std::isfinite(high)) return high;
    return Bounded(high) + Bounded((x - exact::Dyadic(high)).approximate());
}
bool precise(const Bounded& x) { return x.is_zero() || x.error() < 0x1p-68 * std::abs(x.high()); }
bool precise(const exact::Dyadic&) { return true; }
int sign_of(const Bounded& x) { return x.sign(); }
int sign_of(const exact::Dyadic& x) { return x.sign(); }

template <class N>
bool invert(Frame& f) {
    f.determinant_sign = 1;
    const std::array<N, 3> origin{N(0.0), N(0.0), N(0.0)};
    for (int j = 0; j < 3; ++j) {
        Vec3 axis{0};
        axis[j] = 1;
        const FrameLine<N> line = line_in_frame<N>(f, origin, axis);
        if (!precise(line.w)) return false;
        for (int i = 0; i < 3; ++i) {
            if (!precise(line.d[static_cast<std::size_t>(i)])) return false;
            f.inverse[static_cast<std::size_t>(3 * i + j)] = (value_of(line.d[static_cast<std::size_t>(i)]) / value_of(line.w)).high();
        }
        if (j == 2) f.determinant_sign = sign_of(line.w) < 0 ? -1 : 1;
    }
    return true;
}

bool is_power_of_two(double x) {
    int exponent = 0;
    return std::abs(std::frexp(x, &exponent)) == 0.5;
}

// Axes permuted, mirrored and scaled by powers of two: products and sums are exact, so entering rounds the difference from the offset alone, if there is one.
void count_roundings(Frame& f) {
    for (int i = 0; i < 3; ++i) {
        int entries = 0;
        for (int j = 0; j < 3; ++j) {
            const double x = f.placement.linear(i, j);
            if (x != 0 && (!is_power_of_two(x) || ++entries > 1)) return;
        }
    }
    f.origin_units = f.placement.offset(0) == 0 && f.placement.offset(1) == 0 && f.placement.offset(2) == 0 ? 0 : 1.0625;
    f.direction_units = f.sum_units = 0;
}

}  // namespace

Frame make_frame(const Placement& placement) {
    Frame f;
    f.placement = placement;
    f.identity = placement.is_identity();
    if (f.identity) return f;
    if (!invert<Bounded>(f)) invert<exact::Dyadic>(f);
    count_roundings(f);
    return f;
}

}  // namespace whittle
