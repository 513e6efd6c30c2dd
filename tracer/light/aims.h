// aims.h — the balls that lamps shine at, so that their rays of light are of use: around each thing that mirrors or bends light.
//
// One ball around everything would catch mostly what lies between the things. So neighbours share a ball only where that is not much larger than two, or where
// there are too many to choose among.
#pragma once

#include <vector>

#include "csg/base/vec.h"

namespace whittle {

struct Aim {
    Vec3 centre{0};
    double radius = 0;
};

// Balls that cover all boxes, at most kMostAims. None: there is no box with an extent and an end.
inline constexpr std::size_t kMostAims = 16;
std::vector<Aim> aims_around(const std::vector<Bounds>& things);

}  // namespace whittle
