// identity.h — which supports are one surface: the world-wide classes, decided once, before any ray.
//
// Supports equal to the bit are one already (SupportTable). Here supports of one kind that occur in touching boxes and agree there within the
// snap's tolerance are made one class; its coefficients are those of the support that came first. A support joins a class by agreeing with that
// first one, never with a later member, so a ladder of planes does not run together. docs/numerics.md, snap.
//
// Facets of prisms and meshes keep their own planes beside: which of them a ray crosses is decided by their vertices, and a ray almost in their class's
// plane may cross that far away from them, or nowhere (parity.cpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/span/ray.h"
#include "tracer/engine/formula.h"

namespace whittle {

// Of the larger box's extent.
inline constexpr double kSnapTolerance = 0x1p-44;

struct ClassOfSupport {
    ClassId id = 0;
    bool flipped = false;  // the class's positive side is the support's negative one
};

struct Classes {
    std::vector<Support> supports;       // by class
    std::vector<ClassOfSupport> of;      // by SupportId
    std::vector<ClassId> own;            // by SupportId: of a facet that joined another's class a class of its own plane; otherwise its class
    std::uint64_t fused = 0;             // supports that joined one they did not equal to the bit
    double largest = 0;                  // the largest distance between such two over their boxes
};

Classes find_classes(const Formula& formula, bool snap);

}  // namespace whittle
