// tile_cell.h — a cell as a tile of rays meets it: its half-spaces without those that cannot matter there, and one bound for the errors of all its
// crossings. Private to the engine.
//
// Running error bounds cost as much as the crossings themselves. Over a tile every magnitude in them has a largest value, so the bound is worked out once
// for all lanes (docs/numerics.md, bounds of a tile); it serves to see which lanes double cannot decide. The bound a hit reports is the ray's own, as ever.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/engine/program.h"

namespace whittle {

// Intervals that hold origins and directions of all rays of a tile in a frame; each coordinate was taken there within eo, ed.
struct TileLine {
    std::array<double, 3> o_lo{}, o_hi{}, d_lo{}, d_hi{}, eo{}, ed{};
};

// When a lane's crossings with a ball or cylinder are certain. Lanes that are neither met nor missed are undecided.
struct RoundLimits {
    double least_a = HUGE_VAL;       // of the square of the direction (across the axis); lanes below are undecided
    double missed = HUGE_VAL;        // the square of the distance less that of the radius, above: none; below its negative: within, where `still`
    double met = HUGE_VAL;           // the discriminant above: two
    double error = HUGE_VAL;         // of t, besides two units of t itself
};

RoundLimits round_limits(const TileLine& line, const std::array<double, 3>& centre, double r, bool ball, std::size_t axis);

struct TileSurface {
    enum class Kind : std::uint8_t {
        kEntering,  // an axis plane of the root frame that every ray enters the cell by; leaves by; or either
        kLeaving,
        kCrossing,
        kPlane,     // any other
        kBall,
        kCylinder,
        kQuadric    // cones, ellipsoids, tubes, general ones: each lane by its own bounds
    };
    Kind kind = Kind::kPlane;
    bool inverted = false;
    bool still = false;       // cylinders: no ray moves across the axis
    std::uint8_t axis = 0;
    FrameId frame = 0;
    std::uint64_t id = 0;     // class << 1
    double value = 0;         // axis planes of the root frame
    double least_slope = 0;   // kPlane: lanes below are undecided,
    double clear = HUGE_VAL;  // unless they start further than this from it: then none gets there
    const Support* support = nullptr;
    RoundLimits round;
    double error = 0;         // kQuadric: lanes whose t is worse are undecided
};

struct TileCell {
    std::uint32_t first = 0, count = 0;  // into the tile's surfaces
    bool known = false;                  // else no lane is decided
};

// What a tile needs to fold cells.
struct TileScope {
    TileLine root;
    double horizon = 0;  // |t| of every event that matters is at most this
};

// False: no ray of the tile meets the cell in [near, far], which is made tighter. Surfaces are appended; `error` grows to bound each crossing's.
bool fold_cell(const Program& program, const TileScope& scope, const Leaf& leaf, std::vector<TileSurface>& surfaces, TileCell& cell, double& error, double& near,
               double& far);

}  // namespace whittle
