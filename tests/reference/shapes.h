// shapes.h — each shape of the canonical solid as a formula over its supports.
#pragma once

#include "csg/solid/solid.h"
#include "tests/reference/formula.h"

namespace whittle::reference {

// True if every shape of the solid has a finite formula: no twist, no motion, of convex bodies those of convex.h.
bool has_formula(const Solid& solid);

// Is the point, given in the shape's own frame, inside? Requires has_formula(solid).
ExpressionId shape_formula(Formulas& formulas, const Solid& solid, const Shape& shape, const FormPoint& p);

}  // namespace whittle::reference
