// settle.h — a mesh in the precision it will have, without facets that cross there.
//
// Rounding moves points, and slivers may then cross. What crosses is arranged once more with the facets around it (settle_piece.h), on the points as they are now, and
// rounded again, until nothing does: mostly once. The rest of the mesh stays as it is, so this takes what the crossings take, not what the mesh does.
// Source: iterated snap rounding: Halperin and Packer (2002); in three dimensions Lazard and Valque, Removing self-intersections in triangular meshes (2024).
#pragma once

#include "modeler/mesh/mesh.h"

namespace whittle {

struct Settled {
    Mesh mesh;                     // welded, no triangle of no area
    std::uint64_t crossings = 0;   // pairs of triangles that still cross
    bool rearranged = false;
};

// In double: points of binary fractions of the model's size, where `mesh` has crossings; else `mesh` itself.
Settled settled_in_double(const Mesh& mesh, MeshControl& control);
// In float32: every coordinate of the result is a float.
Settled settled_in_single(const Mesh& mesh, MeshControl& control);

}  // namespace whittle
