// ear_clipping.h — a plane region with holes as triangles on its own corners.
//
// Holes are joined to their outer contour by bridges walked twice, then ears are clipped; every decision is an exact sign.
// Source: Meisters, Polygons have ears (1975); Eberly, Triangulation by Ear Clipping.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

using IndexTriangle = std::array<std::uint32_t, 3>;

// Contours index `points`: outer ones counter-clockwise, holes clockwise, none crossing or touching itself. Counter-clockwise triangles that cover
// the region once and keep every corner; nothing where the contours are not as required.
std::optional<std::vector<IndexTriangle>> ear_clipped(const std::vector<Vec2>& points, const std::vector<std::vector<std::uint32_t>>& contours);

}  // namespace whittle
