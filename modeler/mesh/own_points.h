// own_points.h — points of their own for parts of a solid that only touch, for formats and programs that know edges of two facets only.
#pragma once

#include "modeler/mesh/mesh.h"

namespace whittle {

// The same surface with points of their own for parts that touch in an edge or a point only: every edge has two triangles, every point one fan of
// them. Where parts touch along an edge, the sides of one part stay together. Triangles keep their number and order, new points come behind the old.
// Requires: closed, without knots (below; their edges keep all their triangles).
Mesh with_own_points(const Mesh& mesh);

// A knot is an edge at which two sheets touch that hang together around both its ends, as where two pits meet along an edge within a block: no point
// can be given away there. It gets a point in its middle, which each sheet can have for itself. Equal points must be one. Returns how many.
std::size_t divide_knots(Mesh& mesh);

}  // namespace whittle
