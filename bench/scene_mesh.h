// scene_mesh.h — the mesh one would have made of a scene, for peers that need one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/scenes.h"

namespace whittle::bench {

struct PeerMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Of a meshable scene: the exact booleans of the modeler's mesher, at `chord_error` or 1e-3 of the radius. Of a sponge up to level 4: the faces of its
// cells. Of a mesh: itself. Of instances: their part's. Empty for the others.
PeerMesh peer_mesh(const BenchScene& scene, std::optional<double> chord_error = std::nullopt);

}  // namespace whittle::bench
