// convex_hull.h — the convex hull of the author's points, exactly: every decision is the sign of a determinant, corners keep their bits.
//
// Source: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls (1996); Andrew's monotone chain in the plane (1979).
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// Triangles counter-clockwise seen from outside; nothing where all points lie in one plane. Same points, same list.
std::optional<FacetList> convex_hull_of(std::vector<Vec3> points);

// Counter-clockwise, without corners on a side; fewer than three points where all lie on a line.
std::vector<Vec2> convex_hull_of(std::vector<Vec2> points);

// The points of one, each moved by each of the other's: their hull is the Minkowski sum of the two hulls.
std::vector<Vec3> sums_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace whittle
