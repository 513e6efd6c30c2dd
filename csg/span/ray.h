// ray.h — a ray, its departure from a surface, and the ends and spans it makes in a solid.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// World-wide identity of surfaces that coincide.
using ClassId = std::uint32_t;
inline constexpr ClassId kNoClass = 0xFFFFFFFF;

// A ray that starts on surfaces (shadow, mirror, refraction) names them: the classes of the event it leaves. The engine takes t = 0 as an exact root
// of each, whatever the rounding of the origin, and does not report it again.
struct Departure {
    std::array<ClassId, 6> classes{};
    int count = 0;
};

// Points origin + t*direction, t >= 0. The direction is not normalised and t is in units of it. See is_askable() for the numbers it may hold.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, 1};
    double time = 0;               // 0..1 over the shutter
    std::uint32_t wavelength = 0;  // slot of the hero wavelength; 0: none
    const Departure* departure = nullptr;
};

// Are the six numbers within what the bounds of the engine were derived for? No product of a few of them and of a scene's lengths may overflow, nor lose
// bits to underflow. Queries require it.
inline bool is_askable(const Ray& ray) {
    constexpr double kLeast = 0x1p-300, kMost = 0x1p300;  // 5e-91, 2e90
    const auto fits = [](double x) { return x == 0 || (std::fabs(x) >= kLeast && std::fabs(x) <= kMost); };
    for (int k = 0; k < 3; ++k)
        if (!fits(ray.origin[k]) || !fits(ray.direction[k])) return false;
    return ray.direction != Vec3(0);
}

inline Vec3 point_at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

// A border of the solid on a ray. |t - exact t| <= t_error where `certified`.
// `normal` is the unit outward normal of the solid in the root frame; `use` indexes the engine's leaf uses in author's order.
struct End {
    double t = 0;
    double t_error = 0;
    Vec3 normal{0};
    ClassId surface = kNoClass;
    std::uint32_t use = 0;
    bool certified = true;
};

// A maximal interval of t >= 0 inside the solid. No `in`: the ray starts inside. No `out`: the solid is unbounded along the ray.
struct Span {
    std::optional<End> in, out;
};

using Spans = std::vector<Span>;

}  // namespace whittle
