// reduce.h — makes a failing solid small, and writes it as the text of a test.
#pragma once

#include <functional>
#include <string>

#include "csg/solid/solid.h"
#include "csg/span/ray.h"

namespace whittle::support {

// A solid on which `fails` still holds and from which no operand, placement or level can be taken so that it does. Built without simplifications.
// Requires: fails(solid). Labels and motions are dropped first if that keeps it failing; nothing is reduced otherwise.
Solid reduced(const Solid& solid, const std::function<bool(const Solid&)>& fails);

// C++ that builds the solid with a SolidBuilder `b` and helpers `use(node, placement)`; numbers to the last bit.
std::string to_code(const Solid& solid);

}  // namespace whittle::support
