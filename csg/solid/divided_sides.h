// divided_sides.h — the parameter `segments` of linear_extrude: sides of a profile cut into pieces, so that the facets of a twist or an uneven taper follow its
// true surface more closely. The set stays the same; only corners are added.
#pragma once

#include "csg/solid/facets.h"

namespace whittle {

// Most pieces that a contour is cut into, whatever the author asks for.
inline constexpr int kMostSegments = 1 << 20;

// How an extrusion changes the lengths of its profile's sides on the way up, looked at in each of its slices.
struct SideStretch {
    double twist_deg = 0;
    Vec2 scale_top{1};
    int slices = 1;
};

// Each contour with fewer than `segments` corners gets more of them, at most so many: the longest pieces are cut first, and all that are as long to a thousandth
// together, or none of them, so that what was symmetric stays so. Corners that were there keep their bits.
Contours with_divided_sides(const Contours& contours, int segments, const SideStretch& stretch);

}  // namespace whittle
