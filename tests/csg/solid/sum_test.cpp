// sum_test.cpp — what Minkowski sums of solids that are not convex are put together from: cut polytopes, covers, rounded faces, edges and corners.
#include <cmath>

#include <catch2/catch.hpp>

#include "csg/solid/convex_cover.h"
#include "csg/solid/convex_hull.h"
#include "csg/solid/exact_hull.h"
#include "csg/solid/facets.h"
#include "csg/solid/polyhedron.h"
#include "csg/solid/polytope.h"
#include "csg/solid/rounded.h"
#include "csg/solid/use_of.h"

using namespace whittle;

namespace {

std::vector<Vec3> box_corners(Vec3 lo, Vec3 hi) {
    std::vector<Vec3> out;
    for (int i = 0; i < 8; ++i) out.emplace_back(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z);
    return out;
}

double volume_of(std::vector<Vec3> corners) {
    const auto hull = convex_hull_of(std::move(corners));
    return hull ? signed_volume(*hull) : 0;
}

// Of pieces that overlap in their borders only.
double volume_of(const std::vector<Polytope>& pieces) {
    double sum = 0;
    for (const Polytope& p : pieces) sum += volume_of(corners_of(p));
    return sum;
}

Use l_of(SolidBuilder& b) {
    shape::Extrusion e{};
    e.profile = b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}})});
    e.z1 = 1;
    e.scale_top = Vec2(1);
    return use_of(b.shape(e));
}

CoverOptions options_for(SolidBuilder& b, double tolerance = 0.01) {
    return {tolerance, 1000, [&b](const Use& use) { return is_known_convex(b, use); }};
}

std::size_t capsules_in(const SolidBuilder& b, const Use& use) {
    std::size_t out = 0;
    for (const Use& part : std::get<Combination>(b.node(use.node)).operands)
        if (const auto* s = std::get_if<Shape>(&b.node(part.node)); s && std::holds_alternative<shape::Capsule>(*s)) ++out;
    return out;
}

}  // namespace

TEST_CASE("what a box leaves of another is cut into pieces of the volume that remains") {
    const Polytope block = polytope_of(box_corners(Vec3(0), Vec3(10)));
    const auto around = difference(block, planes_of(polytope_of(box_corners(Vec3(2), Vec3(5)))), 1e-12);
    CHECK(around.size() == 6);
    CHECK(volume_of(around) == Approx(1000 - 27).epsilon(1e-12));
    const auto corner = difference(block, planes_of(polytope_of(box_corners(Vec3(5), Vec3(12)))), 1e-12);
    CHECK(corner.size() == 3);
    CHECK(volume_of(corner) == Approx(1000 - 125).epsilon(1e-12));
    CHECK(difference(block, planes_of(polytope_of(box_corners(Vec3(11), Vec3(12)))), 1e-12) == std::vector<Polytope>{block});
    CHECK(difference(block, planes_of(polytope_of(box_corners(Vec3(-1), Vec3(12)))), 1e-12).empty());
}

TEST_CASE("a polytope cut by a plane through its corners keeps one of its halves") {
    const Polytope block = polytope_of(box_corners(Vec3(0), Vec3(1)));
    const double n = std::sqrt(0.5);
    const Polytope half = clipped(block, {{n, n, 0}, n}, 1e-12);
    CHECK(volume_of(corners_of(half)) == Approx(0.5).epsilon(1e-14));
    CHECK(convex_hull_of(corners_of(half))->points.size() == 6);  // a diagonal of a facet leaves one more in a side
    CHECK(clipped(block, {{1, 0, 0}, 1}, 1e-12) == block);
    CHECK(clipped(block, {{1, 0, 0}, 0}, 1e-12).empty());
}

TEST_CASE("covers are as few convex pieces as the shape has") {
    SolidBuilder b;
    const Use l = l_of(b), box = use_of(b.shape(shape::Box{Vec3(0), Vec3(9)})), ball = use_of(b.shape(shape::Ellipsoid{Vec3(5)}));
    const auto of_l = convex_cover(b, l, options_for(b));
    REQUIRE(of_l);
    CHECK(of_l->pieces.size() == 2);
    CHECK_FALSE(of_l->chords);
    const auto both = convex_cover(b, use_of(b.combine(SetOp::kUnion, {ball, use_of(l.node, Placement::translation({7, 0, 0}))})), options_for(b));
    REQUIRE(both);
    CHECK(both->pieces.size() == 3);
    CHECK_FALSE(both->chords);
    const auto cut = convex_cover(b, use_of(b.combine(SetOp::kDifference, {ball, box})), options_for(b));
    REQUIRE(cut);
    CHECK(cut->pieces.size() == 3);
    CHECK(cut->chords);
    const auto met = convex_cover(b, use_of(b.combine(SetOp::kIntersection, {l, use_of(box.node, Placement::translation({0, 2, 0}))})), options_for(b));
    REQUIRE(met);
    CHECK(met->pieces.size() == 1);
    CHECK_FALSE(convex_cover(b, use_of(b.shape(shape::Torus{50, 1})), {0.01, 10, [](const Use&) { return false; }}));
    CHECK_FALSE(convex_cover(b, use_of(b.shape(shape::HalfSpace{{0, 0, 1}, 0})), options_for(b)));
}

TEST_CASE("the pieces of a ring miss it by no more than the tolerance") {
    SolidBuilder b;
    const double tolerance = 0.02;
    const auto ring = convex_cover(b, use_of(b.shape(shape::Torus{10, 2})), options_for(b, tolerance));
    REQUIRE(ring);
    const std::size_t n = ring->pieces.size();
    CHECK(10 * (1 - std::cos(3.14159265358979 / static_cast<double>(n))) <= tolerance);
    CHECK(10 * (1 - std::cos(3.14159265358979 / static_cast<double>(n - 4))) > tolerance);
}

TEST_CASE("the sum of hulls of many points reaches as far as both together") {
    ConvexParts ball{{Vec3(0), {{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}}}, bar;
    for (const Vec3& p : box_corners(Vec3(-4, -1, -1), Vec3(4, 1, 1))) bar.push_back({p, {{{0.5, 0, 0}, {0, 1, 0}, {0, 0, 0.5}}}});
    const double tolerance = 0.01;
    const auto p = corners_within(ball, tolerance, 4000), q = corners_within(bar, tolerance, 40000);
    REQUIRE(p);
    REQUIRE(q);
    CHECK_FALSE(corners_within(bar, tolerance, 100));
    const auto sum = sum_of_hulls(*p, *q);
    REQUIRE(sum);
    CHECK(open_edges(*sum) == 0);
    CHECK(sum->points.size() < 10000);
    for (int i = 0; i < 300; ++i) {
        const double z = -1 + (2 * i + 1) / 300.0, a = 2.4 * i;
        const Vec3 n(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
        double most = -HUGE_VAL;
        for (const Vec3& x : sum->points) most = std::max(most, glm::dot(x, n));
        const double whole = reach(ball, n) + reach(bar, n);
        CHECK(most <= whole + 1e-12);
        CHECK(most >= whole - 4 * tolerance);  // both miss by chords both ways round
    }
}

TEST_CASE("a ball rounds the edges that stick out, not the hollow one and not those within a face") {
    SolidBuilder b;
    const Use l = l_of(b);
    const FacetList list = *facets_of(b.so_far(), l.node);
    const auto round = rounded_by_ball(b, list, {0, 0, 0}, 0.25, 1000);
    REQUIRE(round);
    CHECK(capsules_in(b, *round) == 17);
    const Bounds box = b.bounds(*round);
    CHECK(box.lo.x == Approx(-0.25));
    CHECK(box.hi.z == Approx(1.25));
    CHECK_FALSE(rounded_by_ball(b, list, {0, 0, 0}, 0.25, 10));
    FacetList open = list;
    open.facets.pop_back();
    CHECK_FALSE(rounded_by_ball(b, open, {0, 0, 0}, 0.25, 1000));
}
