// nearest_point.h — distances from a point to the boundaries of simple shapes in their own frames.
#pragma once

#include <span>

#include "csg/solid/solid.h"
#include "modeler/check/leaf_distance.h"

namespace whittle {

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);
double distance_to_segment(Vec3 p, Vec3 a, Vec3 b);
// A planar polygon, convex or not, even-odd.
double distance_to_polygon(Vec3 p, std::span<const Vec3> polygon);
// To the ellipsoid's surface, by bisection of the one root that the nearest point is (Eberly, Distance from a point to an ellipsoid, 2013).
double distance_to_ellipsoid(Vec3 p, Vec3 radii);

// In the shape's own frame. Extrusions and revolutions have none: their profiles are leaves of their own; shapes of facets neither (placed_facets.h).
LeafDistance boundary_distance(const Shape& shape, Vec3 p);
// Of a 2D shape's boundary in its plane.
LeafDistance boundary_distance_2d(const Shape& shape, Vec2 p);

}  // namespace whittle
