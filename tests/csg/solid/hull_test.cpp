// hull_test.cpp — hulls, sums, sections, shadows and roofs in their exact forms.
#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include "csg/solid/convex_hull.h"
#include "csg/solid/convex_parts.h"
#include "csg/solid/exact_hull.h"
#include "csg/solid/facet_operations.h"
#include "csg/solid/polyhedron.h"
#include "csg/solid/predicates.h"
#include "csg/solid/roof.h"
#include "csg/solid/section.h"
#include "csg/solid/support.h"

using namespace whittle;

namespace {

Use at(NodeId node, Vec3 by = Vec3(0)) {
    Use use;
    use.node = node;
    use.placement = Placement::translation(by);
    return use;
}

double reach(const SolidBuilder& b, const Use& use, Vec3 d) {
    Solid solid = b.so_far();
    const auto own = support(solid, use.node, {use.placement.m[0] * d.x + use.placement.m[4] * d.y + use.placement.m[8] * d.z,
                                               use.placement.m[1] * d.x + use.placement.m[5] * d.y + use.placement.m[9] * d.z,
                                               use.placement.m[2] * d.x + use.placement.m[6] * d.y + use.placement.m[10] * d.z});
    REQUIRE(own);
    return *own + use.placement.offset(0) * d.x + use.placement.offset(1) * d.y + use.placement.offset(2) * d.z;
}

const std::vector<Vec3> kDirections{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 2, 3}, {-3, 1, 0.5}, {0.2, -1, -2}, {-1, -1, 1}};

}  // namespace

TEST_CASE("a convex hull holds all points, closes, and keeps no point that others hold") {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> grid(-4, 4);  // many coplanar and equal ones
    for (int round = 0; round < 40; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 60; ++i) points.emplace_back(grid(random), grid(random), grid(random));
        const auto hull = convex_hull_of(points);
        REQUIRE(hull);
        CHECK(open_edges(*hull) == 0);
        for (const auto& f : hull->facets)
            for (const Vec3& p : points) CHECK(side_of(hull->points[f[0]], hull->points[f[1]], hull->points[f[2]], p) <= 0);
    }
}

TEST_CASE("points in one plane have no hull, those of a cube and its middle have twelve triangles") {
    CHECK_FALSE(convex_hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}));
    std::vector<Vec3> cube{{0.5, 0.5, 0.5}};
    for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    const auto hull = convex_hull_of(cube);
    REQUIRE(hull);
    CHECK(hull->points.size() == 8);
    CHECK(hull->facets.size() == 12);
    CHECK(signed_volume(*hull) == 1);
}

TEST_CASE("the flat hull drops points on its sides") {
    const auto ring = convex_hull_of(std::vector<Vec2>{{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 1}});
    CHECK(ring == std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST_CASE("the hull of balls and corners reaches as far as they do, everywhere") {
    SolidBuilder b;
    const std::vector<Use> operands{at(b.shape(shape::Ellipsoid{Vec3(2)})), at(b.shape(shape::Ellipsoid{Vec3(1)}), {7, 1, 0}), at(b.shape(shape::Box{Vec3(0), Vec3(1)}), {2, 6, 3}),
                                    at(b.shape(shape::Capsule{{0, 0, 5}, {1, 2, 8}, 0.5}))};
    const HullResult hull = exact_hull(b, operands);
    REQUIRE(hull.use);
    for (const Vec3& d : kDirections) {
        double most = -HUGE_VAL;
        for (const Use& use : operands) most = std::max(most, reach(b, use, d));
        CHECK(reach(b, *hull.use, d) == Approx(most).epsilon(1e-12));
    }
}

TEST_CASE("the hull of equal balls at the corners of a box is a rounded box") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(1)});
    std::vector<Use> corners, slab;
    for (int k = 0; k < 8; ++k) corners.push_back(at(ball, {k & 1 ? 5.0 : 1.0, k & 2 ? 6.0 : 1.0, k & 4 ? 7.0 : 1.0}));
    for (int k = 0; k < 4; ++k) slab.push_back(at(ball, {k & 1 ? 5.0 : 1.0, 2, k & 2 ? 7.0 : 1.0}));
    const auto box = exact_hull(b, corners);
    REQUIRE(box.use);
    CHECK(std::get<Shape>(b.node(box.use->node)) == Shape{shape::RoundBox{Vec3(0), {6, 7, 8}, 1}});
    const auto flat = exact_hull(b, slab);
    REQUIRE(flat.use);
    CHECK(std::get<Shape>(b.node(flat.use->node)) == Shape{shape::RoundBox{{0, 1, 0}, {6, 3, 8}, 1}});
    corners.back() = at(ball, {5, 6, 7.5});
    const auto skew = exact_hull(b, corners);
    REQUIRE(skew.use);
    CHECK(std::holds_alternative<Combination>(b.node(skew.use->node)));
}

TEST_CASE("a ball that sticks out is joined though no plane touches it and two others") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(1)}), big = b.shape(shape::Ellipsoid{Vec3(20)});
    const std::vector<Use> operands{at(big), at(ball, {50, 0, 0}), at(ball, {-18, -12, 0}), at(ball, {-18, -11, 3})};
    const auto hull = exact_hull(b, operands);
    REQUIRE(hull.use);
    for (const Vec3& d : kDirections) {
        double most = -HUGE_VAL;
        for (const Use& use : operands) most = std::max(most, reach(b, use, d));
        CHECK(reach(b, *hull.use, d) == Approx(most).epsilon(1e-12));
    }
    std::size_t cones = 0;
    for (const Use& part : std::get<Combination>(b.node(hull.use->node)).operands)
        cones += std::holds_alternative<shape::Frustum>(std::get<Shape>(b.node(part.node))) ? 1U : 0U;
    CHECK(cones >= 1);
}

TEST_CASE("hulls of two balls, of discs, of cylinders of one height stand as curves") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(1)}), disc = b.shape(shape::Disc{1}), bar = b.shape(shape::Frustum{0, 2, 1, 1});
    CHECK(exact_hull(b, {at(ball), at(ball, {5, 0, 0})}).use);
    CHECK(exact_hull(b, {at(disc), at(disc, {5, 0, 0})}).use);
    const auto bars = exact_hull(b, {at(bar), at(bar, {5, 0, 0})});
    REQUIRE(bars.use);
    CHECK(std::holds_alternative<shape::Extrusion>(std::get<Shape>(b.node(bars.use->node))));
    CHECK_FALSE(exact_hull(b, {at(bar), at(bar, {5, 0, 1})}).use);
    CHECK(exact_hull(b, {}).flat);
}

TEST_CASE("the hull of a cone, a cylinder and a ball on one axis turns about it") {
    SolidBuilder b;
    const NodeId cone = b.shape(shape::Frustum{0, 4, 5, 1}), bar = b.shape(shape::Frustum{0, 1, 2, 2});
    const std::vector<Use> stack{at(cone, {3, 2, 0}), at(bar, {3, 2, 9})};
    const HullResult straight = exact_hull(b, stack);
    REQUIRE(straight.use);
    for (const Vec3& d : kDirections) CHECK(reach(b, *straight.use, d) == Approx(std::max(reach(b, stack[0], d), reach(b, stack[1], d))).epsilon(1e-12));
    const HullResult round = exact_hull(b, {stack[0], at(b.shape(shape::Ellipsoid{Vec3(2)}), {3, 2, 9})});
    REQUIRE(round.use);
    const Bounds box = b.bounds(*round.use);
    CHECK(box.hi.z == Approx(11));
    CHECK(box.lo.x == Approx(-2));
    CHECK_FALSE(exact_hull(b, {stack[0], at(bar, {4, 2, 9})}).use);
}

TEST_CASE("a cylinder swept over a ball is a body of revolution, over a ring nothing exact") {
    SolidBuilder b;
    const Use bar = at(b.shape(shape::Frustum{0, 4, 3, 3})), cone = at(b.shape(shape::Frustum{0, 2, 1, 0}), {1, 0, 5});
    const auto sum = exact_minkowski(b, bar, cone);
    REQUIRE(sum);
    for (const Vec3& d : kDirections) CHECK(reach(b, *sum, d) == Approx(reach(b, bar, d) + reach(b, cone, d)).epsilon(1e-12));
    const auto rounded = exact_minkowski(b, bar, at(b.shape(shape::Ellipsoid{Vec3(1)})));
    REQUIRE(rounded);
    CHECK(b.bounds(*rounded).hi.z == Approx(5));
    CHECK_FALSE(exact_minkowski(b, bar, at(b.shape(shape::Torus{3, 1}))));
}

TEST_CASE("a box grown by a ball is known by its reach; a ring has no exact sum") {
    SolidBuilder b;
    const Use box = at(b.shape(shape::Box{Vec3(0), Vec3(4, 3, 2)})), ball = at(b.shape(shape::Ellipsoid{Vec3(0.5)}), {1, 0, 0}), ring = at(b.shape(shape::Torus{3, 1}));
    const auto sum = exact_minkowski(b, box, ball);
    REQUIRE(sum);
    for (const Vec3& d : kDirections) CHECK(reach(b, *sum, d) == Approx(reach(b, box, d) + reach(b, ball, d)).epsilon(1e-12));
    CHECK_FALSE(exact_minkowski(b, box, ring));
}

TEST_CASE("an L swept over a cube is cut into parts whose union is the sum") {
    FacetList l, cube;
    const std::vector<Vec2> outline{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
    SolidBuilder b;
    shape::Extrusion e{};
    e.profile = b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{outline})});
    e.z1 = 1;
    e.scale_top = Vec2(1);
    const NodeId bar = b.shape(e), box = b.shape(shape::Box{Vec3(0), Vec3(1)});
    l = *facets_of(b.so_far(), bar);
    cube = *facets_of(b.so_far(), box);
    const auto parts = minkowski_parts(l, cube, 1000);
    REQUIRE(parts);
    CHECK(parts->size() > 1);
    for (const FacetList& part : *parts) {
        CHECK(open_edges(part) == 0);
        CHECK(signed_volume(part) > 0);
    }
    CHECK_FALSE(minkowski_parts(l, cube, 2));
}

TEST_CASE("sections and shadows of upright shapes are the flat shapes they are swept from") {
    SolidBuilder b;
    const Use ball = at(b.shape(shape::Ellipsoid{Vec3(5)}), {1, 2, 3}), ring = at(b.shape(shape::Torus{5, 1})), cone = at(b.shape(shape::Frustum{0, 4, 4, 0}), {0, 0, -1});
    const auto circle = exact_section(b, ball, {});
    REQUIRE(circle);
    CHECK(std::get<shape::Disc>(std::get<Shape>(b.node(circle->node))).r == Approx(4));
    const auto cut = exact_section(b, cone, {});
    REQUIRE(cut);
    CHECK(std::get<shape::Disc>(std::get<Shape>(b.node(cut->node))).r == Approx(3));
    const auto annulus = exact_section(b, ring, {});
    REQUIRE(annulus);
    CHECK(std::get<Combination>(b.node(annulus->node)).op == SetOp::kDifference);
    const auto shadow = exact_shadow(b, cone);
    REQUIRE(shadow);
    CHECK(std::get<shape::Disc>(std::get<Shape>(b.node(shadow->node))).r == 4);
    const auto missed = exact_section(b, at(b.shape(shape::Box{Vec3(0), Vec3(1)}), {0, 0, 2}), {});
    REQUIRE(missed);
    CHECK(missed->node == kEmptyNode);
}

TEST_CASE("a cube's section counts what is just above the plane") {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(0), Vec3(1)});
    CHECK(exact_section(b, at(box), {})->node != kEmptyNode);
    CHECK(exact_section(b, at(box, {0, 0, -1}), {})->node == kEmptyNode);
}

TEST_CASE("a tilted cube's shadow is a hexagon of the area that its projection has") {
    SolidBuilder b;
    const FacetList cube = *facets_of(b.so_far(), b.shape(shape::Box{Vec3(-1), Vec3(1)}));
    const double s = std::sqrt(0.5), t = std::sqrt(1.0 / 3);
    const Placement tilt{{s, -s, 0, 0, s * t, s * t, -std::sqrt(2.0 / 3), 0, t, t, t, 0}};  // a corner upwards
    const Contours shadow = shadow_of(placed_facets(cube, tilt));
    REQUIRE(shadow.size() == 1);
    CHECK(ring_area(shadow[0]) == Approx(4 * std::sqrt(3.0)).epsilon(1e-8));
}

TEST_CASE("a roof is bounded by its floor and as high as the largest circle in it") {
    SolidBuilder b;
    const Use roof = roof_of(b, {{{0, 0}, {6, 0}, {6, 4}, {0, 4}}});
    const Bounds box = b.bounds(roof);
    CHECK(box.lo == Vec3(0));
    CHECK(box.hi.x == 6);
    CHECK(box.hi.y == 4);
    CHECK(is_one_convex_ring({{{0, 0}, {6, 0}, {6, 4}, {0, 4}}}));
    CHECK_FALSE(is_one_convex_ring({{{0, 0}, {4, 0}, {4, 4}, {2, 1}}}));
}
