// random_solid.h — random solids full of planted coincidences, and rays that go for them.
//
// Sizes and offsets of one solid come from a short list, placements from few angles, so that faces coincide, abut, touch and nest by themselves. Each
// solid remembers points and directions of its parts in the root frame: corners, rims, centres, axes. Rays are drawn through them.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "csg/solid/solid.h"
#include "csg/span/ray.h"

namespace whittle::support {

enum class Theme : std::uint8_t {
    kPlanes,       // boxes, polyhedra, prisms, half-spaces
    kRound,        // balls, cylinders, cones, capsules, tori ...
    kEverything,
    kStack,        // one frame, integer translations: abutting and coincident boxes and cylinders
    kInstances,    // few nodes used many times below common turns
    kChain,        // a - (b - (c - ...)), deep
    kThin,         // shells and films of 1e-3 ... 1e-15
    kWedge,        // faces that meet at 1e-4 ... 1e-11 rad
    kLadder,       // the same shape many times, each 0.6 of some small length further
    kFar,          // far from the origin, sizes from 1e-6 to 1e6
    kConvex        // hulls and sums of round parts among all other shapes, in trees, chains, shells and ladders
};
inline constexpr int kThemes = 11;
const char* name_of(Theme theme);

struct RandomSolid {
    Solid solid;
    std::vector<Vec3> points;      // in the root frame, rounded where the placement is not exact
    std::vector<Vec3> directions;
    double size = 1;               // of the whole, roughly
};

// The same seed and theme give the same recipe, whatever the passes. `outer` is placed above it; points and directions are those without it.
RandomSolid random_solid(Theme theme, std::uint64_t seed, const SolidPasses& passes = {}, const Placement& outer = {});

// A ray at the solid: random, through its points, along its directions, from its points.
Ray random_ray(const RandomSolid& solid, std::mt19937_64& random);

// The ray as text with all digits.
std::string to_text(const Ray& ray);

}  // namespace whittle::support
