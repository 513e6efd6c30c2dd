// placement.h — products of placements that lose nothing, and boxes that contain everything.
#pragma once

#include <optional>

#include "csg/base/vec.h"
#include "csg/solid/solid.h"

namespace whittle {

// outer after inner if every rounding in it is exact, else nothing. Translations by representable sums and anything after the identity fold;
// general rotations do not: chains of those stay chains, for the engine to multiply in exact arithmetic.
std::optional<Placement> exact_product(const Placement& outer, const Placement& inner);

// -0 becomes 0, so that equal placements have equal bits.
Placement without_negative_zero(const Placement& placement);

// Box of a box on its way through a motion (start to end, rigid part on a screw of at most half a turn), outward rounded.
Bounds moved_bounds(const Bounds& box, const Motion& motion);

// Smallest box around both; an empty one adds nothing.
Bounds around(const Bounds& a, const Bounds& b);
// Common part; empty where there is none.
Bounds common(const Bounds& a, const Bounds& b);

}  // namespace whittle
