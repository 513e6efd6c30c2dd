// axis_planes.h — solids whose faces all lie in axis planes: where those planes are.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// Sorted distinct coordinates of the faces' planes, one list per axis. Between neighbours the solid does not change along that axis.
using AxisPlanes = std::array<std::vector<double>, 3>;

// Coordinates nearer than 2^-44 of the model's extent are one plane (the snap of reading a solid; docs/numerics.md).
inline constexpr double kPlaneMerge = 0x1p-44;

// Nothing where some face of some leaf is curved or tilted, or where there are more than `limit` planes.
std::optional<AxisPlanes> axis_planes(const Solid& solid, std::size_t limit);

}  // namespace whittle
