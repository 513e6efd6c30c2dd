// polytope.h — convex polytopes cut by planes, in double arithmetic: for pieces that something is added to afterwards, so that a gap of a rounding between two
// of them is covered.
//
// Source: Sutherland, Hodgman, Reentrant Polygon Clipping (1974).
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

struct Plane { Vec3 n; double d; };  // n of length 1; inside is n.p <= d

// The border as convex polygons, counter-clockwise seen from outside; a corner has the same bits in each. None: the empty set.
using Polytope = std::vector<std::vector<Vec3>>;

// The hull of the points; empty where they lie in one plane.
Polytope polytope_of(std::vector<Vec3> points);

// Each corner once.
std::vector<Vec3> corners_of(const Polytope& polytope);

// Those of its facets, each once: facets that a rounding parts are one plane.
std::vector<Plane> planes_of(const Polytope& polytope);

// What lies inside of the plane; corners within the slack of it lie in it. Empty where nothing reaches further inside than the slack.
Polytope clipped(const Polytope& polytope, const Plane& plane, double slack);

// Convex pieces, disjoint but for their borders, whose union is a less the set inside of all the planes; {a} where they do not meet.
std::vector<Polytope> difference(const Polytope& a, const std::vector<Plane>& b, double slack);

}  // namespace whittle
