// section.h — projection() where it has an exact form: sections commute with set operations, shadows with unions.
#pragma once

#include <functional>
#include <optional>

#include "csg/solid/outside.h"
#include "csg/solid/solid.h"

namespace whittle {

// The part of the use in the plane z = 0, as a 2D use; the empty node where there is none. Where a face lies in the plane, what is just above it counts.
// Up to the rounding of placements and corners it is made of 2D shapes for ellipsoids, prisms of any profile, boxes with round edges, capsules and what is bounded by
// facets however they are placed; for cones that are cut in an ellipse; for what is turned about an axis, if that is square to the plane or in it; and for twisted
// and tapered extrusions that stand upright. Any other shape stands below a polygon (shape::Polygon::section) within a tolerance of its section: `outline`'s.
// Nothing where a shape moves, or has no outline.
using OutlineOf = std::function<std::optional<SectionOutline>(const Use&)>;
std::optional<Use> exact_section(SolidBuilder& builder, const Use& use, const OutlineOf& outline);

// What the use covers seen along z: upright shapes and unions of them.
std::optional<Use> exact_shadow(SolidBuilder& builder, const Use& use);

}  // namespace whittle
