// judge.h — crossings of a support by a ray in arithmetic that does not round, and whether a claimed crossing keeps its promise.
//
// The polynomial is made in exact numbers (wide.h). How many crossings there are follows from signs of its discriminant, and whether |t - root| <= error
// from its signs at t - error and t + error: no root need be computed. What that leaves open (multiple roots, overlapping intervals) is answered by the
// reference's roots, isolated to 200 bits.
#pragma once

#include <string>

#include "tests/reference/polynomial.h"
#include "tests/tracer/engine/wide.h"
#include "tracer/engine/roots.h"

namespace whittle::testing {

struct Judgement {
    LinePolynomial<Wide> p;
    int degree = -1;      // of p; -1 where it vanishes: the ray lies in the support
    int count = 0;        // sign changes
    int first_sign = 0;   // before the first
    bool simple = true;   // no multiple root anywhere
    bool tangent = false; // the discriminant is at most 4 units in the last place of what it is the difference of: b^2 and 4ac, or the quartic's squares and cubes
};

// `leaving`: t = 0 is taken as a root.
Judgement judged(const Support& support, const Frame& frame, const Ray& ray, bool leaving);

// Empty where the crossings are those of the judgement, each within its error.
std::string fault_of(const Judgement& truth, const Crossings& claimed);

// The roots at which the sign changes, to 200 bits, ascending.
std::vector<reference::Root> exact_roots(const Judgement& truth);

// |t - root| / error of each crossing, the root to 200 bits.
double error_share(reference::Root root, double t, double error);

}  // namespace whittle::testing
