// scene_mesh.cpp — meshes by the modeler, or cell by cell.
#include "bench/scene_mesh.h"

#include "modeler/mesh/mesh.h"

namespace whittle::bench {

namespace {

bool in_sponge(int x, int y, int z) {
    constexpr int n = 81;
    if (x < 0 || y < 0 || z < 0 || x >= n || y >= n || z >= n) return false;
    for (int k = 0; k < 4; ++k, x /= 3, y /= 3, z /= 3)
        if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
    return true;
}

// Two triangles of the cell's face towards +-axis.
void add_face(PeerMesh& mesh, const std::array<int, 3>& cell, std::size_t axis, bool up) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
        std::array<int, 3> p = cell;
        p[axis] += up ? 1 : 0;
        p[a] += corner == 1 || corner == 2 ? 1 : 0;
        p[b] += corner >= 2 ? 1 : 0;
        mesh.points.emplace_back((2.0 * p[0] - 81) / 81, (2.0 * p[1] - 81) / 81, (2.0 * p[2] - 81) / 81);
    }
    const auto triangle = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { mesh.triangles.push_back({first + i, first + (up ? j : k), first + (up ? k : j)}); };
    triangle(0, 1, 2);
    triangle(0, 2, 3);
}

PeerMesh sponge_faces() {
    PeerMesh mesh;
    for (int x = 0; x < 81; ++x)
        for (int y = 0; y < 81; ++y)
            for (int z = 0; z < 81; ++z) {
                if (!in_sponge(x, y, z)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (const bool up : {false, true}) {
                        std::array<int, 3> beside{x, y, z};
                        beside[axis] += up ? 1 : -1;
                        if (!in_sponge(beside[0], beside[1], beside[2])) add_face(mesh, {x, y, z}, axis, up);
                    }
            }
    return mesh;
}

}  // namespace

PeerMesh peer_mesh(const BenchScene& scene) {
    if (scene.name == "S6") return sponge_faces();
    if (scene.name != "S1" && scene.name != "S2") return {};
    MeshControl control;
    const Result<MeshResult> made = mesh_solid(scene.solid, {}, control);
    if (!made) return {};
    return {made->mesh.points, made->mesh.triangles};
}

}  // namespace whittle::bench
