// lowered.h — the engine's formula, as the reference sees it: what compiling, root finding, ordering and sweeping must reproduce to the last border.
//
// Reading a solid rounds its numbers once into frames and classes (tracer/engine lower, identity). The numbers after that are taken here as they are;
// what they mean (polynomials, parity) is written anew. So a comparison has no tolerance on any solid, fused or not. That lowering itself is right
// is another test: the solid's own reference.
#pragma once

#include "tests/reference/reference.h"
#include "tracer/engine/formula.h"
#include "tracer/engine/identity.h"

namespace whittle::stress {

struct Lowered {
    reference::Tree tree;                        // its leaves are the formula's leaf nodes, in order of first appearance
    std::vector<std::uint32_t> use_of_leaf;      // each leaf's author's use
    std::vector<std::uint32_t> support_of_class;  // the tree's support that a class became; kNoSupport of a convex body, which is many
};

// Requires: nothing moves.
Lowered lowered(const Formula& formula, const Classes& classes);

// The same for a solid, by the engine's lowering.
Result<Lowered> lowered(const Solid& solid, bool snap);

}  // namespace whittle::stress
