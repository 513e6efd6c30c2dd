// lights.h — lights resolved: what they send to a point, and where a ray meets them.
//
// A sample's `radiance` is divided by its density already: (scattering x cosine x radiance) summed over the samples and divided by their number
// estimates the reflected light. Areas are sampled by solid angle where that has a closed form (sphere, sun, rectangle), by area otherwise (oblique
// parallelograms, and rectangles so small or far that their solid angle is mostly rounding). Source: Urena, Fajardo, King, An Area-Preserving
// Parametrization for Spherical Rectangles (2013).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "csg/base/vec.h"
#include "csg/eval/matter.h"
#include "tracer/light/environment.h"

namespace whittle {

enum class LightKind : std::uint8_t { kPoint, kSphere, kSun, kParallelogram, kEnvironment };

// `emitted`: radiant intensity of a point, irradiance of a sun, radiance of a sphere or parallelogram (which shines from both sides).
struct LightSource {
    LightKind kind = LightKind::kPoint;
    bool casts_shadow = true;  // the studio's fill does not
    Vec3 p{0};                 // place; for a sun the unit direction towards it
    Vec3 u{0}, v{0}, normal{0};
    double radius = 0;         // of a sphere
    double one_minus_cos = 0;  // of the sun's disc; 0: a point
    double area = 0;
    Vec3 emitted{0};
    std::shared_ptr<const EnvironmentMap> map;  // of an environment

    bool extended() const { return kind != LightKind::kPoint && (kind != LightKind::kSun || one_minus_cos > 0); }
};

struct LightSample {
    Vec3 direction{0};    // unit, towards the light
    double distance = 0;  // infinite for a sun
    Vec3 radiance{0};     // over density; zero: no light from there
    double density = 0;   // over solid angle; 0 for points
};

// `u` in [0,1)^2; unused by points. What a light at `from` itself would send (no distance) is zero.
LightSample sample_light(const LightSource& light, Vec3 from, Vec2 u);

// The same from each of `count` <= lanes::kMost places, by 2^32 times `u` and `v`.
void sample_light(const LightSource& light, const Vec3* from, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, LightSample* samples);

// Radiance of the nearest light (environments aside) met before `t_max` by the ray, suns included when nothing limits it; false: none.
struct LightMet {
    double t = 0;
    std::size_t light = 0;
    Vec3 radiance{0};
    double density = 0;  // that sample_light() would have had there
};
bool meet_lights(const std::vector<LightSource>& lights, Vec3 origin, Vec3 direction, double t_max, LightMet& met);

// As the author wrote it. A light without power gives a white matte surface at `centre` radiance 1. Degenerate sizes become points.
LightSource resolve_light(const PointLight& light, Vec3 centre);
LightSource resolve_light(const SunLight& light);
LightSource resolve_light(const AreaLight& light, Vec3 centre);

}  // namespace whittle
