// compare.h — the engine's answers against the reference's, border by border; and two references against each other outside a mask.
#pragma once

#include <memory>
#include <random>
#include <string>

#include "tests/reference/reference.h"
#include "tests/support/random_solid.h"
#include "tracer/engine/engine.h"

namespace whittle::stress {

struct Subject {
    std::shared_ptr<const Program> program;
    std::unique_ptr<reference::Evaluator> exact;   // of the engine's own formula
    std::vector<std::uint32_t> use_of_leaf, support_of_class;  // of that formula (lowered.h)
    std::vector<std::uint32_t> bodies;             // the classes that are convex bodies: they have no exact tier
    bool snap = true;
    std::string failure;                           // why there is none
};

Subject subject_of(const Solid& solid, bool snap);

// What the comparisons met, so that a test can demand that they were not trivial.
struct Tally {
    std::uint64_t pairs = 0, borders = 0, from_inside = 0, uncertified = 0, masked = 0, continued = 0, not_compiled = 0;
    std::uint64_t body_rays = 0, undecided = 0, loose = 0;  // of solids with convex bodies; those that left one undecided; and had other borders, near the reference's
    double worst_ratio = 0;  // |t - exact t| / t_error
};

// Empty where all_spans, first_hit and any_hit agree with the reference: number, order and direction of the borders, every t within its bound, the
// use of each border among those that change there. Otherwise what differs.
// A ray that leaves a convex body undecided (it runs within rounding of its outline, or two borders of which one is a body's lie within their bounds) is held to
// docs/numerics.md: the borders of the reference on it, or on a ray moved by 2^-20 of the size, within 2^-10 of that, but for intervals shorter than that.
std::string disagreement(const Subject& subject, const Ray& ray, Scratch& scratch, std::mt19937_64& random, Tally& tally);

// The same for a ray that leaves the first border of `ray` (Ray::departure), in a random direction, against the reference with that root made exact.
// That reference in turn must be, a little way along, where a plain ray is that starts there.
std::string continuation_disagreement(const Subject& subject, const Ray& ray, Scratch& scratch, std::mt19937_64& random, Tally& tally);

// Empty where both references have the same borders, or where a move of the ray by 1e-12 ... 1e-17 of the solid's size changes the answer of `a`, or makes
// that of `b` the one of `a` (then masked: rounding in reading moves the solid as much, and may open a slit that just this ray lies in).
// Intervals shorter than 1e-9 of the size are left out first. For a formula whose numbers were rounded in reading against the solid before.
std::string loose_disagreement(const reference::Evaluator& a, const reference::Evaluator& b, const Ray& ray, double size, std::mt19937_64& random, Tally& tally);

}  // namespace whittle::stress
