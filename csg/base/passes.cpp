// passes.cpp — see passes.h.
#include "csg/base/passes.h"

namespace whittle {

namespace {

constexpr PassInfo kPasses[] = {
    // csg/solid
    {"equal", "equal operands once; A - A is nothing"},
    {"disjoint", "no cutters that miss, no intersections of what lies apart"},
    {"buried", "no parts inside a box"},
    // tracer/engine
    {"boxes", "no parts whose box a ray misses"},
    {"hierarchy", "parts of a wide group through a tree of boxes"},
    {"occlusion", "nothing behind what is met already"},
    {"first", "no borders behind the first one"},
    {"any", "any border for shadow rays, without normals"},
    {"filter", "more digits only where double cannot tell"},
    {"frustum", "a tile's rays meet only what they can"},
    {"windows", "the far parts of a tile after the near ones"},
    {"masks", "the packets of a tile that can meet a part"},
    {"cells", "deep trees divided into the cells of an octree"},
    // tracer/light
    {"packets", "the camera and shadow rays of a tile met together"},
    {"media", "no division by matter where nothing is clear"},
};

}  // namespace

std::span<const PassInfo> known_passes() { return kPasses; }

}  // namespace whittle
