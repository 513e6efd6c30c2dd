// passes.cpp — see passes.h.
#include "csg/base/passes.h"

namespace whittle {

namespace {

constexpr PassInfo kPasses[] = {
    // csg/solid
    {"equal", "equal operands once; A - A is nothing"},
    {"disjoint", "no cutters that miss, no intersections of what lies apart"},
    {"buried", "no parts inside a box"},
    // tracer/light
    {"packets", "the camera and shadow rays of a tile met together"},
    {"media", "no division by matter where nothing is clear"},
};

}  // namespace

std::span<const PassInfo> known_passes() { return kPasses; }

}  // namespace whittle
