#include "tracer/light/tracer.h"

#include <limits>

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Branches that can change no byte of the picture (1/2 of 1/255, and the tree has few of them at once) are not followed.
constexpr double kLeastWeight = 1.0 / 512;

// Least blur (GGX alpha) of what is seen in a rough mirror. Chosen on the bearing of gold and steel: no sparks at 16 samples.
constexpr double kRoughImage = 0.25;

// Covers one behind the other that a ray goes through before it is called opaque.
constexpr int kMostCovers = 64;

}  // namespace

CameraLight Tracer::camera_light(const Ray& ray, double height, const Sampler& sampler, const FirstBorder* first) {
    sampler_ = &sampler;
    ++counters_.camera;
    FirstBorder asked;
    if (!first) asked.met = stage_.world.next(ray, nullptr, kInfinity, scratch_, asked.border);
    const auto& [met, border] = first ? *first : asked;
    LightMet lamp;
    if (direct_.lamp_seen(ray, met ? border.t : kInfinity, lamp)) return {lamp.radiance, 1};
    if (met) return {shade(ray, border, Branch{}), 1};
    return {stage_.surroundings.backdrop(ray.direction, height), 0};
}

Vec3 Tracer::follow(const Ray& ray, const Leaving* leaving, const Branch& branch) {
    Border border;
    const bool met = stage_.world.next(ray, leaving, kInfinity, scratch_, border);
    LightMet lamp;
    if (branch.sees_lights && direct_.lamp_seen(ray, met ? border.t : kInfinity, lamp)) return lamp.radiance;
    return met ? shade(ray, border, branch) : stage_.surroundings.radiance(ray.direction);
}

Vec3 Tracer::shade(const Ray& ray, const Border& border, const Branch& branch) {
    ++counters_.normals;
    const Surface& s = *border.surface;
    if (s.sharp() || s.alpha >= branch.spread) return shade_as(s, ray, border, branch);
    // A highlight seen in a rough mirror is blurred: one ray cannot find it, and finding it by chance makes sparks.
    Surface blurred = s;
    blurred.alpha = branch.spread;
    return shade_as(blurred, ray, border, branch);
}

Vec3 Tracer::shade_as(const Surface& s, const Ray& ray, const Border& border, const Branch& branch) {
    const Bsdf bsdf(s, border.normal, -ray.direction);
    Vec3 sum = s.emission;
    if (s.transmission < 1) {
        sum += (1 - s.transmission) * lit(s, border, bsdf, branch);
        if (s.metal > 0 || (s.sharp() && s.dielectric_f0 > 0)) sum += (1 - s.transmission) * reflection(s, ray, border, bsdf, branch);
    }
    if (s.transmission > 0) sum += s.transmission * through_clear(s, ray, border, bsdf, branch);
    if (s.coverage < 1) sum = s.coverage * sum + (1 - s.coverage) * straight_on(ray, border, branch);
    return absorbed_before(border) * sum;
}

Vec3 Tracer::lit(const Surface& s, const Border& border, const Bsdf& bsdf, const Branch& branch) {
    if (s.metal >= 1 && s.sharp()) return Vec3(0);
    Vec3 sum = sky(border, bsdf, branch);
    for (std::size_t i = 0; i < stage_.lights.size(); ++i) {
        const int parts = direct_.parts_of(stage_.lights[i]);
        for (int k = 0; k < parts; ++k) {
            const LightSample sample = direct_.sample(i, border.point, *sampler_, branch.depth, k, parts);
            const double cos_light = glm::dot(border.normal, sample.direction);
            if (!(cos_light > 0) || sample.radiance == Vec3(0)) continue;
            const bool shadow = stage_.lights[i].casts_shadow && stage_.integrator != Integrator::kPreview;
            const Vec3 share = shadow ? direct_.transmittance(border, sample.direction, sample.distance, 0, ClearShadows::kLetThrough) : Vec3(1);
            if (share != Vec3(0)) sum += bsdf.value(sample.direction, cos_light) * share * sample.radiance * (cos_light / parts);
        }
    }
    return sum;
}

// Light of the surroundings on rough matter; metals and clear matter follow a ray instead.
Vec3 Tracer::sky(const Border& border, const Bsdf& bsdf, const Branch& branch) {
    if (stage_.surroundings.dark()) return Vec3(0);
    if (distributes()) {
        if (bsdf.diffuse_albedo() == Vec3(0)) return Vec3(0);
        const Vec3 direction = Frame(border.normal).to_world(on_cosine_hemisphere(sampler_->pair(Draw::kSky, static_cast<std::uint32_t>(branch.depth))));
        return bsdf.diffuse_albedo() * stage_.surroundings.sky(direction) * direct_.transmittance(border, direction, kInfinity, 0, ClearShadows::kLetThrough);
    }
    return bsdf.diffuse_albedo() * stage_.surroundings.sky(border.normal) + bsdf.sheen() * stage_.surroundings.sky(mirrored(-bsdf.view(), border.normal));
}

Vec3 Tracer::reflection(const Surface& s, const Ray& ray, const Border& border, const Bsdf& bsdf, const Branch& branch) {
    if (branch.depth >= stage_.options.max_depth) return Vec3(0);
    const Vec3 micro = distributes() ? bsdf.micro_normal(lobe(branch)) : border.normal;
    Ray next = ray;
    next.origin = border.point;
    next.direction = mirrored(ray.direction, micro);
    const double cos_out = glm::dot(next.direction, border.normal);
    if (!(cos_out > 0)) return Vec3(0);
    const Vec3 share = bsdf.mirror_share(-glm::dot(ray.direction, micro)) * (s.sharp() ? 1.0 : ggx_masking(cos_out, s.alpha));
    if (stage_.integrator == Integrator::kPreview) return share * stage_.surroundings.radiance(next.direction);
    Branch onward = branch;
    onward.weight *= largest(share);
    if (onward.weight < kLeastWeight) return Vec3(0);
    ++onward.depth;
    onward.sees_lights = s.sharp();
    if (!s.sharp()) onward.spread = std::max(kRoughImage, s.alpha);
    ++counters_.reflection;
    return share * follow(next, &border.leaving, onward);
}

// Both branches at the border of clear matter.
Vec3 Tracer::through_clear(const Surface& s, const Ray& ray, const Border& border, const Bsdf& bsdf, const Branch& branch) {
    if (branch.depth >= stage_.options.max_depth) return Vec3(0);
    const double eta = border.eta();
    const Vec3 micro = distributes() ? bsdf.micro_normal(lobe(branch)) : border.normal;
    const double mirror = fresnel_dielectric(-glm::dot(ray.direction, micro), eta);
    Ray next = ray;
    next.origin = border.point;
    Branch onward = branch;
    ++onward.depth;
    onward.sees_lights = s.sharp();
    if (!s.sharp()) onward.spread = std::max(kRoughImage, s.alpha);
    const double reach = branch.weight * largest(absorbed_before(border));
    Vec3 sum(0);
    onward.weight = reach * mirror;
    next.direction = mirrored(ray.direction, micro);
    if (onward.weight >= kLeastWeight && glm::dot(next.direction, border.normal) > 0) {
        ++counters_.reflection;
        sum += mirror * follow(next, &border.leaving, onward);
    }
    onward.weight = reach * (1 - mirror);
    const std::optional<Vec3> bent = refracted(ray.direction, micro, eta);
    if (bent && onward.weight >= kLeastWeight && glm::dot(*bent, border.normal) < 0) {
        ++counters_.refraction;
        next.direction = *bent;
        sum += (1 - mirror) * s.color * follow(next, &border.leaving, onward);
    }
    return sum;
}

// Behind a thin cover.
Vec3 Tracer::straight_on(const Ray& ray, const Border& border, const Branch& branch) {
    Branch onward = branch;
    onward.weight *= 1 - border.surface->coverage;
    ++onward.straight;
    if (onward.weight < kLeastWeight || onward.straight > kMostCovers) return Vec3(0);
    Ray next = ray;
    next.origin = border.point;
    return follow(next, &border.leaving, onward);
}

}  // namespace whittle
