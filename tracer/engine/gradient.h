// gradient.h — normals: the gradient of a support at a point.
#pragma once

#include "tracer/engine/support.h"

namespace whittle {

// Squares of lengths in here neither lose bits nor overflow.
inline constexpr double kLeastSafeSquare = 0x1p-900, kMostSafeSquare = 0x1p+900;

// n / |n|; (0, 0, 1) for a vector of no length.
Vec3 unit_vector(Vec3 n);

// Unit gradient (towards outside) at a point of the root frame, by the inverse transpose of the frame; relative error a few units of roundoff times
// the condition of the frame. The direction is arbitrary where the gradient vanishes (a cone's apex).
Vec3 unit_gradient(const Support& support, const Frame& frame, const Vec3& point);

}  // namespace whittle
