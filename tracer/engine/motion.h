// motion.h — placements that change over the shutter.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

// A motion and what stands above it: placement(t) = parent(t) * outer * motion(t). Group 0 stands still.
struct MotionGroup {
    MotionId parent = 0;
    Placement outer;
    Motion motion;
};

// The motion's placement at a time in 0..1: translation, stretch and rotation interpolated apart (polar decomposition, rotation about its own axis
// by a share of its angle), so a rigid motion stays rigid. At 0 and 1 the given placements to the bit.
// Source: Shoemake and Duff, Matrix animation and polar decomposition (1992).
Placement placement_at(const Motion& motion, double time);

}  // namespace whittle
