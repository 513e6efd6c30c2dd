// mesh_report.cpp — what a mesh is, as it stands: closed, oriented, its shells and their genus.
#include <algorithm>

#include "modeler/arrange/edge_order.h"
#include "modeler/arrange/sets.h"
#include "modeler/mesh/mesh.h"
#include "modeler/mesh/own_points.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

struct HalfEdge {
    std::uint32_t lo, hi, triangle;
    auto key() const { return std::pair(lo, hi); }
};

std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles, std::size_t points) {
    std::vector<HalfEdge> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[i][k], b = triangles[i][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), i});
        }
    sort_edges(edges, points, [](const HalfEdge& e) { return e.lo; }, [](const HalfEdge& x, const HalfEdge& y) {
        return x.hi != y.hi ? x.hi < y.hi : x.triangle < y.triangle;
    });
    return edges;
}

std::uint64_t count_duplicates(const std::vector<Triangle>& triangles, std::size_t points) {
    std::vector<Triangle> sorted = triangles;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    sort_edges(sorted, points, [](const Triangle& t) { return t[0]; }, std::less<>());
    std::uint64_t same = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) same += sorted[i] == sorted[i - 1] ? 1U : 0U;
    return same;
}

}  // namespace

Bounds mesh_bounds(const Mesh& mesh) {
    Bounds b;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        b.lo = i == 0 ? mesh.points[i] : glm::min(b.lo, mesh.points[i]);
        b.hi = i == 0 ? mesh.points[i] : glm::max(b.hi, mesh.points[i]);
    }
    return b;
}

// Where solids touch, in an edge or a corner, each has points of its own: then every edge has two triangles, and Euler's formula gives the genus:
// V - E + F = 2(shells - genus).
MeshReport report_mesh(const Mesh& given) {
    Mesh mesh{given.points, given.triangles, {}};
    weld(mesh);
    MeshReport report;
    report.triangles = given.triangles.size();
    report.vertices = mesh.points.size();
    report.degenerate = given.triangles.size() - mesh.triangles.size();
    for (const Triangle& t : mesh.triangles) report.degenerate += is_flat(mesh, t) ? 1U : 0U;
    report.duplicate = count_duplicates(mesh.triangles, mesh.points.size());
    report.open_edges = count_open_edges(mesh.triangles);
    const auto edges = sorted_half_edges(mesh.triangles, mesh.points.size());
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        for (j = i; j < edges.size() && edges[j].key() == edges[i].key(); ++j) {}
        report.shared_edges += (j - i) % 2 == 0 && j - i > 2 ? 1U : 0U;
    }
    const Mesh apart = report.open_edges > 0 ? mesh : with_own_points(mesh);
    DisjointSets shells(apart.points.size());
    std::uint64_t edge_count = 0;
    for (const Triangle& t : apart.triangles) shells.join(t[0], t[1]), shells.join(t[1], t[2]);
    for (const auto halves = sorted_half_edges(apart.triangles, apart.points.size()); const HalfEdge& e : halves) edge_count += &e == halves.data() || e.key() != (&e - 1)->key() ? 1U : 0U;
    for (std::uint32_t v = 0; v < apart.points.size(); ++v) report.components += shells.find(v) == v ? 1U : 0U;
    const auto euler = static_cast<std::int64_t>(apart.points.size() + apart.triangles.size()) - static_cast<std::int64_t>(edge_count);
    report.genus = static_cast<std::int64_t>(report.components) - euler / 2;
    return report;
}

}  // namespace whittle
