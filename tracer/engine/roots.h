// roots.h — where a ray crosses a support: each crossing's t with an error bound, or the word that double cannot tell.
//
// The filter works in double with running error bounds; what it cannot decide goes to exact arithmetic (exact_roots). The two agree in the number
// and order of crossings; t differs within the bounds. docs/numerics.md derives the bounds.
#pragma once

#include <array>
#include <cstdint>

#include "csg/span/ray.h"
#include "tracer/engine/crossing_kernel.h"
#include "tracer/engine/support.h"

namespace whittle {

// Half the distance between 1 and the next double.
inline constexpr double kUnitRoundoff = 0x1p-53;

// A ray in a frame, in double: |o - exact| <= eo, |d - exact| <= ed, by coordinate.
struct FrameRay {
    std::array<double, 3> o, d, eo, ed;
};

FrameRay ray_in_frame(const Frame& frame, const Ray& ray);

// Where the support's sign changes along the whole line, ascending. `first_sign`: its sign before the first change (1 outside, -1 inside).
struct Crossings {
    static constexpr int kMost = 8;  // polynomials have at most four, turned sides of a piece of a twist hardly more
    std::array<double, kMost> t, error;
    std::uint8_t count = 0;
    std::int8_t first_sign = 1;
};

// An axis plane met by the ray itself (no frame between). Requires: inverse is finite.
inline void axis_plane_crossing(double value, double o, double d, double inverse, Crossings& out) {
    single::axis_plane_crossing(value, o, inverse, out.t[0], out.error[0]);
    out.count = 1;
    out.first_sign = d > 0 ? -1 : 1;
}

// False: not decidable in double.
bool filtered_crossings(const Support& support, const FrameRay& ray, Crossings& out);

// The same for a ray that leaves the support: t = 0 is an exact root.
bool filtered_departure(const Support& support, const FrameRay& ray, Crossings& out);

}  // namespace whittle
