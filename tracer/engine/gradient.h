// gradient.h — normals: the gradient of a support at a point.
#pragma once

#include "tracer/engine/support.h"

namespace whittle {

// Unit gradient (towards outside) at a point of the root frame, by the inverse transpose of the frame; relative error a few units of roundoff times
// the condition of the frame. The direction is arbitrary where the gradient vanishes (a cone's apex).
Vec3 unit_gradient(const Support& support, const Frame& frame, const Vec3& point);

}  // namespace whittle
