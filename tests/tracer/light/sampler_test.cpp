#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "tracer/light/sampler.h"

using namespace whittle;

namespace {

constexpr SamplerKind kKinds[] = {SamplerKind::kSobol, SamplerKind::kStratified, SamplerKind::kIndependent};

// Root of the mean square error of an integral over the unit square by `n` samples of a pixel, over many pixels.
double error_of(SamplerKind kind, std::uint32_t n, double truth, const std::function<double(Vec2)>& f) {
    constexpr int kPixels = 400;
    double sum = 0;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        double mean = 0;
        for (std::uint32_t i = 0; i < n; ++i) mean += f(Sampler(7, pixel, 2, i, {kind, n}).pair(Draw::kLight, 1)) / n;
        sum += (mean - truth) * (mean - truth) / kPixels;
    }
    return std::sqrt(sum);
}

double rate_of(SamplerKind kind, double truth, const std::function<double(Vec2)>& f) {
    return std::log(error_of(kind, 1024, truth, f) / error_of(kind, 16, truth, f)) / std::log(64.0);
}

}  // namespace

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

TEST_CASE("samplers converge as they should: smooth integrals by n^-3/2, n^-1 and n^-1/2, edges by n^-3/4, n^-3/4 and n^-1/2") {
    const double smooth_rates[] = {-1.5, -1, -0.5}, edge_rates[] = {-0.75, -0.75, -0.5};
    for (std::size_t k = 0; k < 3; ++k) {
        INFO(sampler_name(kKinds[k]));
        // Of exp(x + y / 2), whose integral is (e - 1) (2 sqrt(e) - 2), and of a half-plane that cuts off 0.3 + 0.17 / 2.
        CHECK(rate_of(kKinds[k], 1.71828182845904524 * 1.29744254140025629, [](Vec2 u) { return std::exp(u.x + u.y / 2); }) == Approx(smooth_rates[k]).margin(0.1));
        CHECK(rate_of(kKinds[k], 0.385, [](Vec2 u) { return u.x < 0.3 + 0.17 * u.y ? 1.0 : 0.0; }) == Approx(edge_rates[k]).margin(0.1));
    }
}

TEST_CASE("chance alone has the error of chance") {
    // Of x y: the variance is 1/9 - 1/16.
    CHECK(error_of(SamplerKind::kIndependent, 64, 0.25, [](Vec2 u) { return u.x * u.y; }) == Approx(std::sqrt((1.0 / 9 - 1.0 / 16) / 64)).epsilon(0.12));
}

TEST_CASE("stratified samples have a cell each, in an order of each pixel's and pair's own") {
    for (const std::uint32_t n : {1U, 2U, 5U, 16U, 37U, 64U, 1000U}) {
        const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(n))), rows = (n + columns - 1) / columns;
        INFO(n << " samples");
        std::vector<std::uint32_t> orders[3];
        for (int k = 0; k < 3; ++k) {
            std::set<std::uint32_t> cells;
            for (std::uint32_t i = 0; i < n; ++i) {
                const Vec2 u = Sampler(1, k % 2, 0, i, {SamplerKind::kStratified, n}).pair(Draw::kLobe, k / 2);
                REQUIRE((u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1));
                orders[k].push_back(static_cast<std::uint32_t>(u.x * columns) + columns * static_cast<std::uint32_t>(u.y * rows));
                cells.insert(orders[k].back());
            }
            CHECK(cells.size() == n);
        }
        if (n > 4) CHECK((orders[0] != orders[1] && orders[0] != orders[2]));
    }
}

TEST_CASE("the light samples of all samples share one grid, and each number alone is even over the unit square") {
    std::set<int> cells;
    for (std::uint32_t i = 0; i < 4; ++i)
        for (std::uint32_t part = 0; part < 16; ++part) {
            const Vec2 u = Sampler(1, 5, 9, i, {SamplerKind::kStratified, 4}).pair(Draw::kLight, 0, part, 16);
            cells.insert(static_cast<int>(u.x * 8) * 8 + static_cast<int>(u.y * 8));
        }
    CHECK(cells.size() == 64);
    for (const SamplerKind kind : kKinds) {
        // The third of five samples, over many pixels: chi-square of 63 degrees exceeds 104 once in a thousand.
        std::vector<double> count(64, 0);
        constexpr int kPixels = 64000;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            const Vec2 u = Sampler(3, pixel, 8, 2, {kind, 5}).pair(Draw::kSky, 2);
            count[static_cast<std::size_t>(static_cast<int>(u.x * 8) * 8 + static_cast<int>(u.y * 8))] += 1;
        }
        double chi2 = 0;
        for (const double c : count) chi2 += (c - kPixels / 64.0) * (c - kPixels / 64.0) / (kPixels / 64.0);
        INFO(sampler_name(kind));
        CHECK(chi2 < 104);
    }
}
