#include "csg/solid/divided_sides.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace whittle;

namespace {

const std::vector<Vec2> kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::size_t corners(const std::vector<Vec2>& contour, int segments, const SideStretch& stretch = {}) {
    return with_divided_sides({contour}, segments, stretch)[0].size();
}

}  // namespace

TEST_CASE("sides of one length are cut together or not at all") {
    CHECK(corners(kSquare, 3) == 4);
    CHECK(corners(kSquare, 7) == 4);
    CHECK(corners(kSquare, 8) == 8);
    CHECK(corners(kSquare, 11) == 8);
    CHECK(corners(kSquare, 16) == 16);
}

TEST_CASE("the longest pieces are cut first") {
    const Contours made = with_divided_sides({{{0, 0}, {30, 0}, {30, 10}, {0, 10}}}, 8, {});
    CHECK(made[0] == std::vector<Vec2>{{0, 0}, {10, 0}, {20, 0}, {30, 0}, {30, 10}, {20, 10}, {10, 10}, {0, 10}});
}

TEST_CASE("corners that were there keep their bits, and every contour is cut by itself") {
    const std::vector<Vec2> odd{{0.1, 0.7}, {1.0 / 3, 0.2}, {2.7, 1e-9}};
    const Contours made = with_divided_sides({odd, kSquare}, 12, {});
    CHECK(made[0].size() <= 12);
    CHECK(made[0].size() > 9);
    CHECK(made[1].size() == 12);
    for (const Vec2& p : odd) CHECK(std::count(made[0].begin(), made[0].end(), p) == 1);
}

TEST_CASE("a side counts with the greatest length it has on the way up") {
    // The square's sides along y grow to three times their length.
    const Contours made = with_divided_sides({kSquare}, 8, {0, {1, 3}, 4});
    CHECK(made[0].size() == 8);
    CHECK(std::count_if(made[0].begin(), made[0].end(), [](Vec2 p) { return p.x == 10; }) == 4);
    // A quarter of a turn on the way lets all four grow.
    CHECK(corners(kSquare, 8, {90, {3, 3}, 4}) == 8);
}

TEST_CASE("what has no length is left as it is") {
    CHECK(corners({{1, 1}, {1, 1}, {1, 1}}, 100) == 3);
}
