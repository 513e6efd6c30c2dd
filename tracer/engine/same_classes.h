// same_classes.h — which surfaces of one program are surfaces of another that was made of the same text: a part's of the whole's.
#pragma once

#include <vector>

#include "csg/span/ray.h"

namespace whittle {

class Program;

// By class of `part`: the class of `whole` whose support is equal to the bit, as all are that the snap has not moved; else kNoClass. Surfaces of what moves,
// twisted sides and convex bodies have none.
std::vector<ClassId> same_classes(const Program& part, const Program& whole);

}  // namespace whittle
