#include "csg/solid/solid.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace whittle;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

Use use_of(NodeId node, Vec3 at = Vec3(0)) {
    Use use;
    use.node = node;
    use.placement = Placement::translation(at);
    return use;
}
NodeId cube(SolidBuilder& b, double size) { return b.shape(shape::Box{Vec3(0), Vec3(size)}); }
NodeId ball(SolidBuilder& b, double r) { return b.shape(shape::Ellipsoid{Vec3(r)}); }
const Combination& combination(const SolidBuilder& b, NodeId id) { return std::get<Combination>(b.node(id)); }
// A quarter turn about z and a turn that no double holds.
const Placement kQuarter{{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}};
const Placement kTurned{{0.8, -0.6, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0}};

}  // namespace

TEST_CASE("a shape made twice is one node") {
    SolidBuilder b;
    CHECK(cube(b, 3) == cube(b, 3));
    CHECK(cube(b, 3) != cube(b, 4));
    CHECK(b.shape(shape::Box{Vec3(-0.0), Vec3(3)}) == cube(b, 3));
    CHECK(b.shape(shape::Disc{3}) != b.shape(shape::FacetedBall{3, 3}));
    const auto mesh = [] { return std::make_shared<FacetList>(FacetList{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}); };
    CHECK(b.shape(shape::Polyhedron{mesh()}) == b.shape(shape::Polyhedron{mesh()}));
}

TEST_CASE("a set operation made twice is one node") {
    SolidBuilder b;
    const auto make = [&] { return b.combine(SetOp::kDifference, {use_of(cube(b, 3)), use_of(ball(b, 1))}); };
    CHECK(make() == make());
}

TEST_CASE("a solid less itself is empty") {
    SolidBuilder b;
    const NodeId a = ball(b, 2);
    CHECK(b.combine(SetOp::kDifference, {use_of(a, {1, 2, 3}), use_of(a, {1, 2, 3})}) == kEmptyNode);
    CHECK(b.combine(SetOp::kDifference, {use_of(a), use_of(a, {1e-9, 0, 0})}) != kEmptyNode);
}

TEST_CASE("a solid less itself is empty whatever its labels") {
    SolidBuilder b;
    const auto drilled = [&](std::uint32_t line) {
        Use cutter = use_of(ball(b, 1));
        cutter.label = b.label({{}, {0, line, 1}, ""});
        return b.combine(SetOp::kDifference, {use_of(cube(b, 3)), cutter});
    };
    REQUIRE(drilled(1) != drilled(2));
    CHECK(b.combine(SetOp::kDifference, {use_of(drilled(1)), use_of(drilled(2))}) == kEmptyNode);
}

TEST_CASE("nothing absorbs in an intersection and vanishes from a union") {
    SolidBuilder b;
    const NodeId a = cube(b, 3);
    CHECK(b.combine(SetOp::kUnion, {}) == kEmptyNode);
    CHECK(b.combine(SetOp::kUnion, {use_of(kEmptyNode), use_of(a)}) == a);
    CHECK(b.combine(SetOp::kIntersection, {use_of(a), use_of(kEmptyNode)}) == kEmptyNode);
    CHECK(b.combine(SetOp::kDifference, {use_of(a), use_of(kEmptyNode)}) == a);
    CHECK(b.combine(SetOp::kDifference, {use_of(kEmptyNode), use_of(a)}) == kEmptyNode);
}

TEST_CASE("equal operands of a union count once, many or few") {
    SolidBuilder b;
    const NodeId a = ball(b, 1);
    CHECK(b.combine(SetOp::kUnion, {use_of(a), use_of(a)}) == a);
    CHECK(b.combine(SetOp::kIntersection, {use_of(a), use_of(a)}) == a);
    std::vector<Use> many;
    for (int i = 0; i < 1000; ++i) many.push_back(use_of(a, {3.0 * (i % 250), 0, 0}));
    CHECK(combination(b, b.combine(SetOp::kUnion, many)).operands.size() == 250);
}

TEST_CASE("equal glasses of different matter stay two, equal opaque ones become one") {
    SolidBuilder b;
    const auto of = [&](const char* preset) {
        Use use = use_of(ball(b, 1));
        Material m;
        m.preset = preset;
        use.label = b.label({m, {}, ""});
        return use;
    };
    CHECK(combination(b, b.combine(SetOp::kUnion, {of("glass"), of("water")})).operands.size() == 2);
    CHECK(combination(b, b.combine(SetOp::kUnion, {of("gold"), of("steel")})).operands.size() == 1);
}

TEST_CASE("nested unions, intersections and differences are one list") {
    SolidBuilder b;
    const Use x = use_of(ball(b, 1)), y = use_of(ball(b, 1), {1, 0, 0}), z = use_of(ball(b, 1), {0, 1, 0});
    const NodeId flat_union = b.combine(SetOp::kUnion, {x, y, z});
    CHECK(b.combine(SetOp::kUnion, {use_of(b.combine(SetOp::kUnion, {x, y})), z}) == flat_union);
    const NodeId flat_meet = b.combine(SetOp::kIntersection, {x, y, z});
    CHECK(b.combine(SetOp::kIntersection, {x, use_of(b.combine(SetOp::kIntersection, {y, z}))}) == flat_meet);
    const NodeId flat_less = b.combine(SetOp::kDifference, {x, y, z});
    CHECK(b.combine(SetOp::kDifference, {use_of(b.combine(SetOp::kDifference, {x, y})), z}) == flat_less);
    CHECK(b.combine(SetOp::kDifference, {x, use_of(b.combine(SetOp::kUnion, {y, z}))}) == flat_less);
    CHECK(b.combine(SetOp::kDifference, {x, use_of(b.combine(SetOp::kDifference, {y, z}))}) != flat_less);
}

TEST_CASE("what boxes decide is decided: cutters that miss, parts that do not meet, parts that are buried") {
    SolidBuilder b;
    const Use big = use_of(cube(b, 10)), inner = use_of(ball(b, 1), {5, 5, 5}), beside = use_of(cube(b, 10), {10, 0, 0});
    CHECK(b.combine(SetOp::kDifference, {big, beside}) == big.node);
    CHECK(b.combine(SetOp::kIntersection, {big, beside}) == kEmptyNode);
    CHECK(b.combine(SetOp::kUnion, {inner, big}) == big.node);
    CHECK(b.combine(SetOp::kDifference, {inner, big}) == kEmptyNode);
    CHECK(combination(b, b.combine(SetOp::kUnion, {big, beside})).operands.size() == 2);
    CHECK(b.skipped().disjoint == 3);
    CHECK(b.skipped().buried == 3);
}

TEST_CASE("a disabled pass leaves the operands") {
    SolidPasses none;
    none.equal = none.disjoint = none.buried = false;
    SolidBuilder b(none);
    const Use big = use_of(cube(b, 10)), inner = use_of(ball(b, 1), {5, 5, 5}), beside = use_of(cube(b, 10), {20, 0, 0});
    CHECK(combination(b, b.combine(SetOp::kUnion, {big, inner, inner})).operands.size() == 3);
    CHECK(combination(b, b.combine(SetOp::kDifference, {big, beside})).operands.size() == 2);
}

TEST_CASE("placements fold where no digit is lost and stay a chain elsewhere") {
    SolidBuilder b;
    const Use ball_at = use_of(ball(b, 1), {1, 2, 3});
    CHECK(b.placed(Placement::translation({10, 0, 0}), ball_at) == use_of(ball(b, 1), {11, 2, 3}));
    CHECK(b.placed(kQuarter, ball_at).node == ball_at.node);
    const Use far = b.placed(Placement::translation({0.1, 0, 0}), use_of(ball(b, 1), {0.2, 0, 0}));
    CHECK(far.node != ball_at.node);
    CHECK(combination(b, far.node).operands == std::vector<Use>{use_of(ball(b, 1), {0.2, 0, 0})});
    CHECK(b.placed(kTurned, b.placed(kTurned, ball_at)).node != ball_at.node);
}

TEST_CASE("the outer material wins parameter by parameter and the inner place stays") {
    SolidBuilder b;
    Material red, rough;
    red.color = Vec4(1, 0, 0, 1);
    rough.color = Vec4(0, 1, 0, 1);
    rough.roughness = 0.5;
    Use use = b.labelled({rough, {0, 7, 3}, ""}, use_of(ball(b, 1)));
    use = b.labelled({red, {}, "knob"}, use);
    const Label& label = b.label_of(use.label);
    CHECK(*label.material.color == Vec4(1, 0, 0, 1));
    CHECK(*label.material.roughness == 0.5);
    CHECK(label.place.line == 7);
    CHECK(label.part == "knob");
}

TEST_CASE("boxes are exact where arithmetic is and contain everything where it is not") {
    SolidBuilder b;
    const NodeId a = cube(b, 3);
    CHECK(b.bounds(use_of(a, {1, 2, 3})) == Bounds{{1, 2, 3}, {4, 5, 6}});
    const Bounds far = b.bounds(use_of(b.shape(shape::Box{{0.1, 0, 0}, {0.3, 1, 1}}), {1e6, 0, 0}));
    CHECK(static_cast<long double>(far.lo.x) <= 1e6L + static_cast<long double>(0.1));
    CHECK(static_cast<long double>(far.hi.x) >= 1e6L + static_cast<long double>(0.3));
    CHECK(far.hi.x - far.lo.x < 0.2 + 1e-9);
    CHECK(b.bounds(b.shape(shape::HalfSpace{{0, 0, 2}, 3})).hi.z == Approx(1.5));
    CHECK(b.bounds(b.shape(shape::HalfSpace{{0, 1, 2}, 3})).hi.z == kInf);
    const NodeId cut = b.combine(SetOp::kIntersection, {use_of(a), use_of(b.shape(shape::HalfSpace{{0, 0, 1}, 2}))});
    CHECK(b.bounds(cut).lo == Vec3(0));
    CHECK(b.bounds(cut).hi.z == Approx(2));
    CHECK(b.bounds(b.combine(SetOp::kDifference, {use_of(a), use_of(ball(b, 2))})) == b.bounds(a));
}

TEST_CASE("a quadric has a box where it is an ellipsoid, none where it is not, and may be nothing") {
    SolidBuilder b;
    // (x-1)^2 + 4 y^2 + 9 (z+2)^2 <= 36
    const Bounds box = b.bounds(b.shape(shape::Quadric{{1, 4, 9, 0, 0, 0, -2, 0, 36, 1}}));
    CHECK(box.lo.x <= -5);
    CHECK(box.lo.x == Approx(-5));
    CHECK(box.hi.y >= 3);
    CHECK(box.hi.y == Approx(3));
    CHECK(box.lo.z == Approx(-4));
    CHECK(box.hi.z == Approx(0).margin(1e-6));
    CHECK(b.bounds(b.shape(shape::Quadric{{1, 1, 0, 0, 0, 0, 0, 0, 0, -1}})).hi.z == kInf);
    CHECK(b.shape(shape::Quadric{{1, 1, 1, 0, 0, 0, 0, 0, 0, 1}}) == kEmptyNode);
}

TEST_CASE("a partial revolution's box is its sector's") {
    SolidBuilder b;
    const NodeId profile = b.shape(shape::Rectangle{{2, 0}, {4, 1}});
    const Bounds box = b.bounds(b.shape(shape::Revolution{profile, 0, 90, 0}));
    CHECK(box.lo.x == Approx(0).margin(1e-9));
    CHECK(box.hi.x == Approx(4));
    CHECK(box.hi.y >= 4);
    CHECK(box.lo.y <= 0);
    CHECK(box.hi.z == 1);
}

TEST_CASE("a motion's box holds both ends and the way between") {
    SolidBuilder b;
    Use use = use_of(cube(b, 1));
    use.motion = b.motion({Placement{}, Placement::translation({5, 0, 0})});
    CHECK(b.bounds(use) == Bounds{{0, 0, 0}, {6, 1, 1}});
    use = use_of(b.shape(shape::Box{{9, -1, 0}, {10, 1, 1}}));
    use.motion = b.motion({Placement{}, kQuarter});
    const Bounds box = b.bounds(use);
    const double middle = std::sqrt(101.0) * std::sqrt(0.5);
    CHECK(box.hi.x >= middle);
    CHECK(box.hi.y >= middle);
}

TEST_CASE("a finished solid holds what its root reaches, children first") {
    SolidBuilder b;
    const NodeId unused = cube(b, 99);
    const NodeId root = b.combine(SetOp::kDifference, {use_of(cube(b, 3)), use_of(ball(b, 1), {3, 3, 3})});
    REQUIRE(unused != root);
    const Solid solid = b.finish(use_of(root, {1, 0, 0}));
    REQUIRE(solid.node_count() == 4);
    CHECK(solid.root_bounds() == Bounds{{1, 0, 0}, {4, 3, 3}});
    for (NodeId id = 0; id < solid.node_count(); ++id)
        if (const auto* c = std::get_if<Combination>(&solid.node(id)))
            for (const Use& use : c->operands) CHECK(use.node < id);
    CHECK(solid.geometry(solid.root().node) == solid.root().node);
}
