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
    {"coarse", "first hits of a camera's tile found in float, where float can tell"},
    // tracer/light
    {"packets", "the camera and shadow rays of a tile met together"},
    {"shadows", "no shadow rays to lamps that give no light"},
    {"media", "no division by matter, nor a list of the matters a ray is in, where nothing is clear"},
    {"photons", "no rays from the lamps where nothing focuses light onto something dull"},
    {"spectrum", "three channels, no wavelengths, where nothing disperses"},
    {"lens", "no places on the lens without an aperture"},
    {"shutter", "no times where nothing moves"},
    {"areas", "no places on lamps without a size"},
};

}  // namespace

std::span<const PassInfo> known_passes() { return kPasses; }

}  // namespace whittle
