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

// Leaves are the formula's leaf nodes, in order of first appearance; `use_of_leaf` gives each its author's leaf use. Requires: nothing moves.
reference::Tree tree_of(const Formula& formula, const Classes& classes, std::vector<std::uint32_t>& use_of_leaf);

// The same for a solid, by the engine's lowering.
Result<reference::Tree> lowered_tree(const Solid& solid, bool snap, std::vector<std::uint32_t>& use_of_leaf);

}  // namespace whittle::stress
