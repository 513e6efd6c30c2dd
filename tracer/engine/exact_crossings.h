// exact_crossings.h — what double could not tell, told exactly: crossings of a support by a ray, and the order of two crossings.
#pragma once

#include <vector>

#include "tracer/engine/real_root.h"
#include "tracer/engine/roots.h"
#include "tracer/engine/support.h"

namespace whittle {

// The support's polynomial on the ray, exactly; where it vanishes all along the ray, that of the lowest order of the perturbation that does not
// (csg/span/perturbation.h). `leaving`: the constant term is taken as zero (Ray::departure).
exact::Polynomial exact_polynomial(const Support& support, const Frame& frame, const Ray& ray, bool leaving);

// The same crossings as roots.h promises, decided exactly; t to the last place. Requires: not is_transcendental().
std::vector<exact::RealRoot> exact_crossings(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out);

// The same crossings in double-double. False: not decidable.
bool fine_crossings(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out);

// One crossing's t in double-double, high + low. False: undecided.
bool fine_crossing(const Support& support, const Frame& frame, const Ray& ray, bool leaving, int index, double& high, double& low, double& error);

}  // namespace whittle
