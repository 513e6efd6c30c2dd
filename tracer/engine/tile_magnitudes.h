// tile_magnitudes.h — what bounds of a tile's cells are made with. Private to the engine.
#pragma once

#include <algorithm>
#include <cmath>

namespace whittle::tile_magnitudes {

inline constexpr double kRoom = 1 + 0x1p-40;        // over the roundings of the bounds themselves
inline constexpr double kCoarseRoom = 1 + 0x1p-20;  // over what limits round when they become floats

// The greatest and the least magnitude of the numbers of an interval.
inline double largest(double lo, double hi) { return std::max(std::abs(lo), std::abs(hi)); }
inline double smallest(double lo, double hi) { return lo > 0 ? lo : hi < 0 ? -hi : 0; }

}  // namespace whittle::tile_magnitudes
