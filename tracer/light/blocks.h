// blocks.h — the 4 x 4 blocks of a tile: what fills the lanes of a packet, and what gets further samples or is good enough.
//
// A block is good enough when the estimated error of all its pixels is, and of those two pixels beside it: what crosses a corner of a block unseen by its
// own rays is seen by theirs. Only the tile's own samples are looked at, so a tile is the same in every region, shard and order.
#pragma once

#include <array>

#include "tracer/light/render.h"

namespace whittle {

inline constexpr int kTileSide = 16, kBlockSide = 4, kBlocksInRow = kTileSide / kBlockSide;
// By block, row by row: samples. A block that the tile does not hold (at the picture's right and lower edge) has none.
using BlockSamples = std::array<int, kBlocksInRow * kBlocksInRow>;

// The pixels of a block, of which some or all may lie outside the tile.
TileRegion block_in(TileRegion tile, int block);

// When is a block good enough: not with fewer than `least` samples, nor where the error of display luminance may be `noise` (0: never).
struct GoodEnough {
    double noise = 0;
    int least = 1;
};

// The samples that `film` holds of each block.
BlockSamples samples_of(const Film& film, TileRegion tile);

using BlockMarks = std::array<bool, std::tuple_size_v<BlockSamples>>;

// The blocks that are not good enough. It changes only as the tile's pixels do.
BlockMarks busy_blocks(const Film& film, TileRegion tile, GoodEnough enough);

// Where each block goes on from to reach `goal`: the samples `film` holds of it, or `goal` where it has them, is not busy, or is not there.
BlockSamples begins_of(const Film& film, TileRegion tile, int goal, const BlockMarks& busy);

}  // namespace whittle
