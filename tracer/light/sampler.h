// sampler.h — one design of random numbers for pixel, lens, time, light, lobe and wavelength.
//
// By default each pair of dimensions is the two-dimensional Sobol sequence, its order shuffled and its digits scrambled by hashes of (seed, pixel, pair):
// any first n samples of a pixel are stratified in every pair, pairs and pixels are independent, and sample i can be asked for without those
// before it. Source: B. Burley, Practical Hash-based Owen Scrambling (JCGT 2020); A. Owen, Randomly permuted (t,m,s)-nets (1995).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "csg/base/vec.h"

namespace whittle {

// Where the numbers of a pixel's samples lie. kStratified: each pair in a cell of its own of a grid of as many cells as there are samples (or a few more), in an
// order of its own; smooth integrals err by n^-1, edges by n^-3/4, once all samples are drawn. kIndependent: chance, n^-1/2. kSobol: as said above, n^-3/2
// and n^-3/4, whatever part of the samples is drawn. The last two are there to be compared with. Source: M. Pharr, W. Jakob, G. Humphreys, Physically Based Rendering.
enum class SamplerKind : std::uint8_t { kSobol, kStratified, kIndependent };
// "sobol", "stratified", "independent".
std::string_view sampler_name(SamplerKind kind);
std::optional<SamplerKind> sampler_named(std::string_view name);

// Which numbers, and of how many samples each pixel has (at least 1): grids are laid out for them.
struct Sequence {
    SamplerKind kind = SamplerKind::kSobol;
    std::uint32_t count = 1;
};

// What a pair of numbers is for. Those from kLight on are drawn at every vertex of a path.
enum class Draw : std::uint32_t { kPixel = 0, kLens = 1, kTimeAndWavelength = 2, kLight = 3, kLobe = 4, kChoice = 5, kSky = 6 };
inline constexpr std::uint32_t kPairsAVertex = 4;

// Which pair of numbers: `bounce` counts the vertices of the path; `part` of `parts` stratifies within the sample (light samples).
struct PairOf {
    Draw what;
    std::uint32_t bounce = 0, part = 0, parts = 1;
    std::uint32_t which() const { return static_cast<std::uint32_t>(what) + kPairsAVertex * bounce; }
};

namespace sobol {

inline std::uint32_t reversed(std::uint32_t x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffU) << 8) | ((x & 0xff00ff00U) >> 8);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x & 0xf0f0f0f0U) >> 4);
    x = ((x & 0x33333333U) << 2) | ((x & 0xccccccccU) >> 2);
    return ((x & 0x55555555U) << 1) | ((x & 0xaaaaaaaaU) >> 1);
}

// Owen scrambling of the digits of a bit-reversed number (Laine and Karras's permutation, Vegdahl's constants).
inline std::uint32_t permuted(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}
inline std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) { return reversed(permuted(reversed(x), seed)); }

// The second coordinate of sample `i`: digit j is the sum of the bits k of i with j a subset of k (Pascal's triangle modulo 2, by Lucas).
inline std::uint32_t second(std::uint32_t i) {
    std::uint32_t x = reversed(i);
    x ^= x << 16;
    x ^= (x & 0x00ff00ffU) << 8;
    x ^= (x & 0x0f0f0f0fU) << 4;
    x ^= (x & 0x33333333U) << 2;
    x ^= (x & 0x55555555U) << 1;
    return x;
}

inline std::uint32_t hash(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}
inline std::uint32_t hash(std::uint32_t a, std::uint32_t b) { return hash(a ^ (hash(b) + 0x9e3779b9U)); }

inline double unit(std::uint32_t x) { return x * 0x1p-32; }

}  // namespace sobol

// The numbers of one sample of one pixel.
class Sampler {
public:
    Sampler() = default;
    Sampler(std::uint64_t seed, int x, int y, std::uint32_t index, Sequence sequence = {})
        : Sampler(sobol::hash(sobol::hash(folded(seed), static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y)), index, sequence) {}
    Sampler(std::uint32_t key, std::uint32_t index, Sequence sequence = {}) : key_(key), index_(index), sequence_(sequence) {}

    // Two numbers in [0, 1).
    Vec2 pair(const PairOf& draw) const {
        if (sequence_.kind != SamplerKind::kSobol) {
            const std::array<std::uint32_t, 2> other = unlike_sobol(draw);
            return {sobol::unit(other[0]), sobol::unit(other[1])};
        }
        const std::uint32_t key = sobol::hash(key_, draw.which());
        const std::uint32_t i = sobol::scrambled(index_ * draw.parts + draw.part, key);
        const std::uint32_t x = sobol::scrambled(sobol::reversed(i), sobol::hash(key, 1));
        const std::uint32_t y = sobol::scrambled(sobol::second(i), sobol::hash(key, 2));
        return {sobol::unit(x), sobol::unit(y)};
    }
    Vec2 pair(Draw what, std::uint32_t bounce = 0, std::uint32_t part = 0, std::uint32_t parts = 1) const { return pair(PairOf{what, bounce, part, parts}); }

    // What the pixel's numbers depend on beside `index`.
    std::uint32_t key() const { return key_; }
    std::uint32_t index() const { return index_; }
    Sequence sequence() const { return sequence_; }
    // 2^32 times pair(). Requires: the sequence is not Sobol's.
    std::array<std::uint32_t, 2> unlike_sobol(const PairOf& draw) const;
    static std::uint32_t folded(std::uint64_t seed) { return sobol::hash(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)); }

private:
    std::uint32_t key_ = 0;
    std::uint32_t index_ = 0;
    Sequence sequence_;
};

}  // namespace whittle
