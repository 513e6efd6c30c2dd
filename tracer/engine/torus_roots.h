// torus_roots.h — the double filter for the torus: crossings isolated in the Bernstein basis, certified by signs.
#pragma once

#include "tracer/engine/roots.h"

namespace whittle {

// False: not decidable in double. Requires: the support is a torus.
bool filtered_torus(const Support& support, const FrameRay& ray, Crossings& out);
// The same where t = 0 is a root.
bool filtered_torus_departure(const Support& support, const FrameRay& ray, Crossings& out);

}  // namespace whittle
