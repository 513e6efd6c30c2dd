// crossings.h — does a mesh in double cross itself? Decided exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "csg/base/vec.h"

namespace whittle {

// Pairs of triangles that meet anywhere but in a whole common edge or corner (equal indices). Requires finite coordinates.
std::uint64_t count_crossings(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace whittle
