// ear_clipping_test.cpp — regions with holes are covered once.
#include <cmath>

#include <catch2/catch.hpp>

#include "csg/solid/ear_clipping.h"

using namespace whittle;

namespace {

void add_circle(std::vector<Vec2>& points, std::vector<std::uint32_t>& ring, Vec2 centre, double r, int n, bool hole) {
    for (int i = 0; i < n; ++i) {
        const double a = (hole ? -2 : 2) * 3.14159265358979 * i / n;
        ring.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(centre + r * Vec2(std::cos(a), std::sin(a)));
    }
}

double twice_area(const std::vector<Vec2>& points, const std::uint32_t* ring, std::size_t n) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = points[ring[i]], b = points[ring[(i + 1) % n]];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

}  // namespace

TEST_CASE("a plate with holes anywhere is triangulated, corner for corner, over its whole area") {
    for (const int n : {6, 7, 30})
        for (const int m : {3, 4, 8})
            for (const double off : {0.0, 4.0, -4.0, 4.1}) {
                std::vector<Vec2> points;
                std::vector<std::vector<std::uint32_t>> contours(3);
                add_circle(points, contours[0], Vec2(0), 8, n, false);
                add_circle(points, contours[1], Vec2(off, 0), 1, m, true);
                add_circle(points, contours[2], Vec2(0.5, 3), 1, m, true);
                const auto triangles = ear_clipped(points, contours);
                INFO("n " << n << " m " << m << " off " << off);
                REQUIRE(triangles);
                CHECK(triangles->size() == points.size() + 2);  // n - 2 and 2 for each hole
                double want = 0, got = 0;
                for (const auto& c : contours) want += twice_area(points, c.data(), c.size());
                for (const auto& t : *triangles) {
                    const double a = twice_area(points, t.data(), 3);
                    CHECK(a > 0);
                    got += a;
                }
                CHECK(got == Approx(want).epsilon(1e-12));
            }
}
