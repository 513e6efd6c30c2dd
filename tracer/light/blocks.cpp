// blocks.cpp — see blocks.h.
#include "tracer/light/blocks.h"

#include <algorithm>
#include <cmath>

#include "tracer/image/tone.h"

namespace whittle {

namespace {

// At most by how much display luminance (sRGB curve) grows with luminance: 12.92 in the dark, else 1.055 / 2.4 * x^(-7/12), here with -5/8 for want of a
// faster power. Nothing above 1.
constexpr double kSteepest = 12.92;
double steepness(double luminance) {
    if (luminance >= 1) return 0;
    const double root = std::sqrt(luminance), eighth = std::sqrt(std::sqrt(root));
    return std::min(kSteepest, 1.055 / 2.4 / (root * eighth));
}

// How many pixels around a noisy one are drawn on with it.
constexpr int kBeside = 2;

// May the standard error of the pixel's display luminance be `noise` or more?
bool is_noisy(const Film& film, std::size_t pixel, double noise) {
    const PixelSums& p = film.pixels[pixel];
    if (p.samples < 2) return false;
    // Both times n^2 (n - 1), to spare most pixels their quotients.
    const double n = p.samples, variance = n * p.luminance_squared - p.luminance * p.luminance, allowed = noise * noise * (n * n * (n - 1));
    if (variance * (kSteepest * kSteepest) < allowed) return false;
    const double slope = steepness(luminance(film.color(pixel)));
    return variance * (slope * slope) >= allowed;
}

// Marks the blocks that hold a pixel at most kBeside from (x, y) of the tile.
void mark_around(int x, int y, BlockMarks& marks) {
    const auto block = [](int at) { return std::clamp(at, 0, kTileSide - 1) / kBlockSide; };
    for (int v = block(y - kBeside); v <= block(y + kBeside); ++v)
        for (int u = block(x - kBeside); u <= block(x + kBeside); ++u) marks[static_cast<std::size_t>(v * kBlocksInRow + u)] = true;
}

void mark_noisy(const Film& film, TileRegion tile, TileRegion block, double noise, BlockMarks& marks) {
    for (int y = block.y; y < block.y + block.height; ++y)
        for (int x = block.x; x < block.x + block.width; ++x)
            if (is_noisy(film, film.index(x, y), noise)) mark_around(x - tile.x, y - tile.y, marks);
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

BlockMarks busy_blocks(const Film& film, TileRegion tile, GoodEnough enough) {
    const BlockSamples samples = samples_of(film, tile);
    BlockMarks busy{};
    for (std::size_t b = 0; b < samples.size(); ++b) {
        if (enough.noise == 0 || samples[b] < enough.least) busy[b] = true;
        else mark_noisy(film, tile, block_in(tile, static_cast<int>(b)), enough.noise, busy);
    }
    return busy;
}

BlockSamples begins_of(const Film& film, TileRegion tile, int goal, const BlockMarks& busy) {
    BlockSamples begins = samples_of(film, tile);
    for (std::size_t b = 0; b < begins.size(); ++b) {
        const TileRegion block = block_in(tile, static_cast<int>(b));
        if (!busy[b] || begins[b] > goal || block.width == 0 || block.height == 0) begins[b] = goal;
    }
    return begins;
}

}  // namespace whittle
