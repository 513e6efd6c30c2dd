// triangulate.h — polygons with holes cut into triangles, exactly.
//
// Ear clipping on integer coordinates: every decision is the sign of a determinant in 128 bits. Every ear is strictly counter-clockwise and the
// border is kept, so the triangles cover the polygon once: their winding numbers add up to the polygon's, which is 1 inside. No vertex is dropped,
// collinear ones neither: walls stand on them.
// Source: Meisters, Polygons have ears (1975); Eberly, Triangulation by Ear Clipping (bridges to holes).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/mesh/int128.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

struct GridPoint2 {
    std::int64_t x = 0, y = 0;
    auto operator<=>(const GridPoint2&) const = default;
};

// Twice the signed area of (a, b, c), positive when counter-clockwise. Requires |coordinate| < 2^61.
Int128 cross(const GridPoint2& a, const GridPoint2& b, const GridPoint2& c);

// Contours index `points`: outer ones counter-clockwise, holes clockwise, no two crossing. Returns triangles on the same indices; nothing when the
// contours are not what is required.
std::optional<std::vector<Triangle>> triangulate(const std::vector<GridPoint2>& points, const std::vector<std::vector<std::uint32_t>>& contours);

}  // namespace whittle
