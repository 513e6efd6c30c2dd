// frame.cpp — the rounded inverse of a placement, each entry to a unit of roundoff however ill-conditioned it is.
#include <cmath>

#include "csg/solid/directed.h"
#include "tracer/engine/bounded.h"
#include "tracer/engine/dyadic.h"
#include "tracer/engine/support.h"

namespace whittle {

namespace {

// To more than 2^-90 of itself.
Bounded value_of(const exact::Dyadic& x) {
    const double high = x.approximate();
    if (!std::isfinite(high)) return high;
    return Bounded(high) + Bounded((x - exact::Dyadic(high)).approximate());
}

// The entry rounded, and what that lacks; the quotient's numbers may be off by 2^-90.
void keep_entry(Frame& f, std::size_t k, const Bounded& quotient) {
    f.inverse[k] = quotient.high();
    f.direction_room[k] = std::abs(quotient.low()) + quotient.error() + 0x1p-80 * std::abs(quotient.high());
}

void invert_exactly(Frame& f) {
    f.determinant_sign = 1;
    const exact::Dyadic zero(0.0);
    for (int j = 0; j < 3; ++j) {
        Vec3 axis{0};
        axis[j] = 1;
        const FrameLine<exact::Dyadic> line = line_in_frame<exact::Dyadic>(f, {zero, zero, zero}, axis);
        for (std::size_t i = 0; i < 3; ++i) keep_entry(f, 3 * i + static_cast<std::size_t>(j), value_of(line.d[i]) / value_of(line.w));
        if (j == 2) f.determinant_sign = line.w.sign() < 0 ? -1 : 1;
    }
}

// a b - c d to more than 2^-100 of itself, however much of it cancels. False: a product is so small that its error may be lost.
bool difference_of_products(double a, double b, double c, double d, Bounded& out) {
    const double p = a * b, q = -(c * d);
    for (const double product : {p, q})
        if (!(std::abs(product) < 0x1p960) || (product != 0 && std::abs(product) < kProductErrorExact)) return false;
    if ((p == 0 && a != 0 && b != 0) || (q == 0 && c != 0 && d != 0)) return false;
    // An expansion that grows by the four numbers (Shewchuk, Adaptive precision floating-point arithmetic, 1997, section 2.3).
    std::array<double, 4> sum{};
    std::size_t count = 0;
    for (double x : {std::fma(a, b, -p), std::fma(-c, d, -q), p, q}) {
        for (std::size_t k = 0; k < count; ++k) {
            const double s = sum[k] + x;
            sum[k] = sum_error(sum[k], x, s);
            x = s;
        }
        sum[count++] = x;
    }
    double high = 0, low = 0;
    for (std::size_t k = 4; k-- > 0;) {
        const double s = high + sum[k];
        low += sum_error(high, sum[k], s);
        high = s;
    }
    out = Bounded(high) + Bounded(low);
    return true;
}

// The same in double-double. False: it may not be precise to 2^-64.
bool invert_quickly(Frame& f) {
    std::array<std::array<Bounded, 3>, 3> minors;
    const auto at = [&](std::size_t r, std::size_t c) { return f.placement.m[4 * (r % 3) + c % 3]; };
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            if (!difference_of_products(at(r + 1, c + 1), at(r + 2, c + 2), at(r + 1, c + 2), at(r + 2, c + 1), minors[r][c])) return false;
    const Bounded determinant = Bounded(at(0, 0)) * minors[0][0] + Bounded(at(0, 1)) * minors[0][1] + Bounded(at(0, 2)) * minors[0][2];
    if (!(determinant.error() < 0x1p-68 * std::abs(determinant.high()))) return false;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) keep_entry(f, 3 * i + j, minors[j][i] / determinant);
    f.determinant_sign = determinant.high() < 0 ? -1 : 1;
    return true;
}

bool is_power_of_two(double x) {
    int exponent = 0;
    return std::abs(std::frexp(x, &exponent)) == 0.5;
}

// Axes permuted, mirrored and scaled by powers of two: the inverse is exact.
bool is_exact(const Placement& a) {
    for (int i = 0; i < 3; ++i) {
        int entries = 0;
        for (int j = 0; j < 3; ++j)
            if (const double x = a.linear(i, j); x != 0 && (!is_power_of_two(x) || ++entries > 1)) return false;
    }
    return true;
}

// What of the frame's coordinates no difference from `entry` makes: those of `entry` itself.
void keep_lift(Frame& f, SectionPlane& plane) {
    const std::array<exact::Dyadic, 3> at{exact::Dyadic(plane.entry[0]), exact::Dyadic(plane.entry[1]), exact::Dyadic(plane.entry[2])};
    const FrameLine<exact::Dyadic> line = line_in_frame<exact::Dyadic>(f, at, Vec3(0));
    for (std::size_t i = 0; i < 3; ++i) {
        const Bounded lift = value_of(line.o[i]) / value_of(line.w);
        plane.lift[i] = lift.high();
        plane.lift_room[i] = 1.0625 * (std::abs(lift.low()) + lift.error() + 0x1p-80 * std::abs(lift.high()));
    }
}

// What each entry of the inverse lacks is known; products round but with 0 and powers of two, differences but from an offset of 0, sums where there are two.
void count_roundings(Frame& f) {
    constexpr double kUnit = 1.0625 * 0x1p-53;
    const bool exact = !f.section && is_exact(f.placement);
    for (std::size_t i = 0; i < 3; ++i) {
        int entries = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            const double entry = f.inverse[3 * i + j], size = kUnit * std::abs(entry);
            double& room = f.direction_room[3 * i + j];
            entries += entry != 0;
            room = (exact ? 0 : 1.0625 * room) + (entry == 0 || is_power_of_two(entry) ? 0 : size);
            f.origin_room[3 * i + j] = room + (f.entry(static_cast<int>(j)) == 0 ? 0 : size);
        }
        f.sum_room[i] = entries > 1 || f.section ? kUnit : 0;
    }
}

}  // namespace

Frame make_frame(const Placement& placement) {
    Frame f;
    f.placement = placement;
    f.identity = placement.is_identity();
    if (f.identity) return f;
    if (!invert_quickly(f)) invert_exactly(f);
    count_roundings(f);
    return f;
}

Frame make_frame(const Placement& placement, const Frame& outer) {
    Frame f;
    f.placement = placement;
    f.identity = false;
    auto plane = std::make_shared<SectionPlane>();
    plane->frame = outer;
    for (int j = 0; j < 3; ++j) plane->entry[static_cast<std::size_t>(j)] = outer.entry(j);
    f.section = plane;
    invert_exactly(f);
    keep_lift(f, *plane);
    count_roundings(f);
    return f;
}

Frame moved_frame(const Frame& frame, const Placement& motion) {
    if (!frame.section) return make_frame(motion * frame.placement);
    return make_frame(frame.placement, moved_frame(frame.section->frame, motion));
}

bool stand_alike(const Frame& a, const Frame& b) {
    if (!(a.placement == b.placement) || !a.section != !b.section) return false;
    return a.section == b.section || stand_alike(a.section->frame, b.section->frame);
}

Vec3 point_in_frame(const Frame& frame, const Vec3& point) {
    if (frame.identity) return point;
    const auto& k = frame.inverse;
    const Vec3 p = point - Vec3(frame.entry(0), frame.entry(1), frame.entry(2));
    return {k[0] * p.x + k[1] * p.y + k[2] * p.z + frame.lift(0), k[3] * p.x + k[4] * p.y + k[5] * p.z + frame.lift(1),
            k[6] * p.x + k[7] * p.y + k[8] * p.z + frame.lift(2)};
}

Vec3 gradient_in_root(const Frame& frame, const Vec3& n) {
    if (frame.identity) return n;
    const auto& k = frame.inverse;
    return {k[0] * n.x + k[3] * n.y + k[6] * n.z, k[1] * n.x + k[4] * n.y + k[7] * n.z, k[2] * n.x + k[5] * n.y + k[8] * n.z};
}

}  // namespace whittle
