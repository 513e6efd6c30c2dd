// grid_mesh.h — triangle meshes on an integer grid: what goes into exact set operations.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace whittle {

__extension__ typedef __int128 Int128;

using GridPoint = std::array<std::int64_t, 3>;
using FacetTag = std::uint32_t;

// Box in grid units, closed. Empty when lo > hi.
struct GridBox {
    GridPoint lo{1, 1, 1}, hi{0, 0, 0};
    bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
    bool operator==(const GridBox&) const = default;
};

// A closed, oriented mesh. Triangles of one tag are exactly coplanar and turn the same way.
struct GridMesh {
    std::vector<GridPoint> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<FacetTag> tags;
    bool operator==(const GridMesh&) const = default;
};

// What the arrangement's integers are wide enough for: |coordinate| of any placed point.
inline constexpr std::int64_t kLargestPlacedCoordinate = std::int64_t{1} << 50;

}  // namespace whittle
