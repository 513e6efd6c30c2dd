// tile_bounds.cpp — see tile_bounds.h.
#include "tracer/engine/tile_bounds.h"

#include <algorithm>
#include <limits>

namespace whittle {

TileBounds tile_bounds(const TileExtremes& extremes) {
    const auto& [o_lo, o_hi, d_lo, d_hi, least_square] = extremes;
    (void)least_square;
    TileBounds b;
    b.extremes = extremes;
    b.o_lo = o_lo;
    b.o_hi = o_hi;
    double best = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double least = d_lo[i] > 0 ? d_lo[i] : d_hi[i] < 0 ? -d_hi[i] : 0;
        if (!(least > best)) continue;
        best = least;
        b.axis = i;
        b.backward = d_hi[i] < 0;
    }
    b.slowest = best;
    b.fastest = std::max(std::abs(d_lo[b.axis]), std::abs(d_hi[b.axis]));
    b.inverse_fastest = std::isnormal(1 / b.fastest) ? outward_down(1 / b.fastest) : 0;
    b.coherent = best >= 0x1p-500 && b.fastest < 2 * b.slowest;
    for (std::size_t i = 0; i < 3; ++i) {
        b.coherent = b.coherent && std::isfinite(o_lo[i]) && std::isfinite(o_hi[i]) && std::isfinite(d_lo[i]) && std::isfinite(d_hi[i]);
        if (i == b.axis) continue;
        b.n_lo[i] = outward_down(d_lo[i] < 0 ? d_lo[i] / b.slowest : d_lo[i] / b.fastest);
        b.n_hi[i] = outward_up(d_hi[i] > 0 ? d_hi[i] / b.slowest : d_hi[i] / b.fastest);
        if (b.n_lo[i] == 0) b.n_lo[i] = -std::numeric_limits<double>::min();
        if (b.n_hi[i] == 0) b.n_hi[i] = std::numeric_limits<double>::min();
        b.inverse_lo[i] = 1 / b.n_lo[i];
        b.inverse_hi[i] = 1 / b.n_hi[i];
    }
    return b;
}

bool TileBounds::meets(const std::array<double, 3>& lo, const std::array<double, 3>& hi, double& near, double& far) const {
    if (!culls) {
        near = 0, far = HUGE_VAL;
        return true;
    }
    if (rays_meet) return rays_meet(rays, lo, hi, near, far);
    const double ahead_lo = backward ? o_lo[axis] - hi[axis] : lo[axis] - o_hi[axis];
    const double ahead_hi = backward ? o_hi[axis] - lo[axis] : hi[axis] - o_lo[axis];
    double w0 = std::max(0.0, ahead_lo), w1 = ahead_hi;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == axis) continue;
        // The upper line o_hi + w n_hi must not stay below lo, nor the lower one above hi.
        const double rise = (lo[i] - o_hi[i]) * inverse_hi[i], fall = (hi[i] - o_lo[i]) * inverse_lo[i];
        if (n_hi[i] > 0) {
            w0 = rise > w0 ? rise : w0;
        } else {
            w1 = rise < w1 ? rise : w1;
        }
        if (n_lo[i] < 0) {
            w0 = fall > w0 ? fall : w0;
        } else {
            w1 = fall < w1 ? fall : w1;
        }
    }
    near = outward_down(outward_down(w0) / fastest);
    far = outward_up(outward_up(w1) / slowest);
    return outward_down(w0) <= outward_up(w1) && w1 >= 0;
}

}  // namespace whittle
