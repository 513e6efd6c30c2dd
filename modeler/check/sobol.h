// sobol.h — Owen-scrambled Sobol points in up to five dimensions: evenly spread, yet each randomisation is unbiased and independent of the others.
//
// Points k = 0, 1, 2, ... of one sequence may be asked for in any order, so threads share nothing. Any 2^m points from a multiple of 2^m on form a net:
// take whole nets. The scramble flips each digit by a hash of the digits above it, as a permutation of 32 bits in reversed order does.
//
// Source: Sobol (1967) with direction numbers of Joe and Kuo, Constructing Sobol sequences with better two-dimensional projections (2008);
// Owen, Randomly permuted (t,m,s)-nets (1995); Laine and Karras, Stratified sampling for stochastic transparency (2011), for scrambling by a hash.
#pragma once

#include <array>
#include <cstdint>

namespace whittle {

inline constexpr int kSobolDimensions = 5;

// Spreads the bits of a and b over 64 bits; for deriving seeds from seeds.
std::uint64_t mixed(std::uint64_t a, std::uint64_t b);

class ScrambledSobol {
public:
    // Different seeds give independent scrambles.
    explicit ScrambledSobol(std::uint64_t seed);
    // Coordinate `dimension` of point k < 2^32, in [0, 1), in the middle of its cell of 2^-32.
    double at(std::uint32_t k, int dimension) const;

private:
    std::array<std::uint32_t, kSobolDimensions> seeds_;
};

}  // namespace whittle
