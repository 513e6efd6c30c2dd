// blocks.cpp — see blocks.h.
#include "tracer/light/blocks.h"

#include <algorithm>
#include <cmath>

#include "tracer/image/tone.h"

namespace whittle {

namespace {

// At most by how much display luminance (sRGB curve) grows with luminance: 12.92 in the dark, else 1.055 / 2.4 * x^(-7/12), here with -5/8 for want of a
// faster power. Nothing above 1.
double steepness(double luminance) {
    if (luminance >= 1) return 0;
    const double root = std::sqrt(luminance), eighth = std::sqrt(std::sqrt(root));
    return std::min(12.92, 1.055 / 2.4 / (root * eighth));
}

// May the standard error of some pixel's display luminance be `noise` or more?
bool is_noisy(const Film& film, TileRegion block, double noise) {
    for (int y = block.y; y < block.y + block.height; ++y)
        for (int x = block.x; x < block.x + block.width; ++x) {
            const std::size_t i = film.index(x, y);
            const double slope = steepness(luminance(film.color(i)));
            if (film.variance(i) * slope * slope >= noise * noise) return true;
        }
    return false;
}

}  // namespace

TileRegion block_in(TileRegion tile, int block) {
    TileRegion r{tile.x + block % kBlocksInRow * kBlockSide, tile.y + block / kBlocksInRow * kBlockSide, kBlockSide, kBlockSide};
    r.width = std::clamp(tile.x + tile.width - r.x, 0, kBlockSide);
    r.height = std::clamp(tile.y + tile.height - r.y, 0, kBlockSide);
    return r;
}

BlockSamples samples_of(const Film& film, TileRegion tile) {
    BlockSamples samples{};
    for (std::size_t b = 0; b < samples.size(); ++b)
        if (const TileRegion block = block_in(tile, static_cast<int>(b)); block.width > 0 && block.height > 0)
            samples[b] = static_cast<int>(film.pixels[film.index(block.x, block.y)].samples);
    return samples;
}

BlockSamples begins_of(const Film& film, TileRegion tile, int goal, GoodEnough enough) {
    BlockSamples begins = samples_of(film, tile);
    std::array<bool, std::tuple_size_v<BlockSamples>> busy{}, beside{};
    for (std::size_t b = 0; b < begins.size(); ++b) {
        const TileRegion block = block_in(tile, static_cast<int>(b));
        if (block.width == 0 || block.height == 0) continue;
        busy[b] = enough.noise == 0 || begins[b] < enough.least || is_noisy(film, block, enough.noise);
        if (!busy[b]) continue;
        const int x = static_cast<int>(b) % kBlocksInRow, y = static_cast<int>(b) / kBlocksInRow;
        for (int v = std::max(0, y - 1); v <= std::min(kBlocksInRow - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(kBlocksInRow - 1, x + 1); ++u) beside[static_cast<std::size_t>(v * kBlocksInRow + u)] = true;
    }
    for (std::size_t b = 0; b < begins.size(); ++b) {
        const TileRegion block = block_in(tile, static_cast<int>(b));
        if (!beside[b] || begins[b] > goal || block.width == 0 || block.height == 0) begins[b] = goal;
    }
    return begins;
}

}  // namespace whittle
