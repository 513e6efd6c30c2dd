// sheet.h — a 2D set as a thin solid, to be seen.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// Every 2D shape raised from z0 to z1 in its place: raising commutes with set operations, so colours and places in the text stay where they are.
// Requires: the root is 2D or empty; z0 < z1.
Solid as_sheet(const Solid& flat, double z0, double z1);

}  // namespace whittle
