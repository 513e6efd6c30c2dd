// tile.cpp — the pure function from (stage, tile, samples) to pixels.
#include <cmath>

#include <sleef.h>

#include "tracer/image/tone.h"
#include "tracer/light/integrator.h"
#include "tracer/light/planes.h"

namespace whittle {

namespace {

// What is left of the light on a drawn edge.
constexpr double kEdgeShare = 0.06;

// What the samples of one tile share.
struct TileWork {
    const Stage& stage;
    Scratch& scratch;
    Integration integration;
    Spans spans;
};

CameraLight xray_light(TileWork& work, const Ray& ray) {
    const double thickness = thickness_along(work.stage, ray, work.scratch, work.spans);
    const double share = Sleef_cinz_expd1_u10purec(-thickness / work.stage.thickness_scale);
    return {Vec3(0.02, 0.05, 0.10) + share * Vec3(0.90, 0.90, 0.86), thickness > 0 ? 1.0 : 0.0};
}

CameraLight light_of(TileWork& work, const CameraSample& sample, const Sampler& sampler) {
    if (work.stage.options.look == Look::kXray) return xray_light(work, sample.ray);
    return work.integration.radiance(sample, sampler);
}

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void add_sample(const CameraLight& light, double weight, PixelSums& sums) {
    // What is no number is no light: one such sample must not blacken or blow up a pixel.
    const Vec3 radiance = finite(light.radiance) ? light.radiance : Vec3(0);
    const double bright = luminance(radiance);
    sums.color += weight * radiance;
    sums.coverage += weight * light.coverage;
    sums.weight += weight;
    sums.luminance += bright;
    sums.luminance_squared += bright * bright;
    ++sums.samples;
}

void draw_sample(TileWork& work, int x, int y, int index, PixelSums& sums) {
    const Stage& stage = work.stage;
    const Sampler sampler(stage.options.seed, x, y, static_cast<std::uint32_t>(index));
    // A single sample stands in the middle, so that the picture is the one the planes show.
    FilterSampler::Place place{Vec2(0), 1};
    if (stage.options.samples > 1) place = stage.filter.place(sampler.pair(Draw::kPixel));
    const double px = x + 0.5 + place.offset.x, py = y + 0.5 + place.offset.y;
    CameraLight light = light_of(work, camera_sample(stage, x, y, index, px, py, sampler), sampler);
    if (stage.options.edges && on_edge(stage, px, py, work.scratch)) light.radiance *= kEdgeShare;
    add_sample(light, place.weight, sums);
}

double work_done(const Scratch& scratch) { return static_cast<double>(scratch.counters.primitive_tests); }

}  // namespace

bool render_tile(const Stage& stage, TileRegion tile, int begin, int end, Scratch& scratch, RenderCounters& counters, Film& film, const std::atomic<bool>* abort) {
    std::vector<PixelSums> kept;
    kept.reserve(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height));
    TileWork work{stage, scratch, Integration(stage, scratch, counters), {}};
    const bool planes = film.aovs != 0 && begin == 0;
    std::vector<float>& cost = film.planes[static_cast<std::size_t>(Aov::kCost)];
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            if (abort && abort->load(std::memory_order_relaxed)) {
                for (std::size_t i = 0; i < kept.size(); ++i)
                    film.pixels[film.index(tile.x + static_cast<int>(i) % tile.width, tile.y + static_cast<int>(i) / tile.width)] = kept[i];
                return false;
            }
            PixelSums& sums = film.pixels[film.index(x, y)];
            kept.push_back(sums);
            if (planes) fill_planes(stage, x, y, scratch, film);
            const double before = work_done(scratch);
            for (int i = begin; i < end; ++i) draw_sample(work, x, y, i, sums);
            if (!cost.empty()) cost[film.index(x, y)] += static_cast<float>(work_done(scratch) - before);
        }
    return true;
}

}  // namespace whittle
