// watertight_test.cpp — a closed mesh is crossed an even number of times by every ray, also by rays that go exactly through corners, edges and faces.
//
// Corners are integers divisible by 6 and origins integers, so a ray through a corner, the middle of an edge or of a face is exact; that it is incident is
// proven in integers. The hidden test [.soak] takes WHITTLE_RAYS (10^8), one in eighty incident, on meshes of 10^3 ... 10^6 triangles.
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "tests/support/seed.h"
#include "tests/tracer/engine/adversary.h"
#include "tests/tracer/engine/rays.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

using Integer3 = std::array<std::int64_t, 3>;

struct IntegerMesh {
    std::vector<Integer3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A bumpy ball of 2 n (m - 1) triangles about the origin, corners on a grid of 6.
IntegerMesh bumpy_ball(int n, int m, double radius) {
    IntegerMesh mesh;
    const auto point = [&](double u, double v) {
        const double a = 2 * M_PI * u, b = M_PI * v, r = radius * (1 + 0.15 * std::sin(5 * a) * std::sin(3 * b));
        const auto grid = [](double x) { return 6 * static_cast<std::int64_t>(std::lround(x / 6)); };
        mesh.points.push_back({grid(r * std::sin(b) * std::cos(a)), grid(r * std::sin(b) * std::sin(a)), grid(r * std::cos(b))});
    };
    point(0, 0);
    for (int j = 1; j < m; ++j)
        for (int i = 0; i < n; ++i) point(static_cast<double>(i) / n, static_cast<double>(j) / m);
    point(0, 1);
    const auto at = [&](int i, int j) { return j == 0 ? 0u : j == m ? static_cast<std::uint32_t>(mesh.points.size() - 1) : static_cast<std::uint32_t>(1 + (j - 1) * n + i % n); };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            if (j > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            if (j + 1 < m) mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return mesh;
}

Solid solid_of(const IntegerMesh& mesh, const Placement& placement) {
    auto list = std::make_shared<FacetList>();
    for (const Integer3& p : mesh.points) list->points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    for (const auto& t : mesh.triangles) list->facets.push_back({t[0], t[1], t[2]});
    SolidBuilder b;
    Use use;
    use.node = b.shape(shape::Polyhedron{std::move(list)});
    use.placement = placement;
    return b.finish(use);
}

// A corner, or the middle of an edge or of a face.
Integer3 target(const IntegerMesh& mesh, Random& random) {
    const auto& t = mesh.triangles[static_cast<std::size_t>(random.between(0, static_cast<double>(mesh.triangles.size())))];
    const int corners = 1 + static_cast<int>(random.between(0, 3));
    Integer3 sum{};
    for (int k = 0; k < corners; ++k)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += mesh.points[t[static_cast<std::size_t>(k)]][i];
    for (std::int64_t& x : sum) x /= corners;  // exact: corners are divisible by 6
    return sum;
}

// Is (to - from) x (p - from) zero, in integers of at most 2^40?
bool is_incident(const Integer3& from, const Integer3& way, const Integer3& p) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Integer3 q{p[0] - from[0], p[1] - from[1], p[2] - from[2]};
        if (way[i] * q[j] != way[j] * q[i]) return false;
    }
    return true;
}

Vec3 as_vector(const Integer3& p) { return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}; }

struct Crossed {
    std::uint64_t rays = 0, incident = 0, crossings = 0, leaks = 0, exact = 0;
};

void shoot(const Program& program, const IntegerMesh& mesh, double radius, const Placement& placement, std::uint64_t rays, Random& random, Crossed& r) {
    Scratch scratch;
    Spans spans;
    for (std::uint64_t i = 0; i < rays; ++i) {
        const bool incident = i % 80 == 0;
        Ray ray;
        const auto far = static_cast<std::int64_t>(3 * radius);
        const auto integer = [&] { return static_cast<std::int64_t>(random.between(static_cast<double>(-far), static_cast<double>(far))); };
        Integer3 from{integer(), integer(), integer()};
        from[static_cast<std::size_t>(random.between(0, 3))] = random.between(0, 1) < 0.5 ? -far : far;
        if (incident) {
            const Integer3 to = target(mesh, random), way{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
            REQUIRE(is_incident(from, way, to));
            ray.origin = as_vector(from);
            ray.direction = as_vector(way);
            ++r.incident;
        } else {
            ray.origin = as_vector(from);
            ray.direction = 1.1 * radius * on_sphere(random) * random.between(0, 1) - ray.origin;
        }
        ray.origin = apply_to_point(placement, ray.origin);
        ray.direction = apply_to_direction(placement, ray.direction);
        all_spans(program, ray, scratch, spans);
        ++r.rays;
        for (const Span& s : spans) {
            r.crossings += 2;
            r.leaks += !s.in || !s.out;
        }
    }
    r.exact += scratch.counters.escalated_exact;
}

// Integers again after it.
const Placement kTurned{{3, -4, 0, 1000, 4, 3, 0, -2000, 0, 0, -5, 70}};

Crossed shoot_at(int n, double radius, std::uint64_t rays, Random& random) {
    const IntegerMesh mesh = bumpy_ball(n, n / 2, radius);
    Crossed r;
    for (const Placement& placement : {Placement{}, kTurned}) shoot(*compiled(solid_of(mesh, placement)), mesh, radius, placement, rays / 2, random, r);
    return r;
}

}  // namespace

TEST_CASE("every ray crosses a closed mesh an even number of times") {
    Random random(support::fresh_seed());
    for (const int n : {32, 100}) {
        const Crossed r = shoot_at(n, 60000, 20'000, random);
        CHECK(r.leaks == 0);
        CHECK(r.crossings > r.rays / 2);
        CHECK(r.incident == r.rays / 80);
        CHECK(r.exact > 0);
    }
}

TEST_CASE("no ray of 10^8 leaks through a closed mesh", "[.soak]") {
    const char* text = std::getenv("WHITTLE_RAYS");
    const std::uint64_t asked = text == nullptr ? 100'000'000 : std::strtoull(text, nullptr, 10), seed = support::fresh_seed();
    fmt::print("WHITTLE_SEED={}\n", seed);
    Random random(seed);
    for (const auto& [n, share] : {std::pair(32, 0.5), {100, 0.3}, {316, 0.15}, {1000, 0.05}}) {
        const Crossed r = shoot_at(n, 600000, static_cast<std::uint64_t>(share * static_cast<double>(asked)), random);
        fmt::print("{} triangles: {} rays, {} incident, {} crossings, {} leaks, exact tier {}\n", n * (n - 2), r.rays, r.incident, r.crossings, r.leaks, r.exact);
        std::fflush(stdout);
        CHECK(r.leaks == 0);
    }
}
