// busy.cpp — see busy.h.
#include "tracer/light/busy.h"

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

// How many pixels around a noisy one are drawn on with it, by its samples. Least rays for the error on bench/light's reflection, refraction and soft shadow, of
// 2 up to 4, 6 or 10 samples and 1 up to 9, 16 or 20.
int reach_of(std::uint32_t samples) { return samples < 6 ? 2 : samples < 20 ? 1 : 0; }

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

// Marks the pixels of the tile at most `reach` from (x, y).
void mark_around(TileRegion tile, int x, int y, int reach, PixelMarks& marks) {
    for (int v = std::max(0, y - reach); v <= std::min(tile.height - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(tile.width - 1, x + reach); ++u) marks[place_in_tile(u, v)] = true;
}

}  // namespace

PixelMarks busy_pixels(const Film& film, TileRegion tile, GoodEnough enough) {
    PixelMarks busy{};
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const std::size_t pixel = film.index(tile.x + x, tile.y + y);
            const std::uint32_t samples = film.pixels[pixel].samples;
            if (enough.noise == 0 || samples < static_cast<std::uint32_t>(enough.least)) busy[place_in_tile(x, y)] = true;
            else if (is_noisy(film, pixel, enough.noise)) mark_around(tile, x, y, reach_of(samples), busy);
        }
    return busy;
}

int most_samples(const Film& film, TileRegion tile) {
    std::uint32_t most = 0;
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) most = std::max(most, film.pixels[film.index(x, y)].samples);
    return static_cast<int>(most);
}

TileSamples begins_of(const Film& film, TileRegion tile, int goal, const PixelMarks& busy) {
    TileSamples begins;
    begins.fill(goal);
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x)
            if (busy[place_in_tile(x, y)]) begins[place_in_tile(x, y)] = std::min(goal, static_cast<int>(film.pixels[film.index(tile.x + x, tile.y + y)].samples));
    return begins;
}

}  // namespace whittle
