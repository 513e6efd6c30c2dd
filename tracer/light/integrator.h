// integrator.h — the seam between the loop over samples and the physics of light: a camera ray goes in, its light comes out.
//
// The loop draws places in the picture and keeps sums; lens, shutter and every kind of integrator stand behind the two calls below. A caller that met the
// first border already (camera packets) hands it in.
#pragma once

#include <variant>

#include "tracer/light/camera_samples.h"
#include "tracer/light/path.h"
#include "tracer/light/tracer.h"

namespace whittle {

// One a tile; it owns nothing but its walkers.
class Integration {
public:
    Integration(const Stage& stage, Scratch& scratch, RenderCounters& counters);

    // Light against the sample's ray. `first` is what World::next() would answer for the ray; null: it is asked here.
    // `ahead`: shadows at that border that are known.
    CameraLight radiance(const CameraSample& sample, const FirstBorder* first = nullptr, AnswersAhead ahead = {});

private:
    const Stage& stage_;
    RenderCounters& counters_;
    std::variant<Tracer, PathTracer> walker_;
};

}  // namespace whittle
