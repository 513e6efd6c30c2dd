// profile.h — a 2D node as plain contours, for those who need points: facets, meshes, the sign of a profile's radii.
//
// Set operations are made by Clipper on an integer grid of about 2^-44 of the profile's size; corners that were there before keep their bits, crossings
// lie on the grid. The exact tracer takes only tapered profiles, and straight sides that turn, from here. Arcs become chords no further than the tolerance
// from the arc, with corners on it.
#pragma once

#include "csg/solid/facets.h"
#include "csg/solid/solid.h"

namespace whittle {

// Chord error of profiles as a share of their size where no one asks for another.
inline constexpr double kProfileTolerance = 0x1p-14;

// The regularised 2D set of the node. Nothing where its coordinates overflow.
// Requires: is_2d(node), tolerance > 0.
Contours contours_of(const Solid& solid, NodeId node, double tolerance);

// The same, and how far corners may be from where exact arithmetic would have them: 0 where none was rounded.
struct RoundedContours {
    Contours contours;
    double rounding = 0;
};
RoundedContours rounded_contours_of(const Solid& solid, NodeId node, double tolerance);

// The union of rings whose corners carry rounding, on a grid of 2^-32 of their size: inside is what they go round, on balance, at least once
// counter-clockwise. Corners closer than two units of the grid to each other or to the line of their neighbours become one or go.
Contours united_rings(const std::vector<std::vector<Vec2>>& rings);

enum class Join { kRound, kMiter, kSquare };

// The set of the contours grown by delta (shrunk where negative), on the same kind of grid. Round corners become chords of a circle cut into
// `fragments`, as OpenSCAD cuts them.
Contours offset_contours(const Contours& contours, double delta, Join join, int fragments);

}  // namespace whittle
