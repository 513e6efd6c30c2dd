#include "tracer/light/light_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// As for paths from the eye.
constexpr int kSureBounces = 4;
constexpr int kMostCovers = 256;

// Rays of light draw other numbers than pixels do.
constexpr std::uint64_t kLightSeed = 0x6c69676874ULL;

}  // namespace

double time_of_pass(const Stage& stage, int index) {
    const RenderOptions& o = stage.options;
    if (!stage.needs.shutter || o.samples == 1) return 0;
    const auto number = static_cast<std::uint32_t>(index);
    if (o.sampler != SamplerKind::kSobol) return Sampler(o.seed ^ kLightSeed, -1, -1, number, o.sequence()).pair(Draw::kTimeAndWavelength).x;
    return sobol::unit(sobol::scrambled(sobol::reversed(number), sobol::hash(static_cast<std::uint32_t>(o.seed))));
}

Splats picture_of(const RenderOptions& o) { return {SplatFilter(o.filter, o.samples == 1), o.width, o.height}; }

LightWalker::LightWalker(const Stage& stage, int index, int rays, bool on_picture)
    : stage_(stage), index_(index), rays_(rays), on_picture_(on_picture), picture_(picture_of(stage.options)), direct_(stage, scratch_, counters_) {}

// The rays of all passes, one after the other, are one sequence of Sobol's: those of a pass are spread over the lamp and what it shines at, and so are all.
// A grid holds those of a pass.
Sampler LightWalker::sampler_of(int ray) const {
    const RenderOptions& o = stage_.options;
    if (o.sampler != SamplerKind::kSobol) return {o.seed ^ kLightSeed, index_, 0, static_cast<std::uint32_t>(ray), {o.sampler, static_cast<std::uint32_t>(rays_)}};
    const std::uint64_t place = static_cast<std::uint64_t>(index_) * static_cast<std::uint64_t>(rays_) + static_cast<std::uint64_t>(ray);
    return {o.seed ^ kLightSeed, static_cast<int>(place >> 32), 0, static_cast<std::uint32_t>(place)};
}

LightWalker::Beam LightWalker::sent(const Sampler& sampler) const {
    const Emitted e = stage_.emission.emit(sampler.pair(Draw::kPixel).x, sampler.pair(Draw::kLight), sampler.pair(Draw::kSky));
    Beam beam;
    beam.ray.origin = e.origin;
    beam.ray.direction = e.direction;
    beam.ray.time = time_of_pass(stage_, index_);
    beam.power = e.power / static_cast<double>(rays_);
    beam.first = largest(beam.power);
    return beam;
}

void LightWalker::walk(int begin, int end, LightLeft& left) {
    for (int from = begin; from < end; from += MetTogether::kMost) walk_together(from, std::min(from + MetTogether::kMost, end), left);
}

void LightWalker::walk_together(int begin, int end, LightLeft& left) {
    beams_.clear();
    samplers_.clear();
    rays_together_.clear();
    for (int number = begin; number < end; ++number) {
        const Sampler sampler = sampler_of(number);
        const Beam beam = sent(sampler);
        if (!(beam.first > 0) || !std::isfinite(beam.first)) continue;
        beams_.push_back(beam);
        samplers_.push_back(sampler);
        rays_together_.push_back(beam.ray);
    }
    if (stage_.packets) stage_.world.meet(rays_together_.data(), static_cast<int>(beams_.size()), scratch_, met_);
    for (std::size_t k = 0; k < beams_.size(); ++k) {
        Beam& beam = beams_[k];
        Border first;
        const bool met = stage_.packets ? stage_.world.first(beam.ray, met_, static_cast<int>(k), scratch_, first) : stage_.world.next(beam.ray, nullptr, kInfinity, scratch_, first);
        bool on = met && go_on(beam, first, samplers_[k], left);
        while (on) on = step(beam, samplers_[k], left);
    }
}

bool LightWalker::step(Beam& beam, const Sampler& sampler, LightLeft& left) {
    Border border;
    return stage_.world.next(beam.ray, &beam.leaving, kInfinity, scratch_, border) && go_on(beam, border, sampler, left);
}

// From a border that it meets.
bool LightWalker::go_on(Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left) {
    beam.power *= absorbed_before(border);
    beam.leaving = border.leaving;
    beam.ray.origin = border.point;
    const double cover = sampler.pair(Draw::kChoice, static_cast<std::uint32_t>(beam.bounce + beam.covers)).y;
    if (border.surface->coverage < 1 && cover >= border.surface->coverage) return ++beam.covers < kMostCovers;
    if (!scatter(beam, border, sampler, left)) return false;
    if (++beam.bounce > stage_.options.max_depth) return false;
    if (beam.bounce < kSureBounces) return true;
    const double survival = std::min(1.0, largest(beam.power) / beam.first);
    if (!(sampler.pair(Draw::kSky, static_cast<std::uint32_t>(beam.bounce)).x < survival)) return false;
    beam.power /= survival;
    return true;
}

// By the same choices as a path from the eye; false where the beam ends.
bool LightWalker::scatter(Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left) {
    const Surface& s = *border.surface;
    const auto vertex = static_cast<std::uint32_t>(beam.bounce);
    double choice = sampler.pair(Draw::kChoice, vertex + static_cast<std::uint32_t>(beam.covers)).x;
    if (choice < s.transmission) {
        const CrossingDraws draws{sampler.pair(Draw::kLobe, vertex), choice / s.transmission, stage_.spectrum ? sampler.pair(Draw::kTimeAndWavelength).y : 0};
        const std::optional<Crossing> crossing = cross_border(stage_, border, beam.ray.direction, draws, beam.hues);
        if (!crossing) return false;
        if (crossing->through) beam.power *= s.color;
        beam.ray.direction = crossing->direction;
        beam.focused = true;
        return true;
    }
    choice = (choice - s.transmission) / (1 - s.transmission);
    const Bsdf bsdf(s, border.normal, -beam.ray.direction);
    const Vec3 mirror = s.sharp() ? bsdf.mirror_share(-glm::dot(border.normal, beam.ray.direction)) : Vec3(0);
    const double bright = largest(mirror), dull = largest(bsdf.dull_albedo());
    const double mirror_share = bright > 0 ? bright / (bright + dull) : 0;
    if (choice < mirror_share) {
        beam.power *= mirror / mirror_share;
        beam.ray.direction = mirrored(beam.ray.direction, border.normal);
        beam.focused = true;
        return glm::dot(beam.ray.direction, border.normal) > 0;
    }
    if (!beam.focused) return false;
    beam.power /= 1 - mirror_share;
    leave(beam, border, sampler, left);
    return false;
}

void LightWalker::leave(const Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left) {
    // Who gathers comes by the same lots: what gets through a cover, or goes into clear matter, is counted there.
    const double lots = border.surface->coverage * (1 - border.surface->transmission);
    left.photons.push_back({border.point, -beam.ray.direction, border.normal, beam.power * beam.hues.color() / lots});
    if (on_picture_) draw(beam, border, sampler, left);
}

// Onto the picture, where the eye sees the place without a detour.
void LightWalker::draw(const Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left) {
    const std::optional<Sighting> seen = sighting(stage_.lens, border.point, sampler.pair(Draw::kLens));
    if (!seen) return;
    const RenderOptions& o = stage_.options;
    const double half = o.height / 2.0;
    const Vec2 at(o.width / 2.0 + seen->x * half, half - seen->y * half);
    if (!picture_.shows(at)) return;
    const Vec3 to = seen->eye - border.point;
    const double distance = glm::length(to), cosine = glm::dot(to, border.normal) / distance;
    if (!(cosine > 0) || !std::isfinite(cosine)) return;
    const Bsdf bsdf(*border.surface, border.normal, to / distance);
    // A unit of the picture's plane holds (height / 2)^2 pixels.
    const Vec3 flux = beam.power * beam.hues.color() * bsdf.value(-beam.ray.direction, -glm::dot(beam.ray.direction, border.normal));
    Vec3 light = flux * (cosine * seen->radiance_per_intensity * half * half);
    // In clear matter, where the eye is too, radiance is as much more as its index squared. What only lets a share of light by bends none.
    if (border.before && border.before->clear()) light /= border.before->ior * border.before->ior;
    light *= direct_.transmittance(border, to / distance, distance, beam.ray.time, ClearShadows::kBlock);
    if (light == Vec3(0) || !std::isfinite(light.x + light.y + light.z)) return;
    left.splats.push_back({at, light});
}

}  // namespace whittle
