#include "tracer/light/integrator.h"

#include <cmath>

#include "tracer/light/light_walk.h"
#include "tracer/light/planes.h"

namespace whittle {

namespace {

std::variant<Tracer, PathTracer> walker_of(const Stage& stage, Scratch& scratch, RenderCounters& counters) {
    if (stage.integrator == Integrator::kPath || stage.integrator == Integrator::kCaustics) return PathTracer(stage, scratch, counters);
    return Tracer(stage, scratch, counters);
}

}  // namespace

CameraSample camera_sample(const Stage& stage, int x, int y, int index, double px, double py, const Sampler& sampler) {
    CameraSample s{x, y, index, px, py, picture_height(stage, py), {}};
    const bool distributes = stage.distributes();
    const double half = stage.options.height / 2.0;
    if (!distributes || !stage.needs.lens) s.ray = picture_ray(stage, px, py);
    else s.ray = camera_ray(stage.lens, (px - stage.options.width / 2.0) / half, (half - py) / half, sampler.pair(Draw::kLens));
    // A single sample shows time 0, as the planes do. Photons of one pass have one time, and so have the eyes that meet them.
    if (!distributes || !stage.needs.shutter || stage.options.samples == 1) return s;
    s.ray.time = stage.light_passes && stage.needs.photons ? time_of_pass(stage, index) : sampler.pair(Draw::kTimeAndWavelength).x;
    return s;
}

Integration::Integration(const Stage& stage, Scratch& scratch, RenderCounters& counters) : stage_(stage), counters_(counters), walker_(walker_of(stage, scratch, counters)) {}

CameraLight Integration::radiance(const CameraSample& sample, const Sampler& sampler, const FirstBorder* first, AnswersAhead ahead) {
    const auto shine = [&](auto& walker) {
        walker.know(ahead);
        return walker.camera_light(sample.ray, sample.height, sampler, first);
    };
    CameraLight light = std::visit(shine, walker_);
    if (!std::isfinite(light.radiance.x + light.radiance.y + light.radiance.z)) ++counters_.no_numbers;
    if (!stage_.light_passes) return light;
    const LightPass* pass = std::get<PathTracer>(walker_).pass();
    if (pass && pass->draws_on_picture()) light.drawn = pass->on_pixel(static_cast<std::uint32_t>(sample.y) * static_cast<std::uint32_t>(stage_.options.width) + static_cast<std::uint32_t>(sample.x));
    return light;
}

}  // namespace whittle
