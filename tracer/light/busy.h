// busy.h — the pixels of a tile that get further samples, and those that are good enough.
//
// A pixel is good enough when its estimated error is, and that of the pixels near it: what crosses a pixel unseen by its own rays is seen by theirs. The more
// rays a pixel has the less it needs its neighbours. Only the tile's own samples are looked at, so a tile is the same in every region, shard and order.
#pragma once

#include <array>

#include "tracer/light/render.h"

namespace whittle {

inline constexpr int kTileSide = 16;

// By pixel of a tile, row by row. What the tile does not hold (at the picture's right and lower edge) has none.
template <class T>
using OfTile = std::array<T, static_cast<std::size_t>(kTileSide) * kTileSide>;
inline std::size_t place_in_tile(int x, int y) { return static_cast<std::size_t>(y) * kTileSide + static_cast<std::size_t>(x); }

// When is a pixel good enough: not with fewer than `least` samples, nor where the error of display luminance may be `noise` (0: never).
struct GoodEnough {
    double noise = 0;
    int least = 1;
};

// The pixels that are not good enough. It changes only as the tile's pixels do.
using PixelMarks = OfTile<bool>;
PixelMarks busy_pixels(const Film& film, TileRegion tile, GoodEnough enough);

// Of a pixel of the tile.
int most_samples(const Film& film, TileRegion tile);

// Where each pixel goes on from to reach `goal`: the samples `film` holds of it, or `goal` where it has them, is not busy, or is not there.
TileSamples begins_of(const Film& film, TileRegion tile, int goal, const PixelMarks& busy);

}  // namespace whittle
