// support.h — how far a solid reaches in a direction: boxes that are tight, not merely large enough.
#pragma once

#include <optional>

#include "csg/solid/solid.h"

namespace whittle {

// The largest d.p over the points of the node, in double; nothing where the solid is unbounded, moves, or is an intersection or a difference whose
// reach only its surface tells.
std::optional<double> support(const Solid& solid, NodeId node, Vec3 direction);

// The smallest box of the use, up to rounding, where support() knows it.
std::optional<Bounds> tight_bounds(const Solid& solid, const Use& use);

}  // namespace whittle
