// exact_hull.h — hull() and minkowski() where they have an exact form: polytopes, balls and discs of any radii, upright prisms, bodies of revolution
// about one axis.
//
// The hull of balls is the union of the balls, of the cones that touch two of them, and of the polytope of the points in which planes touch three:
// a flat part of the border lies in the polytope, a cone's in its cone, a ball's in its ball. In 2D likewise with discs, lines and a polygon.
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// Operands of one dimension, none empty. Nothing where no exact form is known, or where the hull has no inside (`flat` is then set).
struct HullResult {
    std::optional<Use> use;
    bool flat = false;
};
HullResult exact_hull(SolidBuilder& builder, const std::vector<Use>& operands);

// Is the set, of three dimensions, known to be convex? Not every convex one is: bodies the hull of which is a union of pieces are told by who made them.
bool is_known_convex(SolidBuilder& builder, const Use& use);

// The sum of two convex sets, or of any 2D set with straight sides and a polygon. Nothing where no exact form is known.
std::optional<Use> exact_minkowski(SolidBuilder& builder, const Use& a, const Use& b);

}  // namespace whittle
