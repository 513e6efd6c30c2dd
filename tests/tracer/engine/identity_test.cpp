// identity_test.cpp — coinciding surfaces are one: across instances, frames and ways of writing.
#include <catch2/catch.hpp>

#include "csg/base/degrees.h"
#include "tests/tracer/engine/rays.h"
#include "tracer/engine/engine.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

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

const Placement kTurn{{0.82677959106982157, -0.56054089667657359, -0.047216638417421436, 0.3, 0.48442422807701524, 0.75214408342758576, -0.44678008574338313,
                       -0.7, 0.28595222510483553, 0.34651577297130326, 0.89339696889999232, 0.1}};

}  // namespace

TEST_CASE("a block of abutting cubes has the spans of one cube, to the bit") {
    const int n = 20;
    const auto many = compiled(cubes(n, kTurn, false)), one = compiled(cubes(n, kTurn, true));
    Scratch s;
    Spans a, b;
    Random random(7);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = random.ray_through(program_bounds(*one));
        all_spans(*many, ray, s, a);
        all_spans(*one, ray, s, b);
        REQUIRE(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            REQUIRE(a[k].in.has_value() == b[k].in.has_value());
            if (a[k].in) REQUIRE(a[k].in->t == b[k].in->t);
            REQUIRE(a[k].out->t == b[k].out->t);
        }
        hits += !a.empty();
    }
    CHECK(hits > 5000);
    CHECK(s.counters.escalated_exact == 0);
}

TEST_CASE("a solid less itself is empty, across instances and frames") {
    SolidBuilder b;
    const NodeId cube = b.shape(shape::Box{Vec3(0), Vec3(1)});
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(1)});
    const NodeId ring = b.shape(shape::Torus{1, 0.25});
    const NodeId pin = b.shape(shape::Frustum{-1, 1, 0.5, 0.75});
    const auto turn = [](double deg) { return Placement{{cosd(deg), -sind(deg), 0, 0, sind(deg), cosd(deg), 0, 0, 0, 0, 1, 0}}; };
    for (const NodeId shape : {cube, ball, ring, pin}) {
        SolidBuilder c;
        const NodeId same = c.shape(std::get<Shape>(b.finish({shape, 0, 0, {}}).node(shape)));
        const NodeId twice = c.combine(SetOp::kUnion, {{same, 0, 0, turn(30)}});
        const NodeId d = c.combine(SetOp::kDifference, {{twice, 0, 0, turn(30)}, {same, 0, 0, turn(60)}});
        const auto program = compiled(c.finish({d, 0, 0, {}}));
        Scratch s;
        Spans spans;
        Random random(11);
        for (int i = 0; i < 2000; ++i) {
            all_spans(*program, random.ray_through({Vec3(-1.5), Vec3(1.5)}), s, spans);
            REQUIRE(spans.empty());
        }
        b = SolidBuilder();
        b.shape(shape::Box{Vec3(0), Vec3(1)});
        b.shape(shape::Ellipsoid{Vec3(1)});
        b.shape(shape::Torus{1, 0.25});
        b.shape(shape::Frustum{-1, 1, 0.5, 0.75});
    }
}
