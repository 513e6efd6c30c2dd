// grid_frame.h — the axes along which a model is put on the grid.
//
// Faces that are flush stay so on a grid only where the grid's axes are theirs: in a part turned as a whole every corner is rounded by itself, and what was one
// plane becomes many that nearly agree. So where most of the model stands under one rotation the grid is turned with it, and the finished corners are turned back.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// A rotation: from the grid's axes to the world's. The identity, where the model does not stand under one rotation, is exact.
// One that is brought in at many places is none: equal parts at grid distances in the world would lie at others in its axes, and be combined one by one.
Placement grid_frame(const Solid& solid, const Use& root);

// Does the map's linear part take every axis along an axis, up to a few roundings?
bool keeps_axes(const Placement& p);

// The inverse of a rotation, as a transposition.
Placement turned_back(const Placement& rotation);

}  // namespace whittle
