// test_queries.cpp — integrals, crossings, hulls.
#include <random>

#include "modeler/arrange/crossings.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Mesh box_mesh(const Vec3& lo, const Vec3& hi) {
    SolidBuilder b;
    return meshed(b, b.shape(shape::Box{lo, hi})).mesh;
}

std::vector<MeshCrossing> crossings(const Mesh& mesh, const Ray& ray) {
    std::vector<MeshCrossing> out;
    MeshRays(mesh).crossings(ray, out);
    return out;
}

bool alternates(const std::vector<MeshCrossing>& c) {
    for (std::size_t i = 0; i < c.size(); ++i)
        if (c[i].entering != (i % 2 == 0)) return false;
    return c.size() % 2 == 0;
}

}  // namespace

TEST_CASE("mass properties of a box far from the origin") {
    const MassProperties m = mass_properties(box_mesh({1e6, 2e6, 3e6}, {1e6 + 2, 2e6 + 4, 3e6 + 6}));
    CHECK(m.volume == Approx(48).epsilon(1e-14));
    CHECK(m.area == Approx(88).epsilon(1e-14));
    CHECK(m.centroid.x == Approx(1e6 + 1).epsilon(1e-15));
    CHECK(m.inertia[0] == Approx(48.0 * (16 + 36) / 12).epsilon(1e-13));
    CHECK(m.inertia[4] == Approx(48.0 * (4 + 36) / 12).epsilon(1e-13));
    CHECK(m.inertia[8] == Approx(48.0 * (4 + 16) / 12).epsilon(1e-13));
    CHECK(std::fabs(m.inertia[1]) < 1e-10);
}

TEST_CASE("a ray through a box enters and leaves it") {
    const auto c = crossings(box_mesh(Vec3(0), Vec3(10)), Ray{{3, 4, -5}, {0, 0, 2}});
    REQUIRE(c.size() == 2);
    CHECK(c[0].t == 2.5);
    CHECK(c[0].entering);
    CHECK(c[1].t == 7.5);
    CHECK_FALSE(c[1].entering);
    CHECK(crossings(box_mesh(Vec3(0), Vec3(10)), Ray{{3, 4, 5}, {0, 0, 2}}).size() == 1);
    CHECK(crossings(box_mesh(Vec3(0), Vec3(10)), Ray{{3, 4, 50}, {0, 0, 2}}).empty());
}

TEST_CASE("rays along edges, through corners and in faces meet the mesh as their neighbours do") {
    const Mesh mesh = box_mesh(Vec3(0), Vec3(10));
    const std::vector<Vec3> places{{0, 0, 0}, {10, 0, 0}, {0, 10, 10}, {5, 0, 0}, {5, 5, 0}, {0, 5, 5}, {10, 10, 10}, {5, 5, 10}, {3, 3, 0}};
    for (const Vec3& p : places)
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    const Vec3 d{x, y, z};
                    INFO(p.x << " " << p.y << " " << p.z << " along " << x << " " << y << " " << z);
                    const auto c = crossings(mesh, Ray{p - 32.0 * d, d});
                    CHECK(alternates(c));
                    CHECK(c.size() <= 2);
                }
}

TEST_CASE("crossings of a closed mesh alternate, and their lengths add up to the volume") {
    SolidBuilder b;
    const NodeId ring = b.shape(shape::Torus{10, 4}), box = b.shape(shape::Box{Vec3(-5), Vec3(5)});
    const MeshResult made = meshed(b, b.combine(SetOp::kUnion, {at(ring), at(box)}));
    const MeshRays rays(made.mesh);
    std::vector<MeshCrossing> c;
    const int n = 200;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            rays.crossings(Ray{{-15 + 30.0 * (i + 0.5) / n, -15 + 30.0 * (j + 0.5) / n, -50}, {0, 0, 1}}, c);
            REQUIRE(alternates(c));
            for (const MeshCrossing& k : c) sum += k.entering ? -k.t : k.t;
        }
    CHECK(sum * 900 / (n * n) == Approx(volume(made)).epsilon(5e-3));
}

TEST_CASE("random rays through vertices and edge middles alternate") {
    SolidBuilder b;
    const MeshResult made = meshed(b, b.shape(shape::FacetedBall{10, 12}));
    const MeshRays rays(made.mesh);
    std::mt19937 random(7);
    std::vector<MeshCrossing> c;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 p = made.mesh.points[random() % made.mesh.points.size()], q = made.mesh.points[random() % made.mesh.points.size()];
        if (p == q) continue;
        rays.crossings(Ray{p - 8.0 * (q - p), q - p}, c);
        REQUIRE(alternates(c));
    }
}

TEST_CASE("self-intersections are counted, by CGAL and by ourselves") {
    Mesh two = box_mesh(Vec3(0), Vec3(10));
    CHECK(count_self_intersections(two).value() == 0);
    CHECK(count_crossings(two.points, two.triangles) == 0);
    const Mesh other = box_mesh(Vec3(5), Vec3(15));
    const auto n = static_cast<std::uint32_t>(two.points.size());
    two.points.insert(two.points.end(), other.points.begin(), other.points.end());
    for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    CHECK(count_self_intersections(two).value() > 0);
    CHECK(count_crossings(two.points, two.triangles) == count_self_intersections(two).value());
}
