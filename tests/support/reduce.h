// reduce.h — makes a failing solid small, and writes it as the text of a test.
#pragma once

#include <functional>
#include <string>

#include "csg/solid/solid.h"
#include "csg/span/ray.h"

namespace whittle::support {

// A solid on which `fails` still holds though operands, placements and levels were taken from it as long as that (and patience) lasted; built without
// simplifications, labels and motions. The solid itself where it does not fail without those.
Solid reduced(const Solid& solid, const std::function<bool(const Solid&)>& fails);

// C++ that builds the solid with a SolidBuilder `b` and helpers `use(node, placement)`; numbers to the last bit.
std::string to_code(const Solid& solid);

}  // namespace whittle::support
