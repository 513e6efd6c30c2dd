#include "tracer/light/tracer.h"

#include <limits>

#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Branches that can change no byte of the picture (1/2 of 1/255, and the tree has few of them at once) are not followed.
constexpr double kLeastWeight = 1.0 / 512;

// Covers one behind the other that a ray goes through before it is called opaque.
constexpr int kMostCovers = 64;

double largest(Vec3 v) { return std::max(v.x, std::max(v.y, v.z)); }

Vec3 absorbed(Vec3 per_mm, double length) {
    if (per_mm == Vec3(0)) return Vec3(1);
    const auto share = [&](double a) { return a > 0 ? Sleef_cinz_expd1_u10purec(-a * length) : 1.0; };
    return {share(per_mm.x), share(per_mm.y), share(per_mm.z)};
}

// The dielectric's highlight keeps a colourless share, a metal's takes the colour.
Vec3 normal_reflectance(const Surface& s) { return glm::mix(Vec3(s.dielectric_f0), s.color, s.metal); }

}  // namespace

Tracer::Light Tracer::camera_light(const Ray& ray, double height, const Sampler& sampler) {
    sampler_ = &sampler;
    ++counters_.camera;
    Hit hit;
    const bool met = first_hit(*stage_.program, ray, kInfinity, scratch_, hit);
    LightMet lamp;
    const bool lamp_first = stage_.needs.soft_lights && meet_lights(stage_.lights, ray.origin, ray.direction, met ? hit.end.t : kInfinity, lamp) &&
                            !stage_.surroundings.is_studio();
    if (lamp_first) return {lamp.radiance, 1};
    if (met) return {shade(ray, hit, Branch{}), 1};
    return {stage_.surroundings.backdrop(ray.direction, height), 0};
}

// Where nothing is met.
Vec3 Tracer::beyond(const Ray& ray, const Branch& branch) const {
    LightMet lamp;
    if (branch.sees_lights && stage_.needs.soft_lights && !stage_.surroundings.is_studio() &&
        meet_lights(stage_.lights, ray.origin, ray.direction, kInfinity, lamp))
        return lamp.radiance;
    return stage_.surroundings.radiance(ray.direction);
}

Vec3 Tracer::follow(const Ray& ray, const Branch& branch) {
    Hit hit;
    if (!first_hit(*stage_.program, ray, kInfinity, scratch_, hit)) return beyond(ray, branch);
    LightMet lamp;
    if (branch.sees_lights && stage_.needs.soft_lights && !stage_.surroundings.is_studio() &&
        meet_lights(stage_.lights, ray.origin, ray.direction, hit.end.t, lamp))
        return lamp.radiance;
    return shade(ray, hit, branch);
}

Vec3 Tracer::shade(const Ray& ray, Hit& hit, const Branch& branch) {
    ++counters_.normals;
    Meeting m{hit, &stage_.surfaces[hit.end.use], hit.end.normal, -ray.direction, 0};
    m.cos_view = glm::dot(m.normal, m.view);
    if (m.cos_view < 0) {
        m.normal = -m.normal;
        m.cos_view = -m.cos_view;
    }
    const Surface& s = *m.surface;
    Vec3 sum = s.emission;
    if (s.transmission < 1) sum += (1 - s.transmission) * lit(m, branch);
    if (s.transmission > 0) sum += s.transmission * through_glass(ray, m, branch);
    if (s.transmission < 1 && (s.metal > 0 || (s.sharp() && s.dielectric_f0 > 0))) sum += (1 - s.transmission) * reflection(ray, m, branch);
    if (s.coverage < 1) sum = s.coverage * sum + (1 - s.coverage) * continued(ray, m, branch);
    return sum;
}

Vec3 Tracer::lit(const Meeting& m, const Branch& branch) {
    if (m.surface->metal >= 1 && m.surface->sharp()) return Vec3(0);
    Vec3 sum = sky(m, branch);
    for (std::size_t i = 0; i < stage_.lights.size(); ++i) sum += lit_by(stage_.lights[i], i, m, branch);
    return sum;
}

Vec3 Tracer::lit_by(const LightSource& light, std::size_t number, const Meeting& m, const Branch& branch) {
    const bool sampled = light.extended() && sampler_;
    const int parts = light.extended() && distributes() ? stage_.options.light_samples : 1;
    Vec3 sum(0);
    for (int k = 0; k < parts; ++k) {
        Vec2 u(0, 0);
        if (light.extended()) u = light.kind == LightKind::kSun ? Vec2(0, 0) : Vec2(0.5, 0.5);
        if (sampled && stage_.options.samples * parts > 1) {
            u = sampler_->pair(Draw::kLight, static_cast<std::uint32_t>(branch.depth) + 64 * static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(k),
                               static_cast<std::uint32_t>(parts));
        }
        const LightSample sample = sample_light(light, m.hit.point, u);
        const double cos_light = glm::dot(m.normal, sample.direction);
        if (!(cos_light > 0) || sample.radiance == Vec3(0)) continue;
        Vec3 arriving = sample.radiance;
        if (light.casts_shadow && stage_.integrator != Integrator::kPreview) arriving *= transmittance(m, sample.direction, sample.distance);
        if (arriving == Vec3(0)) continue;
        sum += scattering(m, sample.direction, cos_light) * arriving * cos_light;
    }
    return sum / static_cast<double>(parts);
}

// Diffuse share and highlight for light from `direction`.
Vec3 Tracer::scattering(const Meeting& m, Vec3 direction, double cos_light) const {
    const Surface& s = *m.surface;
    const double sheen = fresnel_schlick(s.dielectric_f0, m.cos_view);
    Vec3 value = s.color * ((1 - s.metal) * (1 - sheen) / kPi);
    if (s.sharp() || (s.dielectric_f0 == 0 && s.metal == 0)) return value;
    const Vec3 half = glm::normalize(direction + m.view);
    const double nh = glm::dot(m.normal, half), vh = glm::dot(m.view, half);
    return value + fresnel_schlick(normal_reflectance(s), vh) * (ggx_density(nh, s.alpha) * ggx_visibility(cos_light, std::max(m.cos_view, 1e-9), s.alpha));
}

// The unshadowed share of the surroundings on rough matter; metals and glass follow a ray instead.
Vec3 Tracer::sky(const Meeting& m, const Branch& branch) {
    const Surface& s = *m.surface;
    const double sheen = fresnel_schlick(s.dielectric_f0, m.cos_view);
    if (stage_.surroundings.dark()) return Vec3(0);
    if (distributes()) {
        const Vec2 u = sampler_->pair(Draw::kSky, static_cast<std::uint32_t>(branch.depth));
        const Vec3 direction = Frame(m.normal).to_world(on_cosine_hemisphere(u));
        return s.color * ((1 - s.metal) * (1 - sheen)) * stage_.surroundings.sky(direction) * transmittance(m, direction, kInfinity);
    }
    Vec3 sum = s.color * ((1 - s.metal) * (1 - sheen)) * stage_.surroundings.sky(m.normal);
    if (s.dielectric_f0 > 0 && !s.sharp() && s.metal < 1) {
        // A dull sheen: the room's mean brightness in the mirror direction, weaker the rougher.
        const double dull = (1 - s.metal) * (1 - s.alpha) * fresnel_schlick(s.dielectric_f0, m.cos_view);
        sum += dull * stage_.surroundings.sky(mirrored(-m.view, m.normal));
    }
    return sum;
}

Vec3 Tracer::reflection(const Ray& ray, const Meeting& m, const Branch& branch) {
    const Surface& s = *m.surface;
    if (branch.depth >= stage_.options.max_depth) return Vec3(0);
    if (stage_.integrator == Integrator::kPreview) return s.metal * s.color * stage_.surroundings.radiance(mirrored(ray.direction, m.normal));
    const Vec3 f0 = s.sharp() ? normal_reflectance(s) : s.color * s.metal;
    Vec3 micro = m.normal;
    double masking = 1;
    if (!s.sharp() && distributes()) {
        const Frame frame(m.normal);
        micro = frame.to_world(ggx_visible_normal(frame.to_local(m.view), s.alpha, sampler_->pair(Draw::kLobe, static_cast<std::uint32_t>(branch.depth))));
    }
    Ray next = ray;
    next.direction = mirrored(ray.direction, micro);
    const double cos_out = glm::dot(next.direction, m.normal);
    if (!(cos_out > 0)) return Vec3(0);
    if (!s.sharp()) masking = ggx_masking(cos_out, s.alpha);
    const Vec3 share = fresnel_schlick(f0, glm::dot(m.view, micro)) * masking;
    Branch onward = branch;
    onward.weight *= largest(share);
    if (onward.weight < kLeastWeight) return Vec3(0);
    ++onward.depth;
    onward.sees_lights = s.sharp();
    next.origin = m.hit.point;
    next.departure = &m.hit.departure;
    ++counters_.reflection;
    return share * follow(next, onward);
}

// Both branches at a border of glass. Inside, light is absorbed along the way.
Vec3 Tracer::through_glass(const Ray& ray, const Meeting& m, const Branch& branch) {
    const Surface& s = *m.surface;
    const bool leaving = m.hit.from_inside;
    const Vec3 travelled = leaving ? absorbed(s.absorption, m.hit.end.t * glm::length(ray.direction)) : Vec3(1);
    if (branch.depth >= stage_.options.max_depth) return Vec3(0);
    const double eta = leaving ? s.ior : 1 / s.ior;
    Vec3 micro = m.normal;
    if (!s.sharp() && distributes()) {
        const Frame frame(m.normal);
        micro = frame.to_world(ggx_visible_normal(frame.to_local(m.view), s.alpha, sampler_->pair(Draw::kLobe, static_cast<std::uint32_t>(branch.depth))));
    }
    const double mirror = fresnel_dielectric(glm::dot(m.view, micro), eta);
    Ray next = ray;
    next.origin = m.hit.point;
    next.departure = &m.hit.departure;
    Branch onward = branch;
    ++onward.depth;
    onward.sees_lights = s.sharp();
    Vec3 sum(0);
    const double reach = branch.weight * largest(travelled);
    onward.weight = reach * mirror;
    next.direction = mirrored(ray.direction, micro);
    if (onward.weight >= kLeastWeight && glm::dot(next.direction, m.normal) > 0) {
        ++counters_.reflection;
        sum += mirror * follow(next, onward);
    }
    onward.weight = reach * (1 - mirror);
    const std::optional<Vec3> bent = refracted(ray.direction, micro, eta);
    if (bent && onward.weight >= kLeastWeight && glm::dot(*bent, m.normal) < 0) {
        ++counters_.refraction;
        next.direction = *bent;
        sum += (1 - mirror) * s.color * follow(next, onward);
    }
    return travelled * sum;
}

// Straight on behind a thin cover.
Vec3 Tracer::continued(const Ray& ray, const Meeting& m, const Branch& branch) {
    Branch onward = branch;
    onward.weight *= 1 - m.surface->coverage;
    ++onward.straight;
    if (onward.weight < kLeastWeight || onward.straight > kMostCovers) return Vec3(0);
    Ray next = ray;
    next.origin = m.hit.point;
    next.departure = &m.hit.departure;
    if (branch.depth == 0) {
        Hit hit;
        if (first_hit(*stage_.program, next, kInfinity, scratch_, hit)) return shade(next, hit, onward);
        return stage_.surroundings.radiance(next.direction);
    }
    return follow(next, onward);
}

// Share of the light that comes through from `direction`: 0 or 1 among opaque matter. Glass lets it pass unbent.
Vec3 Tracer::transmittance(const Meeting& m, Vec3 direction, double distance) {
    Ray ray;
    ray.origin = m.hit.point;
    ray.direction = direction;
    ray.departure = &m.hit.departure;
    ++counters_.shadow;
    if (!stage_.needs.see_through) return any_hit(*stage_.program, ray, distance, scratch_) ? Vec3(0) : Vec3(1);
    Vec3 share(1);
    Hit hit;
    Departure left;
    for (int cover = 0; cover < kMostCovers; ++cover) {
        if (!first_hit(*stage_.program, ray, distance, scratch_, hit)) return share;
        const Surface& s = stage_.surfaces[hit.end.use];
        const double cosine = std::abs(glm::dot(hit.end.normal, direction));
        const Vec3 clear = s.transmission * (1 - fresnel_schlick(s.dielectric_f0, cosine)) * s.color * (hit.from_inside ? absorbed(s.absorption, hit.end.t) : Vec3(1));
        share *= glm::mix(Vec3(1), clear, s.coverage);
        if (largest(share) < kLeastWeight) return Vec3(0);
        distance -= hit.end.t;
        ray.origin = hit.point;
        left = hit.departure;
        ray.departure = &left;
    }
    return Vec3(0);
}

}  // namespace whittle
