// convex_rings.h — a plane region as convex pieces on its own corners.
//
// Ears are clipped (ear_clipping.h), then pieces grow together over the edges they share while they stay convex. Every decision is an exact sign.
// Source: Hertel and Mehlhorn, Fast triangulation of simple polygons (1983): at most four times as many pieces as are needed, where none is too large.
#pragma once

#include <optional>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// Contours as of facets.h: outer ones counter-clockwise, holes clockwise, none crossing or touching itself. Counter-clockwise convex rings that cover the
// region once; one contour that is convex is itself. Nothing where ears run out, as they do of contours that are not so.
std::optional<std::vector<std::vector<Vec2>>> convex_rings(std::vector<std::vector<Vec2>> contours);

}  // namespace whittle
