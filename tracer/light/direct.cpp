#include "tracer/light/direct.h"

#include <cmath>

#include <sleef.h>

#include "tracer/light/lanes.h"

namespace whittle {

namespace {

// Less than this share of a light is darkness: half of the least step of eight bits.
constexpr double kLeastShare = 1.0 / 512;

// Borders that a shadow ray goes through before it is called blocked.
constexpr int kMostBorders = 256;

// A single sample of an area stands in its middle.
Vec2 middle_of(const LightSource& lamp) { return lamp.kind == LightKind::kParallelogram ? Vec2(0.5, 0.5) : Vec2(0, 0); }

// Lamps have numbers of their own at every bounce: bounces beyond this share them.
constexpr std::uint32_t kBouncesApart = 64;

}  // namespace

Vec3 absorbed(Vec3 per_mm, double length) {
    if (per_mm == Vec3(0)) return Vec3(1);
    const auto share = [&](double a) { return a > 0 ? Sleef_cinz_expd1_u10purec(-a * length) : 1.0; };
    return {share(per_mm.x), share(per_mm.y), share(per_mm.z)};
}

Vec3 absorbed_before(const Border& border) { return border.before ? absorbed(border.before->absorption, border.travelled) : Vec3(1); }

int DirectLight::parts_of(const LightSource& lamp) const {
    return lamp.extended() && stage_.distributes() ? stage_.options.light_samples : 1;
}

LightSample DirectLight::sample(std::size_t number, Vec3 point, const Sampler& sampler, int bounce, int part, int parts) const {
    for (std::size_t i = 0; i < ahead_.count && bounce == 0; ++i) {
        const ShadowAnswer& a = ahead_.first[i];
        if (a.lamp == number && a.part == static_cast<std::uint32_t>(part) && a.origin == point) return a.sample;
    }
    const std::optional<PairOf> draw = draw_of(number, bounce, part, parts);
    if (draw) ++counters_.draws;
    return sample_light(stage_.lights[number], point, draw ? sampler.pair(*draw) : middle_of(stage_.lights[number]));
}

std::optional<PairOf> DirectLight::draw_of(std::size_t number, int bounce, int part, int parts) const {
    const bool spread = stage_.lights[number].extended() || stage_.needs.sizeless;
    if (!spread || stage_.options.samples * parts == 1 || stage_.integrator == Integrator::kCone) return std::nullopt;
    const std::uint32_t place = static_cast<std::uint32_t>(bounce) % kBouncesApart + kBouncesApart * static_cast<std::uint32_t>(number);
    return PairOf{Draw::kLight, place, static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(parts)};
}

void DirectLight::sample_many(std::size_t number, const Vec3* points, const Sampler* samplers, std::size_t count, int part, int parts, LightSample* samples) {
    const LightSource& lamp = stage_.lights[number];
    const std::optional<PairOf> draw = draw_of(number, 0, part, parts);
    if (!draw || count == 0) {
        for (std::size_t k = 0; k < count; ++k) samples[k] = sample_light(lamp, points[k], middle_of(lamp));
        return;
    }
    counters_.draws += count;
    lanes::Row<std::uint32_t> keys, indices, u, v;
    for (std::size_t k = 0; k < count; ++k) keys[k] = samplers[k].key(), indices[k] = samplers[k].index();
    lanes::pairs_of(keys.data(), indices.data(), count, *draw, u.data(), v.data(), samplers[0].sequence());
    sample_light(lamp, points, u.data(), v.data(), count, samples);
}

const ShadowAnswer* DirectLight::known(const Ray& ray, double distance) const {
    for (std::size_t i = 0; i < ahead_.count; ++i) {
        const ShadowAnswer& a = ahead_.first[i];
        if (a.asked && a.sample.direction == ray.direction && a.origin == ray.origin && a.sample.distance == distance && a.time == ray.time) return &a;
    }
    return nullptr;
}

Vec3 DirectLight::transmittance(const Border& border, Vec3 direction, double distance, double time, ClearShadows clear) const {
    Ray ray;
    ray.origin = border.point;
    ray.direction = direction;
    ray.time = time;
    ++counters_.shadow;
    const ShadowAnswer* answer = known(ray, distance);
    if (!stage_.needs.see_through) return Vec3((answer ? answer->blocked : stage_.world.blocked(ray, &border.leaving, distance, scratch_)) ? 0 : 1);
    if (answer && !answer->blocked) {
        ++counters_.media_stack;
        return border.before && std::isfinite(distance) ? absorbed(border.before->absorption, distance) : Vec3(1);
    }
    Vec3 share(1);
    Leaving leaving = border.leaving;
    const Surface* within = border.before;
    for (int i = 0; i < kMostBorders; ++i) {
        Border next;
        ++counters_.media_stack;
        if (!stage_.world.next(ray, &leaving, distance, scratch_, next)) return within && std::isfinite(distance) ? share * absorbed(within->absorption, distance) : share;
        within = next.after;
        const Surface& s = *next.surface;
        const double open = clear == ClearShadows::kLetThrough ? s.transmission * (1 - fresnel_dielectric(-glm::dot(next.normal, direction), next.eta())) : 0;
        share *= absorbed_before(next) * glm::mix(Vec3(1), open * s.color, s.coverage);
        if (largest(share) < kLeastShare) return Vec3(0);
        distance -= next.t;
        ray.origin = next.point;
        leaving = next.leaving;
    }
    return Vec3(0);
}

Vec3 DirectLight::cone_transmittance(const Border& border, const LightSource& lamp, const LightSample& sample, const Footprint& footprint) const {
    const Departure departure = stage_.world.departure_from_whole(border.leaving);
    Ray axis;
    axis.origin = border.point;
    axis.direction = sample.direction;
    axis.departure = &departure;
    Cone cone = cone_about(stage_.lens, axis);
    cone.near_u = footprint.u;
    cone.near_v = footprint.v;
    cone.reach = sample.distance;
    if (lamp.kind == LightKind::kParallelogram) {
        // The ellipse of equal deviations.
        cone.far_u = lamp.u / std::sqrt(3.0);
        cone.far_v = lamp.v / std::sqrt(3.0);
    } else if (lamp.extended()) {
        // The disc of the same solid angle. Lamps that fill the sky are cut down to a wide cone.
        constexpr double kLeastCosine = 0.1;
        const double cosine = std::max(0.0, 1 - 1 / (2 * kPi * sample.density));
        cone.spread = std::sqrt(1 - cosine * cosine) / std::max(kLeastCosine, cosine);
    }
    const auto open = [&](Vec3 direction) { return transmittance(border, glm::normalize(direction), sample.distance, 0, ClearShadows::kLetThrough); };
    const ConeParts parts = cones_->split(*stage_.program, cone, sample.distance);
    if (!parts.divided()) return open(sample.direction);
    Vec3 sum(0);
    double asked = 0;
    for (const ConePart& part : parts) {
        const Vec3 direction = part.t * sample.direction + part.off;
        // Parts that lie behind the surface itself are not asked.
        if (!(glm::dot(direction, border.normal) > 0)) continue;
        sum += part.share * open(direction);
        asked += part.share;
    }
    return asked > 0 ? sum / asked : open(sample.direction);
}

bool DirectLight::lamp_seen(const Ray& ray, double t_max, LightMet& met) const {
    // The studio's lamps are not things: its surroundings show a soft box instead.
    if (!stage_.needs.soft_lights || stage_.surroundings.is_studio()) return false;
    return meet_lights(stage_.lights, ray.origin, ray.direction, t_max, met);
}

}  // namespace whittle
