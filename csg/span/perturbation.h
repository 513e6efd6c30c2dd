// perturbation.h — the one rule for rays that lie in a face, along an edge or through a vertex: which way they are nudged.
//
// A ray o + t d means the limit, for ε -> 0+, of the rays o + ε v1 + ε² v2 + ε³ v3 + t d, the v fixed in the root frame. A support whose
// polynomial vanishes all along the ray takes its sign from the lowest power of ε that does not vanish. Three independent vectors with
// generic components: no plane, edge or symmetry axis an author writes is parallel to them by habit. The direction is never nudged.
//
// Source: Edelsbrunner and Mücke, Simulation of Simplicity (1990), with the perturbation on the ray instead of on the points.
#pragma once

#include <array>

#include "csg/base/vec.h"

namespace whittle {

// Small odd integers: exact in double, and products with them stay cheap in exact arithmetic. Determinant 433,494,812 (not 0).
inline const std::array<Vec3, 3> kPerturbation{Vec3{577, 431, 263}, Vec3{-389, 619, 151}, Vec3{227, -347, 743}};

}  // namespace whittle
