// convex_rings_test.cpp — regions as convex pieces: nothing lost, nothing twice, few of them.
#include <catch2/catch.hpp>

#include <cmath>

#include "csg/solid/convex_rings.h"
#include "csg/solid/predicates.h"

using namespace whittle;

namespace {

using Ring = std::vector<Vec2>;

double area_of(const Ring& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return sum;
}

bool is_convex(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn_of(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) <= 0) return false;
    return true;
}

bool holds(const Ring& ring, Vec2 p) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn_of(ring[i], ring[(i + 1) % ring.size()], p) < 0) return false;
    return true;
}

// A star's corners: points far out and near by turns.
Ring star(int points) {
    Ring ring;
    for (int i = 0; i < 2 * points; ++i) {
        const double a = 3.14159265358979 * i / points, r = i % 2 == 0 ? 20 : 11;
        ring.push_back({r * std::cos(a), r * std::sin(a)});
    }
    return ring;
}

}  // namespace

TEST_CASE("a convex contour is its only piece") {
    const Ring square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const auto parts = convex_rings({square});
    REQUIRE(parts);
    REQUIRE(parts->size() == 1);
    CHECK((*parts)[0] == square);
}

TEST_CASE("a star is its points and its heart") {
    const Ring ring = star(8);
    const auto parts = convex_rings({ring});
    REQUIRE(parts);
    CHECK(parts->size() == 9);
    double sum = 0;
    for (const Ring& part : *parts) {
        CHECK(is_convex(part));
        sum += area_of(part);
    }
    CHECK(sum == Approx(area_of(ring)).epsilon(1e-12));
}

TEST_CASE("convex pieces cover a region with holes once") {
    const Ring outside{{-10, -7}, {12, -9}, {3, 0}, {11, 8}, {-4, 9}, {-9, 2}}, hole{{-5, -3}, {-4, 1}, {1, 2}, {0, -4}};
    const auto parts = convex_rings({outside, hole});
    REQUIRE(parts);
    double sum = 0;
    for (const Ring& part : *parts) {
        CHECK(is_convex(part));
        sum += area_of(part);
    }
    CHECK(sum == Approx(area_of(outside) + area_of(hole)).epsilon(1e-12));
    for (double x = -10.03; x < 13; x += 0.61)
        for (double y = -9.01; y < 10; y += 0.57) {
            int in = 0;
            for (const Ring& part : *parts) in += holds(part, {x, y}) ? 1 : 0;
            CHECK(in <= 1);
        }
}
