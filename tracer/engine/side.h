// side.h — on which side of the ray does a point or an edge pass? Filter in double, then in double-double, then exact with the perturbation: never zero.
//
// The answer for a shared vertex or edge is the same for all facets that share it, which makes meshes and prisms watertight.
#pragma once

#include "tracer/engine/ray_context.h"

namespace whittle {

// Sign of du (v.y - o_v) - dv (v.x - o_u), where u = axis+1, v = axis+2: the ray's shadow along the axis against a point. 0: the ray is parallel
// to the axis, exactly.
int side_of_point(RayContext& context, FrameId frame, int axis, Vec2 point);

// Sign of d . ((a - o) x (b - o)). 0 only where a == b or the ray's direction lies along a - b, exactly.
int side_of_edge(RayContext& context, FrameId frame, const Vec3& a, const Vec3& b);

// Does the point that the ray's shadow along the axis shrinks to lie to the left of the line from a to b? Requires: the ray is parallel to the axis. +1 left.
int side_of_line(RayContext& context, FrameId frame, int axis, Vec2 a, Vec2 b);
// Sign of o_v - y for the same.
int height_against(RayContext& context, FrameId frame, int axis, double y);

}  // namespace whittle
