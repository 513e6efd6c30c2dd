// space.h — the program folded to the cells of an octree: in each cell only the leaves whose borders pass through it are left. Private to the engine.
//
// Leaves that hold a whole cell, or miss it, are constants there; a deep tree over large overlapping parts falls apart into a few leaves a cell. A cell's
// formula equals the program's in the cell grown by kSpaceGrowth on every side, so that rays may change cells anywhere in the overlap and no face
// coincides with the place where they do.
// Source: Wyvill and Kunii, A functional model for constructive solid geometry (1985); Duff, Interval arithmetic and recursive subdivision (1992).
#pragma once

#include "tracer/engine/program.h"

namespace whittle {

inline constexpr double kSpaceGrowth = 0x1p-16;  // of the cell's size; what a ray is followed through is grown by half of it

// The k-th eighth of a box: bit i of k is the half along i.
Bounds octant(const Bounds& box, std::uint32_t k);

// Divides a finished program's bounds into cells where that pays; leaves Program::space empty where it does not.
void divide_space(Program& program);

}  // namespace whittle
