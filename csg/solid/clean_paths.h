// clean_paths.h — contours of a set, as Clipper gives them, without what encloses nothing.
//
// Clipper leaves two contours that share a way in opposite directions where it did not join them, and spikes where collinear points are kept; a crossing
// it rounded lies a step beside the side it cuts, which another shape's side then no longer covers. All have no area on the grid, but a wall over one is a
// film of no thickness, and walls that twist along it are two that gape. So sides are led through the points they pass within a step of, and what then
// runs both ways goes.
// Source: Hobby, Practical segment intersection with finite precision output (1999), for hot pixels.
#pragma once

#include <polyclipping/clipper.hpp>

namespace whittle {

// The same set up to a step: no side runs back along another one, none turns straight back, none is empty. Contours may touch in points.
// Requires: the set lies on the left of every contour; |coordinate| < 2^61.
ClipperLib::Paths clean_paths(const ClipperLib::Paths& paths);

}  // namespace whittle
