// test_sobol.cpp — evenness and independence of the scrambled points.
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "modeler/check/sobol.h"

using whittle::ScrambledSobol;

TEST_CASE("256 scrambled points put one into each elementary interval of the first two coordinates") {
    for (const std::uint64_t seed : {0u, 1u, 77u}) {
        const ScrambledSobol points(seed);
        for (int log_x = 0; log_x <= 8; ++log_x) {
            std::set<int> boxes;
            for (std::uint32_t k = 256; k < 512; ++k) {
                const int x = static_cast<int>(std::ldexp(points.at(k, 0), log_x)), y = static_cast<int>(std::ldexp(points.at(k, 1), 8 - log_x));
                boxes.insert(x << (8 - log_x) | y);
            }
            CHECK(boxes.size() == 256);
        }
    }
}

TEST_CASE("each coordinate of 1024 scrambled points is one to each of 1024 cells") {
    const ScrambledSobol points(5);
    for (int d = 0; d < whittle::kSobolDimensions; ++d) {
        std::set<int> cells;
        for (std::uint32_t k = 0; k < 1024; ++k) cells.insert(static_cast<int>(1024 * points.at(k, d)));
        CHECK(cells.size() == 1024);
    }
}

TEST_CASE("the first point of a scramble is spread evenly over the seeds") {
    std::array<int, 16> cells{};
    for (std::uint64_t seed = 0; seed < 16000; ++seed) ++cells[static_cast<std::size_t>(16 * ScrambledSobol(seed).at(0, 1))];
    double chi_squared = 0;
    for (const int count : cells) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
    CHECK(chi_squared < 37.7);  // 15 degrees of freedom, 99.9 %
}
