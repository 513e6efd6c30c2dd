// test_leaf_distance.cpp — distances to leaves' boundaries against points moved off the surface by a known length.
#include <cmath>

#include "csg/solid/facets.h"
#include "modeler/check/leaf_distance.h"
#include "modeler/check/nearest_point.h"
#include "tests/modeler/check/check_solids.h"

using namespace whittle;
using namespace whittle::test;

namespace {

double nearest(const Solid& solid, Vec3 p) {
    const auto leaves = LeafDistances::of(solid);
    REQUIRE(leaves);
    return leaves->nearest(p, 1, 1, 4).distance;
}

}  // namespace

TEST_CASE("distances to plain shapes are those of geometry") {
    CHECK(nearest(one_shape(shape::Box{Vec3(0), Vec3(2)}), {1, 1, 1.75}) == Approx(0.25));
    CHECK(nearest(one_shape(shape::Box{Vec3(0), Vec3(2)}), {3, 3, 1}) == Approx(std::sqrt(2)));
    CHECK(nearest(one_shape(shape::Ellipsoid{Vec3(2)}), {0, 0, 0.5}) == Approx(1.5));
    CHECK(nearest(one_shape(shape::Torus{5, 2}), {0, 5, 2.5}) == Approx(0.5));
    CHECK(nearest(one_shape(shape::Frustum{0, 4, 3, 1}), {4, 0, 0}) == Approx(1));
    CHECK(nearest(one_shape(shape::Frustum{0, 4, 2, 2}), {0, 1.5, 2}) == Approx(0.5));
    CHECK(nearest(one_shape(shape::Capsule{{0, 0, 0}, {0, 0, 3}, 1}), {0, 0, 4.5}) == Approx(0.5));
    CHECK(nearest(one_shape(shape::RoundBox{Vec3(0), Vec3(4), 1}), {4, 4, 2}) == Approx(std::sqrt(2) - 1));
    CHECK(nearest(one_shape(shape::FacetedFrustum{0, 4, 2, 2, 4}), {2, 2, 2}) == Approx(std::sqrt(2)));
    CHECK(nearest(one_shape(shape::FacetedBall{2, 4}), {0, 0, 3}) == Approx(3 - std::sqrt(2)));
}

TEST_CASE("curved and flat parts are told apart") {
    const LeafDistance d = boundary_distance(shape::Frustum{0, 4, 2, 2}, {1, 0, 3.5});
    CHECK(d.curved == Approx(1));
    CHECK(d.flat == Approx(0.5));
    CHECK_FALSE(boundary_distance(shape::Box{Vec3(0), Vec3(1)}, Vec3(0.5)).curved < 1e9);
}

TEST_CASE("the nearest point of an ellipsoid is where its normal passes through the point") {
    const Vec3 r(3, 2, 1);
    for (int k = 0; k < 200; ++k) {
        const double a = 0.1 * k, b = std::fmod(0.37 * k, M_PI);
        const Vec3 on(r.x * std::sin(b) * std::cos(a), r.y * std::sin(b) * std::sin(a), r.z * std::cos(b));
        const Vec3 normal = glm::normalize(on / (r * r));
        for (const double off : {1.0, 0.1, 1e-6, -0.1, -0.25}) CHECK(distance_to_ellipsoid(on + off * normal, r) == Approx(std::fabs(off)).epsilon(1e-6));
    }
    CHECK(distance_to_ellipsoid(Vec3(0), r) == Approx(1));
}

TEST_CASE("placements that stretch give distances to first order") {
    // A ball stretched to radii 3, 2, 1, tilted: against the ellipsoid itself.
    const Placement stretch{{3, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0}};
    const Solid stretched = one_shape(shape::Ellipsoid{Vec3(1)}, tilted(50) * stretch);
    const Solid straight = one_shape(shape::Ellipsoid{{3, 2, 1}}, tilted(50));
    for (int k = 0; k < 100; ++k) {
        const double a = 0.3 * k, b = std::fmod(0.41 * k, M_PI);
        const Vec3 on(3 * std::sin(b) * std::cos(a), 2 * std::sin(b) * std::sin(a), std::cos(b));
        const Vec3 p = apply_to_point(tilted(50), 1.001 * on);
        CHECK(nearest(stretched, p) == Approx(nearest(straight, p)).epsilon(0.01));
    }
}

TEST_CASE("extruded and revolved profiles are measured where they lie") {
    SolidBuilder b;
    const NodeId disc = b.shape(shape::Disc{1});
    const NodeId square = b.shape(shape::Rectangle{{-1, -1}, {1, 1}});
    const NodeId profile = b.combine(SetOp::kUnion, {use(disc, Placement::translation({1, 0, 0})), use(square, Placement::translation({3, 0, 0}))});
    const NodeId bar = b.shape(shape::Extrusion{profile, 0, 10, 0, Vec2(1), 0});
    const Solid solid = b.finish(use(bar));
    CHECK(nearest(solid, {1, 1.5, 5}) == Approx(0.5));
    CHECK(nearest(solid, {4.25, 0, 5}) == Approx(0.25));
    CHECK(nearest(solid, {3.1, 0.1, 9.5}) == Approx(0.5));
    CHECK(nearest(solid, {4, 1, 11}) == Approx(1));

    SolidBuilder c;
    const NodeId ring = c.shape(shape::Disc{1});
    const NodeId moved = c.combine(SetOp::kUnion, {use(ring, Placement::translation({5, 0, 0}))});
    const Solid half = c.finish(use(c.shape(shape::Revolution{moved, 0, 180, 0})));
    CHECK(nearest(half, {0, 6.5, 0}) == Approx(0.5));
    CHECK(nearest(half, {5, -0.5, 0}) == Approx(0.5));
    CHECK(nearest(half, {0, -6.5, 0}) > 3);
}

TEST_CASE("a far point finds the nearest of many leaves") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(0.25)});
    std::vector<Use> balls;
    for (int i = 0; i < 100; ++i) balls.push_back(use(ball, Placement::translation({static_cast<double>(i), 0, 0})));
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, balls)));
    const auto leaves = LeafDistances::of(solid);
    REQUIRE(leaves);
    CHECK(leaves->nearest({40, 7, 0}, 0.01, 0.001, 4).distance == Approx(6.75));
    CHECK(leaves->nearest({40, 0.26, 0}, 0.01, 0.001, 4).ratio == Approx(1));
}

TEST_CASE("a twist in slices is measured against its facets") {
    SolidBuilder b;
    const NodeId square = b.shape(shape::Rectangle{{-1, -1}, {1, 1}});
    const Solid solid = b.finish(use(b.shape(shape::Extrusion{square, 0, 4, 90, Vec2(1), 2})));
    CHECK(nearest(solid, {0, 0, 3.5}) == Approx(0.5));
    CHECK(nearest(solid, {-std::sqrt(2), 0, 2}) < 1e-12);  // a corner, turned by half of the twist
    CHECK(nearest(solid, {1, 1, 0}) < 1e-12);
}

TEST_CASE("beside a face that is stretched unevenly, distances are those of geometry down to rounding") {
    // A letter as text makes it: whole numbers, made small in its own plane.
    SolidBuilder b;
    const NodeId bar = b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{{{0, 0}, {700000, 100000}, {700000, 200000}, {0, 100000}}})});
    const NodeId letter = b.combine(SetOp::kUnion, {use(bar, Placement{{1e-4, 0, 0, 3, 0, 1e-4, 0, 0, 0, 0, 1, 0}})});
    const NodeId swept = b.shape(shape::Extrusion{letter, 0, 5, 0, Vec2(1), 0});
    const auto letters = LeafDistances::of(b.finish(use(swept)));
    REQUIRE(letters);
    const Solid cube = one_shape(shape::Box{Vec3(0), Vec3(1)}, Placement{{100, 3, 0, 0, 0, 1, 0, 0, 0, 0.5, 7, 0}});
    const auto cubes = LeafDistances::of(cube);
    REQUIRE(cubes);
    const Vec3 normal = glm::normalize(Vec3(1, -7, 0)), side = glm::normalize(glm::cross(Vec3(3, 1, 0.5), Vec3(0, 0, 7)));
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-11}) {
        const auto wall = letters->nearest(Vec3(3 + 35, 5, 2.5) + off * normal, 1, 1e-2, 4);
        CHECK(wall.distance == Approx(off).epsilon(1e-3).margin(1e-13));
        const auto face = cubes->nearest(apply_to_point(Placement{{100, 3, 0, 0, 0, 1, 0, 0, 0, 0.5, 7, 0}}, {1, 0.5, 0.5}) + off * side, 1, 1e-2, 4);
        CHECK(face.distance == Approx(off).epsilon(1e-3).margin(1e-13));
    }
}

TEST_CASE("facets far and near are measured alike") {
    const Solid ball = one_shape(shape::FacetedBall{2, 30}, tilted(40, {1, 2, 3}));
    CHECK(nearest(ball, {1, 2, 3}) == Approx(2 * std::cos(M_PI / 30)).epsilon(1e-2));
    const auto leaves = LeafDistances::of(ball);
    REQUIRE(leaves);
    CHECK(leaves->nearest({1, 2, 503}, 1e-9, 1e-9, 4).distance == Approx(498).epsilon(1e-3));
    CHECK(leaves->nearest({1, 2, 503}, 1e-9, 1e-9, 4).ratio > 1);
}

TEST_CASE("a roof that ends in a line is near its walls up to that line") {
    // A square turned by 30 degrees, its x shrinking to nothing: the walls are x = X(y) (1 - z / 10).
    SolidBuilder b;
    const double c = 3 * std::cos(M_PI / 6), s = 1.5;
    const std::vector<Vec2> square{{c - s, s + c}, {-c - s, c - s}, {s - c, -s - c}, {c + s, s - c}};
    Use root;
    root.node = b.shape(shape::Extrusion{b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{square})}), 0, 10, 0, {0, 1}, 0});
    const Solid roof = b.finish(root);
    const auto leaves = LeafDistances::of(roof);
    REQUIRE(leaves);
    const double slope = (square[0].x - square[3].x) / (square[0].y - square[3].y);
    for (const double z : {5.0, 9.0, 9.9, 9.96, 9.99, 9.999}) {
        const double shrunk = 1 - z / 10, y = 1.77, x = square[3].x + (y - square[3].y) * slope;
        for (const double share : {0.2, -0.2, 0.001}) {
            const double off = share * x * shrunk;
            const double truth = std::fabs(off) / std::sqrt(1 + slope * shrunk * slope * shrunk + x * x / 100);
            CHECK(leaves->nearest({x * shrunk + off, y, z}, 1, 1e-9, 1).distance == Approx(truth).epsilon(0.15));
        }
    }
}

TEST_CASE("a twist that is scaled unevenly is near where its profile is, turned first and scaled then") {
    SolidBuilder b;
    Use root;
    root.node = b.shape(shape::Extrusion{b.shape(shape::Rectangle{{0, 0}, {8, 2}}), 0, 10, 45, {2, 0.5}, 0});
    const auto leaves = LeafDistances::of(b.finish(root));
    REQUIRE(leaves);
    for (const double share : {0.2, 0.5, 0.8}) {
        const double a = -45 * share * M_PI / 180, kx = 1 + share, ky = 1 - 0.5 * share;
        for (const Vec2 p : {Vec2(8, 1), Vec2(3, 2), Vec2(6, 0)}) {
            const Vec3 on(kx * (std::cos(a) * p.x - std::sin(a) * p.y), ky * (std::sin(a) * p.x + std::cos(a) * p.y), 10 * share);
            CHECK(leaves->nearest(on, 1, 1e-9, 1).distance < 1e-9);
        }
    }
}
