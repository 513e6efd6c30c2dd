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

// A point on a screw of angle w leaves its chord c by at most c/2 * tan(w/4) <= c/2; as much again covers a change of scale on the way.
Bounds moved_bounds(const Bounds& box, const Motion& motion) {
    const Bounds ends = around(placed_bounds(box, motion.start), placed_bounds(box, motion.end));
    if (ends.empty() || (is_translation(motion.start) && is_translation(motion.end))) return ends;
    double reach = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{(corner & 1 ? box.hi : box.lo).x, (corner & 2 ? box.hi : box.lo).y, (corner & 4 ? box.hi : box.lo).z};
        reach = std::max(reach, distance_up(apply_to_point(motion.start, p), apply_to_point(motion.end, p)));
    }
    if (!std::isfinite(reach)) return {Vec3(-kInfinity), Vec3(kInfinity)};
    Bounds r;
    for (int i = 0; i < 3; ++i) {
        r.lo[i] = add_down(ends.lo[i], -reach);
        r.hi[i] = add_up(ends.hi[i], reach);
    }
    return r;
}

}  // namespace whittle
