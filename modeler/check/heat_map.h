// heat_map.h — the mesh with each facet coloured by how far it strays from the exact surface.
#pragma once

#include "csg/base/result.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

struct HeatMap {
    MeshResult result;        // the mesh; its leaves are the colours, from none of what is allowed (blue) over half (green) to all (red), and more (white)
    double most_mm = 0;       // the largest deviation seen
    double allowed_mm = 0;    // tolerance and rounding, as check_agreement allows them
    std::size_t beyond = 0;   // facets with a point that strays farther
};

// The deviation of a facet: the largest distance of its centre and its sides' middles from the nearest leaf boundary. Bounds are those of a mesh that
// mesh_solid() made of `solid`. Fails as check_agreement does.
Result<HeatMap> heat_map(const Solid& solid, const MeshResult& made);

}  // namespace whittle
