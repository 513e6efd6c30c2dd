#include "modeler/mesh/mesh_part.h"

#include <limits>

namespace whittle {

void grow_by_ring(const Mesh& mesh, std::vector<bool>& chosen) {
    std::vector<bool> near(mesh.points.size(), false);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
            for (const std::uint32_t v : mesh.triangles[i]) near[v] = true;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (near[t[0]] || near[t[1]] || near[t[2]]) chosen[i] = true;
    }
}

Mesh part_of(const Mesh& mesh, const std::vector<bool>& chosen) {
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    Mesh part;
    std::vector<std::uint32_t> renamed(mesh.points.size(), kNone);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!chosen[i]) continue;
        Triangle t = mesh.triangles[i];
        for (std::uint32_t& v : t) {
            if (renamed[v] == kNone) {
                renamed[v] = static_cast<std::uint32_t>(part.points.size());
                part.points.push_back(mesh.points[v]);
            }
            v = renamed[v];
        }
        part.triangles.push_back(t);
        if (!mesh.leaf.empty()) part.leaf.push_back(mesh.leaf[i]);
    }
    return part;
}

void remove_part(Mesh& mesh, const std::vector<bool>& chosen) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (chosen[i]) continue;
        mesh.triangles[kept] = mesh.triangles[i];
        if (!mesh.leaf.empty()) mesh.leaf[kept] = mesh.leaf[i];
        ++kept;
    }
    mesh.triangles.resize(kept);
    if (!mesh.leaf.empty()) mesh.leaf.resize(kept);
}

void append(Mesh& mesh, const Mesh& part) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (const Triangle& t : part.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.leaf.insert(mesh.leaf.end(), part.leaf.begin(), part.leaf.end());
}

}  // namespace whittle
