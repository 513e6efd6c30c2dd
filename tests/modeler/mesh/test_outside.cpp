// test_outside.cpp — hulls and sums of a scene's operands.
#include <numbers>

#include "modeler/mesh/outside_mesh.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;

namespace {

double volume_of(const FacetList& list) {
    Mesh mesh;
    mesh.points = list.points;
    for (const auto& f : list.facets) mesh.triangles.push_back({f[0], f[1], f[2]});
    CHECK(report_mesh(mesh).valid());
    return mass_properties(mesh).volume;
}

}  // namespace

TEST_CASE("the hull of two cubes along a diagonal, and of a drilled one") {
    SolidBuilder b;
    const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(1)}), drilled = b.combine(SetOp::kDifference, {at(cube), at(b.shape(shape::Box{Vec3(0.25), Vec3(0.75)}))});
    const Solid solid = b.finish(at(drilled));
    const auto both = hull_of(solid, {at(cube), at(cube, {0, 0, 3})});
    REQUIRE(both);
    CHECK(volume_of(**both) == Approx(4).epsilon(1e-12));
    const auto filled = hull_of(solid, {at(drilled)});
    REQUIRE(filled);
    CHECK(volume_of(**filled) == Approx(1).epsilon(1e-12));
    CHECK_FALSE(hull_of(solid, {}));
}

TEST_CASE("a sum of convex solids; one that is not convex is refused") {
    SolidBuilder b;
    const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(2)}), ball = b.shape(shape::Ellipsoid{Vec3(1)}), ring = b.shape(shape::Torus{5, 1});
    const Solid solid = b.finish(at(cube));
    MeshOptions coarse;
    coarse.tolerance_mm = 0.02;
    const auto sum = minkowski_of(solid, {at(cube), at(ball)}, coarse);
    REQUIRE(sum);
    const double exact = 8 + 6 * 4 + 6 * std::numbers::pi / 4 * 2 * 2 + 4.0 / 3 * std::numbers::pi;  // Steiner's formula
    CHECK(volume_of(**sum) < exact);
    CHECK(volume_of(**sum) == Approx(exact).epsilon(0.03));
    const auto refused = minkowski_of(solid, {at(cube), at(ring)}, coarse);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().fault == Fault::kScene);
}
