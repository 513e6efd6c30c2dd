// mask.h — which rays rounding decides, by the exact reference.
#pragma once

#include <random>

#include "tests/stress/compare.h"

namespace whittle::stress {

// How far a grazing ray's crossings may move, t of the scenes' size, where its origin moves by `far`.
double way_of(double far);

// Does the exact answer, surfaces and what holds the inside included, change when the ray moves by `far`, its direction by `turned`?
bool is_masked(const Subject& subject, const Ray& ray, double far, double turned, std::mt19937_64& random);

}  // namespace whittle::stress
