// shape_bounds.h — the box of one shape in its own frame.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// Closed, outward rounded, infinite where the shape is. `profile` is the box of the 2D node below an extrusion or a revolution.
// Empty where the shape certainly holds nothing (a quadric without real points, a profile without any).
Bounds shape_bounds(const Shape& shape, const Bounds& profile);

}  // namespace whittle
