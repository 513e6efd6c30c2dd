// mesh_part.h — a few triangles of a large mesh taken out, to be worked on by themselves and put back.
#pragma once

#include <vector>

#include "modeler/mesh/mesh.h"

namespace whittle {

// Adds all triangles that have a corner of a chosen one.
void grow_by_ring(const Mesh& mesh, std::vector<bool>& chosen);

// The chosen triangles in their order, with the points they use.
Mesh part_of(const Mesh& mesh, const std::vector<bool>& chosen);
void remove_part(Mesh& mesh, const std::vector<bool>& chosen);  // points stay

// Behind what the mesh has, with points of its own: weld() joins them.
void append(Mesh& mesh, const Mesh& part);

}  // namespace whittle
