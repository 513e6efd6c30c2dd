// test_agreement.cpp — right meshes agree; meshes with a planted fault do not. Place and size of a fault come from a printed seed.
#include <functional>
#include <random>

#include "modeler/check/agreement.h"
#include "tests/modeler/check/check_solids.h"
#include "tests/support/random_solid.h"

using namespace whittle;
using namespace whittle::test;

namespace {

MeshResult meshed(const Solid& solid) {
    MeshControl control;
    auto result = mesh_solid(solid, {}, control);
    REQUIRE(result);
    return *result;
}

Agreement agreement(const Solid& solid, const MeshResult& made, const Mesh& mesh, std::uint64_t lines = 4096) {
    AgreementOptions options;
    options.tolerance = made.tolerance_mm;
    options.rounding = made.grid_mm;
    options.lines = lines;
    const auto a = check_agreement(solid, *compiled(solid), mesh, options);
    REQUIRE(a);
    return *a;
}

Solid box_and_ball() {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(-4), Vec3(4)});
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(3)});
    const NodeId rod = b.shape(shape::Frustum{-9, 9, 1, 1});
    const NodeId hollow = b.combine(SetOp::kDifference, {use(box), use(rod, tilted(90))});
    return b.finish(use(b.combine(SetOp::kUnion, {use(hollow), use(ball, Placement::translation({0, 0, 5}))})));
}

Mesh cuboid(Vec3 lo, Vec3 hi, bool outward) {
    Mesh m;
    for (int k = 0; k < 8; ++k) m.points.push_back({k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z});
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    if (!outward)
        for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
    return m;
}

void append(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.leaf.clear();
}

using Fault = std::function<void(Mesh&, double, std::mt19937_64&)>;
struct NamedFault { const char* name; Fault plant; };

// Each moves or adds something by at least `size`.
const std::vector<NamedFault>& faults() {
    static const std::vector<NamedFault> list{
        {"a moved vertex", [](Mesh& m, double, std::mt19937_64& random) { m.points[random() % m.points.size()] += Vec3(0.9, -0.8, 0.7); }},
        {"a flipped facet", [](Mesh& m, double, std::mt19937_64& random) {
             // One of the larger half of the facets: a sliver is a matter of luck for any number of lines.
             const auto area = [&](const Triangle& t) { return glm::length(glm::cross(m.points[t[1]] - m.points[t[0]], m.points[t[2]] - m.points[t[0]])); };
             std::stable_sort(m.triangles.begin(), m.triangles.end(), [&](const Triangle& a, const Triangle& b) { return area(a) > area(b); });
             std::swap(m.triangles[random() % (m.triangles.size() / 50 + 1)][1], m.triangles[0][1]);
             std::swap(m.triangles[0][1], m.triangles[0][2]);
         }},
        {"an inner film", [](Mesh& m, double size, std::mt19937_64&) { append(m, cuboid({-3.5, -3.5, -3}, {3.5, 3.5, -3 + size}, false)); }},
        {"a film of no thickness", [](Mesh& m, double, std::mt19937_64&) {
             append(m, cuboid({-3.5, -3.5, -3}, {3.5, 3.5, -3}, true));
         }},
        {"a film outside", [](Mesh& m, double size, std::mt19937_64&) { append(m, cuboid({-3, -3, -6}, {3, 3, -6 + size}, true)); }},
        {"a shifted part", [](Mesh& m, double size, std::mt19937_64& random) {
             const Vec3 by = size * glm::normalize(Vec3(1, 2, random() % 3));
             for (Vec3& p : m.points) p += by;
         }},
        {"a wrong size", [](Mesh& m, double size, std::mt19937_64&) {
             for (Vec3& p : m.points) p *= 1 + size / 4;
         }},
        {"a mirrored part", [](Mesh& m, double, std::mt19937_64&) {
             for (Vec3& p : m.points) p.z = -p.z;
             for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
         }},
        {"an inverted mesh", [](Mesh& m, double, std::mt19937_64&) {
             for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
         }},
        {"a dropped shell", [](Mesh& m, double, std::mt19937_64&) { m.triangles.clear(); }},
        {"a mesh twice", [](Mesh& m, double size, std::mt19937_64&) {
             Mesh copy = m;
             for (Vec3& p : copy.points) p += Vec3(size, size, size);
             append(m, copy);
         }},
    };
    return list;
}

}  // namespace

TEST_CASE("exact solids and their meshes agree, and their volumes do") {
    for (const Solid& solid : {one_shape(shape::Box{Vec3(-1), Vec3(2)}, tilted(17)), one_shape(shape::Ellipsoid{Vec3(3)}), one_shape(shape::Torus{5, 2}),
                               tricylinder(2), carved_cube(), box_and_ball(), sponge(2)}) {
        const MeshResult made = meshed(solid);
        const Agreement a = agreement(solid, made, made.mesh);
        CAPTURE(a.worst.distance, a.worst.bound, a.disagreements_in_all, a.volume_spans.value, a.volume_mesh.value, a.tolerance);
        CHECK(a.agree);
        CHECK(a.lines == 4096);
        CHECK(a.difference_volume.value - a.difference_volume.error <= a.difference_bound);
    }
}

TEST_CASE("flat solids are allowed rounding alone") {
    const Solid solid = sponge(2);
    const MeshResult made = meshed(solid);
    const Agreement a = agreement(solid, made, made.mesh);
    CHECK(a.tolerance == 0);
    CHECK(a.rounding < 1e-9);
    CHECK(a.difference_volume.value < 1e-9);
    Mesh moved = made.mesh;
    for (Vec3& p : moved.points) p.x += 1e-7;
    CHECK_FALSE(agreement(solid, made, moved).agree);
}

TEST_CASE("every planted fault is found") {
    const Solid solid = box_and_ball();
    const MeshResult made = meshed(solid);
    const double tolerance = made.tolerance_mm;
    REQUIRE(tolerance > 0);
    for (const NamedFault& fault : faults())
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            CAPTURE(fault.name, seed, tolerance);
            std::mt19937_64 random(seed);
            Mesh mesh = made.mesh;
            fault.plant(mesh, 3 * tolerance, random);
            const Agreement a = agreement(solid, made, mesh, 16384);
            CHECK_FALSE(a.agree);
            CHECK(a.disagreements_in_all > 0);
        }
}

TEST_CASE("a mesh of another solid disagrees: a missing hole, a wrong radius, a swapped operand") {
    const Solid right = box_and_ball();
    const MeshResult made = meshed(right);
    const double t = made.tolerance_mm;
    const auto other = [&](double radius, double rod, bool swapped) {
        SolidBuilder b;
        const NodeId box = b.shape(shape::Box{Vec3(-4), Vec3(4)});
        const NodeId ball = b.shape(shape::Ellipsoid{Vec3(radius)});
        const Use bore = use(b.shape(shape::Frustum{-9, 9, rod, rod}), tilted(90));
        const NodeId hollow = swapped ? b.combine(SetOp::kDifference, {bore, use(box)}) : b.combine(SetOp::kDifference, {use(box), bore});
        return b.finish(use(b.combine(SetOp::kUnion, {use(rod > 0.01 ? hollow : box), use(ball, Placement::translation({0, 0, 5}))})));
    };
    CHECK_FALSE(agreement(right, made, meshed(other(3, 0.001, false)).mesh).agree);
    CHECK_FALSE(agreement(right, made, meshed(other(3, 1 + 3 * t, false)).mesh, 16384).agree);
    CHECK_FALSE(agreement(right, made, meshed(other(3 + 3 * t, 1, false)).mesh).agree);
    CHECK_FALSE(agreement(right, made, meshed(other(3, 1, true)).mesh).agree);
    CHECK(agreement(right, made, meshed(other(3, 1, false)).mesh).agree);
}

TEST_CASE("a disagreement names the line that shows it and the source line nearest to it") {
    SolidBuilder b;
    Label label;
    label.place = {0, 42, 1};
    Use box = use(b.shape(shape::Box{Vec3(0), Vec3(2)}));
    box.label = b.label(label);
    const Solid solid = b.finish(box);
    const MeshResult made = meshed(solid);
    Mesh larger = made.mesh;
    for (Vec3& p : larger.points) p *= 1.25;
    const Agreement a = agreement(solid, made, larger);
    REQUIRE_FALSE(a.agree);
    REQUIRE(!a.disagreements.empty());
    const Disagreement& d = a.disagreements.front();
    CHECK(d.place.line == 42);
    CHECK(d.in_mesh);
    CHECK(d.distance > d.bound);
    CHECK(d.distance <= 0.5 * std::sqrt(3) + 1e-9);
}

TEST_CASE("an agreement's bytes do not depend on the run") {
    const Solid solid = carved_cube();
    const MeshResult made = meshed(solid);
    const Agreement a = agreement(solid, made, made.mesh), b = agreement(solid, made, made.mesh);
    CHECK(a.difference_volume.value == b.difference_volume.value);
    CHECK(a.worst.distance == b.worst.distance);
    CHECK(a.worst.ray.origin == b.worst.ray.origin);
}
