#include "tracer/light/path.h"

#include <limits>

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bounces before a dim walk may be ended by lot.
constexpr int kSureBounces = 4;

constexpr int kMostCovers = 256;

// Veach's power heuristic with exponent 2, one sample of each.
double weighed(double own, double other) {
    const double a = own * own, b = other * other;
    return a + b > 0 && std::isfinite(a) ? a / (a + b) : own > other ? 1 : 0;
}

}  // namespace

CameraLight PathTracer::camera_light(const Ray& ray, double height, const Sampler& sampler, const FirstBorder* first) {
    ++counters_.camera;
    take_pass(static_cast<int>(sampler.index()));
    Walk walk;
    walk.ray = ray;
    bool met = false;
    while (step(walk, height, sampler, met ? nullptr : first)) met = true;
    // A walk that ends at its first border met the solid as well.
    met = met || walk.departs;
    if (!walk.hues.white()) ++counters_.wavelengths;
    return {walk.radiance, met ? 1.0 : 0.0};
}

// A tile draws one sample of many pixels after the other.
void PathTracer::take_pass(int number) {
    if (!stage_.light_passes || number == pass_number_) return;
    auto pass = stage_.light_passes->pass(number);
    pass_number_ = number;
    // Made in vain (--disable photons), it says nothing.
    if (stage_.needs.photons) pass_ = std::move(pass);
}

// Light from where nothing is met.
Vec3 PathTracer::surroundings(const Walk& walk, double height) const {
    if (walk.straight && !walk.departs) return stage_.surroundings.backdrop(walk.ray.direction, height);
    // A picture's light onto what is dull, by way of mirrors and glass: the photons bring that.
    if (walk.single && walk.dull && pass_ && stage_.surroundings.map()) return Vec3(0);
    if (walk.single) return stage_.surroundings.radiance(walk.ray.direction);
    // Behind rough scattering the studio is its smooth sky: the key's soft box is sampled as a lamp.
    const Vec3 sky = stage_.surroundings.is_studio() ? stage_.surroundings.sky(walk.ray.direction) : stage_.surroundings.radiance(walk.ray.direction);
    if (!stage_.surroundings.map() || !stage_.options.sample_lamps) return sky;
    return sky * weighed(walk.density, stage_.surroundings.map()->density(walk.ray.direction) * stage_.options.light_samples);
}

void PathTracer::meet_lamp(Walk& walk, const LightMet& lamp) const {
    // Through mirrors and glass onto what is dull: the photons bring that.
    if (pass_ && walk.dull && walk.single) return;
    const double other = lamp.density * direct_.parts_of(stage_.lights[lamp.light]);
    walk.radiance += walk.carried() * lamp.radiance * (walk.single || !stage_.options.sample_lamps ? 1.0 : weighed(walk.density, other));
}

// One border further; false where the walk ends.
bool PathTracer::step(Walk& walk, double height, const Sampler& sampler, const FirstBorder* known) {
    FirstBorder asked;
    if (!known) asked.met = stage_.world.next(walk.ray, walk.departs ? &walk.leaving : nullptr, kInfinity, scratch_, asked.border);
    const auto& [met, border] = known ? *known : asked;
    LightMet lamp;
    if (direct_.lamp_seen(walk.ray, met ? border.t : kInfinity, lamp)) {
        if (met) walk.share *= absorbed(border.before ? border.before->absorption : Vec3(0), lamp.t);
        meet_lamp(walk, lamp);
        return false;
    }
    if (!met) {
        walk.radiance += walk.carried() * surroundings(walk, height);
        return false;
    }
    ++counters_.normals;
    // Radiance is that of air: what a camera inside of clear matter takes up is less by the square of the index.
    if (!walk.departs && border.before) walk.share /= border.before->ior * border.before->ior;
    walk.departs = true;
    walk.share *= absorbed_before(border);
    walk.leaving = border.leaving;
    walk.ray.origin = border.point;
    const Surface& s = *border.surface;
    const Vec2 choices = sampler.pair(Draw::kChoice, static_cast<std::uint32_t>(walk.bounce + walk.covers));
    if (s.coverage < 1 && choices.y >= s.coverage) return ++walk.covers < kMostCovers;
    walk.radiance += walk.carried() * s.emission;
    if (walk.bounce >= stage_.options.max_depth) return false;
    const Bsdf bsdf(s, border.normal, -walk.ray.direction);
    if (!scatter(walk, border, bsdf, sampler)) return false;
    walk.straight = false;
    if (++walk.bounce < kSureBounces) return true;
    const double survival = std::min(1.0, largest(walk.share));
    if (!(sampler.pair(Draw::kSky, static_cast<std::uint32_t>(walk.bounce)).x < survival)) return false;
    walk.share /= survival;
    return true;
}

void PathTracer::add_lamps(Walk& walk, const Border& border, const Bsdf& bsdf, const Sampler& sampler) {
    for (std::size_t i = 0; i < stage_.lights.size(); ++i) {
        const LightSource& light = stage_.lights[i];
        // The studio's fill stands for light between surfaces, which is walked here.
        const bool seen = light.extended() && !stage_.surroundings.is_studio();
        if (!light.casts_shadow || (seen && !stage_.options.sample_lamps)) continue;
        const int parts = direct_.parts_of(light);
        for (int k = 0; k < parts; ++k) {
            const LightSample sample = direct_.sample(i, border.point, sampler, walk.bounce, k, parts);
            const double cos_light = glm::dot(border.normal, sample.direction);
            if (!(cos_light > 0) || (sample.radiance == Vec3(0) && !stage_.needs.dark_lamps)) continue;
            const Vec3 open = direct_.transmittance(border, sample.direction, sample.distance, walk.ray.time, ClearShadows::kBlock);
            if (open == Vec3(0)) continue;
            const double weight = seen ? weighed(sample.density * parts, bsdf.density(sample.direction, cos_light)) : 1;
            walk.radiance += walk.carried() * bsdf.value(sample.direction, cos_light) * open * sample.radiance * (cos_light * weight / parts);
        }
    }
}

void PathTracer::add_photons(Walk& walk, const Border& border, const Bsdf& bsdf) const {
    // What the eye sees without a detour was drawn from the lamps right onto the picture.
    if (!pass_ || (walk.straight && pass_->draws_on_picture())) return;
    walk.radiance += walk.carried() * pass_->gathered(border, bsdf);
}

// Picks clear, ideal or rough scattering by its share and goes on.
bool PathTracer::scatter(Walk& walk, const Border& border, const Bsdf& bsdf, const Sampler& sampler) {
    const Surface& s = *border.surface;
    const Vec2 u = sampler.pair(Draw::kLobe, static_cast<std::uint32_t>(walk.bounce));
    double choice = sampler.pair(Draw::kChoice, static_cast<std::uint32_t>(walk.bounce + walk.covers)).x;
    if (choice < s.transmission) return scatter_clear(walk, border, u, choice / s.transmission, sampler);
    choice = (choice - s.transmission) / (1 - s.transmission);
    const Vec3 view = -walk.ray.direction;
    const Vec3 mirror = s.sharp() ? bsdf.mirror_share(glm::dot(border.normal, view)) : Vec3(0);
    const double bright = largest(mirror), dull = largest(bsdf.dull_albedo());
    const double mirror_share = bright > 0 ? bright / (bright + dull) : 0;
    if (choice < mirror_share) {
        ++counters_.reflection;
        walk.ray.direction = mirrored(-view, border.normal);
        walk.share *= mirror / mirror_share;
        walk.single = true;
        return glm::dot(walk.ray.direction, border.normal) > 0;
    }
    walk.share /= 1 - mirror_share;
    add_lamps(walk, border, bsdf, sampler);
    add_photons(walk, border, bsdf);
    const Bsdf::Drawn drawn = bsdf.draw(u, (choice - mirror_share) / (1 - mirror_share));
    if (!(drawn.density > 0) || drawn.share == Vec3(0)) return false;
    ++counters_.diffuse;
    walk.ray.direction = drawn.direction;
    walk.share *= drawn.share;
    walk.density = drawn.density;
    walk.single = false;
    walk.dull = true;
    return true;
}

bool PathTracer::scatter_clear(Walk& walk, const Border& border, Vec2 u, double choice, const Sampler& sampler) {
    if (stage_.spectrum) ++counters_.draws;
    const CrossingDraws draws{u, choice, stage_.spectrum ? sampler.pair(Draw::kTimeAndWavelength).y : 0};
    const std::optional<Crossing> crossing = cross_border(stage_, border, walk.ray.direction, draws, walk.hues);
    if (!crossing) return false;
    walk.single = true;
    walk.ray.direction = crossing->direction;
    walk.share *= crossing->radiance_scale;
    if (crossing->through) walk.share *= border.surface->color;
    ++(crossing->through ? counters_.refraction : counters_.reflection);
    return true;
}

}  // namespace whittle
