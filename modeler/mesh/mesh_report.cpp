// mesh_report.cpp — what a mesh is, as it stands: closed, oriented, its shells and their genus.
#include <algorithm>
#include <numeric>

#include "modeler/mesh/mesh.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

class Sets {  // union-find, path halving
public:
    explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t find(std::uint32_t x) {
        while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
        return x;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }
    std::uint64_t count() {
        std::uint64_t n = 0;
        for (std::uint32_t i = 0; i < parent_.size(); ++i) n += find(i) == i ? 1U : 0U;
        return n;
    }

private:
    std::vector<std::uint32_t> parent_;
};

struct HalfEdge {
    std::uint32_t lo, hi, triangle, slot;
    bool forward;  // from lo to hi
    auto key() const { return std::pair(lo, hi); }
};

std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles) {
    std::vector<HalfEdge> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[i][k], b = triangles[i][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), i, k, a < b});
        }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
        return x.key() != y.key() ? x.key() < y.key() : x.triangle < y.triangle;
    });
    return edges;
}

std::uint64_t count_duplicates(const std::vector<Triangle>& triangles) {
    std::vector<Triangle> sorted = triangles;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    std::sort(sorted.begin(), sorted.end());
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

// Corners of triangles that hang together by edges of two are one vertex of a shell; where solids touch, in an edge or a corner, shells have their
// own. Euler's formula then gives the genus: V - E + F = 2(shells - genus).
MeshReport report_mesh(const Mesh& given) {
    Mesh mesh{given.points, given.triangles, {}};
    weld(mesh);
    MeshReport report;
    report.triangles = given.triangles.size();
    report.vertices = mesh.points.size();
    report.degenerate = given.triangles.size() - mesh.triangles.size();
    for (const Triangle& t : mesh.triangles) report.degenerate += is_flat(mesh, t) ? 1U : 0U;
    report.duplicate = count_duplicates(mesh.triangles);
    report.open_edges = count_open_edges(mesh.triangles);

    const auto edges = sorted_half_edges(mesh.triangles);
    Sets shells(mesh.triangles.size()), corners(mesh.triangles.size() * 3);
    std::int64_t edge_count = 0;
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        for (j = i; j < edges.size() && edges[j].key() == edges[i].key(); ++j) {}
        const HalfEdge &a = edges[i], &b = edges[j - 1];
        if (j - i == 2 && a.forward != b.forward) {
            ++edge_count;
            shells.join(a.triangle, b.triangle);
            corners.join(a.triangle * 3 + a.slot, b.triangle * 3 + (b.slot + 1) % 3);
            corners.join(a.triangle * 3 + (a.slot + 1) % 3, b.triangle * 3 + b.slot);
        } else {
            edge_count += static_cast<std::int64_t>((j - i + 1) / 2);
            report.shared_edges += (j - i) % 2 == 0 && j - i > 2 ? 1U : 0U;
        }
    }
    report.components = mesh.triangles.empty() ? 0 : shells.count();
    const auto v = static_cast<std::int64_t>(corners.count()), f = static_cast<std::int64_t>(mesh.triangles.size());
    report.genus = static_cast<std::int64_t>(report.components) - (v - edge_count + f) / 2;
    return report;
}

}  // namespace whittle
