// tile_bounds.h — bounds of the rays of a tile. Private to the engine.
//
// Along the main axis k of the tile's directions every ray is x_i(w) = o_i + w n_i, w >= 0 the way along k: intervals of o_i and n_i bound all rays, and
// a box cuts an interval of w out of them, as a slab test does for one ray.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace whittle {

// A few roundings, relative, with plenty of room: culling may keep too much, never too little.
inline constexpr double kRoomOfBounds = 0x1p-44;
inline double outward_down(double x) { return x - std::abs(x) * kRoomOfBounds; }
inline double outward_up(double x) { return x + std::abs(x) * kRoomOfBounds; }

// Of the coordinates of a tile's origins and directions, and of the square of its directions' lengths.
struct TileExtremes {
    std::array<double, 3> o_lo, o_hi, d_lo, d_hi;
    double least_square = 0;
};

// Bounds of a tile's rays. Built from extremes of origins and directions; every result errs outward.
struct TileBounds {
    bool coherent = false;  // else nothing below holds
    bool culls = true;      // false: meets() is always true
    std::size_t axis = 0;
    bool backward = false;
    std::array<double, 3> o_lo, o_hi;
    std::array<double, 3> n_lo, n_hi, inverse_lo, inverse_hi;  // of d_i / |d_axis|, i != axis; never 0
    double slowest = 0, fastest = 0;                           // of |d_axis|
    double inverse_fastest = 0;                                // no greater than 1 / fastest

    TileExtremes extremes;
    // Of rays that do not go together: every ray against every box. Set by the packets, with what it is called for.
    bool (*rays_meet)(const void* rays, const std::array<double, 3>& lo, const std::array<double, 3>& hi, double& near, double& far) = nullptr;
    const void* rays = nullptr;

    // False: no ray of the tile meets the box at t >= 0. [near, far] holds t wherever one does.
    bool meets(const std::array<double, 3>& lo, const std::array<double, 3>& hi, double& near, double& far) const;
};

TileBounds tile_bounds(const TileExtremes& extremes);

}  // namespace whittle
