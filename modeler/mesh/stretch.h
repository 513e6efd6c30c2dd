// stretch.h — how much a placement lengthens.
#pragma once

#include "csg/base/vec.h"
#include "csg/solid/solid.h"

namespace whittle {

// The most by which the map lengthens a vector.
double largest_stretch(const Placement& p);

}  // namespace whittle
