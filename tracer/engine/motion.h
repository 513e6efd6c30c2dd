// motion.h — placements that change over the shutter.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "csg/solid/solid.h"

namespace whittle {

// A motion taken apart once, so that a ray's time costs one turn and no decomposition. Translation, stretch and rotation are interpolated apart (polar
// decomposition, rotation about its own axis by a share of its angle), so a rigid motion stays rigid.
// Source: Shoemake and Duff, Matrix animation and polar decomposition (1992).
class MotionPath {
public:
    MotionPath() = default;
    explicit MotionPath(const Motion& motion);

    // Of a time in 0..1; at 0 and 1 the given placements to the bit.
    Placement at(double time) const;
    // Around all that a box goes through, outward rounded.
    Bounds swept(const Bounds& box) const;

private:
    Motion ends_;
    glm::dquat from_{1, 0, 0, 0}, to_{1, 0, 0, 0};
    glm::dmat3 stretch_from_{1}, stretch_to_{1};
    double turn_ = 0;  // radians between the two rotations
};

// A motion and what stands above it: placement(t) = parent(t) * outer * path(t). Group 0 stands still.
struct MotionGroup {
    MotionId parent = 0;
    Placement outer;
    MotionPath path;
};

// The box that a box of group `id` goes through in the root's frame.
Bounds swept_bounds(const std::vector<MotionGroup>& groups, MotionId id, const Bounds& box);

}  // namespace whittle
