// weld.h — joins equal points of a mesh and drops what that makes empty; counts what is open.
#pragma once

#include "modeler/mesh/mesh.h"

namespace whittle {

// Equal points become one, numbered by first use; triangles with two equal corners go, and so do pairs of opposite triangles on the same corners.
void weld(Mesh& mesh);

// Is the triangle of no area, its normal computed in double?
bool is_flat(const Mesh& mesh, const Triangle& t);

// Takes such triangles out, keeping the mesh closed; those in a place where it is not a surface stay.
void remove_flat_triangles(Mesh& mesh);

// Directed edges without as many opposite ones.
std::uint64_t count_open_edges(const std::vector<Triangle>& triangles);

}  // namespace whittle
