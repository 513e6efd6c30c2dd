// test_booleans.cpp — operations on meshes: exact on flush and touching parts, valid always, the same bytes on any number of threads.
#include <cmath>
#include <numbers>

#include "modeler/mesh/settle.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

NodeId cube(SolidBuilder& b, double size) { return b.shape(shape::Box{Vec3(0), Vec3(size)}); }

}  // namespace

TEST_CASE("a solid less itself is nothing, and no boolean is made for it") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(10)}), drilled = b.combine(SetOp::kDifference, {at(ball), at(b.shape(shape::Frustum{-20, 20, 2, 2}))});
    const NodeId twice = b.combine(SetOp::kUnion, {at(drilled), at(drilled, {30, 0, 0})});
    Use nudged = at(drilled, {15, 0, 0});
    nudged.placement.m[3] -= 15;
    const MeshResult r = meshed(b, b.combine(SetOp::kDifference, {at(drilled), nudged}));
    CHECK(r.mesh.triangles.empty());
    CHECK(twice != kEmptyNode);
}

TEST_CASE("flush cuts leave no film") {
    SolidBuilder b;
    const NodeId plate = b.shape(shape::Box{Vec3(0), {30, 30, 5}}), hole = b.shape(shape::Frustum{0, 5, 3, 3});
    const MeshResult r = meshed(b, b.combine(SetOp::kDifference, {at(plate), at(hole, {10, 10, 0}), at(hole, {20, 20, 0})}));
    CHECK(r.report.genus == 2);
    CHECK(r.report.components == 1);
}

TEST_CASE("parts that abut become one, though 0.1 + 0.2 is not 0.3") {
    SolidBuilder b;
    const NodeId left = b.shape(shape::Box{Vec3(0), {0.1 + 0.2, 1, 1}}), right = b.shape(shape::Box{{0.3, 0, 0}, {1, 1, 1}});
    const MeshResult r = meshed(b, b.combine(SetOp::kUnion, {at(left), at(right)}));
    CHECK(r.report.components == 1);
    CHECK_THAT(volume(r), WithinRel(1.0, 1e-12));
}

TEST_CASE("cubes that share an edge or a corner") {
    SolidBuilder b;
    const NodeId c = cube(b, 10);
    const MeshResult edge = meshed(b, b.combine(SetOp::kUnion, {at(c), at(c, {10, 10, 0})}));
    CHECK_THAT(volume(edge), WithinRel(2000.0, 1e-12));
    CHECK(edge.report.shared_edges == 1);
    CHECK(edge.report.components == 2);
    SolidBuilder d;
    const NodeId e = cube(d, 10);
    const MeshResult corner = meshed(d, d.combine(SetOp::kUnion, {at(e), at(e, {10, 10, 10})}));
    CHECK_THAT(volume(corner), WithinRel(2000.0, 1e-12));
    CHECK(corner.report.components == 2);
    CHECK(corner.report.genus == 0);
}

TEST_CASE("a union through the corner where two solids touch") {
    SolidBuilder b;
    const NodeId c = cube(b, 10), small = cube(b, 2);
    const NodeId pair = b.combine(SetOp::kUnion, {at(c), at(c, {10, 10, 10})});
    Use turned = at(pair);
    turned.placement = {{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}};
    const MeshResult r = meshed(b, b.combine(SetOp::kDifference, {turned, at(small, {-11, 9, 9})}));
    CHECK_THAT(volume(r), WithinRel(2000.0 - 2, 1e-12));
    SolidBuilder d;
    const NodeId e = cube(d, 10);
    const NodeId touching = d.combine(SetOp::kDifference, {at(d.shape(shape::Box{Vec3(0), Vec3(20)})), at(e, {0, 10, 0}), at(e, {10, 0, 0}), at(e, {0, 0, 10}), at(e, {10, 10, 10})});
    const MeshResult joined = meshed(d, d.combine(SetOp::kUnion, {at(touching), at(cube(d, 2), {9, 9, 9})}));
    CHECK_THAT(volume(joined), WithinRel(4000.0 + 4, 1e-12));
}

TEST_CASE("a part turned as a whole keeps its flush faces") {
    // A cube with three square tunnels that share the planes of their walls, as it is and turned about the corner axis.
    const auto sponge = [](const Placement& placement, Vec3 beside) {
        SolidBuilder b;
        const double third = 100.0 / 3;
        const NodeId bar = b.shape(shape::Box{{-60, -third / 2, -third / 2}, {60, third / 2, third / 2}});
        const NodeId upright = b.shape(shape::Box{{-third / 2, -third / 2, -60}, {third / 2, third / 2, 60}});
        const NodeId across = b.shape(shape::Box{{-third / 2, -60, -third / 2}, {third / 2, 60, third / 2}});
        const NodeId drilled = b.combine(SetOp::kDifference, {at(b.shape(shape::Box{Vec3(-50), Vec3(50)})), at(bar), at(upright), at(across)});
        return meshed(b, b.combine(SetOp::kUnion, {placed(drilled, placement), at(b.shape(shape::Box{Vec3(0), Vec3(1)}), beside)}));
    };
    const double s = std::sqrt(0.5), c = std::sqrt(2.0 / 3), z = std::sqrt(1.0 / 3);
    const MeshResult straight = sponge({}, Vec3(200)), turned = sponge({{c, 0, z, 1, s * z, s, -s * c, 2, -s * z, s, s * c, 3}}, Vec3(200));
    CHECK(turned.report.triangles == straight.report.triangles);
    CHECK(turned.report.genus == straight.report.genus);
    CHECK(turned.report.components == 2);
    CHECK_THAT(volume(turned), WithinAbs(volume(straight), turned.grid_mm * area(turned)));
    // Corners that no operation made are the doubles they would be without a grid.
    CHECK(std::count(turned.mesh.points.begin(), turned.mesh.points.end(), Vec3(201, 200, 200)) == 1);
    MeshControl control;
    CHECK(settled_in_single(turned.mesh, control).crossings == 0);
}

TEST_CASE("a part that stands turned in several places is combined once, with flush faces and colours") {
    SolidBuilder b;
    const auto coloured = [&](NodeId node, Vec4 color, Vec3 by) {
        Use use = at(node, by);
        Label label;
        label.material.color = color;
        use.label = b.label(label);
        return use;
    };
    const NodeId slab = b.shape(shape::Box{Vec3(0), {9, 4, 2}}), post = b.shape(shape::Box{Vec3(0), {2, 4, 7}});
    const NodeId bracket = b.combine(SetOp::kUnion, {coloured(slab, {1, 0, 0, 1}, Vec3(0)), coloured(post, {0, 1, 0, 1}, Vec3(0))});
    std::vector<Use> places;
    for (const double angle : {0.1, 0.7, 1.3}) {
        const double c = std::cos(angle), s = std::sin(angle);
        places.push_back(placed(bracket, {{c, -s, 0.25, 40 * angle, s, c, 0, 3, 0, 0, 1, angle}}));
    }
    SolidBuilder alone;
    const NodeId one = alone.combine(SetOp::kUnion, {at(alone.shape(shape::Box{Vec3(0), {9, 4, 2}})), at(alone.shape(shape::Box{Vec3(0), {2, 4, 7}}))});
    const MeshResult straight = meshed(alone, one), turned = meshed(b, b.combine(SetOp::kUnion, places));
    CHECK(turned.report.triangles == 3 * straight.report.triangles);
    CHECK(turned.report.components == 3);
    CHECK_THAT(volume(turned), WithinAbs(3 * volume(straight), turned.grid_mm * area(turned)));
    CHECK(turned.stats.booleans == 1);
    REQUIRE(turned.leaves.size() == 6);
    std::array<double, 2> areas{};  // red, green
    for (std::size_t i = 0; i < turned.mesh.triangles.size(); ++i) {
        const auto& t = turned.mesh.triangles[i];
        const auto& p = turned.mesh.points;
        const auto color = turned.leaves[turned.mesh.leaf[i]].material.color;
        REQUIRE(color);
        areas[(*color)[0] == 1 ? 0 : 1] += glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
    }
    CHECK(areas[0] > areas[1]);
    CHECK(areas[1] > 3 * 40);
}

TEST_CASE("what touches along an edge can be cut further") {
    SolidBuilder b;
    const NodeId c = cube(b, 10), pair = b.combine(SetOp::kUnion, {at(c), at(c, {10, 10, 0})});
    const MeshResult r = meshed(b, b.combine(SetOp::kDifference, {at(pair), at(b.shape(shape::Box{Vec3(0), Vec3(3)}), {8, 8, 8})}));
    CHECK_THAT(volume(r), WithinRel(2000.0 - 2 * 2 * 2 - 1 * 1 * 2, 1e-12));
}

TEST_CASE("every pair of shapes under every operation: volumes add up") {
    struct Entry { const char* name; Shape shape; };
    const std::vector<Entry> shapes{{"box", shape::Box{Vec3(-4), Vec3(4)}},
                                    {"ball", shape::Ellipsoid{Vec3(5)}},
                                    {"ellipsoid", shape::Ellipsoid{{6, 3, 4}}},
                                    {"cylinder", shape::Frustum{-4, 4, 4, 4}},
                                    {"cone", shape::Frustum{-4, 5, 5, 0}},
                                    {"torus", shape::Torus{4, 2}},
                                    {"capsule", shape::Capsule{{-3, -3, -3}, {3, 3, 3}, 2}},
                                    {"roundbox", shape::RoundBox{Vec3(-4), {4, 5, 6}, 1}},
                                    {"faceted ball", shape::FacetedBall{5, 12}},
                                    {"prism", shape::FacetedFrustum{-4, 4, 5, 3, 5}}};
    MeshOptions coarse;
    coarse.tolerance_mm = 0.2;
    for (const Entry& x : shapes)
        for (const Entry& y : shapes) {
            INFO(x.name << " and " << y.name);
            const auto result = [&](SetOp op) {
                SolidBuilder b;
                const NodeId first = b.shape(x.shape), second = b.shape(y.shape);
                return volume(meshed(b, b.combine(op, {at(first), at(second, {1.25, 0, 2})}), coarse));
            };
            const auto alone = [&](const Shape& s) {
                SolidBuilder b;
                return volume(meshed(b, b.shape(s), coarse));
            };
            const double a = alone(x.shape), c = alone(y.shape), both = result(SetOp::kIntersection);
            CHECK(both > 0);
            CHECK_THAT(result(SetOp::kUnion), WithinRel(a + c - both, 1e-6));
            CHECK_THAT(result(SetOp::kDifference), WithinRel(a - both, 1e-6));
        }
}

TEST_CASE("equal parts are combined once") {
    SolidBuilder b;
    const NodeId c = cube(b, 1);
    std::vector<Use> row;
    for (int i = 0; i < 64; ++i) row.push_back(at(c, {1.0 * i, 0, 0}));
    const MeshResult r = meshed(b, b.combine(SetOp::kUnion, row));
    CHECK_THAT(volume(r), WithinRel(64.0, 1e-12));
    CHECK(r.stats.booleans == 6);
    CHECK(r.report.components == 1);
}

TEST_CASE("boxes that do not meet reach no boolean") {
    SolidBuilder b;
    const NodeId c = cube(b, 1);
    std::vector<Use> apart;
    for (int i = 0; i < 20; ++i) apart.push_back(at(c, {2.0 * i, 0, 0}));
    const MeshResult r = meshed(b, b.combine(SetOp::kUnion, apart));
    CHECK(r.stats.booleans == 0);
    CHECK_FALSE(r.stats.loaded_cgal);
    CHECK(r.report.components == 20);
}

TEST_CASE("exactly coplanar triangles are joined") {
    SolidBuilder b;
    std::vector<Use> uses{at(b.shape(shape::Box{Vec3(0), {100, 10, 10}}))};
    const NodeId notch = b.shape(shape::Box{{1, 1, 9}, {3, 9, 11}});
    for (int i = 0; i < 20; ++i) uses.push_back(at(notch, {4.0 * i, 0, 0}));
    const MeshResult r = meshed(b, b.combine(SetOp::kDifference, uses));
    CHECK(r.mesh.points.size() == 8 + 20 * 8);
    CHECK(r.stats.booleans == 1);
}

TEST_CASE("the bytes do not depend on the number of threads") {
    const auto made = [](int threads) {
        SolidBuilder b;
        const NodeId ball = b.shape(shape::FacetedBall{10, 16});
        std::vector<Use> uses;
        for (int i = 0; i < 24; ++i) uses.push_back(at(ball, {7.3 * (i % 5), 6.1 * (i % 3), 5.9 * (i % 7)}));
        MeshOptions options;
        options.threads = threads;
        return meshed(b, b.combine(SetOp::kUnion, uses), options).mesh;
    };
    const Mesh one = made(1);
    CHECK(one == made(1));
    CHECK(one == made(2));
    CHECK(one == made(4));
}

TEST_CASE("a triangle knows the leaf it came from") {
    SolidBuilder b;
    Label red, blue;
    red.material.color = Vec4{1, 0, 0, 1};
    blue.material.color = Vec4{0, 0, 1, 1};
    Use body = at(cube(b, 10)), cutter = at(cube(b, 10), {5, 5, 5});
    body.label = b.label(red);
    cutter.label = b.label(blue);
    const MeshResult r = meshed(b, b.combine(SetOp::kDifference, {body, cutter}));
    REQUIRE(r.leaves.size() == 2);
    CHECK(r.leaves[1].subtracts());
    for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i) {
        const Triangle& t = r.mesh.triangles[i];
        const Vec3 n = glm::cross(r.mesh.points[t[1]] - r.mesh.points[t[0]], r.mesh.points[t[2]] - r.mesh.points[t[0]]);
        const Vec3 middle = (r.mesh.points[t[0]] + r.mesh.points[t[1]] + r.mesh.points[t[2]]) / 3.0;
        const bool on_cut = (middle.x == 5 && n.x > 0) || (middle.y == 5 && n.y > 0) || (middle.z == 5 && n.z > 0);
        CHECK(r.mesh.leaf[i] == (on_cut ? 1U : 0U));
    }
}

TEST_CASE("halfspaces and quadrics are cut to what bounds them") {
    const auto common = [](Shape s) {
        SolidBuilder b;
        const NodeId box = b.shape(shape::Box{Vec3(-10), Vec3(10)}), other = b.shape(std::move(s));
        return meshed(b, b.combine(SetOp::kIntersection, {at(box), at(other)}));
    };
    const auto removed = [](Shape s) {
        SolidBuilder b;
        const NodeId box = b.shape(shape::Box{Vec3(-10), Vec3(10)}), other = b.shape(std::move(s));
        return meshed(b, b.combine(SetOp::kDifference, {at(box), at(other)}));
    };
    CHECK_THAT(volume(common(shape::HalfSpace{{0, 0, 1}, 3})), WithinRel(400.0 * 13, 1e-12));
    CHECK_THAT(volume(common(shape::HalfSpace{{1, 1, 1}, 0})), WithinRel(4000.0, 1e-9));
    const double pi = std::numbers::pi;
    struct Case { const char* name; std::array<double, 10> c; double volume; };
    const std::vector<Case> cases{
        {"ball", {1, 1, 1, 0, 0, 0, 0, 0, 0, -25}, 4.0 / 3 * pi * 125},
        {"cylinder", {1, 1, 0, 0, 0, 0, 0, 0, 0, -25}, pi * 25 * 20},
        {"turned cylinder", {0, 1, 1, 0, 0, 0, 0, -2, 0, -24}, pi * 25 * 20},
        {"elliptic cylinder", {1, 4, 0, 0, 0, 0, 0, 0, 0, -36}, pi * 18 * 20},
        {"double cone", {4, 4, -1, 0, 0, 0, 0, 0, 0, 0}, 2 * pi * 25 * 10 / 3},
        {"paraboloid", {1, 1, 0, 0, 0, 0, 0, 0, -2, -20}, pi * 400},            // z >= r^2/2 - 10, radius^2 = 2(z + 10)
        {"hanging paraboloid", {1, 1, 0, 0, 0, 0, 0, 0, 2, -20}, pi * 400},
        {"one sheet", {1, 1, -0.25, 0, 0, 0, 0, 0, 0, -4}, pi * (80 + 0.25 * 2000 / 3)},
        {"two sheets", {1, 1, -0.25, 0, 0, 0, 0, 0, 0, 4}, 2 * pi * (0.25 * (1000 - 64) / 3 - 4 * 6)},
        {"slab", {0, 0, 1, 0, 0, 0, 0, 0, 0, -9}, 400.0 * 6},
        {"parabolic cylinder", {1, 0, 0, 0, 0, 0, 0, 0, -10, 0}, 20 * (200 - 2000.0 / 30)},  // z >= x^2/10
        {"saddle", {1, -1, 0, 0, 0, 0, 0, 0, -10, 0}, 4000},
        {"hyperbolic cylinder", {1, -1, 0, 0, 0, 0, 0, 0, 0, 0}, 4000},
        {"plane", {0, 0, 0, 0, 0, 0, 1, 0, 0, -3}, 400.0 * 13},
    };
    for (const Case& k : cases) {
        INFO(k.name);
        CHECK_THAT(volume(common(shape::Quadric{k.c})), WithinRel(k.volume, 1e-2));
        CHECK_THAT(volume(removed(shape::Quadric{k.c})), WithinRel(8000 - k.volume, 1e-2));
        std::array<double, 10> inverse = k.c;
        for (double& x : inverse) x = -x;
        CHECK_THAT(volume(common(shape::Quadric{inverse})), WithinRel(8000 - k.volume, 1e-2));
    }
}

TEST_CASE("an unbounded solid is refused, a cancelled one is interrupted") {
    SolidBuilder b;
    const Solid open = b.finish(at(b.shape(shape::HalfSpace{{0, 0, 1}, 3})));
    MeshControl control;
    const auto refused = mesh_solid(open, {}, control);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().fault == Fault::kScene);
    struct Cancelled : MeshControl {
        bool cancelled() const override { return true; }
    } cancelled;
    SolidBuilder c;
    const Solid box = c.finish(at(cube(c, 1)));
    const auto stopped = mesh_solid(box, {}, cancelled);
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().fault == Fault::kInterrupted);
}
