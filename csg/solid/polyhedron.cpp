#include "csg/solid/polyhedron.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/predicates.h"

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

// Newell's normal: twice the area vector, whatever the polygon's shape.
Vec3 area_vector(const FacetList& mesh, const Facet& facet) {
    Vec3 n(0);
    const Vec3 o = mesh.points[facet[0]];
    for (std::size_t i = 1; i + 1 < facet.size(); ++i) n += glm::cross(mesh.points[facet[i]] - o, mesh.points[facet[i + 1]] - o);
    return n;
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

std::vector<IndexTriangle> triangulated(const FacetList& mesh, const Facet& facet) {
    Facet ring(facet.size());
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = static_cast<std::uint32_t>(i);
    auto triangles = ear_clipped(projected(mesh, facet), {ring});
    if (!triangles) {  // not simple: a fan keeps the surface closed
        triangles.emplace();
        for (std::uint32_t i = 2; i < facet.size(); ++i) triangles->push_back({0, i - 1, i});
    }
    for (auto& t : *triangles)
        for (auto& corner : t) corner = facet[corner];
    return *triangles;
}

bool is_convex(const FacetList& mesh, const Facet& facet) {
    if (facet.size() <= 3) return true;
    const std::vector<Vec2> flat = projected(mesh, facet);
    const std::size_t n = flat.size();
    int times_lowest = 0;  // a convex polygon goes down and up once
    for (std::size_t i = 0; i < n; ++i) {
        if (turn_of(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0) return false;
        const auto lower = [](Vec2 a, Vec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
        times_lowest += lower(flat[(i + 1) % n], flat[i]) && lower(flat[(i + 1) % n], flat[(i + 2) % n]);
    }
    return times_lowest == 1;
}

FacetList with_convex_facets(const FacetList& mesh) {
    FacetList out;
    out.points = mesh.points;
    for (const Facet& facet : mesh.facets) {
        if (is_convex(mesh, facet)) {
            out.facets.push_back(facet);
            continue;
        }
        for (const auto& t : triangulated(mesh, facet)) out.facets.push_back({t.begin(), t.end()});
    }
    return out;
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
