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

inline constexpr double kFineUnit = 0x1p-53, kCoarseUnit = 0x1p-24;  // what an operation rounds by, in double and in float

// When a lane's crossings with a ball or cylinder are certain. Lanes that are neither met nor missed are undecided.
struct RoundLimits {
    double least_a = HUGE_VAL;       // of the square of the direction (across the axis); lanes below are undecided
    double missed = HUGE_VAL;        // the square of the distance less that of the radius, above: none; below its negative: within, where `still`
    double met = HUGE_VAL;           // the discriminant above: two
    double error = HUGE_VAL;         // of t, besides two units of t itself
};

// A direction with a smaller coordinate is not met in float, nor is one whose square is outside of these.
inline constexpr double kLeastCoarseSlope = 0x1p-40, kLeastCoarseSquare = 0x1p-20, kMostCoarseSquare = 0x1p20;
// Nor are rays whose way to the farthest corner of the solid is shorter or longer: products of four lengths are to be numbers of float.
inline constexpr double kLeastCoarseReach = 0x1p-20, kMostCoarseReach = 0x1p20;

RoundLimits round_limits(const TileLine& line, const std::array<double, 3>& centre, double r, bool ball, std::size_t axis);

// Of the directions of a tile, in the coordinates of a ball or cylinder: what all limits of such have in common. `unit`: of the crossings' arithmetic.
struct RoundDirections {
    double d = 0, ed = 0;             // sum of the coordinates; their error
    double a = 0, least_a = 0, root_a = 0, ea = 0;
    double unit = kFineUnit;
    bool still = false;
};
RoundDirections round_directions(const TileLine& line, bool ball, std::size_t axis, double unit);
// `o`, `eo`: sum of the coordinates of the origin from the centre, and their error. In float (`horizon` finite) it is weighed which lanes graze by too little,
// against how far events must be apart then, as a share of the horizon.
RoundLimits round_limits(const RoundDirections& way, double o, double eo, double r, double horizon);

struct TileSurface {
    enum class Kind : std::uint8_t {
        kEntering,  // an axis plane of the root frame that every ray enters the cell by; leaves by; or either
        kLeaving,
        kCrossing,
        kSlab,      // the first of two kCrossing ones across an axis, the cell between them: below the next surface, above this one
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
    std::uint32_t coarse = 0; // of TileTree::coarse
    double value = 0;         // axis planes of the root frame; for packets in float, from the eye
    double least_slope = 0;   // kPlane: lanes below are undecided,
    double clear = HUGE_VAL;  // unless they start further than this from it: then none gets there
    const Support* support = nullptr;
    RoundLimits round;
    double error = 0;         // kQuadric: lanes whose t is worse are undecided
};

struct TileCell {
    std::uint32_t first = 0, count = 0;  // into the tile's surfaces
    bool known = false;                  // else no lane is decided
    bool folded = true;                  // else it is when a packet first meets it
    bool missed = false;                 // no ray of the tile meets it
};

// What a tile needs to fold cells.
struct TileScope {
    TileLine root;
    double horizon = 0;   // |t| of every event that matters is at most this
    bool coarse = false;  // for packets in float: cells get their numbers
    double unit() const { return coarse ? kCoarseUnit : kFineUnit; }
    // Of the t of any axis plane of the root frame; in float the value and the direction are rounded besides.
    double axis_plane_error() const { return (coarse ? 6 : 4) * unit() * horizon; }
};

struct CoarseSurface;

// False: no ray of the tile meets the cell in [near, far], which is made tighter. Surfaces are appended, for a coarse scope with their numbers for float; `error` grows to bound each crossing's.
bool fold_cell(const Program& program, const TileScope& scope, const Leaf& leaf, std::vector<TileSurface>& surfaces, std::vector<CoarseSurface>& coarse,
               TileCell& cell, double& error, double& near, double& far);

}  // namespace whittle
