#include "tracer/light/light_walk.h"

#include <cmath>
#include <limits>

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// As for paths from the eye.
constexpr int kSureBounces = 4;
constexpr int kMostCovers = 256;

// Lobes of vertices that no beam has.
constexpr std::uint32_t kFilterVertex = 1U << 16;

// Rays of light draw other numbers than pixels do.
constexpr std::uint64_t kLightSeed = 0x6c69676874ULL;

}  // namespace

double time_of_pass(const Stage& stage, int index) {
    return stage.needs.shutter && stage.options.samples > 1 ? sobol::unit(sobol::scrambled(sobol::reversed(static_cast<std::uint32_t>(index)), sobol::hash(static_cast<std::uint32_t>(stage.options.seed)))) : 0;
}

LightWalker::LightWalker(const Stage& stage, int index, int rays, bool on_picture)
    : stage_(stage), index_(index), rays_(rays), on_picture_(on_picture), direct_(stage, scratch_, counters_) {
    constexpr int kSteps = 512;
    const FilterKind filter = stage.options.filter;
    const double radius = filter_radius(filter);
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += std::abs(filter_profile(filter, radius * ((i + 0.5) / kSteps)));
    filter_area_ = 2 * radius * sum / kSteps;
}

// Camera samples of a pixel are drawn with the density |f| around it and weigh sign(f); a place weighs f / integral of |f| in each pixel near, of which one is
// drawn by |f|.
LightWalker::Pick LightWalker::pick(double at, double u) const {
    if (stage_.options.samples == 1) return {std::floor(at), 1};
    const FilterKind filter = stage_.options.filter;
    const double radius = filter_radius(filter), first = std::ceil(at - 0.5 - radius), last = std::floor(at - 0.5 + radius);
    double all = 0;
    for (double x = first; x <= last; ++x) all += std::abs(filter_profile(filter, at - x - 0.5));
    double below = 0;
    for (double x = first; x <= last; ++x) {
        const double f = filter_profile(filter, at - x - 0.5);
        below += std::abs(f);
        if (f != 0 && u * all < below) return {x, std::copysign(all, f) / filter_area_};
    }
    return {};
}

void LightWalker::walk(int number, LightLeft& left) {
    const Sampler sampler(stage_.options.seed ^ kLightSeed, index_, 0, static_cast<std::uint32_t>(number));
    const Emitted e = stage_.emission.emit(sampler.pair(Draw::kPixel).x, sampler.pair(Draw::kLight), sampler.pair(Draw::kSky));
    Beam beam;
    beam.ray.origin = e.origin;
    beam.ray.direction = e.direction;
    beam.ray.time = time_of_pass(stage_, index_);
    beam.power = e.power / static_cast<double>(rays_);
    beam.first = largest(beam.power);
    if (!(beam.first > 0) || !std::isfinite(beam.first)) return;
    while (step(beam, sampler, left)) {}
}

bool LightWalker::step(Beam& beam, const Sampler& sampler, LightLeft& left) {
    Border border;
    if (!stage_.world.next(beam.ray, beam.departs ? &beam.leaving : nullptr, kInfinity, scratch_, border)) return false;
    beam.departs = true;
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
    left.photons.push_back({border.point, -beam.ray.direction, border.normal, beam.power * beam.hues.color()});
    if (on_picture_) draw(beam, border, sampler, left);
}

// Onto the picture, where the eye sees the place without a detour.
void LightWalker::draw(const Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left) {
    const std::optional<Sighting> seen = sighting(stage_.lens, border.point, sampler.pair(Draw::kLens));
    if (!seen) return;
    const RenderOptions& o = stage_.options;
    const double half = o.height / 2.0;
    const Vec2 u = sampler.pair(Draw::kLobe, kFilterVertex);
    const Pick column = pick(o.width / 2.0 + seen->x * half, u.x), row = pick(half - seen->y * half, u.y);
    const double px = column.pixel, py = row.pixel, weight = column.weight * row.weight;
    if (weight == 0) return;
    if (!(px >= 0 && px < o.width && py >= 0 && py < o.height)) return;
    const Vec3 to = seen->eye - border.point;
    const double distance = glm::length(to), cosine = glm::dot(to, border.normal) / distance;
    if (!(cosine > 0) || !std::isfinite(cosine)) return;
    const Bsdf bsdf(*border.surface, border.normal, to / distance);
    // A unit of the picture's plane holds (height / 2)^2 pixels.
    const Vec3 flux = beam.power * beam.hues.color() * bsdf.value(-beam.ray.direction, -glm::dot(beam.ray.direction, border.normal));
    Vec3 light = flux * (cosine * seen->radiance_per_intensity * half * half * weight);
    if (border.before) light /= border.before->ior * border.before->ior;
    light *= direct_.transmittance(border, to / distance, distance, beam.ray.time, ClearShadows::kBlock);
    if (light == Vec3(0) || !std::isfinite(light.x + light.y + light.z)) return;
    left.splats.push_back({static_cast<std::uint32_t>(py) * static_cast<std::uint32_t>(o.width) + static_cast<std::uint32_t>(px), light});
}

}  // namespace whittle
