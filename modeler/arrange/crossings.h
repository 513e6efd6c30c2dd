// crossings.h — does a mesh in double cross itself? Decided exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// Pairs of triangles that meet anywhere but in a whole common edge or corner (equal indices). Requires finite coordinates.
std::uint64_t count_crossings(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

// These pairs, by index, in an order that depends on the mesh alone; the first `most` of them.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t most);

}  // namespace whittle
