// grown_arcs.h — sets of straight sides and circular arcs grown or shrunk by a distance, as set operations: the Minkowski sum or difference with a disc, exactly.
#pragma once

#include <optional>

#include "csg/solid/solid.h"

namespace whittle {

// All points nearer than `delta` to the 2D use; below 0 those of it that are farther than -delta from what is outside. In the frame above the use. Every side of
// the outline, as wide to both sides as delta says, is added or taken away: a strip, a part of a ring, and a disc where two sides make a corner.
// Nothing where a side is neither straight nor a circle's arc, or there are more than some thousands; nor below a section (shape::Polygon::section). Requires: delta is finite and not 0.
std::optional<Use> grown_by_arcs(SolidBuilder& builder, const Use& flat, double delta);

}  // namespace whittle
