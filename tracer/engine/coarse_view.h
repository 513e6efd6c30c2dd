// coarse_view.h — surfaces as packets in float take them: everything that cancels is taken in double, once for a tile. Private to the engine.
//
// The tile's rays have one origin, the eye. A ray is the tile's middle direction m and what it is off that, e. A plane's slope is n.m + n.e, its value at the
// eye a constant. A ball or cylinder is met from the place `at` along m nearest to its centre: there the ray is at `near` + `at` e, a few radii from the
// centre at most, so that float's 24 bits are bits of the surface, not of the way there.
#pragma once

#include <array>

#include "tracer/engine/tile_cell.h"

namespace whittle {

// A ball's or cylinder's; by its own coordinates: three, or the two across its axis.
struct CoarseRound {
    std::array<float, 3> near{};
    float at = 0, square = 0;  // of the radius
};

struct CoarseSurface {
    std::array<float, 3> normal{};
    float slope = 0, value = 0;  // n.m, and the form at the eye
    CoarseRound round;
    std::array<float, 9> rows{};  // that take directions to a round surface's coordinates; not for the root frame
};

// What the balls, or the cylinders along an axis, of one frame have in common for a tile.
struct CoarseView {
    std::size_t count = 3;
    std::array<std::size_t, 3> index{};  // of each coordinate in the frame
    std::array<double, 3> eye{}, middle{};
    double inverse_square = 0;             // of the middle direction; 0 where it is 0
    double off = 0, size = 0;              // sums over the coordinates: of how far directions are off the middle, of the greatest directions
    double eo = 0, roundings = 0;
    RoundDirections way;
};

// `root` and `line`: the tile in the root frame and in the surface's own, which `rows` (null: the root frame) take directions to.
CoarseView coarse_view(const TileLine& root, const TileLine& line, bool ball, std::size_t axis, const double* rows);
// A ball or cylinder for float, and when its crossings are certain.
RoundLimits coarse_round(const CoarseView& view, const std::array<double, 3>& centre, double r, double horizon, CoarseRound& round);

}  // namespace whittle
