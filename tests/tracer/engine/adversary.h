// adversary.h — supports and rays that try the root finders: random, far, axis-parallel, grazing to the last bit, thin as roundoff.
#pragma once

#include "tests/tracer/engine/rays.h"
#include "tracer/engine/roots.h"
#include "tracer/engine/support.h"

namespace whittle::testing {

inline constexpr int kSupportKinds = 13;
const char* name_of(SupportKind kind);

// One question: where does the ray cross the support in its frame?
struct Question {
    Support support;
    Placement placement;
    Ray ray;
};

enum class Sort : std::uint8_t {
    kRandom,   // through, far from, parallel to, in and out of the frame's own space
    kGrazing,  // turned until it passes from meeting to missing, to the last bit of the direction
    kPell,     // integers with a discriminant of a few units against 2^100: a ray as close to a circle of radius near 2^50 as integers can be
    kThin      // the surface is some 2^-51 of the ray's length thick: both crossings within few units in the last place of t
};
inline constexpr int kSorts = 4;
const char* name_of(Sort sort);

Vec3 on_sphere(Random& random);
Placement random_placement(Random& random);
Support random_support(SupportKind kind, Random& random);
Ray random_ray(Random& random);

// Of a sort that the kind has; kRandom otherwise.
Question ask(Sort sort, SupportKind kind, Random& random);

// An oblique plane whose crossing lies within some `ulps` units in the last place of t from the ray's parameter t.
Support plane_near(const Ray& ray, double t, double ulps, Random& random);

}  // namespace whittle::testing
