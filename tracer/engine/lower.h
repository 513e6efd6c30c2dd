// lower.h — solid → formula: every shape becomes half-spaces of planes, quadrics and tori, or a leaf counted by parity.
#pragma once

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "tracer/engine/formula.h"

namespace whittle {

// Fails (kScene) where the solid holds a shape that no exact leaf and no facets exist for.
Result<Formula> lower(const Solid& solid);

}  // namespace whittle
