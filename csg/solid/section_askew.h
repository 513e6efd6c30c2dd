// section_askew.h — sections of single shapes in closed form, however they stand. Private to the folder; section.h.
#pragma once

#include <optional>

#include "csg/solid/solid.h"

namespace whittle {

// Where the shape, so placed, meets the plane z = 0, as a 2D use; the empty node where it does not. Nothing where there is no exact form. Requires: the placement does not keep
// the z axis.
std::optional<Use> section_of_askew(SolidBuilder& builder, NodeId id, const Shape& s, const Placement& at);

// A polygon, or the empty node.
Use polygon_of(SolidBuilder& builder, std::vector<std::vector<Vec2>> contours);

// Between circles about the origin of these radii; what is below 0 is left out.
std::optional<Use> rings(SolidBuilder& builder, const std::vector<std::pair<double, double>>& radii);

}  // namespace whittle
