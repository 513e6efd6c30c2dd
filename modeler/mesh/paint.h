// paint.h — whose colour a triangle shows: not always that of the shape that made it.
#pragma once

#include <vector>

#include "modeler/mesh/mesh.h"

namespace whittle {

// For each triangle the leaf whose MeshLeaf::shown() it shows. A cutter that names no surface parameter leaves the faces it cuts to the solid that remains.
// Where that was not told (MeshLeaf::filled; all solids are of one matter, or it comes from a part that was combined by itself), they take the leaf of the
// nearest triangle, along the surface, that has one of its own; on a shell without any, the first leaf that adds.
// Empty where the mesh knows no leaves.
std::vector<std::uint32_t> painting_leaves(const MeshResult& result);

}  // namespace whittle
