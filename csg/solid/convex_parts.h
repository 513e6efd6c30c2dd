// convex_parts.h — what a convex hull depends on: the corners and balls of a set, and upright prisms as what they are swept from.
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// A ball, in 2D a disc (z = 0); a corner where r is 0.
struct Ball { Vec3 c; double r = 0; };

// Balls and corners whose hull is the hull of the use, rounded once; nothing where there are none such: below intersections and differences, for other
// curves, in motion.
std::optional<std::vector<Ball>> balls_of(const Solid& solid, const Use& use);

// A 2D set swept upright from z0 to z1.
struct Prism { Use profile; double z0, z1; };

// The use as a prism in the frame above it, where it is one: boxes, cylinders, straight extrusions whose placement keeps the z axis.
std::optional<Prism> prism_of(SolidBuilder& builder, const Use& use);

// By how much a placement scales where it is a similarity, up to the rounding of its entries; `flat`: only the plane counts.
std::optional<double> similarity_of(const Placement& a, bool flat);

// Does the placement map z to z alone, and x, y to x, y?
bool keeps_z(const Placement& a);

}  // namespace whittle
