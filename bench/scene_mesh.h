// scene_mesh.h — the mesh one would have made of a scene, for peers that need one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bench/scenes.h"

namespace whittle::bench {

struct PeerMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// S1, S2: the exact booleans of the modeler's mesher at a chord error of 1e-3 of the radius. S6: the faces of the cells. Empty for the others.
PeerMesh peer_mesh(const BenchScene& scene);

}  // namespace whittle::bench
