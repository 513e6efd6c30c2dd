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

Integration::Integration(const Stage& stage, Scratch& scratch, RenderCounters& counters) : stage_(stage), counters_(counters), walker_(walker_of(stage, scratch, counters)) {}

CameraLight Integration::radiance(const CameraSample& sample, const FirstBorder* first, AnswersAhead ahead) {
    const auto shine = [&](auto& walker) {
        walker.know(ahead);
        return walker.camera_light(sample.ray, sample.height, sample.sampler, first);
    };
    CameraLight light = std::visit(shine, walker_);
    if (!std::isfinite(light.radiance.x + light.radiance.y + light.radiance.z)) ++counters_.no_numbers;
    const PathTracer* paths = std::get_if<PathTracer>(&walker_);
    const LightPass* pass = paths ? paths->pass() : nullptr;
    if (pass && pass->draws_on_picture()) light.drawn = pass->on_pixel(sample.x, sample.y);
    return light;
}

}  // namespace whittle
