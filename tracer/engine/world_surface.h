// world_surface.h — supports as surfaces of the root frame, for telling whether two coincide. Private to the engine.
//
// In long double: its rounding is 2^11 below that of the numbers compared.
#pragma once

#include <array>

#include "tracer/engine/support.h"

namespace whittle {

using Real = long double;

inline Real magnitude(Real x) { return x < 0 ? -x : x; }

// Surface in the root frame, up to a factor: a plane (n, d) with unit n, or a quadric x'Mx + 2b'x + c, or a torus.
struct WorldSurface {
    enum class Form : std::uint8_t { kPlane, kQuadric, kTorus } form = Form::kPlane;
    std::array<Real, 6> m{};  // xx yy zz xy xz yz
    std::array<Real, 3> b{};  // a plane's normal; a torus's centre, of a section's how far three places are from it
    Real c = 0;               // plane: b.x + c = 0
    Real ring = 0, tube = 0;  // a torus's, times the mean stretch of its frame
};

// Requires: has_polynomial().
WorldSurface world_surface(const Support& support, const Frame& frame);

// The quadric's ten coefficients (xx yy zz xy xz yz x y z 1, mixed and linear ones halved) with x = centre + extent * y; the largest is 1 in magnitude and
// the first large one positive.
using QuadricForm = std::array<Real, 10>;
QuadricForm normalised(const WorldSurface& w, const Vec3& centre, double extent, bool& flipped);

// How far points of the first torus are, in the root frame, from the second: at most, over a spread of points that tells any two tori apart, however
// their frames turn, stretch or shear them.
Real torus_distance(const Support& a, const Frame& in_a, const Support& b, const Frame& in_b);

// The same of tori whose sections the frames hold: how much the distances from the two differ, over a spread of points of the box.
Real section_torus_distance(const Support& a, const Frame& in_a, const Support& b, const Frame& in_b, const Bounds& box);

// How far the second quadric is from points of the first, in and about the box [-half, half] whose largest half is 0.5. 1, more than any tolerance, where
// the coefficients are plainly different or hardly any point of the first was found there.
Real quadric_distance(const QuadricForm& a, const QuadricForm& b, const Vec3& half);

}  // namespace whittle
