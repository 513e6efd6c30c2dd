// look_alike.h — do two solids look the same?
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// The same sets, placements, motions and matter in the same order; only the places in the text may differ. A program made of one shows the other.
bool look_alike(const Solid& a, const Solid& b);

}  // namespace whittle
