// identity_test.cpp — coinciding surfaces are one: across instances, frames and ways of writing.
#include <catch2/catch.hpp>

#include "csg/base/degrees.h"
#include "tests/tracer/engine/rays.h"
#include "tracer/engine/engine.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

Use use(NodeId id) { return {id, 0, 0, {}}; }

// nested for loops of unit cubes under a rotation, or one cube.
Solid cubes(int n, const Placement& turn, bool as_one) {
    SolidBuilder b;
    if (as_one) {
        const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(n)});
        return b.finish({cube, 0, 0, turn});
    }
    const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(1)});
    std::vector<Use> planes;
    for (int i = 0; i < n; ++i) {
        std::vector<Use> rows;
        for (int j = 0; j < n; ++j) {
            std::vector<Use> cells;
            for (int k = 0; k < n; ++k) cells.push_back({cube, 0, 0, Placement::translation({i, j, k})});
            rows.push_back({b.combine(SetOp::kUnion, cells), 0, 0, {}});
        }
        planes.push_back({b.combine(SetOp::kUnion, rows), 0, 0, {}});
    }
    return b.finish({b.combine(SetOp::kUnion, planes), 0, 0, turn});
}

void same_spans(const Program& many, const Program& one, int rays, Scratch& s, int& hits) {
    Spans a, b;
    Random random(7);
    for (int i = 0; i < rays; ++i) {
        const Ray ray = random.ray_through(program_bounds(one));
        all_spans(many, ray, s, a);
        all_spans(one, ray, s, b);
        REQUIRE(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            REQUIRE(a[k].in.has_value() == b[k].in.has_value());
            if (a[k].in) REQUIRE(a[k].in->t == b[k].in->t);
            REQUIRE(a[k].out->t == b[k].out->t);
        }
        hits += a.empty() ? 0 : 1;
    }
}

const Placement kTurn{{0.82677959106982157, -0.56054089667657359, -0.047216638417421436, 0.3, 0.48442422807701524, 0.75214408342758576, -0.44678008574338313,
                       -0.7, 0.28595222510483553, 0.34651577297130326, 0.89339696889999232, 0.1}};

}  // namespace

TEST_CASE("a block of abutting cubes has the spans of one cube, to the bit") {
    const int n = 20;
    const auto many = compiled(cubes(n, kTurn, false)), one = compiled(cubes(n, kTurn, true));
    Scratch s;
    int hits = 0;
    same_spans(*many, *one, 20000, s, hits);
    CHECK(hits > 5000);
    CHECK(s.counters.escalated_exact == 0);
}

TEST_CASE("a million abutting cubes under a rotation are one cube") {
    const int n = 100;
    const auto many = compiled(cubes(n, kTurn, false)), one = compiled(cubes(n, kTurn, true));
    CHECK(build_report(*many).classes == 3u * (n + 1));
    Scratch s;
    int hits = 0;
    same_spans(*many, *one, 300, s, hits);
    CHECK(hits > 60);
    CHECK(s.counters.escalated_exact == 0);
}

namespace {

// The shapes of the next test; each keeps to the box of side 3 about the origin.
std::vector<Shape> some_shapes() {
    FacetList wedge{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    return {shape::Box{Vec3(0), Vec3(1)},
            shape::Ellipsoid{Vec3(1)},
            shape::Ellipsoid{Vec3(1, 0.5, 0.75)},
            shape::Torus{1, 0.25},
            shape::Torus{0.5, 0.75},
            shape::Frustum{-1, 1, 0.5, 0.5},
            shape::Frustum{-1, 1, 0.5, 0.75},
            shape::Capsule{Vec3(0), Vec3(0.3, 0.4, 0.5), 0.25},
            shape::RoundBox{Vec3(-1), Vec3(1), 0.25},
            shape::FacetedFrustum{-1, 1, 1, 1, 7},
            shape::FacetedBall{1, 8},
            shape::Polyhedron{std::make_shared<const FacetList>(wedge)}};
}

Placement about_z(double deg) { return {{cosd(deg), -sind(deg), 0, 0, sind(deg), cosd(deg), 0, 0, 0, 0, 1, 0}}; }

}  // namespace

TEST_CASE("a solid less itself is empty, in one frame and written by another rotation") {
    for (const Shape& shape : some_shapes()) {
        INFO("shape " << shape.index());
        SolidBuilder b;
        const NodeId id = b.shape(shape);
        const NodeId twice = b.combine(SetOp::kUnion, {{id, 0, 0, about_z(30)}});
        const NodeId d = b.combine(SetOp::kDifference, {{twice, 0, 0, about_z(30)}, {id, 0, 0, about_z(60)}});
        const auto program = compiled(b.finish({d, 0, 0, {}}));
        Scratch s;
        Spans spans;
        Random random(11);
        for (int i = 0; i < 2000; ++i) {
            all_spans(*program, random.ray_through({Vec3(-1.5), Vec3(1.5)}), s, spans);
            REQUIRE(spans.empty());
        }
    }
}

TEST_CASE("parts that stand on one plane, turned about its normal, share it however far apart they are") {
    SolidBuilder b;
    const NodeId block = b.shape(shape::Box{Vec3(0), Vec3(1, 2, 3)});
    std::vector<Use> parts;
    for (int i = 0; i < 10; ++i) {
        Placement p = about_z(13 * i + 5);
        p.m[3] = 7 * i;
        p.m[11] = 0.25;
        parts.push_back({block, 0, 0, p});
    }
    const auto program = compiled(b.finish({b.combine(SetOp::kUnion, parts), 0, 0, {}}));
    CHECK(build_report(*program).classes == 10 * 4 + 2);
    CHECK(build_report(*program).snap_fused == 0);
    Scratch s;
    Spans spans;
    for (int i = 0; i < 10; ++i) {
        const double turn = 13 * i + 5;
        all_spans(*program, {{7.0 * i + 0.5 * cosd(turn) - sind(turn), 0.5 * sind(turn) + cosd(turn), -1}, {0.01, 0.01, 1}}, s, spans);
        REQUIRE(spans.size() == 1);
        CHECK(spans[0].in->t == 1.25);
        CHECK(spans[0].in->normal == Vec3(0, 0, -1));
    }
}

TEST_CASE("a cutter flush with a face leaves it open, in every frame") {
    for (const Placement& turn : {Placement{}, kTurn}) {
        SolidBuilder b;
        const NodeId block = b.shape(shape::Box{Vec3(-1), Vec3(1)}), cutter = b.shape(shape::Box{Vec3(-0.5, -0.6, 0.1), Vec3(0.7, 0.4, 1)});
        const auto program = compiled(b.finish({b.combine(SetOp::kDifference, {use(block), use(cutter)}), 0, 0, turn}));
        Scratch s;
        Spans spans;
        Random random(5);
        for (int i = 0; i < 2000; ++i) {
            // Down into the pocket, in the block's own coordinates.
            Ray ray;
            ray.origin = apply_to_point(turn, {random.between(-0.45, 0.65), random.between(-0.55, 0.35), 3});
            ray.direction = apply_to_direction(turn, {random.between(-0.001, 0.001), random.between(-0.001, 0.001), -1});
            all_spans(*program, ray, s, spans);
            REQUIRE(spans.size() == 1);
            REQUIRE(spans[0].in->t == Approx(2.9).epsilon(1e-12));
        }
        CHECK(s.counters.escalated_exact == 0);
    }
}

TEST_CASE("a shape without facets is nothing, and cuts nothing away") {
    SolidBuilder b;
    const NodeId small = b.shape(shape::Disc{1}), large = b.shape(shape::Disc{2});
    const NodeId nothing = b.combine(SetOp::kDifference, {use(small), {large, 0, 0, Placement::translation({0.5, 0, 0})}});
    const NodeId cone = b.shape(shape::Extrusion{nothing, 0, 1, 0, Vec2(0.5), 0});
    const NodeId block = b.shape(shape::Box{Vec3(-1), Vec3(1)});
    const auto program = compiled(b.finish(use(b.combine(SetOp::kDifference, {use(block), use(cone)}))));
    Scratch s;
    Spans spans;
    Ray ray;
    ray.origin = {0.1, 0.2, -3};
    all_spans(*program, ray, s, spans);
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].out->t == 4);
}

TEST_CASE("a hair-thin tube keeps its wall: the snap measures distance, not coefficients") {
    SolidBuilder b;
    const NodeId outer = b.shape(shape::Frustum{0, 1, 2e-7, 2e-7}), inner = b.shape(shape::Frustum{-1, 2, 1e-7, 1e-7});
    const auto program = compiled(b.finish(use(b.combine(SetOp::kDifference, {use(outer), use(inner)}))));
    CHECK(build_report(*program).snap_fused == 0);
    Scratch s;
    Spans spans;
    Ray ray;
    ray.origin = {-1, 0, 0.5};
    ray.direction = {1, 0, 1e-3};
    all_spans(*program, ray, s, spans);
    CHECK(spans.size() == 2);
}

TEST_CASE("instances that touch along a face are whole, also when each has a frame of its own") {
    SolidBuilder b;
    const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(1)});
    const NodeId turned = b.combine(SetOp::kUnion, {{cube, 0, 0, about_z(30)}});
    // The second cube is the first, moved by the turned x axis: written as a move behind the turn and as one in front of it.
    const NodeId moved = b.combine(SetOp::kUnion, {{cube, 0, 0, Placement::translation({1, 0, 0})}});
    const NodeId behind = b.combine(SetOp::kUnion, {use(turned), {moved, 0, 0, about_z(30)}});
    const NodeId before = b.combine(SetOp::kUnion, {use(turned), {turned, 0, 0, Placement::translation({cosd(30), sind(30), 0})}});
    const NodeId whole = b.shape(shape::Box{Vec3(0), Vec3(2, 1, 1)});
    const NodeId one = b.combine(SetOp::kUnion, {{whole, 0, 0, about_z(30)}});
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(behind), {before, 0, 0, Placement::translation({10, 0, 0})}, {one, 0, 0, Placement::translation({20, 0, 0})}})));
    const auto program = compiled(solid);
    Scratch s;
    Spans spans;
    Random random(9);
    for (int i = 0; i < 3000; ++i) {
        const double x = random.between(0.02, 1.98), y = random.between(0.02, 0.98);
        for (const double at : {0.0, 10.0, 20.0}) {
            Ray ray;
            ray.origin = apply_to_point(about_z(30), {x, y, 3}) + Vec3(at, 0, 0);
            ray.direction = apply_to_direction(about_z(30), {random.between(-0.005, 0.005), 0, -1});
            all_spans(*program, ray, s, spans);
            REQUIRE(spans.size() == 1);
        }
    }
}

namespace {

// Rays of 2000 that meet anything of the difference of two placed shapes.
int rays_that_meet(const Shape& shape, const Placement& first, const Shape& other, const Placement& second) {
    SolidBuilder b;
    const NodeId x = b.combine(SetOp::kUnion, {{b.shape(shape), 0, 0, first}}), y = b.combine(SetOp::kUnion, {{b.shape(other), 0, 0, second}});
    const auto program = compiled(b.finish(use(b.combine(SetOp::kDifference, {use(x), use(y)}))));
    Scratch s;
    Spans spans;
    Random random(3);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = random.ray_through({Vec3(-2), Vec3(2)});
        Hit hit;
        all_spans(*program, ray, s, spans);
        met += !spans.empty();
        REQUIRE(first_hit(*program, ray, HUGE_VAL, s, hit) == !spans.empty());
    }
    return met;
}

Placement stretched(const Placement& p, double x, double y, double z) { return p * Placement{{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0}}; }

}  // namespace

TEST_CASE("a torus stretched across its axis is not the round one") {
    const shape::Torus torus{1, 0.25};
    CHECK(rays_that_meet(torus, stretched({}, 0.5, 1.1, 1), torus, {}) > 100);
    CHECK(rays_that_meet(torus, {}, torus, stretched({}, 1.125, 1, 1)) > 100);
}

TEST_CASE("a torus is the same whether its frame is scaled, stretched or its radii are") {
    const shape::Torus torus{1, 0.25}, large{1.5, 0.375};
    CHECK(rays_that_meet(torus, stretched(about_z(30) * about_z(30), 1.5, 1.5, 1.5), large, about_z(60)) == 0);
    CHECK(rays_that_meet(large, about_z(60), torus, stretched(about_z(30) * about_z(30), 1.5, 1.5, 1.5)) == 0);
    CHECK(rays_that_meet(torus, stretched(about_z(45), 1, 1, 2), torus, stretched(about_z(20), 1, 1, 2)) == 0);
}
