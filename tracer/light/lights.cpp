#include "tracer/light/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/degrees.h"
#include "tracer/image/tone.h"
#include "tracer/light/lanes.h"
#include "tracer/light/rectangle.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What lights a white matte surface to white.
constexpr double kWhiteIrradiance = kPi;

double squared(Vec3 v) { return glm::dot(v, v); }
Vec3 unit_or(Vec3 v, Vec3 otherwise) {
    const double length = std::sqrt(squared(v));
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}
double finite_or(double x, double otherwise) { return std::isfinite(x) ? x : otherwise; }

// 1 - cos of the angle under which the sphere is seen; 2 from inside.
double sphere_cap(double radius, double distance2) {
    const double sin2 = radius * radius / distance2;
    if (!(sin2 < 1)) return 2;
    return sin2 / (1 + std::sqrt(1 - sin2));
}

// First t > 0 where the unit direction meets the sphere; infinite: never.
double meet_sphere(Vec3 centre, double radius, Vec3 origin, Vec3 direction) {
    const Vec3 to = centre - origin;
    const double along = glm::dot(to, direction), rest = squared(to - along * direction), inside = radius * radius - rest;
    if (inside < 0) return kInfinity;
    const double half = std::sqrt(inside);
    if (along - half > 0) return along - half;
    return along + half > 0 ? along + half : kInfinity;
}

// Infinite where t < t_max is not to be had.
double meet_parallelogram(const LightSource& light, Vec3 origin, Vec3 direction, double t_max) {
    const double slope = glm::dot(direction, light.normal);
    if (slope == 0) return kInfinity;
    const double t = glm::dot(light.p - origin, light.normal) / slope;
    if (!(t > 0 && t < t_max)) return kInfinity;
    const Vec3 at = origin + t * direction - light.p, w = light.normal / light.area;
    const double a = glm::dot(w, glm::cross(at, light.v)), b = glm::dot(w, glm::cross(light.u, at));
    return a >= 0 && a <= 1 && b >= 0 && b <= 1 ? t : kInfinity;
}

LightSample towards(Vec3 offset, Vec3 intensity) {
    LightSample s;
    const double d2 = squared(offset);
    if (!(d2 > 0)) return s;
    s.distance = std::sqrt(d2);
    s.direction = offset / s.distance;
    s.radiance = intensity / d2;
    return s;
}

LightSample from_cap(Vec3 axis, double one_minus_cos, Vec3 radiance, Vec2 u) {
    LightSample s;
    s.direction = ShadingFrame(axis).to_world(on_cap(u, one_minus_cos));
    s.density = 1 / (2 * kPi * one_minus_cos);
    s.radiance = radiance / s.density;
    return s;
}

LightSample from_sphere(const LightSource& light, Vec3 from, Vec2 u) {
    const Vec3 to = light.p - from;
    const double d2 = squared(to);
    const Vec3 axis = d2 > 0 ? to / std::sqrt(d2) : Vec3(0, 0, 1);
    LightSample s = from_cap(axis, d2 > 0 ? sphere_cap(light.radius, d2) : 2, light.emitted, u);
    const double met = meet_sphere(light.p, light.radius, from, s.direction);
    // A direction on the rim may miss by rounding: the tangent's length is the place meant.
    s.distance = met < kInfinity ? met : std::sqrt(std::max(0.0, d2 - light.radius * light.radius));
    return s;
}

LightSample at_point(const LightSource& light, Vec3 to, double density_of_area) {
    LightSample s;
    const double d2 = squared(to);
    if (!(d2 > 0)) return s;
    s.distance = std::sqrt(d2);
    s.direction = to / s.distance;
    const double cosine = std::abs(glm::dot(s.direction, light.normal));
    if (!(cosine > 0)) return s;
    s.density = density_of_area > 0 ? density_of_area : d2 / (cosine * light.area);
    s.radiance = light.emitted / s.density;
    return s;
}

// One place's numbers (rectangle_kernel.inc).
namespace alone {

using N = double;
N number(double x) { return x; }
N root(N x) { return std::sqrt(x); }
N size(N x) { return std::abs(x); }
N least(N a, N b) { return a < b ? a : b; }
N most(N a, N b) { return a > b ? a : b; }
bool less(N a, N b) { return a < b; }
N choose(bool first, N a, N b) { return first ? a : b; }
N with_sign(N x, N sign) { return std::copysign(x, sign); }
void turned(N turns, N& cosine, N& sine) {
    const Vec2 at = on_circle(turns);
    cosine = at.x, sine = at.y;
}
#define KERNEL inline
#define KERNEL_LAMBDA
#include "tracer/light/rectangle_kernel.inc"
#undef KERNEL
#undef KERNEL_LAMBDA

}  // namespace alone

alone::OnRectangle on_rectangle(const RectangleSides& sides, Vec3 from, Vec2 u) {
    const Vec3 to = sides.p - from;
    return alone::on_rectangle(sides, to.x, to.y, to.z, u.x, u.y);
}

LightSample from_parallelogram(const LightSource& light, Vec3 from, Vec2 u) {
    if (const std::optional<RectangleSides> sides = sides_of(light.p, light.u, light.v)) {
        const alone::OnRectangle on = on_rectangle(*sides, from, u);
        if (on.solid_angle > 0) return at_point(light, on.x * sides->x + on.y * sides->y + on.z * sides->z, 1 / on.solid_angle);
    }
    return at_point(light, light.p + u.x * light.u + u.y * light.v - from, 0);
}

double parallelogram_density(const LightSource& light, Vec3 from, Vec3 direction, double t) {
    if (const std::optional<RectangleSides> sides = sides_of(light.p, light.u, light.v)) {
        const double solid_angle = on_rectangle(*sides, from, Vec2(0)).solid_angle;
        if (solid_angle > 0) return 1 / solid_angle;
    }
    return t * t / (std::abs(glm::dot(direction, light.normal)) * light.area);
}

LightSample from_environment(const LightSource& light, Vec2 u) {
    LightSample s;
    const EnvironmentMap::Drawn drawn = light.map->draw(u);
    s.direction = drawn.direction;
    s.distance = kInfinity;
    s.density = drawn.density;
    if (s.density > 0) s.radiance = light.map->radiance(s.direction) / s.density;
    return s;
}

double sun_radiance_factor(const LightSource& sun) {
    // Irradiance on a surface facing the disc's middle: the disc's projected solid angle.
    const double h = sun.one_minus_cos;
    return 1 / (kPi * h * (2 - h));
}

}  // namespace

LightSample sample_light(const LightSource& light, Vec3 from, Vec2 u) {
    switch (light.kind) {
        case LightKind::kPoint: return towards(light.p - from, light.emitted);
        case LightKind::kSphere: return from_sphere(light, from, u);
        case LightKind::kParallelogram: return from_parallelogram(light, from, u);
        case LightKind::kEnvironment: return from_environment(light, u);
        case LightKind::kSun: break;
    }
    LightSample s;
    if (light.one_minus_cos > 0) s = from_cap(light.p, light.one_minus_cos, light.emitted * sun_radiance_factor(light), u);
    else s.direction = light.p, s.radiance = light.emitted;
    s.distance = kInfinity;
    return s;
}

namespace {

void sample_disc(const LightSource& sun, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, LightSample* samples) {
    lanes::Row<double> x, y, z;
    lanes::in_cap(sun.p, sun.one_minus_cos, u, v, count, {x.data(), y.data(), z.data()});
    LightSample s = sample_light(sun, Vec3(0), Vec2(0));
    for (std::size_t k = 0; k < count; ++k) {
        s.direction = {x[k], y[k], z[k]};
        samples[k] = s;
    }
}

void sample_rectangle(const LightSource& light, const RectangleSides& sides, const Vec3* from, const std::uint32_t* u, const std::uint32_t* v, std::size_t count,
                      LightSample* samples) {
    lanes::Row<double> x, y, z, solid_angle;
    for (std::size_t k = 0; k < count; ++k) x[k] = from[k].x, y[k] = from[k].y, z[k] = from[k].z;
    lanes::on_rectangle(sides, {x.data(), y.data(), z.data()}, u, v, count, solid_angle.data());
    for (std::size_t k = 0; k < count; ++k) {
        if (solid_angle[k] > 0) samples[k] = at_point(light, {x[k], y[k], z[k]}, 1 / solid_angle[k]);
        else samples[k] = sample_light(light, from[k], Vec2(sobol::unit(u[k]), sobol::unit(v[k])));
    }
}

}  // namespace

void sample_light(const LightSource& light, const Vec3* from, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, LightSample* samples) {
    if (light.kind == LightKind::kSun && light.one_minus_cos > 0) return sample_disc(light, u, v, count, samples);
    if (light.kind == LightKind::kParallelogram)
        if (const std::optional<RectangleSides> sides = sides_of(light.p, light.u, light.v)) return sample_rectangle(light, *sides, from, u, v, count, samples);
    for (std::size_t k = 0; k < count; ++k) samples[k] = sample_light(light, from[k], Vec2(sobol::unit(u[k]), sobol::unit(v[k])));
}

bool meet_lights(const std::vector<LightSource>& lights, Vec3 origin, Vec3 direction, double t_max, LightMet& met) {
    bool found = false;
    met.t = t_max;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LightSource& light = lights[i];
        if (!light.extended() || light.kind == LightKind::kEnvironment) continue;
        if (light.kind == LightKind::kSun) {
            if (t_max < kInfinity || found || glm::dot(direction, light.p) < 1 - light.one_minus_cos) continue;
            met = {kInfinity, i, light.emitted * sun_radiance_factor(light), 1 / (2 * kPi * light.one_minus_cos)};
            found = true;
            continue;
        }
        const bool sphere = light.kind == LightKind::kSphere;
        const double t = sphere ? meet_sphere(light.p, light.radius, origin, direction) : meet_parallelogram(light, origin, direction, met.t);
        if (!(t < met.t)) continue;
        const double density = sphere ? 1 / (2 * kPi * sphere_cap(light.radius, squared(light.p - origin)))
                                      : parallelogram_density(light, origin, direction, t);
        met = {t, i, light.emitted, density};
        found = true;
    }
    return found;
}

LightSource resolve_light(const PointLight& light, Vec3 centre) {
    LightSource s;
    s.p = light.p;
    const Vec3 color = srgb_to_linear(light.color);
    const double d2 = squared(centre - light.p);
    const double flux = light.power ? finite_or(*light.power, 0) : 4 * kPi * kWhiteIrradiance * (d2 > 0 && std::isfinite(d2) ? d2 : 1);
    const double intensity = std::max(0.0, flux) / (4 * kPi);
    s.emitted = color * intensity;
    if (!(light.radius > 0) || !std::isfinite(light.radius)) return s;
    s.kind = LightKind::kSphere;
    s.radius = light.radius;
    s.area = 4 * kPi * s.radius * s.radius;
    s.emitted = color * (intensity / (kPi * s.radius * s.radius));
    return s;
}

LightSource resolve_light(const SunLight& light) {
    LightSource s;
    s.kind = LightKind::kSun;
    s.p = -unit_or(light.direction, Vec3(0, 0, -1));
    s.emitted = srgb_to_linear(light.color) * std::max(0.0, finite_or(light.irradiance.value_or(kWhiteIrradiance), 0));
    const double half_deg = std::min(90.0, std::max(0.0, finite_or(light.angle_deg, 0)) / 2);
    // 1 - cos x = 2 sin^2 (x/2) keeps its digits for small discs.
    const double sine = sind(half_deg / 2);
    s.one_minus_cos = 2 * sine * sine;
    return s;
}

LightSource resolve_light(const AreaLight& light, Vec3 centre) {
    LightSource s;
    const Vec3 across = glm::cross(light.u, light.v);
    s.area = std::sqrt(squared(across));
    const Vec3 color = srgb_to_linear(light.color), middle = light.p + 0.5 * (light.u + light.v);
    if (!(s.area > 0) || !std::isfinite(s.area)) {
        PointLight point;
        point.p = middle;
        point.color = light.color;
        point.power = light.power;
        return resolve_light(point, centre);
    }
    s.kind = LightKind::kParallelogram;
    s.p = light.p;
    s.u = light.u;
    s.v = light.v;
    s.normal = across / s.area;
    const Vec3 to = centre - middle;
    const double d2 = squared(to);
    const double cosine = d2 > 0 ? std::abs(glm::dot(to, s.normal)) / std::sqrt(d2) : 1;
    // A model in the light's own plane is lit from nowhere: then as if it stood in front.
    const double radiance = light.power ? std::max(0.0, finite_or(*light.power, 0)) / (2 * kPi * s.area)
                                        : kWhiteIrradiance * (d2 > 0 ? d2 : 1) / (s.area * (cosine > 0 ? cosine : 1));
    s.emitted = color * radiance;
    return s;
}

}  // namespace whittle
