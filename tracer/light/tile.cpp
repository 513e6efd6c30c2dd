// tile.cpp — the pure function from (stage, tile, samples) to pixels.
//
// All pixels of a tile draw a sample together: their camera rays meet the solid as packets, in the order of 4 x 4 blocks, then each is shaded alone. A
// pixel takes its samples by their numbers all the same, so the bits are those of one pixel after the other.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include <sleef.h>

#include "tracer/image/tone.h"
#include "tracer/light/blocks.h"
#include "tracer/light/camera_samples.h"
#include "tracer/light/edges.h"
#include "tracer/light/integrator.h"
#include "tracer/light/planes.h"
#include "tracer/light/shadows_ahead.h"

namespace whittle {

namespace {

// What is left of the light on a drawn edge.
constexpr double kEdgeShare = 0.06;

constexpr std::size_t kMostRays = MetTogether::kMost;
static_assert(kMostRays <= lanes::kMost);

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void add_sample(const CameraLight& light, double weight, PixelSums& sums) {
    // What is no number is no light: one such sample must not blacken or blow up a pixel.
    const Vec3 radiance = finite(light.radiance) ? light.radiance : Vec3(0);
    const double bright = luminance(radiance + light.drawn);
    sums.color += weight * radiance + light.drawn;
    sums.coverage += weight * light.coverage;
    sums.weight += weight;
    sums.luminance += bright;
    sums.luminance_squared += bright * bright;
    ++sums.samples;
}

double work_done(const Scratch& scratch) { return static_cast<double>(scratch.counters.primitive_tests); }

// Those of blocks that go on from `begin`.
std::vector<PixelPlace> pixels_of(TileRegion tile, const BlockSamples& begins, int begin) {
    std::vector<PixelPlace> pixels;
    for (std::size_t b = 0; b < begins.size(); ++b) {
        if (begins[b] != begin) continue;
        const TileRegion block = block_in(tile, static_cast<int>(b));
        for (int y = block.y; y < block.y + block.height; ++y)
            for (int x = block.x; x < block.x + block.width; ++x) pixels.push_back({x, y});
    }
    return pixels;
}

}  // namespace

// Draws samples of pixels together.
class TileDrawer::Work {
public:
    Work(const Stage& stage, Scratch& scratch, RenderCounters& counters)
        : stage_(stage), scratch_(scratch), integration_(stage, scratch, counters), edges_(stage.options.edges ? new EdgeFinder(stage, scratch) : nullptr),
          camera_(stage, counters), shadows_(stage, scratch, counters) {
        if (stage.shows_scheme()) background_ = srgb_to_linear(stage.options.scheme->background);
    }

    // Samples begin <= i < end of some pixels. False: aborted.
    bool draw(const std::vector<PixelPlace>& pixels, int begin, int end, Film& film, const std::atomic<bool>* abort) {
        std::vector<float>& cost = film.planes[static_cast<std::size_t>(Aov::kCost)];
        // What a pixel costs is seen only where it is drawn alone.
        const std::size_t together = cost.empty() ? kMostRays : 1;
        for (std::size_t at = 0; at < pixels.size(); at += together) {
            const std::span<const PixelPlace> group(pixels.data() + at, std::min(together, pixels.size() - at));
            const double before = work_done(scratch_);
            for (int i = begin; i < end; ++i) {
                if (abort && abort->load(std::memory_order_relaxed)) return false;
                draw_sample(group, i, film);
            }
            if (!cost.empty()) cost[film.index(group[0].x, group[0].y)] += static_cast<float>(work_done(scratch_) - before);
            if (film.aovs != 0 && begin == 0) fill_planes(stage_, group.data(), static_cast<int>(group.size()), scratch_, film);
        }
        return true;
    }

private:
    // Sample `index` of at most kMostRays pixels.
    void draw_sample(std::span<const PixelPlace> pixels, int index, Film& film) {
        camera_.draw(pixels, index);
        if (stage_.options.look == Look::kShaded) meet(static_cast<int>(pixels.size()));
        if (edges_) find_edges();
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            CameraLight light = stage_.options.look == Look::kXray ? xray_light(camera_.rays()[k]) : light_of(k);
            if (edges_ && edge_[k]) light.radiance *= kEdgeShare;
            add_sample(light, camera_.samples()[k].weight, film.pixels[film.index(pixels[k].x, pixels[k].y)]);
        }
    }

    void find_edges() {
        for (std::size_t k = 0; k < camera_.samples().size(); ++k) places_[k] = {camera_.samples()[k].px, camera_.samples()[k].py};
        edges_->find(places_.data(), static_cast<int>(camera_.samples().size()), edge_.data());
    }

    void meet(int count) {
        if (stage_.packets) stage_.world.meet(camera_.rays().data(), count, scratch_, met_);
        for (int k = 0; k < count; ++k) {
            FirstBorder& first = firsts_[static_cast<std::size_t>(k)];
            const Ray& ray = camera_.rays()[static_cast<std::size_t>(k)];
            first.met = stage_.packets ? stage_.world.first(ray, met_, k, scratch_, first.border)
                                       : stage_.world.next(ray, nullptr, std::numeric_limits<double>::infinity(), scratch_, first.border);
        }
        shadows_.ask(firsts_.data(), camera_.samples().data(), count);
    }

    CameraLight light_of(std::size_t k) {
        const FirstBorder& first = firsts_[k];
        CameraLight light = integration_.radiance(camera_.samples()[k], &first, shadows_.of(static_cast<int>(k)));
        if (stage_.shows_scheme() && light.coverage == 0) light.radiance = background_;
        return light;
    }

    CameraLight xray_light(const Ray& ray) {
        const double thickness = thickness_along(stage_, ray, scratch_, spans_);
        const double share = Sleef_cinz_expd1_u10purec(-thickness / stage_.thickness_scale);
        return {Vec3(0.02, 0.05, 0.10) + share * Vec3(0.90, 0.90, 0.86), thickness > 0 ? 1.0 : 0.0};
    }

    const Stage& stage_;
    Scratch& scratch_;
    Integration integration_;
    Spans spans_;
    Vec3 background_{0};
    std::unique_ptr<EdgeFinder> edges_;
    CameraSampler camera_;
    MetTogether met_;
    ShadowsAhead shadows_;
    std::vector<FirstBorder> firsts_ = std::vector<FirstBorder>(kMostRays);
    std::array<Vec2, kMostRays> places_;
    std::array<bool, kMostRays> edge_;
};

namespace {

// What a tile's pixels hold, to be put back.
class Kept {
public:
    Kept(const Film& film, TileRegion tile) : tile_(tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) pixels_.push_back(film.pixels[film.index(x, y)]);
    }
    void put_back(Film& film) const {
        std::size_t k = 0;
        for (int y = tile_.y; y < tile_.y + tile_.height; ++y)
            for (int x = tile_.x; x < tile_.x + tile_.width; ++x) film.pixels[film.index(x, y)] = pixels_[k++];
    }

private:
    TileRegion tile_;
    std::vector<PixelSums> pixels_;
};

}  // namespace

TileDrawer::TileDrawer(const Stage& stage, Scratch& scratch, RenderCounters& counters)
    : work_(std::make_unique<Work>(stage, scratch, counters)) {}

TileDrawer::~TileDrawer() = default;

bool TileDrawer::draw(TileRegion tile, const BlockSamples& begins, int end, Film& film, const std::atomic<bool>* abort) {
    BlockSamples apart = begins;
    std::sort(apart.begin(), apart.end());
    const auto last = std::unique(apart.begin(), apart.end());
    if (apart[0] >= end) return true;
    const Kept kept(film, tile);
    for (auto begin = apart.begin(); begin != last && *begin < end; ++begin) {
        if (work_->draw(pixels_of(tile, begins, *begin), *begin, end, film, abort)) continue;
        kept.put_back(film);
        return false;
    }
    return true;
}

}  // namespace whittle
