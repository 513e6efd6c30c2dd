// shape_bounds.h — the box of one shape in its own frame.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// Closed, outward rounded, infinite where the shape is. `part` is the box of the node that the shape is made of: a profile, or the solid that a polygon is the section of.
// Empty where the shape certainly holds nothing (a quadric without real points, a profile without any).
Bounds shape_bounds(const Shape& shape, const Bounds& part);

}  // namespace whittle
