// weld.h — joins equal points of a mesh and drops what that makes empty; counts what is open.
#pragma once

#include "modeler/mesh/mesh.h"

namespace whittle {

// Equal points become one, numbered by first use; triangles with two equal corners go, and so do pairs of opposite triangles on the same corners.
void weld(Mesh& mesh);

// Directed edges without as many opposite ones.
std::uint64_t count_open_edges(const std::vector<Triangle>& triangles);

}  // namespace whittle
