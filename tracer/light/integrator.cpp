#include "tracer/light/integrator.h"

#include "tracer/light/planes.h"

namespace whittle {

namespace {

std::variant<Tracer, PathTracer> walker_of(const Stage& stage, Scratch& scratch, RenderCounters& counters) {
    if (stage.integrator == Integrator::kPath) return PathTracer(stage, scratch, counters);
    return Tracer(stage, scratch, counters);
}

}  // namespace

CameraSample camera_sample(const Stage& stage, int x, int y, int index, double px, double py, const Sampler& sampler) {
    CameraSample s{x, y, index, px, py, picture_height(stage, py), {}};
    if (!stage.needs.lens || stage.integrator < Integrator::kDistributed) {
        s.ray = picture_ray(stage, px, py);
        return s;
    }
    const double half = stage.options.height / 2.0;
    s.ray = camera_ray(stage.lens, (px - stage.options.width / 2.0) / half, (half - py) / half, sampler.pair(Draw::kLens));
    return s;
}

Integration::Integration(const Stage& stage, Scratch& scratch, RenderCounters& counters) : stage_(stage), walker_(walker_of(stage, scratch, counters)) {}

CameraLight Integration::radiance(const CameraSample& sample, const Sampler& sampler, const FirstBorder* first) {
    return std::visit([&](auto& walker) { return walker.camera_light(sample.ray, sample.height, sampler, first); }, walker_);
}

}  // namespace whittle
