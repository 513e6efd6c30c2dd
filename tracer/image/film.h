// film.h — what a rendering leaves behind: sums of samples a pixel, and planes of what the pixels' centre rays met.
//
// A pixel keeps sums, never averages, in double and in the order of the sample numbers. So a rendering that stops after any sample, is
// resumed, or is put together from shards has the bits of one that never stopped. Planes (AOVs) belong to the ray through the pixel's centre:
// a depth or an id averaged over an edge belongs to nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// Pixels x0 <= x < x0 + width, y0 <= y < y0 + height; y counts down from the top.
struct TileRegion {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const TileRegion&) const = default;
};

// The planes by name (--aov). As a set: bits 1 << kind.
enum class Aov : std::uint8_t { kDepth, kPosition, kNormal, kSolid, kSurface, kAlbedo, kSpans, kThickness, kCertified, kCost, kVariance };
inline constexpr int kAovCount = 11;

using AovSet = std::uint32_t;
constexpr AovSet aov_bit(Aov kind) { return AovSet{1} << static_cast<unsigned>(kind); }

// "depth", "position", ... in the order of Aov.
std::string_view aov_name(Aov kind);
std::optional<Aov> aov_named(std::string_view name);
// Channels of a plane: three for position, normal and albedo, else one.
int aov_channels(Aov kind);

// Sums over a pixel's samples, each multiplied by its filter weight. `luminance_squared` estimates the error.
struct PixelSums {
    Vec3 color{0};  // linear Rec.709
    double coverage = 0;
    double weight = 0;
    double luminance = 0, luminance_squared = 0;  // unweighted
    std::uint32_t samples = 0;
    bool operator==(const PixelSums&) const = default;
};

// The whole picture. `planes` holds interleaved channels, one entry a kind of `aovs`, in the order of Aov; absent kinds are empty.
struct Film {
    int width = 0, height = 0;
    std::vector<PixelSums> pixels;  // row by row from the top
    AovSet aovs = 0;
    std::vector<float> planes[kAovCount];

    Film() = default;
    Film(int width_px, int height_px, AovSet kinds);

    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); }
    // Averages of one pixel; black where it has no sample.
    Vec3 color(std::size_t pixel) const;
    double coverage(std::size_t pixel) const;
    // Estimated variance of the pixel's mean luminance; 0 with fewer than two samples.
    double variance(std::size_t pixel) const {
        const PixelSums& p = pixels[pixel];
        if (p.samples < 2) return 0;
        const double n = p.samples, mean = p.luminance / n;
        return std::max(0.0, p.luminance_squared / n - mean * mean) / (n - 1);
    }
    // Pixels without a sample (an interrupted first pass, other shards).
    std::size_t missing_pixels() const;
};

// The same with no samples outside of the region. Requires: that lies in the picture.
Film cropped(const Film& film, TileRegion region);

// Puts the pixels of `part` that hold samples where `whole` holds none. Requires: equal sizes and planes.
void merge(Film& whole, const Film& part);

}  // namespace whittle
