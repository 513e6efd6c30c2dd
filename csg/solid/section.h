// section.h — projection() where it has an exact form: sections commute with set operations, shadows with unions.
#pragma once

#include <optional>

#include "csg/solid/solid.h"

namespace whittle {

// The part of the use in the plane z = 0, as a 2D use; the empty node where there is none. Where a face lies in the plane, what is just above it counts.
// Nothing where some shape's section has no exact form: spheres, cylinders, boxes, rings and prisms that stand upright have one, and so has what is
// bounded by facets (up to the rounding of its corners).
std::optional<Use> exact_section(SolidBuilder& builder, const Use& use);

// What the use covers seen along z: upright shapes and unions of them.
std::optional<Use> exact_shadow(SolidBuilder& builder, const Use& use);

}  // namespace whittle
