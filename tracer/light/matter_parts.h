// matter_parts.h — a solid divided by matter: what is opaque, and each clear matter for itself.
//
// A picture of opaque things needs the border of the whole solid only. Light in a glass of water also needs the border between the two, and where
// they overlap, whose matter is there. So each clear matter becomes a solid of its own; a ray asks all of them, and the owner of a place is
// the containing part of the highest priority, then that of the lowest ordinal (docs/numerics.md, labels are not sets). So what is opaque is divided too,
// by the clear matters that begin before it in the text. A clear matter used in several places has the ordinal of the first.
#pragma once

#include <vector>

#include "csg/eval/matter.h"
#include "csg/solid/solid.h"

namespace whittle {

// Points of `solid` that belong to one matter, or could if nothing of higher rank were there too.
struct MatterPart {
    Solid solid;
    Material material;    // of the first leaf; the matter of a clear part
    bool clear = false;
    double priority = 0;
};

// In author's order of their first leaves. Empty: nothing is clear. One part: all is of one clear matter; its `solid` is left empty.
std::vector<MatterPart> divided_by_matter(const Solid& solid);

}  // namespace whittle
