// camera_samples.h — a sample of many pixels: their places in the filter and the camera rays through them, drawn together (lanes.h).
#pragma once

#include <span>
#include <vector>

#include "tracer/light/lanes.h"
#include "tracer/light/planes.h"
#include "tracer/light/sampler.h"

namespace whittle {

// Sample `sampler.index()` of pixel (x, y): its place in the picture in pixels, its weight in the filter, and its ray.
struct CameraSample {
    int x = 0, y = 0;
    double px = 0, py = 0, weight = 1;
    double height = 0;  // of the place: -1..1 from bottom to top
    Sampler sampler;
    Ray ray;
};

struct SampleWanted {
    PixelPlace pixel;
    int index = 0;
};

class CameraSampler {
public:
    CameraSampler(const Stage& stage, RenderCounters& counters);

    // The samples asked for, of which there are at most lanes::kMost; through the stage's lens, at times within its shutter.
    void draw(std::span<const SampleWanted> wanted);

    // Those drawn last, and their rays once more, side by side.
    const std::vector<CameraSample>& samples() const { return samples_; }
    const std::vector<Ray>& rays() const { return rays_; }

private:
    void draw_places(std::span<const SampleWanted> wanted);
    void draw_rays();
    void draw_together(bool sharp);
    double time_of(const CameraSample& sample) const;

    const Stage& stage_;
    RenderCounters& counters_;
    std::vector<CameraSample> samples_;
    std::vector<Ray> rays_;
    lanes::Row<std::uint32_t> x_, y_, keys_, indices_, u_, v_;
    lanes::Row<double> px_, py_, weights_x_, weights_y_, ray_x_, ray_y_, ray_z_, from_x_, from_y_, from_z_;
};

}  // namespace whittle
