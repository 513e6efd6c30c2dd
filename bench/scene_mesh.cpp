// scene_mesh.cpp — meshes by the modeler, or cell by cell.
#include "bench/scene_mesh.h"

#include "modeler/mesh/mesh.h"

namespace whittle::bench {

namespace {

bool in_sponge(int level, int cells, int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= cells || y >= cells || z >= cells) return false;
    for (int k = 0; k < level; ++k, x /= 3, y /= 3, z /= 3)
        if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
    return true;
}

// Two triangles of the cell's face towards +-axis.
void add_face(PeerMesh& mesh, int cells, const std::array<int, 3>& cell, std::size_t axis, bool up) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
        std::array<int, 3> p = cell;
        p[axis] += up ? 1 : 0;
        p[a] += corner == 1 || corner == 2 ? 1 : 0;
        p[b] += corner >= 2 ? 1 : 0;
        mesh.points.emplace_back((2.0 * p[0] - cells) / cells, (2.0 * p[1] - cells) / cells, (2.0 * p[2] - cells) / cells);
    }
    const auto triangle = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { mesh.triangles.push_back({first + i, first + (up ? j : k), first + (up ? k : j)}); };
    triangle(0, 1, 2);
    triangle(0, 2, 3);
}

PeerMesh sponge_faces(int level) {
    PeerMesh mesh;
    int cells = 1;
    for (int k = 0; k < level; ++k) cells *= 3;
    for (int x = 0; x < cells; ++x)
        for (int y = 0; y < cells; ++y)
            for (int z = 0; z < cells; ++z) {
                if (!in_sponge(level, cells, x, y, z)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (const bool up : {false, true}) {
                        std::array<int, 3> beside{x, y, z};
                        beside[axis] += up ? 1 : -1;
                        if (!in_sponge(level, cells, beside[0], beside[1], beside[2])) add_face(mesh, cells, {x, y, z}, axis, up);
                    }
            }
    return mesh;
}

}  // namespace

PeerMesh peer_mesh(const BenchScene& scene, std::optional<double> chord_error) {
    if (scene.part) return peer_mesh(*scene.part, chord_error);
    if (scene.sponge_level > 0) return scene.sponge_level <= 4 ? sponge_faces(scene.sponge_level) : PeerMesh{};
    if (scene.facets) {
        PeerMesh mesh{scene.facets->points, {}};
        for (const auto& f : scene.facets->facets) mesh.triangles.push_back({f[0], f[1], f[2]});
        return mesh;
    }
    if (!scene.meshable) return {};
    MeshOptions options;
    options.tolerance_mm = chord_error;
    MeshControl control;
    const Result<MeshResult> made = mesh_solid(scene.solid, options, control);
    if (!made) return {};
    return {made->mesh.points, made->mesh.triangles};
}

}  // namespace whittle::bench
