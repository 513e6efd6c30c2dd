// contacts.h — where two convex flat pieces meet: in nothing, a point, a segment, or in one plane.
#pragma once

#include "modeler/arrange/patches.h"

namespace whittle {

struct Contact {
    enum class Kind : std::uint8_t { kNone, kPoint, kSegment, kCoplanar };
    Kind kind = Kind::kNone;
    PointId from = 0, to = 0;  // equal for a point; entered into the table
    bool more_of_a = false, more_of_b = false;  // of a segment: more than two corners of that piece lie in the plane of the other, so some may be within it
};

// The pieces are closed sets. kCoplanar says that the planes are equal, not that the pieces meet.
Contact contact_of(Patches& patches, const Patch& a, const Patch& b);

}  // namespace whittle
