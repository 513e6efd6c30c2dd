// test_shapes.cpp — every shape as a mesh: closed, within tolerance, of the right volume and area.
#include <cmath>
#include <numbers>

#include "solids.h"

using namespace whittle;
using namespace whittle::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double kPi = std::numbers::pi;

MeshResult of(Shape shape, const MeshOptions& options = {}) {
    SolidBuilder builder;
    const NodeId node = builder.shape(std::move(shape));
    return meshed(builder, node, options);
}

// A mesh inside a convex body, nowhere farther from its surface than the tolerance: volumes differ by at most tolerance times area.
void check_inscribed(const MeshResult& result, double exact_volume, double exact_area) {
    CHECK(volume(result) < exact_volume);
    CHECK(exact_volume - volume(result) <= result.tolerance_mm * exact_area);
    CHECK(area(result) < exact_area);
    CHECK(result.report.components == 1);
}

// The most that a point on the mesh is inside of the surface, over the centres of triangles and edges.
template <class Distance>
double deepest(const Mesh& mesh, Distance&& distance) {
    double most = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        for (const Vec3& p : {(a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, a * 0.5 + b * 0.25 + c * 0.25})
            most = std::max(most, std::fabs(distance(p)));
    }
    return most;
}

}  // namespace

TEST_CASE("a box is twelve triangles with the author's own corners") {
    const MeshResult r = of(shape::Box{{0.1, 0.2, 0.3}, {1.1, 2.2, 3.3}});
    CHECK(r.mesh.triangles.size() == 12);
    CHECK(r.mesh.points.size() == 8);
    CHECK(mesh_bounds(r.mesh) == Bounds{{0.1, 0.2, 0.3}, {1.1, 2.2, 3.3}});
    CHECK_FALSE(r.stats.loaded_cgal);
    CHECK(r.report.genus == 0);
}

TEST_CASE("a ball keeps its tolerance and its poles") {
    for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
        MeshOptions options;
        options.tolerance_mm = tolerance;
        const MeshResult r = of(shape::Ellipsoid{Vec3(10)}, options);
        CHECK(deepest(r.mesh, [](const Vec3& p) { return glm::length(p) - 10; }) <= tolerance);
        check_inscribed(r, 4.0 / 3 * kPi * 1000, 4 * kPi * 100);
        CHECK(mesh_bounds(r.mesh) == Bounds{Vec3(-10), Vec3(10)});
    }
}

TEST_CASE("a ball has few triangles more than equilateral ones would be") {
    for (const double tolerance : {0.1, 0.01, 0.002}) {
        MeshOptions options;
        options.tolerance_mm = tolerance;
        const MeshResult r = of(shape::Ellipsoid{Vec3(10)}, options);
        // A triangle's plane is farthest from the ball at the middle of its circumscribed circle.
        double most = 0;
        for (const Triangle& t : r.mesh.triangles) {
            const Vec3 &a = r.mesh.points[t[0]], &b = r.mesh.points[t[1]], &c = r.mesh.points[t[2]];
            most = std::max(most, 10 - std::fabs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), a)));
        }
        CHECK(most <= tolerance);
        const double equilateral = 4 * kPi * 10 / (1.5 * std::sqrt(3.0) * tolerance);
        CHECK(static_cast<double>(r.mesh.triangles.size()) < 1.2 * equilateral);
    }
}

TEST_CASE("by default a ball is within a thousandth of its radius") {
    const MeshResult r = of(shape::Ellipsoid{Vec3(10)});
    CHECK(r.tolerance_mm == Approx(0.01));
    CHECK(deepest(r.mesh, [](const Vec3& p) { return glm::length(p) - 10; }) <= 0.01);
}

TEST_CASE("an ellipsoid is inside and near") { check_inscribed(of(shape::Ellipsoid{{3, 5, 11}}), 4.0 / 3 * kPi * 165, 466.4); }

TEST_CASE("cylinders and cones") {
    check_inscribed(of(shape::Frustum{0, 10, 5, 5}), kPi * 250, 2 * kPi * 5 * 15);
    check_inscribed(of(shape::Frustum{-1, 10, 5, 2}), kPi * 11 / 3 * 39, kPi * (29 + 7 * std::hypot(3, 11)));
    check_inscribed(of(shape::Frustum{0, 10, 0, 5}), kPi * 250 / 3, kPi * 5 * (5 + std::hypot(5, 10)));
    check_inscribed(of(shape::Frustum{0, 10, 5, 0}), kPi * 250 / 3, kPi * 5 * (5 + std::hypot(5, 10)));
}

TEST_CASE("a torus keeps its tolerance, thick or thin, coarse or fine") {
    for (const double minor : {0.2, 2.0, 7.0, 9.9})
        for (const double tolerance : {0.1, 0.01}) {
            MeshOptions options;
            options.tolerance_mm = tolerance;
            const MeshResult r = of(shape::Torus{10, minor}, options);
            CHECK(deepest(r.mesh, [&](const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 10, p.z) - minor; }) <= tolerance);
            CHECK(r.report.genus == 1);
            CHECK(mesh_bounds(r.mesh) == Bounds{Vec3(-10 - minor, -10 - minor, -minor), Vec3(10 + minor, 10 + minor, minor)});
        }
}

TEST_CASE("a torus has a hole and a spindle has none") {
    const MeshResult ring = of(shape::Torus{10, 3});
    CHECK(ring.report.genus == 1);
    CHECK_THAT(volume(ring), WithinRel(2 * kPi * kPi * 10 * 9, 3e-3));
    CHECK(deepest(ring.mesh, [](const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 10, p.z) - 3; }) <= ring.tolerance_mm);
    const MeshResult horn = of(shape::Torus{4, 4});
    CHECK(horn.report.components == 1);
    CHECK_THAT(volume(horn), WithinRel(2 * kPi * kPi * 64, 4e-3));
    const MeshResult spindle = of(shape::Torus{3, 10});
    CHECK(spindle.report.genus == 0);
    // Pappus for the part of the circle on this side of the axis.
    const double half = std::acos(-0.3);
    const double exact = 2 * kPi * (3 * (half * 100 - 50 * std::sin(2 * half)) + 2.0 / 3 * 1000 * std::pow(std::sin(half), 3));
    CHECK_THAT(volume(spindle), WithinRel(exact, 3e-3));
}

TEST_CASE("capsules and rounded boxes") {
    check_inscribed(of(shape::Capsule{{1, 2, 3}, {11, 22, 33}, 4}), kPi * 16 * std::sqrt(1400) + 4.0 / 3 * kPi * 64,
                    8 * kPi * std::sqrt(1400) + 64 * kPi);
    check_inscribed(of(shape::Capsule{{0, 0, 0}, {0, 0, -10}, 4}), kPi * 160 + 4.0 / 3 * kPi * 64, 80 * kPi + 64 * kPi);
    const MeshResult r = of(shape::RoundBox{Vec3(0), {10, 20, 30}, 3});
    check_inscribed(r, 4 * 14 * 24 + 2 * 3 * (4 * 14 + 14 * 24 + 24 * 4) + kPi * 9 * (4 + 14 + 24) + 4.0 / 3 * kPi * 27,
                    2 * (4 * 14 + 14 * 24 + 24 * 4) + 2 * kPi * 3 * (4 + 14 + 24) + 4 * kPi * 9);
    CHECK(mesh_bounds(r.mesh) == Bounds{Vec3(0), {10, 20, 30}});
    CHECK(of(shape::RoundBox{Vec3(0), {6, 6, 30}, 3}).report.genus == 0);
}

TEST_CASE("OpenSCAD's facets have its volume") {
    // A prism over an n-gon, and the ball of half-step rings.
    const MeshResult prism = of(shape::FacetedFrustum{0, 10, 5, 5, 6});
    CHECK_THAT(volume(prism), WithinRel(10 * 25 * 1.5 * std::sqrt(3.0), 1e-12));
    CHECK(prism.tolerance_mm == 0);
    CHECK(of(shape::FacetedBall{10, 8}).mesh.points.size() == 32);
    CHECK(of(shape::FacetedFrustum{0, 10, 5, 0, 6}).mesh.points.size() == 7);
}

TEST_CASE("a polyhedron keeps its corners; one listed from inside is turned") {
    FacetList pyramid{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 2}}, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    CHECK_THAT(volume(of(shape::Polyhedron{std::make_shared<const FacetList>(pyramid)})), WithinRel(6.0, 1e-12));
    for (auto& f : pyramid.facets) std::reverse(f.begin(), f.end());
    CHECK_THAT(volume(of(shape::Polyhedron{std::make_shared<const FacetList>(pyramid)})), WithinRel(6.0, 1e-12));
}

TEST_CASE("an open polyhedron is refused") {
    SolidBuilder builder;
    const FacetList open{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {1, 1, 2}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}};
    const Solid solid = builder.finish(at(builder.shape(shape::Polyhedron{std::make_shared<const FacetList>(open)})));
    MeshControl control;
    const auto result = mesh_solid(solid, {}, control);
    REQUIRE_FALSE(result);
    CHECK(result.error().fault == Fault::kScene);
    CHECK(result.error().message.find("not closed") != std::string::npos);
}

TEST_CASE("extrusions: holes, twist, scale, a point at the top") {
    const auto extruded = [](double twist, Vec2 scale, int slices) {
        SolidBuilder b;
        const NodeId hole = b.shape(shape::Disc{3}), square = b.shape(shape::Rectangle{{-5, -5}, {5, 5}});
        const NodeId profile = b.combine(SetOp::kDifference, {at(square), at(hole)});
        const NodeId node = b.shape(shape::Extrusion{profile, 0, 20, twist, scale, slices});
        return meshed(b, node);
    };
    const double ring = 100 - 9 * kPi;
    CHECK(extruded(0, {1, 1}, 0).report.genus == 1);
    CHECK_THAT(volume(extruded(0, {1, 1}, 0)), WithinAbs(20 * ring, 20 * 6 * kPi * 0.003));
    CHECK_THAT(volume(extruded(90, {1, 1}, 0)), WithinRel(20 * ring, 2e-3));
    CHECK_THAT(volume(extruded(0, {0.5, 0.5}, 0)), WithinRel(20 * ring * 7 / 12, 1e-3));
    CHECK_THAT(volume(extruded(0, {0.5, 2}, 0)), WithinRel(20 * ring * (1 + 0.25 - 0.5 / 3), 2e-3));  // integral of (1 - z/2)(1 + z)
    CHECK(extruded(45, {1, 1}, 4).report.genus == 1);
    SolidBuilder b;
    const NodeId square = b.shape(shape::Rectangle{{-5, -5}, {5, 5}});
    const MeshResult pyramid = meshed(b, b.shape(shape::Extrusion{square, 0, 6, 0, {0, 0}, 0}));
    CHECK_THAT(volume(pyramid), WithinRel(200.0, 1e-12));
    CHECK(pyramid.mesh.points.size() == 5);
}

TEST_CASE("revolutions: whole, part, touching the axis") {
    const auto turned = [](double angle, double inner, int fragments) {
        SolidBuilder b;
        const NodeId node = b.shape(shape::Revolution{b.shape(shape::Rectangle{{inner, 0}, {5, 2}}), 0, angle, fragments});
        return meshed(b, node);
    };
    CHECK_THAT(volume(turned(360, 2, 0)), WithinRel(kPi * 42, 3e-3));
    CHECK(turned(360, 2, 0).report.genus == 1);
    CHECK(turned(360, 0, 0).report.genus == 0);
    CHECK(turned(90, 2, 0).report.genus == 0);
    CHECK_THAT(volume(turned(90, 2, 0)), WithinRel(kPi * 42 / 4, 3e-3));
    CHECK_THAT(volume(turned(360, 0, 4)), WithinRel(100.0, 1e-12));
    CHECK_THAT(volume(turned(90, 0, 3)), WithinRel(3 * 0.5 * 25 * std::sin(kPi / 6) * 2, 1e-12));
}

TEST_CASE("the angle limits segments too") {
    MeshOptions options;
    options.tolerance_mm = 100;
    options.angle_deg = 10;
    const MeshResult r = of(shape::Frustum{0, 1, 1, 1}, options);
    CHECK(r.mesh.points.size() == 72);
}

TEST_CASE("a scaled ball is within the tolerance of the root frame") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(1)});
    MeshOptions options;
    options.tolerance_mm = 0.05;
    const MeshResult r = meshed(b, placed(ball, {{10, 0, 0, 3, 0, 20, 0, 2, 0, 0, -10, 1}}), options);
    CHECK(r.tolerance_mm == Approx(0.05));
    CHECK(volume(r) < 4.0 / 3 * kPi * 2000);
    CHECK_THAT(volume(r), WithinAbs(4.0 / 3 * kPi * 2000, 0.05 * 2300));
}
