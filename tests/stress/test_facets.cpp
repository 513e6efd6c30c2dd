// test_facets.cpp — balls, cones and cylinders of facets, and convex polygons, against the exact reference: rays through their corners, along their edges
// and in their faces, alone and flush with each other.
#include <cmath>

#include <catch2/catch.hpp>

#include "csg/base/degrees.h"
#include "csg/solid/facets.h"
#include "tests/stress/compare.h"
#include "tests/support/use.h"

using namespace whittle;
using namespace whittle::support;
using namespace whittle::stress;

namespace {

Placement turned(double deg, const Vec3& by) { return {{cosd(deg), 0, sind(deg), by.x, 0, 1, 0, by.y, -sind(deg), 0, cosd(deg), by.z}}; }

std::vector<Solid> solids(int n) {
    const auto bar = [&](SolidBuilder& b, double z0, double z1, double r0, double r1) { return b.shape(shape::FacetedFrustum{z0, z1, r0, r1, n}); };
    const Placement tilt = turned(37, {0.5, -1, 2});
    std::vector<Solid> out;
    {  // a stack: rim on rim
        SolidBuilder b;
        out.push_back(b.finish(use(b.combine(SetOp::kUnion, {use(bar(b, 0, 1, 2, 2)), use(bar(b, 1, 2, 2, 1)), use(bar(b, -1, 0, 0, 2))}), tilt)));
    }
    {  // a funnel cut out flush
        SolidBuilder b;
        out.push_back(b.finish(use(b.combine(SetOp::kDifference, {use(bar(b, 0, 2, 2, 2)), use(bar(b, 1, 2, 0.5, 1.5)), use(bar(b, 0, 1, 0.5, 0.5))}))));
    }
    {  // a ball, and half of it once more, turned by whole facets
        SolidBuilder b;
        const NodeId ball = b.shape(shape::FacetedBall{2, n}), half = b.shape(shape::HalfSpace{{0, 0, 1}, 0});
        const double step = 360.0 / n;
        const Placement spin{{cosd(step), -sind(step), 0, 0, sind(step), cosd(step), 0, 0, 0, 0, 1, 0}};
        out.push_back(b.finish(use(b.combine(SetOp::kUnion, {use(ball), use(b.combine(SetOp::kIntersection, {use(ball, spin), use(half)}))}), tilt)));
    }
    {  // extruded and a cylinder of the same facets, one on the other
        SolidBuilder b;
        const NodeId flat = b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{circle_points(2, n)})});
        const NodeId sunk = b.shape(shape::Extrusion{flat, -1, 0, 0, Vec2(1), 0});
        out.push_back(b.finish(use(b.combine(SetOp::kDifference, {use(b.combine(SetOp::kUnion, {use(sunk), use(bar(b, 0, 1, 2, 2))})), use(bar(b, -2, 2, 1, 1))}), tilt)));
    }
    return out;
}

}  // namespace

TEST_CASE("solids of facets agree with the exact reference, through corners and along edges too") {
    std::mt19937_64 random(11);
    const auto between = [&](double a, double b) { return a + (b - a) * (static_cast<double>(random() >> 11) * 0x1p-53); };
    for (const int n : {3, 4, 5, 12, 40})
        for (const Solid& solid : solids(n)) {
            const Subject subject = subject_of(solid, true);
            REQUIRE(subject.failure.empty());
            Scratch scratch;
            Tally tally;
            const Placement tilt = solid.root().placement;
            for (int k = 0; k < (n < 20 ? 40 : 12); ++k) {
                // Corners of rings, and points anywhere; from one to another.
                const auto point = [&] {
                    const double deg = 360.0 / n * static_cast<double>(random() % static_cast<std::uint64_t>(n)), r = k % 4 == 0 ? between(0, 3) : 2, z = static_cast<double>(random() % 4) - 1;
                    return apply_to_point(tilt, Vec3(r * cosd(deg), r * sind(deg), z));
                };
                Ray ray;
                const Vec3 a = point(), b = k % 3 == 0 ? apply_to_point(tilt, Vec3(between(-2, 2), between(-2, 2), between(-1, 2))) : point();
                if (a == b) continue;
                ray.origin = a + (a - b) * (k % 2 == 0 ? 1.0 : 0.0);
                ray.direction = b - a;
                INFO(n << " corners; " << support::to_text(ray));
                CHECK(disagreement(subject, ray, scratch, random, tally).empty());
                CHECK(continuation_disagreement(subject, ray, scratch, random, tally).empty());
            }
            CHECK(tally.borders > 10);
        }
}
