#include "tracer/light/tracer.h"

#include <cmath>
#include <limits>

#include "tracer/engine/cone.h"

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Branches that can change no byte of the picture (1/2 of 1/255, and the tree has few of them at once) are not followed.
constexpr double kLeastWeight = 1.0 / 512;

// Least blur (GGX alpha) of what is seen in a rough mirror. Chosen on the bearing of gold and steel: no sparks at 16 samples.
constexpr double kRoughImage = 0.25;

// Radius of the disc that stands for a GGX lobe in cone tracing, at distance 1 and per alpha: the disc of half the lobe's light lies within.
constexpr double kLobeRadius = 2;

// The disc around a pixel's ray that spreads places as the filter does: of a uniform disc the deviation along a line is half the radius.
Cone pixel_cone(const Stage& stage, const Ray& ray) {
    const double radius = 2 * stage.filter.deviation() * (2 * stage.lens.half_height / stage.options.height);
    Cone cone = cone_about(stage.lens, ray);
    if (stage.lens.orthographic) cone.start = radius;
    else cone.spread = radius * glm::dot(ray.direction, stage.lens.forward);
    return cone;
}

// Surfaces that are seen at more than this slant (cosine) look as long as those.
constexpr double kLeastSlant = 0.05;

// Covers one behind the other that a ray goes through before it is called opaque.
constexpr int kMostCovers = 64;

}  // namespace

CameraLight Tracer::camera_light(const Ray& ray, double height, const Sampler& sampler, const FirstBorder* first) {
    sampler_ = &sampler;
    time_ = ray.time;
    take_pass(static_cast<int>(sampler.index()));
    ++counters_.camera;
    if (first) return light_from(ray, height, *first);
    FirstBorder asked;
    asked.met = stage_.world.next(ray, nullptr, kInfinity, scratch_, asked.border);
    return light_from(ray, height, asked);
}

CameraLight Tracer::light_from(const Ray& ray, double height, const FirstBorder& known) {
    if (cones()) return cone_light(ray, height, known);
    LightMet lamp;
    if (direct_.lamp_seen(ray, known.met ? known.border.t : kInfinity, lamp)) return {lamp.radiance, 1};
    if (known.met) return {shade(ray, known.border, Branch{}), 1};
    return {stage_.surroundings.backdrop(ray.direction, height), 0};
}

void Tracer::take_pass(int sample) {
    if (!stage_.light_passes || stage_.light_passes->number_of(sample) == pass_number_) return;
    auto pass = stage_.light_passes->pass(sample);
    pass_number_ = stage_.light_passes->number_of(sample);
    // Made in vain (--disable photons), it says nothing.
    if (stage_.needs.photons) pass_ = std::move(pass);
}

Vec3 Tracer::seen(const Ray& ray, const FirstBorder& first, const Branch& branch) {
    LightMet lamp;
    if (branch.sees_lights && direct_.lamp_seen(ray, first.met ? first.border.t : kInfinity, lamp)) return brought(branch) ? Vec3(0) : lamp.radiance;
    if (first.met) return shade(ray, first.border, branch);
    return brought(branch) && stage_.surroundings.map() ? Vec3(0) : stage_.surroundings.radiance(ray.direction);
}

Vec3 Tracer::follow(const Ray& ray, const Leaving* leaving, const Branch& branch) {
    FirstBorder first;
    first.met = stage_.world.next(ray, leaving, kInfinity, scratch_, first.border);
    return cones() ? follow_cone(ray, leaving, branch, first) : seen(ray, first, branch);
}

ConeParts Tracer::divided(const Cone& cone, const FirstBorder& first) const {
    if (!first.met) return cones_->split(*stage_.program, cone, kInfinity);
    const Departure hit = stage_.world.departure_from_whole(first.border.leaving);
    return cones_->split(*stage_.program, cone, first.border.t, &hit);
}

// All parts of the pixel that edges divide.
CameraLight Tracer::cone_light(const Ray& ray, double height, const FirstBorder& first) {
    const Cone cone = pixel_cone(stage_, ray);
    const auto light = [&](const Ray& along, const FirstBorder& border, double share) -> CameraLight {
        LightMet lamp;
        const bool lit = direct_.lamp_seen(along, border.met ? border.border.t : kInfinity, lamp);
        if (!border.met && !lit) return {stage_.surroundings.backdrop(along.direction, height), 0};
        if (lit) return {lamp.radiance, 1};
        Branch branch;
        branch.wide = std::sqrt(share) * (cone.start + cone.spread * border.border.t);
        branch.widens = std::sqrt(share) * cone.spread;
        return {shade(along, border.border, branch), 1};
    };
    const ConeParts parts = divided(cone, first);
    if (!parts.divided()) return light(ray, first, 1);
    CameraLight sum;
    for (const ConePart& p : parts) {
        const Vec3 off = p.off / (cone.start + cone.spread * p.t);
        Ray part = ray;
        part.origin += cone.start * off;
        part.direction = glm::normalize(ray.direction + cone.spread * off);
        FirstBorder border;
        border.met = stage_.world.next(part, nullptr, kInfinity, scratch_, border.border);
        const CameraLight own = light(part, border, p.share);
        sum.radiance += p.share * own.radiance;
        sum.coverage += p.share * own.coverage;
    }
    return sum;
}

// What a mirror or glass shows through a cone. All parts leave the same place.
Vec3 Tracer::follow_cone(const Ray& ray, const Leaving* leaving, const Branch& branch, const FirstBorder& axis) {
    const auto onward = [&](const FirstBorder& border, double share) {
        Branch part = branch;
        part.weight *= share;
        part.wide = std::sqrt(share) * (branch.wide + (border.met ? branch.widens * border.border.t : 0));
        part.widens *= std::sqrt(share);
        return part;
    };
    const Departure departure = stage_.world.departure_from_whole(*leaving);
    Cone cone = cone_about(stage_.lens, ray);
    cone.start = branch.wide;
    cone.spread = branch.widens;
    cone.axis.departure = &departure;
    const ConeParts parts = divided(cone, axis);
    if (!parts.divided()) return seen(ray, axis, onward(axis, 1));
    Vec3 sum(0);
    double asked = 0;
    for (const ConePart& p : parts) {
        Ray part = ray;
        part.direction = glm::normalize(ray.direction + p.off / p.t);
        // Parts that lie behind the surface itself are not asked.
        if (!(glm::dot(part.direction, branch.out) > 0)) continue;
        FirstBorder border;
        border.met = stage_.world.next(part, leaving, kInfinity, scratch_, border.border);
        sum += p.share * seen(part, border, onward(border, p.share));
        asked += p.share;
    }
    return asked > 0 ? sum / asked : seen(ray, axis, onward(axis, 1));
}

// Where a cone of this radius lies on the surface.
Footprint Tracer::footprint(const Border& border, Vec3 view, double radius) {
    const Vec3 level = glm::cross(border.normal, view);
    const double slant = glm::length(level), cosine = std::max(kLeastSlant, glm::dot(border.normal, view));
    if (!(slant > 0)) return {radius * ShadingFrame(border.normal).to_world(Vec3(1, 0, 0)), radius * ShadingFrame(border.normal).to_world(Vec3(0, 1, 0))};
    return {level * (radius / slant), glm::cross(border.normal, level) * (radius / slant / cosine)};
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
    if (s.transmission > 0) sum += s.transmission * through_clear(s, ray, border, branch);
    if (s.coverage < 1) sum = s.coverage * sum + (1 - s.coverage) * straight_on(ray, border, branch);
    return absorbed_before(border) * sum;
}

Vec3 Tracer::lit(const Surface& s, const Border& border, const Bsdf& bsdf, const Branch& branch) {
    if (s.metal >= 1 && s.sharp()) return Vec3(0);
    Vec3 sum = sky(s, border, bsdf, branch);
    if (pass_) sum += pass_->gathered(border, bsdf);
    for (std::size_t i = 0; i < stage_.lights.size(); ++i) {
        const LightSource& light = stage_.lights[i];
        // In a metal the picture of the surroundings is met by the ray that follows.
        const bool dull = light.kind == LightKind::kEnvironment && s.metal > 0;
        const int parts = direct_.parts_of(light);
        for (int k = 0; k < parts; ++k) {
            const LightSample sample = direct_.sample(i, border.point, *sampler_, branch.depth, k, parts);
            const double cos_light = glm::dot(border.normal, sample.direction);
            if (!(cos_light > 0) || (sample.radiance == Vec3(0) && !stage_.needs.dark_lamps)) continue;
            const bool shadow = light.casts_shadow && stage_.integrator != Integrator::kPreview;
            const Vec3 share = shadow && cones() ? direct_.cone_transmittance(border, light, sample, footprint(border, bsdf.view(), branch.wide))
                               : shadow            ? direct_.transmittance(border, sample.direction, sample.distance, time_, clear_shadows())
                                                   : Vec3(1);
            if (share == Vec3(0)) continue;
            sum += (dull ? bsdf.dull_value(cos_light) : bsdf.value(sample.direction, cos_light)) * share * sample.radiance * (cos_light / parts);
        }
    }
    return sum;
}

// Light of the surroundings on rough matter; mirrors, metals and clear matter follow a ray instead.
Vec3 Tracer::sky(const Surface& s, const Border& border, const Bsdf& bsdf, const Branch& branch) {
    const Surroundings& around = stage_.surroundings;
    if (around.dark()) return Vec3(0);
    if (!distributes()) return bsdf.dull_albedo() * around.sky(border.normal) + bsdf.sheen() * around.sky(mirrored(-bsdf.view(), border.normal));
    // A picture is a lamp.
    if (around.map()) return Vec3(0);
    const auto vertex = static_cast<std::uint32_t>(branch.depth);
    const Vec2 u = sampler_->pair(Draw::kSky, vertex);
    Bsdf::Drawn drawn;
    if (bsdf.gloss() && !(s.metal > 0)) {
        drawn = bsdf.draw(u, sampler_->pair(Draw::kChoice, vertex).x);
        if (!(drawn.density > 0)) return Vec3(0);
    } else {
        drawn.direction = ShadingFrame(border.normal).to_world(on_cosine_hemisphere(u));
        drawn.share = bsdf.dull_value(glm::dot(drawn.direction, border.normal)) * kPi;
    }
    if (drawn.share == Vec3(0)) return Vec3(0);
    return drawn.share * around.sky(drawn.direction) * direct_.transmittance(border, drawn.direction, kInfinity, time_, ClearShadows::kLetThrough);
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
    onward.brought = s.sharp() && branch.rough;
    if (!s.sharp()) {
        onward.rough = true;
        onward.spread = std::max(kRoughImage, s.alpha);
        onward.widens += kLobeRadius * s.alpha;
    }
    onward.out = border.normal;
    ++counters_.reflection;
    return share * follow(next, &border.leaving, onward);
}

// Both branches at the border of clear matter; of rough matter one of them, by lot.
Vec3 Tracer::through_clear(const Surface& s, const Ray& ray, const Border& border, const Branch& branch) {
    if (branch.depth >= stage_.options.max_depth) return Vec3(0);
    Branch onward = branch;
    ++onward.depth;
    onward.sees_lights = s.sharp();
    onward.brought = s.sharp() && branch.rough;
    onward.rough = branch.rough || !s.sharp();
    if (!s.sharp()) onward.spread = std::max(kRoughImage, s.alpha);
    const double reach = branch.weight * largest(absorbed_before(border));
    if (!s.sharp() && distributes()) {
        onward.weight = reach;
        return reach < kLeastWeight ? Vec3(0) : through_rough(ray, border, onward);
    }
    // The reflected branch keeps all wavelengths together, the refracted one has the hero's way.
    Branch bent = onward;
    Vec3 hue(1);
    if (stage_.spectrum) ++counters_.draws;
    if (stage_.spectrum && disperses(border) && bent.hues.white()) {
        bent.hues.begin(*stage_.spectrum, sampler_->pair(Draw::kTimeAndWavelength).y);
        bent.hues.hero_alone(*stage_.spectrum);
        hue = bent.hues.color();
        ++counters_.wavelengths;
    }
    const double cosine = -glm::dot(ray.direction, border.normal), eta = eta_at(border, bent.hues.hero());
    const double mirror = fresnel_dielectric(cosine, eta_at(border, onward.hues.hero())), let_through = 1 - fresnel_dielectric(cosine, eta);
    Ray next = ray;
    next.origin = border.point;
    Vec3 sum(0);
    onward.weight = reach * mirror;
    next.direction = mirrored(ray.direction, border.normal);
    if (onward.weight >= kLeastWeight) {
        onward.out = border.normal;
        ++counters_.reflection;
        sum += mirror * follow(next, &border.leaving, onward);
    }
    bent.weight = reach * let_through;
    const std::optional<Vec3> refraction = refracted(ray.direction, border.normal, eta);
    if (refraction && bent.weight >= kLeastWeight) {
        ++counters_.refraction;
        next.direction = *refraction;
        bent.out = -border.normal;
        sum += let_through * s.color * hue * follow(next, &border.leaving, bent);
    }
    return sum;
}

Vec3 Tracer::through_rough(const Ray& ray, const Border& border, const Branch& branch) {
    const auto vertex = static_cast<std::uint32_t>(branch.depth);
    if (stage_.spectrum) ++counters_.draws;
    const CrossingDraws draws{lobe(branch), sampler_->pair(Draw::kChoice, vertex).x, stage_.spectrum ? sampler_->pair(Draw::kTimeAndWavelength).y : 0};
    Branch onward = branch;
    const std::optional<Crossing> crossing = cross_border(stage_, border, ray.direction, draws, onward.hues);
    if (!crossing) return Vec3(0);
    Vec3 share = crossing->through ? border.surface->color : Vec3(1);
    if (branch.hues.white() && !onward.hues.white()) {
        onward.hues.hero_alone(*stage_.spectrum);
        share *= onward.hues.color();
        ++counters_.wavelengths;
    }
    Ray next = ray;
    next.origin = border.point;
    next.direction = crossing->direction;
    ++(crossing->through ? counters_.refraction : counters_.reflection);
    return share * follow(next, &border.leaving, onward);
}

// Behind a thin cover.
Vec3 Tracer::straight_on(const Ray& ray, const Border& border, const Branch& branch) {
    Branch onward = branch;
    onward.weight *= 1 - border.surface->coverage;
    ++onward.straight;
    onward.out = -border.normal;
    if (onward.weight < kLeastWeight || onward.straight > kMostCovers) return Vec3(0);
    Ray next = ray;
    next.origin = border.point;
    return follow(next, &border.leaving, onward);
}

}  // namespace whittle
