// integrator.h — the seam between the loop over samples and the physics of light: a camera ray goes in, its light comes out.
//
// The loop draws places in the picture and keeps sums; lens, shutter and every kind of integrator stand behind the two calls below. A caller that met the
// first border already (camera packets) hands it in.
#pragma once

#include <variant>

#include "tracer/light/path.h"
#include "tracer/light/tracer.h"

namespace whittle {

// Sample `index` of pixel (x, y): its ray, and its place in the picture in pixels.
struct CameraSample {
    int x = 0, y = 0, index = 0;
    double px = 0, py = 0;
    double height = 0;  // of the place: -1..1 from bottom to top
    Ray ray;
};

// The place (px, py) seen through the stage's lens at a time within its shutter.
CameraSample camera_sample(const Stage& stage, int x, int y, int index, double px, double py, const Sampler& sampler);

// One a tile; it owns nothing but its walkers.
class Integration {
public:
    Integration(const Stage& stage, Scratch& scratch, RenderCounters& counters);

    // Light against the sample's ray. `first` is what World::next() would answer for the ray; null: it is asked here.
    // `ahead`: shadows at that border that are known.
    CameraLight radiance(const CameraSample& sample, const Sampler& sampler, const FirstBorder* first = nullptr, AnswersAhead ahead = {});

private:
    const Stage& stage_;
    RenderCounters& counters_;
    std::variant<Tracer, PathTracer> walker_;
};

}  // namespace whittle
