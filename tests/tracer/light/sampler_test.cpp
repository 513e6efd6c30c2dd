#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <set>

#include "tracer/light/sampler.h"

using namespace whittle;

TEST_CASE("the second coordinate is Sobol's: Pascal's triangle modulo 2") {
    for (std::uint32_t i : {0U, 1U, 2U, 3U, 4U, 5U, 100U, 0xdeadbeefU, 0xffffffffU}) {
        std::uint32_t direction = 0x80000000U, expected = 0;
        for (int bit = 0; bit < 32; ++bit, direction ^= direction >> 1)
            if ((i >> bit) & 1U) expected ^= direction;
        CHECK(sobol::second(i) == expected);
    }
}

TEST_CASE("the first 2^k samples of every pair fill every elementary rectangle once") {
    for (int x : {0, 7})
        for (Draw what : {Draw::kPixel, Draw::kLight, Draw::kLobe})
            for (int width_log = 0; width_log <= 6; ++width_log) {
                const int columns = 1 << width_log, rows = 64 / columns;
                std::set<int> cells;
                for (std::uint32_t i = 0; i < 64; ++i) {
                    const Vec2 u = Sampler(42, x, 3, i).pair(what, 1);
                    REQUIRE(u.x >= 0);
                    REQUIRE(u.x < 1);
                    cells.insert(static_cast<int>(u.x * columns) * rows + static_cast<int>(u.y * rows));
                }
                CHECK(cells.size() == 64);
            }
}

TEST_CASE("light samples within a sample are stratified together") {
    std::set<int> cells;
    for (std::uint32_t i = 0; i < 4; ++i)
        for (std::uint32_t part = 0; part < 16; ++part) {
            const Vec2 u = Sampler(1, 5, 9, i).pair(Draw::kLight, 0, part, 16);
            cells.insert(static_cast<int>(u.x * 8) * 8 + static_cast<int>(u.y * 8));
        }
    CHECK(cells.size() == 64);
}

TEST_CASE("pixels, pairs and seeds have numbers of their own") {
    std::set<double> seen;
    for (std::uint64_t seed : {0ULL, 1ULL, 1ULL << 40})
        for (int x = 0; x < 3; ++x)
            for (Draw what : {Draw::kPixel, Draw::kLens, Draw::kTimeAndWavelength, Draw::kLight, Draw::kLobe, Draw::kChoice, Draw::kSky})
                for (std::uint32_t bounce = 0; bounce < 3; ++bounce) {
                    if (bounce > 0 && what < Draw::kLight) continue;
                    seen.insert(Sampler(seed, x, 0, 0).pair(what, bounce).x);
                }
    CHECK(seen.size() == 3 * 3 * (3 + 4 * 3));
}

TEST_CASE("the error of a smooth integral falls faster than that of chance") {
    // Integral of x*y over the unit square is 1/4; random numbers would err by about 0.22/sqrt(n).
    double worst = 0;
    for (int pixel = 0; pixel < 20; ++pixel) {
        double sum = 0;
        for (std::uint32_t i = 0; i < 1024; ++i) {
            const Vec2 u = Sampler(0, pixel, 0, i).pair(Draw::kLight);
            sum += u.x * u.y;
        }
        worst = std::max(worst, std::abs(sum / 1024 - 0.25));
    }
    CHECK(worst < 0.22 / 1024 * 4);
}
