#include "modeler/mesh/paint.h"

#include <algorithm>
#include <limits>

namespace whittle {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();

// Triangles by undirected edge, so that those on one edge stand side by side.
std::vector<std::pair<std::uint64_t, std::uint32_t>> triangles_by_edge(const std::vector<Triangle>& triangles) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = triangles[i][k], b = triangles[i][(k + 1) % 3];
            edges.emplace_back(std::min(a, b) << 32 | std::max(a, b), i);
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace

std::vector<std::uint32_t> painting_leaves(const MeshResult& result) {
    const Mesh& mesh = result.mesh;
    std::vector<std::uint32_t> paint(mesh.leaf.size(), kNone), front;
    std::uint32_t first = 0;
    while (first + 1 < result.leaves.size() && result.leaves[first].subtracts()) ++first;
    for (std::uint32_t i = 0; i < mesh.leaf.size(); ++i) {
        const MeshLeaf& leaf = result.leaves[mesh.leaf[i]];
        if (leaf.subtracts() && !leaf.shown().names_surface() && !leaf.filled) continue;
        paint[i] = mesh.leaf[i];
        if (!leaf.subtracts()) front.push_back(i);  // what a cutter painted is not handed on
    }
    if (std::find(paint.begin(), paint.end(), kNone) == paint.end()) return paint;
    const auto edges = triangles_by_edge(mesh.triangles);
    for (std::vector<std::uint32_t> next; !front.empty(); front.swap(next)) {
        next.clear();
        for (const std::uint32_t i : front)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3], key = std::min(a, b) << 32 | std::max(a, b);
                for (auto at = std::lower_bound(edges.begin(), edges.end(), std::pair(key, 0U)); at != edges.end() && at->first == key; ++at)
                    if (paint[at->second] == kNone) {
                        paint[at->second] = paint[i];
                        next.push_back(at->second);
                    }
            }
    }
    std::replace(paint.begin(), paint.end(), kNone, first);
    return paint;
}

}  // namespace whittle
