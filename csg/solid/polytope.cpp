#include "csg/solid/polytope.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/convex_hull.h"

namespace whittle {
namespace {

// Facets of a hull of rounded points that were one face differ in their normals by this at most, unless they are slivers; two planes too many cost two more
// pieces, no more.
constexpr double kSamePlane = 0x1p-30;

bool before(const Vec3& a, const Vec3& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

double height(const Plane& plane, const Vec3& p) { return glm::dot(plane.n, p) - plane.d; }

// The same bits from either end.
Vec3 crossing(const Plane& plane, Vec3 a, Vec3 b) {
    if (before(b, a)) std::swap(a, b);
    const double from = height(plane, a), to = height(plane, b);
    return a + (b - a) * (from / (from - to));
}

std::vector<Vec3> each_once(std::vector<Vec3> points) {
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

// The corners of a new facet in their order about its middle.
std::vector<Vec3> ring_of(std::vector<Vec3> points, const Vec3& n) {
    points = each_once(std::move(points));
    if (points.size() < 3) return {};
    Vec3 middle(0);
    for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
    const Vec3 helper = std::fabs(n.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), u = glm::normalize(glm::cross(helper, n)), v = glm::cross(n, u);
    const auto angle = [&](const Vec3& p) { return std::atan2(glm::dot(p - middle, v), glm::dot(p - middle, u)); };
    std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return angle(a) < angle(b); });
    return points;
}

std::optional<Plane> plane_of(const std::vector<Vec3>& ring) {
    Vec3 n(0);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) n += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    const double length = glm::length(n);
    if (!(length > 0)) return std::nullopt;
    n /= length;
    return Plane{n, glm::dot(n, ring[0])};
}

}  // namespace

Polytope polytope_of(std::vector<Vec3> points) {
    Polytope out;
    const auto hull = convex_hull_of(std::move(points));
    if (!hull) return out;
    for (const auto& facet : hull->facets) {
        auto& ring = out.emplace_back();
        for (const std::uint32_t i : facet) ring.push_back(hull->points[i]);
    }
    return out;
}

std::vector<Vec3> corners_of(const Polytope& polytope) {
    std::vector<Vec3> out;
    for (const auto& ring : polytope) out.insert(out.end(), ring.begin(), ring.end());
    return each_once(std::move(out));
}

std::vector<Plane> planes_of(const Polytope& polytope) {
    double size = 0;
    for (const auto& ring : polytope)
        for (const Vec3& p : ring) size = std::max(size, glm::length(p));
    std::vector<Plane> out;
    for (const auto& ring : polytope) {
        const auto plane = plane_of(ring);
        if (!plane) continue;
        const bool known = std::any_of(out.begin(), out.end(), [&](const Plane& p) { return glm::distance(p.n, plane->n) <= kSamePlane && std::fabs(p.d - plane->d) <= kSamePlane * size; });
        if (!known) out.push_back(*plane);
    }
    return out;
}

Polytope clipped(const Polytope& polytope, const Plane& plane, double slack) {
    bool some_inside = false, some_outside = false;
    for (const auto& ring : polytope)
        for (const Vec3& p : ring) {
            some_inside |= height(plane, p) < -slack;
            some_outside |= height(plane, p) > slack;
        }
    if (!some_inside) return {};
    if (!some_outside) return polytope;
    Polytope out;
    std::vector<Vec3> cut;
    for (const auto& ring : polytope) {
        std::vector<Vec3> kept;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec3 &p = ring[i], &q = ring[(i + 1) % ring.size()];
            const double from = height(plane, p), to = height(plane, q);
            if (from <= slack) kept.push_back(p);
            if (std::fabs(from) <= slack) cut.push_back(p);
            if ((from > slack && to < -slack) || (from < -slack && to > slack)) {
                kept.push_back(crossing(plane, p, q));
                cut.push_back(kept.back());
            }
        }
        const bool reaches_in = std::any_of(kept.begin(), kept.end(), [&](const Vec3& p) { return height(plane, p) < -slack; });
        if (kept.size() >= 3 && reaches_in) out.push_back(std::move(kept));
    }
    if (auto ring = ring_of(std::move(cut), plane.n); ring.size() >= 3) out.push_back(std::move(ring));
    return out;
}

std::vector<Polytope> difference(const Polytope& a, const std::vector<Plane>& b, double slack) {
    std::vector<Polytope> out;
    Polytope rest = a;
    for (const Plane& plane : b) {
        if (auto piece = clipped(rest, {-plane.n, -plane.d}, slack); !piece.empty()) out.push_back(std::move(piece));
        rest = clipped(rest, plane, slack);
        if (rest.empty()) return {a};
    }
    return out;
}

}  // namespace whittle
