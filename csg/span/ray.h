// ray.h — a ray, its departure from a surface, and the ends and spans it makes in a solid.
#pragma once

#include <array>
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

// Points origin + t*direction, t >= 0. The direction is not normalised and t is in units of it.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, 1};
    double time = 0;               // 0..1 over the shutter
    std::uint32_t wavelength = 0;  // slot of the hero wavelength; 0: none
    const Departure* departure = nullptr;
};

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
