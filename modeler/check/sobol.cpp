// sobol.cpp — direction numbers by their recurrence, scrambling by a hash whose carries only go from a digit to those below it.
#include "modeler/check/sobol.h"

namespace whittle {

namespace {

using Directions = std::array<std::array<std::uint32_t, 32>, kSobolDimensions>;

// Primitive polynomials (degree, inner coefficients) and first odd numbers of the dimensions after the first.
struct Polynomial { int degree; std::uint32_t inner; std::array<std::uint32_t, 3> first; };
constexpr std::array<Polynomial, kSobolDimensions - 1> kPolynomials{{{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}}};

constexpr Directions make_directions() {
    Directions v{};
    for (int i = 0; i < 32; ++i) v[0][static_cast<std::size_t>(i)] = 1u << (31 - i);
    for (std::size_t d = 1; d < kSobolDimensions; ++d) {
        const Polynomial& p = kPolynomials[d - 1];
        for (int i = 0; i < 32; ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (i < p.degree) {
                v[d][at] = p.first[at] << (31 - i);
                continue;
            }
            const std::uint32_t last = v[d][static_cast<std::size_t>(i - p.degree)];
            v[d][at] = last ^ (last >> p.degree);
            for (int k = 1; k < p.degree; ++k)
                if ((p.inner >> (p.degree - 1 - k)) & 1u) v[d][at] ^= v[d][static_cast<std::size_t>(i - k)];
        }
    }
    return v;
}

constexpr Directions kDirections = make_directions();

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00FF00FFu) << 8) | ((x >> 8) & 0x00FF00FFu);
    x = ((x & 0x0F0F0F0Fu) << 4) | ((x >> 4) & 0x0F0F0F0Fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// A bit of the result depends on that bit and lower ones only: sums and products by odd or even constants carry upwards. In reversed order this is
// Owen's nested permutation.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x);
    x += seed;
    x ^= x * ((seed << 1 ^ 0x6C50B47Cu) & ~1u);
    x ^= x * 0xB82F1E52u;
    x ^= x * 0xC7AFE638u;
    x *= (seed >> 3) | 1u;
    x ^= x * 0x8D22F6E6u;
    return reversed(x);
}

}  // namespace

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    std::uint64_t x = a + 0x9E3779B97F4A7C15u * (b + 1);
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

ScrambledSobol::ScrambledSobol(std::uint64_t seed) {
    for (std::size_t d = 0; d < kSobolDimensions; ++d) seeds_[d] = static_cast<std::uint32_t>(mixed(seed, d) >> 32);
}

double ScrambledSobol::at(std::uint32_t k, int dimension) const {
    const auto d = static_cast<std::size_t>(dimension);
    std::uint32_t x = 0;
    for (std::size_t bit = 0; k != 0; ++bit, k >>= 1)
        if (k & 1u) x ^= kDirections[d][bit];
    return (scrambled(x, seeds_[d]) + 0.5) * 0x1p-32;
}

}  // namespace whittle
