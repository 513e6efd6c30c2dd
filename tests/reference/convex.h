// convex.h — convex bodies given by their parts, as formulas, where they are made of known pieces: hulls of balls and corners; what turns about z; hulls of upright
// discs at two heights. Nothing of the engine's search for them is used.
#pragma once

#include <vector>

#include "csg/solid/solid.h"
#include "tests/reference/formula.h"

namespace whittle::reference {

// Is the body of one of these families, by its numbers as they are?
bool has_convex_formula(const std::vector<ConvexPart>& parts);

// Is the point, given in the body's own frame, inside? Requires has_convex_formula(parts).
ExpressionId convex_formula(Formulas& formulas, const std::vector<ConvexPart>& parts, const FormPoint& p);

}  // namespace whittle::reference
