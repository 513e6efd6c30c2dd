// predicates.h — signs of determinants of the author's points, exactly: a filter in double, then rationals.
//
// Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates (1997), for the filters' bounds.
#pragma once

#include "csg/base/vec.h"

namespace whittle {

// 1 where a, b, c turn left, -1 where right, 0 on a line.
int turn_of(Vec2 a, Vec2 b, Vec2 c);
bool are_collinear(Vec3 a, Vec3 b, Vec3 c);
bool are_coplanar(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
// 1 where d lies above the plane of a, b, c (they turn left seen from d), -1 below, 0 in it.
int side_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

}  // namespace whittle
