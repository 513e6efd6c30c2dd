// tile.cpp — the pure function from (stage, tile, samples) to pixels.
//
// The pixels of a tile draw their samples together: camera rays meet the solid as packets, in the order of 4 x 4 blocks, then each is shaded alone. Where few
// pixels draw, several samples of each fill a packet. A pixel takes its samples by their numbers all the same, so the bits are those of one pixel after the other.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include <sleef.h>

#include "tracer/image/tone.h"
#include "tracer/light/busy.h"
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

// Pixels of a tile that go on, from a sample of their own.
struct GoingOn {
    PixelPlace pixel;
    int begin = 0;
};

// Calls visit(x, y) in the tile by blocks of 4 x 4, of which each fills whole packets.
template <class Visit>
void each_by_blocks(TileRegion tile, Visit visit) {
    constexpr int kSide = 4;
    for (int by = 0; by < tile.height; by += kSide)
        for (int bx = 0; bx < tile.width; bx += kSide)
            for (int y = by; y < std::min(by + kSide, tile.height); ++y)
                for (int x = bx; x < std::min(bx + kSide, tile.width); ++x) visit(x, y);
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

    // Samples begin <= i < end of the tile's pixels. False: aborted.
    bool draw(TileRegion tile, const TileSamples& begins, int end, Film& film, const std::atomic<bool>* abort) {
        going_on_.clear();
        each_by_blocks(tile, [&](int x, int y) {
            if (const int begin = begins[place_in_tile(x, y)]; begin < end) going_on_.push_back({{tile.x + x, tile.y + y}, begin});
        });
        int least = end;
        for (const GoingOn& g : going_on_) least = std::min(least, g.begin);
        // What a pixel costs is seen only where it is drawn alone.
        const std::size_t together = film.planes[static_cast<std::size_t>(Aov::kCost)].empty() ? kMostRays : 1;
        for (int i = least; i < end; ++i)
            for (const GoingOn& g : going_on_) {
                if (g.begin > i) continue;
                wanted_.push_back({g.pixel, i});
                if (wanted_.size() == together && !draw_wanted(film, abort)) return false;
            }
        if (!wanted_.empty() && !draw_wanted(film, abort)) return false;
        if (film.aovs != 0) fill_new_planes(together, film);
        return true;
    }

private:
    // The samples wanted, of which there are then none. False: aborted.
    bool draw_wanted(Film& film, const std::atomic<bool>* abort) {
        const bool on = !abort || !abort->load(std::memory_order_relaxed);
        std::vector<float>& cost = film.planes[static_cast<std::size_t>(Aov::kCost)];
        const double before = work_done(scratch_);
        if (on) draw_samples(film);
        if (!cost.empty() && on) cost[film.index(wanted_[0].pixel.x, wanted_[0].pixel.y)] += static_cast<float>(work_done(scratch_) - before);
        wanted_.clear();
        return on;
    }

    // Of the pixels drawn for the first time.
    void fill_new_planes(std::size_t together, Film& film) {
        std::vector<PixelPlace> fresh;
        for (const GoingOn& g : going_on_)
            if (g.begin == 0) fresh.push_back(g.pixel);
        for (std::size_t at = 0; at < fresh.size(); at += together)
            fill_planes(stage_, fresh.data() + at, static_cast<int>(std::min(together, fresh.size() - at)), scratch_, film);
    }

    void draw_samples(Film& film) {
        camera_.draw(wanted_);
        if (stage_.options.look == Look::kShaded) meet(static_cast<int>(wanted_.size()));
        if (edges_) find_edges();
        for (std::size_t k = 0; k < wanted_.size(); ++k) {
            CameraLight light = stage_.options.look == Look::kXray ? xray_light(camera_.rays()[k]) : light_of(k);
            if (edges_ && edge_[k]) light.radiance *= kEdgeShare;
            add_sample(light, camera_.samples()[k].weight, film.pixels[film.index(wanted_[k].pixel.x, wanted_[k].pixel.y)]);
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
    std::vector<GoingOn> going_on_;
    std::vector<SampleWanted> wanted_;
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

bool TileDrawer::draw(TileRegion tile, const TileSamples& begins, int end, Film& film, const std::atomic<bool>* abort) {
    if (*std::min_element(begins.begin(), begins.end()) >= end) return true;
    const Kept kept(film, tile);
    if (work_->draw(tile, begins, end, film, abort)) return true;
    kept.put_back(film);
    return false;
}

}  // namespace whittle
