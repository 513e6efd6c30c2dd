// own_deviation.h — how far what rays meet may be from the solid itself, where the engine has no roots for a surface.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// No point of a turned parabola or ellipse, nor of arcs in the profile of a sliced extrusion, is farther from what rays meet, in the root frame at time 0. 0 where there are none.
double own_deviation(const Solid& solid);

}  // namespace whittle
