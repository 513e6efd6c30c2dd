// rounded.h — the Minkowski sum of a solid of facets and a ball: what lies within its radius of the solid.
//
// A point outside is nearest to a facet, to an edge that sticks out, or to a corner of such edges: the sum is the solid, a slab over each face, a capsule along each of
// these edges and a ball at each of these corners. Edges that are hollow or flat need nothing.
// Source: Schneider, Convex Bodies: The Brunn-Minkowski Theory (1993), 4.2 local parallel sets.
#pragma once

#include <optional>

#include "csg/solid/solid.h"

namespace whittle {

// The sum, moved by the ball's centre. Nothing where the list is not closed, or more than `most` slabs, capsules and balls would be needed.
// Requires: r > 0; facets convex, counter-clockwise seen from outside.
std::optional<Use> rounded_by_ball(SolidBuilder& builder, const FacetList& list, const Vec3& centre, double r, std::size_t most);

}  // namespace whittle
