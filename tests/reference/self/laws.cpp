// laws.cpp — what the solid's builder drops is nothing: the same recipe with and without its simplifications has the same borders on every ray.
#include <catch2/catch.hpp>

#include "tests/reference/reference.h"
#include "tests/reference/self/solids.h"
#include "tests/reference/shapes.h"
#include "tests/support/random_solid.h"
#include "tests/support/seed.h"

using namespace whittle;
using namespace whittle::reference;
using namespace whittle::support;

TEST_CASE("simplifying a solid while it is built changes no border of it") {
    const std::uint64_t first_seed = fresh_seed();
    WARN("WHITTLE_SEED=" << first_seed);
    std::mt19937_64 random(first_seed);
    int met = 0, simplified = 0;
    for (int round = 0; round < 240; ++round) {
        const Theme theme = static_cast<Theme>(round % kThemes);
        const std::uint64_t seed = random();
        const RandomSolid kept = random_solid(theme, seed, {false, false, false}), slim = random_solid(theme, seed);
        REQUIRE(has_formula(slim.solid));
        simplified += slim.solid.node_count() < kept.solid.node_count();
        // Rounded, the placements of two shapes that touch may part them or make them overlap by a film; what is dropped goes by the solid as it is written.
        const Options unrounded{false, 0};
        const Evaluator a(kept.solid, unrounded), b(slim.solid, unrounded);
        for (int i = 0; i < 10; ++i) {
            const Ray ray = random_ray(kept, random);
            const Borders x = a.borders(ray), y = b.borders(ray);
            met += !x.borders.empty();
            INFO(name_of(theme) << " " << seed << "  " << to_text(ray));
            REQUIRE(same_borders(x, y));
        }
    }
    CHECK(met > 600);
    CHECK(simplified > 20);
}
