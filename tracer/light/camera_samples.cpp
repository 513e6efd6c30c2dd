#include "tracer/light/camera_samples.h"

#include <cassert>

#include "tracer/light/light_walk.h"

namespace whittle {

namespace {

bool has_disc(const Lens& lens) { return lens.aperture > 0 && lens.blades < 3; }

}  // namespace

CameraSampler::CameraSampler(const Stage& stage, RenderCounters& counters) : stage_(stage), counters_(counters) {}

void CameraSampler::draw(std::span<const SampleWanted> wanted) {
    assert(wanted.size() <= lanes::kMost);
    samples_.resize(wanted.size());
    rays_.resize(wanted.size());
    draw_places(wanted);
    draw_rays();
    if (stage_.distributes()) counters_.draws += (static_cast<std::uint64_t>(stage_.needs.lens) + static_cast<std::uint64_t>(stage_.needs.shutter)) * wanted.size();
}

void CameraSampler::draw_places(std::span<const SampleWanted> wanted) {
    const std::size_t count = wanted.size();
    const Sequence sequence = stage_.options.sequence();
    for (std::size_t k = 0; k < count; ++k) {
        x_[k] = static_cast<std::uint32_t>(wanted[k].pixel.x), y_[k] = static_cast<std::uint32_t>(wanted[k].pixel.y);
        indices_[k] = static_cast<std::uint32_t>(wanted[k].index);
    }
    lanes::keys_of(stage_.options.seed, x_.data(), y_.data(), count, keys_.data());
    // A single sample stands in the middle, so that the picture is the one the planes show.
    const bool spread = stage_.options.samples > 1;
    if (spread) {
        lanes::pairs_of(keys_.data(), indices_.data(), count, {Draw::kPixel}, u_.data(), v_.data(), sequence);
        lanes::places_of(stage_.filter.table(), u_.data(), count, px_.data(), weights_x_.data());
        lanes::places_of(stage_.filter.table(), v_.data(), count, py_.data(), weights_y_.data());
    }
    for (std::size_t k = 0; k < count; ++k) {
        CameraSample& s = samples_[k];
        s.x = wanted[k].pixel.x, s.y = wanted[k].pixel.y;
        s.px = s.x + 0.5 + (spread ? px_[k] : 0), s.py = s.y + 0.5 + (spread ? py_[k] : 0);
        s.weight = spread ? weights_x_[k] * weights_y_[k] : 1;
        s.height = picture_height(stage_, s.py);
        s.sampler = Sampler(keys_[k], indices_[k], sequence);
    }
}

// Through the window of the places px_, py_; with a lens whose aperture is a disc from places on that.
void CameraSampler::draw_together(bool sharp) {
    const Lens& lens = stage_.lens;
    const std::size_t count = samples_.size();
    const lanes::Directions rays{ray_x_.data(), ray_y_.data(), ray_z_.data()};
    lanes::through_window({lens.forward, lens.right, lens.up, lens.half_height}, px_.data(), py_.data(), count, rays);
    if (sharp) return;
    lanes::pairs_of(keys_.data(), indices_.data(), count, {Draw::kLens}, u_.data(), v_.data(), stage_.options.sequence());
    lanes::through_disc({lens.eye, lens.right, lens.up, lens.forward, lens.aperture / 2, lens.focus}, u_.data(), v_.data(), count, {from_x_.data(), from_y_.data(), from_z_.data()},
                        rays);
}

void CameraSampler::draw_rays() {
    const Lens& lens = stage_.lens;
    const double half = stage_.options.height / 2.0, middle = stage_.options.width / 2.0;
    const std::size_t count = samples_.size();
    for (std::size_t k = 0; k < count; ++k) px_[k] = (samples_[k].px - middle) / half, py_[k] = (half - samples_[k].py) / half;
    const bool sharp = !stage_.distributes() || !stage_.needs.lens, together = !lens.orthographic && (sharp || has_disc(lens));
    if (together) draw_together(sharp);
    for (std::size_t k = 0; k < count; ++k) {
        Ray& ray = samples_[k].ray;
        if (together) ray.origin = sharp ? lens.eye : Vec3(from_x_[k], from_y_[k], from_z_[k]), ray.direction = {ray_x_[k], ray_y_[k], ray_z_[k]};
        else if (sharp) ray = camera_ray(lens, px_[k], py_[k]);
        else ray = camera_ray(lens, px_[k], py_[k], samples_[k].sampler.pair(Draw::kLens));
        ray.time = time_of(samples_[k]);
        rays_[k] = ray;
    }
}

// A single sample shows time 0, as the planes do. Photons of one pass have one time, and so have the eyes that meet them.
double CameraSampler::time_of(const CameraSample& sample) const {
    if (!stage_.distributes() || !stage_.needs.shutter || stage_.options.samples == 1) return 0;
    if (stage_.light_passes && stage_.needs.photons) return time_of_pass(stage_, static_cast<int>(sample.sampler.index()));
    return sample.sampler.pair(Draw::kTimeAndWavelength).x;
}

}  // namespace whittle
