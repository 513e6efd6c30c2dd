// shapes.cpp — the reference against closed forms, and the same solid written in different shapes: equal to the last bit on adversarial rays.
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "tests/reference/self/solids.h"
#include "tests/reference/shapes.h"

using namespace whittle;
using namespace whittle::reference;

namespace {

Ray ray(Vec3 o, Vec3 d) {
    Ray r;
    r.origin = o;
    r.direction = d;
    return r;
}

// Half the rays have small integer or half-integer numbers, so that they meet vertices, edges, faces and tangents of small integer solids.
Ray some_ray(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(-3, 3);
    std::uniform_int_distribution<int> coarse(-6, 6), kind(0, 3), way(-2, 2);
    Ray r;
    do {
        for (int i = 0; i < 3; ++i) {
            r.origin[i] = kind(random) == 0 ? uniform(random) : coarse(random) / 2.0;
            r.direction[i] = kind(random) == 0 ? uniform(random) : way(random);
        }
    } while (r.direction == Vec3(0));
    return r;
}

void check_same(const Solid& a, const Solid& b, int rays) {
    std::mt19937_64 random(Catch::rngSeed());
    const Evaluator left(a), right(b);
    int met = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray r = some_ray(random);
        const Borders x = left.borders(r), y = right.borders(r);
        met += !x.borders.empty();
        INFO("ray " << r.origin.x << " " << r.origin.y << " " << r.origin.z << "  " << r.direction.x << " " << r.direction.y << " " << r.direction.z);
        REQUIRE(same_borders(x, y));
    }
    CHECK(met > rays / 50);
}

NodeId centred_disc(SolidBuilder& b, double r, double x, double y) {
    return b.combine(SetOp::kUnion, {use_of(b.shape(shape::Disc{r}), Placement::translation({x, y, 0}))});
}

}  // namespace

TEST_CASE("a ball is met where the quadratic formula says") {
    const Evaluator e(single(shape::Ellipsoid{{2, 2, 2}}));
    CHECK(ts(e.borders(ray({-5, 0, 0}, {1, 0, 0}))) == std::vector<double>{3, 7});
    CHECK(ts(e.borders(ray({0, 0, 0}, {0, 0, 4}))) == std::vector<double>{0.5});
    CHECK(e.borders(ray({0, 0, 0}, {0, 0, 4})).starts_inside);
    CHECK(e.borders(ray({-5, 2, 0}, {1, 0, 0})).borders.empty());  // tangent
    const Borders b = e.borders(ray({-5, 1, 0}, {1, 0, 0}));
    REQUIRE(b.borders.size() == 2);
    CHECK(b.borders[0].hi - b.borders[0].lo <= Dyadic(0x1p-196));
    const Dyadic x = b.borders[0].lo - 5.0, y = b.borders[0].hi - 5.0;
    CHECK(Dyadic(3.0) <= x * x);  // x = -sqrt 3
    CHECK(y * y <= Dyadic(3.0));
}

TEST_CASE("borders at t = 0 count when they enter") {
    const Evaluator e(single(shape::Box{{0, 0, 0}, {1, 1, 1}}));
    const Borders in = e.borders(ray({0, 0.5, 0.5}, {1, 0, 0}));
    CHECK(in.starts_inside);
    REQUIRE(in.borders.size() == 2);
    CHECK(in.borders[0].entering);
    CHECK(in.borders[0].lo.is_zero());
    const Borders out = e.borders(ray({1, 0.5, 0.5}, {1, 0, 0}));
    CHECK_FALSE(out.starts_inside);
    CHECK(out.borders.empty());
    const Borders from = e.borders(ray({0.5, 0.5, 0.5}, {1, 0, 0}));
    CHECK(from.starts_inside);
    CHECK(ts(from) == std::vector<double>{0.5});
}

TEST_CASE("a ray in a face sees the side it is nudged to, the same for both solids at the face") {
    const Ray in_face = ray({-1, 0.5, 1}, {1, 0, 0});  // nudged to z > 1
    CHECK(Evaluator(single(shape::Box{{0, 0, 0}, {1, 1, 1}})).borders(in_face).borders.empty());
    CHECK(ts(Evaluator(single(shape::Box{{0, 0, 1}, {1, 1, 2}})).borders(in_face)) == std::vector<double>{1, 2});
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{{0, 0, 0}, {1, 1, 1}});
    const NodeId stack = b.combine(SetOp::kUnion, {use_of(box), use_of(box, Placement::translation({0, 0, 1}))});
    CHECK(ts(Evaluator(b.finish(use_of(stack))).borders(in_face)) == std::vector<double>{1, 2});
}

TEST_CASE("a generator of a cylinder and of a cone take the nudged side") {
    const Evaluator cylinder(single(shape::Frustum{0, 2, 1, 1}));
    CHECK(cylinder.borders(ray({1, 0, -1}, {0, 0, 1})).borders.empty());
    CHECK(ts(cylinder.borders(ray({-1, 0, -1}, {0, 0, 1}))) == std::vector<double>{1, 3});
    const Evaluator cone(single(shape::Frustum{0, 2, 2, 0}));
    CHECK(cone.borders(ray({2, 0, 0}, {-1, 0, 1})).borders.empty());
    CHECK(ts(cone.borders(ray({-2, 0, 0}, {1, 0, 1}))) == std::vector<double>{0, 2});
}

TEST_CASE("coincident faces are one event") {
    SolidBuilder b;
    const NodeId plate = b.shape(shape::Box{{-2, -2, 0}, {2, 2, 1}});
    const NodeId bore = b.shape(shape::Frustum{0, 1, 1, 1});
    const NodeId drilled = b.combine(SetOp::kDifference, {use_of(plate), use_of(bore)});
    const Solid solid = b.finish(use_of(drilled));
    const Evaluator e(solid);
    CHECK(e.leaf_count() == 2);
    CHECK(e.borders(ray({0.5, 0, -1}, {0, 0, 1})).borders.empty());
    CHECK(ts(e.borders(ray({1.5, 0, -1}, {0, 0, 1}))) == std::vector<double>{1, 2});
    CHECK(ts(e.borders(ray({-3, 0, 0.5}, {1, 0, 0}))) == std::vector<double>{1, 2, 4, 5});
    CHECK(e.borders(ray({-3, 0, 0.5}, {1, 0, 0})).borders[1].leaves == std::vector<std::uint32_t>{1});
}

TEST_CASE("a torus is met up to four times, a spindle is filled") {
    const Evaluator ring(single(shape::Torus{3, 1}));
    CHECK(ts(ring.borders(ray({-5, 0, 0}, {1, 0, 0}))) == std::vector<double>{1, 3, 7, 9});
    CHECK(ring.borders(ray({-5, 0, 1}, {1, 0, 0})).borders.empty());
    CHECK(ts(ring.borders(ray({3, 0, -2}, {0, 0, 1}))) == std::vector<double>{1, 3});
    const Evaluator spindle(single(shape::Torus{1, 2}));
    CHECK(ts(spindle.borders(ray({-5, 0, 0}, {1, 0, 0}))) == std::vector<double>{2, 8});
    const std::vector<double> axis = ts(spindle.borders(ray({0, 0, -5}, {0, 0, 1})));
    REQUIRE(axis.size() == 2);
    CHECK(axis[0] == Approx(5 - std::sqrt(3)));
}

TEST_CASE("the same solid in different shapes gives the same borders") {
    const Solid box = single(shape::Box{{-1, -1, -1}, {1, 2, 1}});
    SECTION("box and polyhedron") { check_same(box, single(shape::Polyhedron{box_mesh({-1, -1, -1}, {1, 2, 1})}), 400); }
    SECTION("box and extruded rectangle") {
        SolidBuilder b;
        check_same(box, b.finish(use_of(b.shape(shape::Extrusion{b.shape(shape::Rectangle{{-1, -1}, {1, 2}}), -1, 1, 0, {1, 1}, 0}))), 400);
    }
    SECTION("box and extruded polygon") {
        SolidBuilder b;
        const auto contour = std::make_shared<std::vector<std::vector<Vec2>>>(1, std::vector<Vec2>{{-1, -1}, {1, -1}, {1, 2}, {-1, 2}});
        check_same(box, b.finish(use_of(b.shape(shape::Extrusion{b.shape(shape::Polygon{contour}), -1, 1, 0, {1, 1}, 0}))), 400);
    }
    SECTION("ball, ellipsoid placed by a scale, quadric") {
        const Solid egg = single(shape::Ellipsoid{{1, 2, 0.5}});
        check_same(egg, single(shape::Ellipsoid{{1, 1, 1}}, rows({1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0.5, 0})), 200);
        check_same(egg, single(shape::Quadric{{4, 1, 16, 0, 0, 0, 0, 0, 0, -4}}), 200);
    }
    SECTION("torus and revolved disc, also a spindle") {
        for (const double minor : {0.5, 1.0, 1.5}) {
            SolidBuilder b;
            check_same(single(shape::Torus{1, minor}), b.finish(use_of(b.shape(shape::Revolution{centred_disc(b, minor, 1, 0), 0, 360, 0}))), 200);
        }
    }
    SECTION("cylinder, revolved rectangle, revolved polygon, extruded disc") {
        const Solid cylinder = single(shape::Frustum{-1, 1, 1, 1});
        SolidBuilder b, c, d;
        check_same(cylinder, b.finish(use_of(b.shape(shape::Revolution{b.shape(shape::Rectangle{{0, -1}, {1, 1}}), 0, 360, 0}))), 200);
        const auto contour = std::make_shared<std::vector<std::vector<Vec2>>>(1, std::vector<Vec2>{{0, -1}, {1, -1}, {1, 1}, {0, 1}});
        check_same(cylinder, c.finish(use_of(c.shape(shape::Revolution{c.shape(shape::Polygon{contour}), 0, 360, 0}))), 200);
        check_same(cylinder, d.finish(use_of(d.shape(shape::Extrusion{d.shape(shape::Disc{1}), -1, 1, 0, {1, 1}, 0}))), 200);
    }
    SECTION("cone, revolved triangle, extruded disc that shrinks to a point") {
        const Solid cone = single(shape::Frustum{0, 2, 2, 0});
        SolidBuilder b, c;
        const auto contour = std::make_shared<std::vector<std::vector<Vec2>>>(1, std::vector<Vec2>{{0, 0}, {2, 0}, {0, 2}});
        check_same(cone, b.finish(use_of(b.shape(shape::Revolution{b.shape(shape::Polygon{contour}), 0, 360, 0}))), 200);
        check_same(cone, c.finish(use_of(c.shape(shape::Extrusion{c.shape(shape::Disc{2}), 0, 2, 0, {0, 0}, 0}))), 200);
    }
    SECTION("extrusion scaled differently in x and y, and a polyhedron") {
        SolidBuilder b;
        auto m = std::make_shared<FacetList>(*box_mesh({-1, -1, -1}, {1, 1, 1}));
        for (Vec3& p : m->points)
            if (p.z > 0) p.x *= 0.5;
        check_same(b.finish(use_of(b.shape(shape::Extrusion{b.shape(shape::Rectangle{{-1, -1}, {1, 1}}), -1, 1, 0, {0.5, 1}, 0}))),
                   single(shape::Polyhedron{m}), 300);
    }
    SECTION("capsule of no length of straight part and rounded cube of no flat part") {
        check_same(single(shape::Ellipsoid{{1, 1, 1}}), single(shape::RoundBox{{-1, -1, -1}, {1, 1, 1}, 1}), 200);
        check_same(single(shape::Capsule{{0, 0, -1}, {0, 0, 1}, 1}), single(shape::RoundBox{{-1, -1, -2}, {1, 1, 2}, 1}), 200);
    }
    SECTION("partial turns are parts of the full one") {
        for (const double angle : {90.0, 180.0, 270.0}) {
            SolidBuilder b, c;
            const NodeId whole = b.shape(shape::Frustum{-1, 1, 1, 1});
            const NodeId x = b.shape(shape::HalfSpace{{-1, 0, 0}, 0}), y = b.shape(shape::HalfSpace{{0, -1, 0}, 0});
            const std::vector<Use> wedge = angle == 90 ? std::vector<Use>{use_of(x), use_of(y)} : std::vector<Use>{use_of(y)};
            NodeId part = b.combine(SetOp::kIntersection, wedge);
            if (angle == 270) {
                const NodeId neg_x = b.shape(shape::HalfSpace{{1, 0, 0}, 0});
                part = b.combine(SetOp::kUnion, {use_of(y), use_of(neg_x)});
            }
            const NodeId cut = b.combine(SetOp::kIntersection, {use_of(whole), use_of(part)});
            check_same(b.finish(use_of(cut)), c.finish(use_of(c.shape(shape::Revolution{c.shape(shape::Rectangle{{0, -1}, {1, 1}}), 0, angle, 0}))), 200);
        }
    }
}

TEST_CASE("placements are pulled back exactly, mirrors and shears too") {
    const Placement shear = rows({2, 1, 0, 1, 0, -1, 0.5, 0, 0, 0, 1, -1});
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{{-1, -1, -1}, {1, 1, 1}});
    auto m = std::make_shared<FacetList>(*box_mesh({-1, -1, -1}, {1, 1, 1}));
    for (Vec3& p : m->points) p = apply_to_point(shear, p);
    check_same(b.finish(use_of(box, shear)), single(shape::Polyhedron{m}), 300);
}

TEST_CASE("a chain of rotations is rounded once, and fuses with the rotation it equals") {
    const double s = std::sqrt(3) / 2;
    const Placement r30 = rows({s, -0.5, 0, 0, 0.5, s, 0, 0, 0, 0, 1, 0}), r60 = rows({0.5, -s, 0, 0, s, 0.5, 0, 0, 0, 0, 1, 0});
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{{-1, -1, -1}, {1, 1, 1}});
    const NodeId twice = b.combine(SetOp::kUnion, {use_of(b.combine(SetOp::kUnion, {use_of(box, r30)}), r30)});
    const NodeId nothing = b.combine(SetOp::kDifference, {use_of(twice), use_of(box, r60)});
    const Solid solid = b.finish(use_of(nothing));
    Options fused;
    fused.fuse = 1e-13;
    CHECK(tree_of(solid).formulas.fuse(1e-13) == 4);
    CHECK(Evaluator(solid, fused).borders(ray({-3, 0.1, 0.2}, {1, 0.1, 0})).borders.empty());
    Options unrounded;
    unrounded.round_chains = false;
    CHECK_FALSE(Evaluator(solid, unrounded).borders(ray({-3, 0.1, 0.2}, {1, 0.1, 0})).borders.empty());
}
