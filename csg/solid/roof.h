// roof.h — the solid under a roof: over each point of a flat set the height is its distance from the border.
//
// It is the upright prism over the set, less what is higher than the distance from each side (a wedge over the strip that faces the side) and from
// each reflex corner (a cone that stands on its tip), so it is exact: planes and cones.
#pragma once

#include "csg/solid/facets.h"
#include "csg/solid/solid.h"

namespace whittle {

// Contours as contours_of makes them, not empty.
Use roof_of(SolidBuilder& builder, const Contours& floor);

bool is_one_convex_ring(const Contours& contours);
double ring_area(const std::vector<Vec2>& ring);

}  // namespace whittle
