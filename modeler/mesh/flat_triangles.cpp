// flat_triangles.cpp — takes out triangles that rounding has pressed flat, without opening the mesh.
//
// A flat triangle with three different corners has one of them on its longest side. Its neighbour across that side is cut in two at this corner,
// and the flat one is gone: no point moves, every edge keeps two triangles. Cutting may press another one flat, so it is repeated.
#include <algorithm>
#include <limits>
#include <vector>

#include "modeler/mesh/mesh_part.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

struct DirectedEdge {
    std::uint64_t key;
    std::uint32_t triangle;
    bool operator<(const DirectedEdge& o) const { return key != o.key ? key < o.key : triangle < o.triangle; }
};
std::uint64_t key_of(std::uint32_t from, std::uint32_t to) { return static_cast<std::uint64_t>(from) << 32 | to; }

std::vector<DirectedEdge> sorted_edges(const std::vector<Triangle>& triangles) {
    std::vector<DirectedEdge> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back({key_of(triangles[i][k], triangles[i][(k + 1) % 3]), i});
    std::sort(edges.begin(), edges.end());
    return edges;
}

// The one triangle that runs along (from, to), if there is exactly one.
std::uint32_t only_one(const std::vector<DirectedEdge>& edges, std::uint32_t from, std::uint32_t to) {
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    const std::uint64_t key = key_of(from, to);
    const auto at = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{key, 0});
    if (at == edges.end() || at->key != key) return kNone;
    const auto next = at + 1;
    return next != edges.end() && next->key == key ? kNone : at->triangle;
}

double squared_length(const Vec3& v) { return glm::dot(v, v); }

// The corner opposite to the longest side.
std::size_t middle_corner(const Mesh& mesh, const Triangle& t) {
    std::size_t best = 0;
    double longest = -1;
    for (std::size_t k = 0; k < 3; ++k)
        if (const double l = squared_length(mesh.points[t[(k + 1) % 3]] - mesh.points[t[(k + 2) % 3]]); l > longest) longest = l, best = k;
    return best;
}

// One round over triangles that do not share a neighbour; returns how many went.
std::size_t one_round(Mesh& mesh) {
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> flat;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        if (is_flat(mesh, mesh.triangles[i])) flat.push_back(i);
    if (flat.empty()) return 0;
    const auto edges = sorted_edges(mesh.triangles);
    std::vector<bool> touched(mesh.triangles.size(), false);
    std::size_t gone = 0;
    for (const std::uint32_t i : flat) {
        Triangle& t = mesh.triangles[i];
        const std::size_t k = middle_corner(mesh, t);
        const std::uint32_t m = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        const std::uint32_t j = only_one(edges, b, a);
        if (touched[i] || j == kNone || touched[j] || j == i) continue;
        Triangle& n = mesh.triangles[j];
        const std::uint32_t d = n[0] != a && n[0] != b ? n[0] : n[1] != a && n[1] != b ? n[1] : n[2];
        touched[i] = touched[j] = true;
        t = {m, a, d};  // (m, a) was an edge of the flat one, (a, d) and (d, b) of its neighbour
        n = {b, m, d};
        if (!mesh.leaf.empty()) mesh.leaf[i] = mesh.leaf[j];
        ++gone;
    }
    return gone;
}

}  // namespace

bool is_flat(const Mesh& mesh, const Triangle& t) {
    return glm::cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]) == Vec3{0};
}

namespace {

void remove_in_rounds(Mesh& mesh) {
    constexpr int kRounds = 64;  // each shortens the chain of flat triangles along one line
    for (int i = 0; i < kRounds && one_round(mesh) > 0; ++i) weld(mesh);
}

}  // namespace

// Of a large mesh with few flat triangles only these and those around them are touched: every round goes over all it is given.
void remove_flat_triangles(Mesh& mesh) {
    constexpr std::size_t kLarge = 100000, kFewOf = 64;
    constexpr int kRings = 3, kTimes = 8;  // a chain that leaves the rings is found again
    for (int time = 0; time < kTimes; ++time) {
        std::vector<bool> chosen(mesh.triangles.size(), false);
        std::size_t flat = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (is_flat(mesh, mesh.triangles[i])) chosen[i] = true, ++flat;
        if (flat == 0) return;
        if (mesh.triangles.size() < kLarge || flat > mesh.triangles.size() / kFewOf) return remove_in_rounds(mesh);
        for (int ring = 0; ring < kRings; ++ring) grow_by_ring(mesh, chosen);
        Mesh part = part_of(mesh, chosen);
        const std::vector<Triangle> before = part.triangles;
        remove_in_rounds(part);
        if (part.triangles == before) return;
        remove_part(mesh, chosen);
        append(mesh, part);
        weld(mesh);
    }
}

}  // namespace whittle
