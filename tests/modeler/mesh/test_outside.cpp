// test_outside.cpp — the meshes that a scene asks for where no exact form exists.
#include "csg/solid/polyhedron.h"
#include "modeler/mesh/outside_mesh.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;

TEST_CASE("a drilled cube as facets: closed, of its volume, where its use stands") {
    SolidBuilder b;
    const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(1)}), drilled = b.combine(SetOp::kDifference, {at(cube), at(b.shape(shape::Box{Vec3(0.25, 0.25, -1), Vec3(0.75, 0.75, 2)}))});
    const Solid solid = b.finish(at(drilled));
    const auto facets = facets_by_mesh(solid, at(drilled, {10, 0, 0}));
    REQUIRE(facets);
    CHECK(open_edges(**facets) == 0);
    CHECK(signed_volume(**facets) == Approx(0.75).epsilon(1e-12));
    for (const Vec3& p : (*facets)->points) CHECK(p.x >= 10);
}

TEST_CASE("a solid without bounds has no facets") {
    SolidBuilder b;
    const NodeId half = b.shape(shape::HalfSpace{{0, 0, 1}, 0});
    const Solid solid = b.finish(at(half));
    const auto facets = facets_by_mesh(solid, at(half));
    REQUIRE_FALSE(facets);
    CHECK(facets.error().fault == Fault::kScene);
}

TEST_CASE("the straight roof over an L: three wings meet, the ridge is as high as half a wing is wide") {
    const auto roof = roof_by_skeleton({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}});
    REQUIRE(roof);
    CHECK(open_edges(**roof) == 0);
    double high = 0;
    for (const Vec3& p : (*roof)->points) high = std::max(high, p.z);
    CHECK(high == Approx(1));
    // The higher of the hip roofs over the two bars: their integral.
    CHECK(signed_volume(**roof) == Approx(16.0 / 3).epsilon(1e-9));
}

TEST_CASE("a straight roof spares a hole in its floor") {
    const auto roof = roof_by_skeleton({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}});
    REQUIRE(roof);
    CHECK(open_edges(**roof) == 0);
    CHECK(signed_volume(**roof) == Approx(16).epsilon(1e-9));
}

TEST_CASE("the outline of a section is as near the true one as it says, however flat the solid meets the plane") {
    // A ring cut by a plane that touches it twice: Villarceau's circles, of the ring's radius about centres that are a tube off its own.
    const double ring = 3, tube = 1, up = tube / ring, across = std::sqrt(1 - up * up);
    SolidBuilder b;
    const NodeId torus = b.shape(shape::Torus{ring, tube});
    const Placement tilted{{1, 0, 0, 0, 0, across, -up, 0, 0, up, across, 0}};
    const Solid solid = b.finish(at(torus));
    const auto outline = section_by_mesh(solid, placed(torus, tilted));
    REQUIRE(outline);
    CHECK(outline->contours.size() == 2);
    CHECK(outline->deviation < 0.05);
    double worst = 0;
    for (const auto& ring_of_points : outline->contours)
        for (std::size_t i = 0; i < ring_of_points.size(); ++i) {
            const Vec2 &p = ring_of_points[i], &q = ring_of_points[(i + 1) % ring_of_points.size()];
            for (const double share : {0.0, 0.5}) {
                const Vec2 at = p + share * (q - p);
                worst = std::max(worst, std::min(std::fabs(glm::length(at - Vec2(tube, 0)) - ring), std::fabs(glm::length(at + Vec2(tube, 0)) - ring)));
            }
        }
    CHECK(worst > 0);
    CHECK(worst <= outline->deviation);
}
