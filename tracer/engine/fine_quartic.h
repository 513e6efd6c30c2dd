// fine_quartic.h — the middle tier for quartics: roots in double-double, isolated in the Bernstein basis, each certified by signs.
#pragma once

#include <array>

#include "tracer/engine/bounded.h"

namespace whittle {

// The places in (-reach, reach) where c0 + c1 s + ... + c4 s^4 changes sign, ascending, each with its bound. False: not decidable in double-double.
// Requires: all roots that matter lie well inside, by a few units of roundoff of reach.
bool fine_quartic_roots(const std::array<Bounded, 5>& c, double reach, std::array<Bounded, 4>& roots, int& count);

}  // namespace whittle
