// hash.h — structural hashes of what a solid is made of: same content, same hash, in every run and on every machine.
#pragma once

#include <cstdint>

#include "csg/solid/solid.h"

namespace whittle {

// Expects -0 replaced by 0 (without_negative_zero). Polyhedra and polygons are hashed by content.
std::uint64_t hash_of(const Shape& shape);
std::uint64_t hash_of(const Use& use);
std::uint64_t hash_of(const Combination& combination);
std::uint64_t hash_of(const Label& label);
std::uint64_t hash_of(const Motion& motion);

// The shape with every -0 replaced by 0.
Shape without_negative_zero(Shape shape);

}  // namespace whittle
