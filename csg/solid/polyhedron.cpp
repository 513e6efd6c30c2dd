#include "csg/solid/polyhedron.h"

#include <algorithm>
#include <cmath>

#include <gmpxx.h>

#include "csg/solid/directed.h"

namespace whittle {
namespace {

using Facet = std::vector<std::uint32_t>;

struct LessByCoordinates {
    bool operator()(Vec3 a, Vec3 b) const {
        if (a.x != b.x) return a.x < b.x;
        return a.y != b.y ? a.y < b.y : a.z < b.z;
    }
};

// First index of each distinct point, per point.
std::vector<std::uint32_t> first_equal(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> order(points.size()), first(points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return points[a] == points[b] ? a < b : LessByCoordinates{}(points[a], points[b]);
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];
    return first;
}

using Exact = std::array<mpq_class, 3>;
Exact exact_difference(Vec3 a, Vec3 b) { return {mpq_class(a.x) - b.x, mpq_class(a.y) - b.y, mpq_class(a.z) - b.z}; }

bool are_coplanar(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double det = glm::dot(u, glm::cross(v, w));
    const Vec3 su = glm::abs(u), sv = glm::abs(v), sw = glm::abs(w);
    const double size = su.x * (sv.y * sw.z + sv.z * sw.y) + su.y * (sv.z * sw.x + sv.x * sw.z) + su.z * (sv.x * sw.y + sv.y * sw.x);
    if (std::fabs(det) > 16 * 0x1p-53 * size) return false;  // 16 half-ulps bound its eleven roundings
    const Exact p = exact_difference(b, a), q = exact_difference(c, a), r = exact_difference(d, a);
    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]) == 0;
}

bool are_collinear(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 u = b - a, v = c - a, n = glm::abs(glm::cross(u, v)), su = glm::abs(u), sv = glm::abs(v);
    const Vec3 size{su.y * sv.z + su.z * sv.y, su.z * sv.x + su.x * sv.z, su.x * sv.y + su.y * sv.x};
    for (int i = 0; i < 3; ++i)
        if (n[i] > 8 * 0x1p-53 * size[i]) return false;
    const Exact p = exact_difference(b, a), q = exact_difference(c, a);
    return p[1] * q[2] == p[2] * q[1] && p[2] * q[0] == p[0] * q[2] && p[0] * q[1] == p[1] * q[0];
}

// Newell's normal: twice the area vector, whatever the polygon's shape.
Vec3 area_vector(const FacetList& mesh, const Facet& facet) {
    Vec3 n(0);
    const Vec3 o = mesh.points[facet[0]];
    for (std::size_t i = 1; i + 1 < facet.size(); ++i) n += glm::cross(mesh.points[facet[i]] - o, mesh.points[facet[i + 1]] - o);
    return n;
}

double turn(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool holds(Vec2 a, Vec2 b, Vec2 c, Vec2 p) { return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0; }

// Corner `i` of what is left is an ear: convex, and no other corner within its triangle.
bool is_ear(const std::vector<Vec2>& flat, const std::vector<std::size_t>& left, std::size_t i) {
    const std::size_t n = left.size(), before = left[(i + n - 1) % n], here = left[i], after = left[(i + 1) % n];
    if (turn(flat[before], flat[here], flat[after]) <= 0) return false;
    for (const std::size_t k : left)
        if (k != before && k != here && k != after && holds(flat[before], flat[here], flat[after], flat[k])) return false;
    return true;
}

std::vector<Vec2> projected(const FacetList& mesh, const Facet& facet) {
    const Vec3 n = area_vector(mesh, facet), size = glm::abs(n);
    const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    std::vector<Vec2> flat;
    for (const std::uint32_t i : facet) flat.push_back({mesh.points[i][u], mesh.points[i][v]});
    if (n[drop] < 0)
        for (Vec2& p : flat) p.x = -p.x;
    return flat;
}

}  // namespace

FacetList welded(const FacetList& mesh) {
    const std::vector<std::uint32_t> first = first_equal(mesh.points);
    constexpr std::uint32_t kUnused = 0xFFFFFFFF;
    std::vector<std::uint32_t> new_index(mesh.points.size(), kUnused);
    FacetList out;
    for (const Facet& facet : mesh.facets) {
        Facet kept;
        for (const std::uint32_t i : facet)
            if (kept.empty() || kept.back() != first[i]) kept.push_back(first[i]);
        while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
        if (kept.size() < 3) continue;
        for (std::uint32_t& i : kept) {
            if (new_index[i] == kUnused) {
                new_index[i] = static_cast<std::uint32_t>(out.points.size());
                out.points.push_back(mesh.points[i]);
            }
            i = new_index[i];
        }
        out.facets.push_back(std::move(kept));
    }
    return out;
}

std::size_t open_edges(const FacetList& mesh) {
    struct Edge { std::uint32_t low, high; int direction; };
    std::vector<Edge> edges;
    for (const Facet& facet : mesh.facets)
        for (std::size_t i = 0; i < facet.size(); ++i) {
            const std::uint32_t a = facet[i], b = facet[(i + 1) % facet.size()];
            edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    std::size_t open = 0;
    for (std::size_t i = 0; i < edges.size();) {
        int balance = 0;
        std::size_t j = i;
        for (; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high; ++j) balance += edges[j].direction;
        open += static_cast<std::size_t>(std::abs(balance));
        i = j;
    }
    return open;
}

bool is_flat(const FacetList& mesh, const Facet& facet) {
    if (facet.size() <= 3) return true;
    const auto point = [&](std::size_t i) { return mesh.points[facet[i]]; };
    std::size_t third = 2;
    while (third < facet.size() && are_collinear(point(0), point(1), point(third))) ++third;
    for (std::size_t i = third + 1; i < facet.size(); ++i)
        if (!are_coplanar(point(0), point(1), point(third), point(i))) return false;
    return true;
}

std::vector<std::array<std::uint32_t, 3>> triangulated(const FacetList& mesh, const Facet& facet) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<Vec2> flat = projected(mesh, facet);
    std::vector<std::size_t> left(facet.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    while (left.size() >= 3) {
        std::size_t ear = 0;  // a polygon that is not simple may have no ear: then any corner, and the surface stays closed
        for (std::size_t i = 0; i < left.size(); ++i)
            if (is_ear(flat, left, i)) {
                ear = i;
                break;
            }
        const std::size_t n = left.size();
        triangles.push_back({facet[left[(ear + n - 1) % n]], facet[left[ear]], facet[left[(ear + 1) % n]]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

FacetList with_flat_facets(const FacetList& mesh) {
    FacetList out;
    out.points = mesh.points;
    for (const Facet& facet : mesh.facets) {
        if (is_flat(mesh, facet)) {
            out.facets.push_back(facet);
            continue;
        }
        for (const auto& t : triangulated(mesh, facet)) out.facets.push_back({t.begin(), t.end()});
    }
    return out;
}

double signed_volume(const FacetList& mesh) {
    double volume = 0;
    if (mesh.points.empty()) return 0;
    const Vec3 o = mesh.points[0];
    for (const Facet& facet : mesh.facets) volume += glm::dot(mesh.points[facet[0]] - o, area_vector(mesh, facet));
    return volume / 6;
}

}  // namespace whittle
