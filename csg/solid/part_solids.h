// part_solids.h — a solid divided by part("name"): each part as a solid of its own, for files that hold several objects.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

struct NamedSolid {
    std::string name;  // "": of what stands in no part
    Solid solid;
};

// In the author's order of first appearance. What is cut from a part, or intersects it, belongs to the part that is cut: the first operand decides. Where
// parts overlap each is whole. A solid without parts is one entry without a name; parts that cutting leaves empty of primitives are left out.
std::vector<NamedSolid> divided_by_part(const Solid& solid);

}  // namespace whittle
