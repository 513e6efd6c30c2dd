#include "csg/solid/placement.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/directed.h"

namespace whittle {
namespace {

// Adds a*b to sum; false where a rounding is not exact.
bool add_product_exactly(double& sum, double a, double b) {
    if (a == 0 || b == 0) return true;
    const double p = a * b;
    if (!std::isfinite(p) || std::fabs(p) < kProductErrorExact || std::fma(a, b, -p) != 0) return false;
    const double s = sum + p;
    if (!std::isfinite(s) || sum_error(sum, p, s) != 0) return false;
    sum = s;
    return true;
}

bool is_translation(const Placement& a) {
    return a.m[0] == 1 && a.m[1] == 0 && a.m[2] == 0 && a.m[4] == 0 && a.m[5] == 1 && a.m[6] == 0 && a.m[8] == 0 && a.m[9] == 0 && a.m[10] == 1;
}

double distance_up(Vec3 a, Vec3 b) {
    const double d = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
    return d + d * 0x1p-40;  // far above the dozen roundings behind d
}

}  // namespace

std::optional<Placement> exact_product(const Placement& outer, const Placement& inner) {
    if (outer.is_identity()) return inner;
    if (inner.is_identity()) return outer;
    Placement r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) {
            double sum = j == 3 ? outer.offset(i) : 0;
            for (int k = 0; k < 3; ++k)
                if (!add_product_exactly(sum, outer.linear(i, k), inner.m[static_cast<std::size_t>(4 * k + j)])) return std::nullopt;
            r.m[static_cast<std::size_t>(4 * i + j)] = sum;
        }
    return without_negative_zero(r);
}

Placement without_negative_zero(const Placement& placement) {
    Placement r = placement;
    for (double& x : r.m) x += 0.0;
    return r;
}

Bounds around(const Bounds& a, const Bounds& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

Bounds common(const Bounds& a, const Bounds& b) {
    if (a.empty() || b.empty()) return {};
    const Bounds c{glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)};
    return c.empty() ? Bounds{} : c;
}

Bounds placed_bounds(const Bounds& box, const Placement& placement) {
    if (box.empty()) return {};
    Bounds r;
    for (int i = 0; i < 3; ++i) {
        double lo = placement.offset(i), hi = lo;
        for (int k = 0; k < 3; ++k) {
            const double a = placement.linear(i, k);
            lo = add_down(lo, multiply_down(a, a > 0 ? box.lo[k] : box.hi[k]));
            hi = add_up(hi, multiply_up(a, a > 0 ? box.hi[k] : box.lo[k]));
        }
        r.lo[i] = lo;
        r.hi[i] = hi;
    }
    return r;
}

// A point whose places in the linear parts are y0 and y1 departs from the chord of its ends by at most 2 (1 - t) sin(t w / 2) |y0| +
// 2 t sin((1 - t) w / 2) |y1| on a turn of w: for half a turn, the most there is, 0.72 (|y0| + |y1|). Translations are linear in time and depart by nothing.
Bounds moved_bounds(const Bounds& box, const Motion& motion) {
    constexpr double kMostDeparture = 0.72;
    const Bounds ends = around(placed_bounds(box, motion.start), placed_bounds(box, motion.end));
    if (ends.empty() || (is_translation(motion.start) && is_translation(motion.end))) return ends;
    const auto linear = [](Placement p) {
        p.m[3] = p.m[7] = p.m[11] = 0;
        return p;
    };
    double from = 0, to = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{(corner & 1 ? box.hi : box.lo).x, (corner & 2 ? box.hi : box.lo).y, (corner & 4 ? box.hi : box.lo).z};
        from = std::max(from, distance_up(apply_to_point(linear(motion.start), p), Vec3(0)));
        to = std::max(to, distance_up(apply_to_point(linear(motion.end), p), Vec3(0)));
    }
    const double reach = kMostDeparture * add_up(from, to);
    if (!std::isfinite(reach)) return {Vec3(-kInfinity), Vec3(kInfinity)};
    Bounds r;
    for (int i = 0; i < 3; ++i) {
        r.lo[i] = add_down(ends.lo[i], -reach);
        r.hi[i] = add_up(ends.hi[i], reach);
    }
    return r;
}

}  // namespace whittle
