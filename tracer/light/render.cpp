// render.cpp — the loop around the pure tile function: passes, threads, stopping, progress.
#include "tracer/light/render.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "tracer/light/busy.h"
#include "tracer/light/light_pass.h"
#include "tracer/light/stage.h"

namespace whittle {

namespace {

constexpr double kSecondsBetweenReports = 0.1;

// Samples of a pixel before its estimate means anything, and where no more than a sixteenth of white is asked for. Of a line a tenth of a pixel wide four miss 6 of
// 10 pixels, but all of five pixels along it only once in 13 times.
constexpr int kFirstSamples = 4, kFirstSamplesCoarse = 2;
constexpr double kCoarseNoise = 0x1p-4;

// After so many tiles the threads wait for each other, so that the film can be kept as it is.
constexpr std::size_t kTilesBetweenLooks = 512;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What a thread brings along.
struct Worker {
    Scratch scratch;
    RenderCounters counters;
    TileDrawer drawer;
    explicit Worker(const Stage& stage) : drawer(stage, scratch, counters) {}
};

class Rendering {
public:
    Rendering(const Stage& stage, RenderControl& control, Film film) : stage_(stage), control_(control), film_(std::move(film)), tiles_(tiles_of(stage.options)) {
        for (const TileRegion& tile : tiles_) counted_.push_back(most_samples(film_, tile));
        for (int n : counted_) samples_before_ += n;
        for (const TileRegion& tile : tiles_) busy_.push_back(busy_pixels(film_, tile, enough_));
    }

    RenderResult run() {
        const int samples = stage_.options.samples;
        bool first = true;
        // Light passes are made for a loop over the tiles and then forgotten.
        const int most = stage_.light_passes ? LightPasses::kKept : samples;
        for (int goal = 1; !tiles_.empty(); goal = std::min(samples, std::max(enough_.least, goal + std::min(goal / 2, most)))) {
            pass(goal, first);
            first = false;
            // What is drawn on may make what is beside it draw on.
            if ((goal >= samples && (stage_.noise == 0 || least_begin(goal) >= goal)) || stopped()) break;
        }
        return finished();
    }

private:
    bool stopped() const {
        return control_.stop || control_.abort || (stage_.options.stop_after_s > 0 && seconds_since(start_) > stage_.options.stop_after_s);
    }

    // Brings every tile that still needs it to `goal` samples. The first pass goes on when asked to stop: a picture is whole or nothing.
    void pass(int goal, bool first) {
        if (stage_.light_passes) stage_.light_passes->make(least_begin(goal), goal);
        const std::size_t together = control_.keep ? kTilesBetweenLooks : tiles_.size();
        for (std::size_t begin = 0; begin < tiles_.size(); begin += together) {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, std::min(begin + together, tiles_.size()), 1), [&](const tbb::blocked_range<std::size_t>& range) {
                Worker& worker = workers_.local();
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    if (control_.abort || (!first && stopped())) return;
                    draw(i, goal, worker);
                }
            });
            keep();
        }
    }

    void keep() {
        const double now = seconds_since(start_);
        if (!control_.keep || now - kept_at_ < control_.keep_every_s) return;
        kept_at_ = now;
        control_.keep(film_);
    }

    // A tile that is resumed has passed lesser goals; the last is asked for until no pixel is busy.
    TileSamples begins(std::size_t i, int goal) const {
        const bool passed = goal < stage_.options.samples && goal <= counted_[i];
        return begins_of(film_, tiles_[i], goal, passed ? PixelMarks{} : busy_[i]);
    }

    int least_begin(int goal) const {
        int least = goal;
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            const TileSamples from = begins(i, goal);
            least = std::min(least, *std::min_element(from.begin(), from.end()));
        }
        return least;
    }

    void draw(std::size_t i, int goal, Worker& worker) {
        const TileSamples from = begins(i, goal);
        if (!worker.drawer.draw(tiles_[i], from, goal, film_, &control_.abort)) return;
        if (*std::min_element(from.begin(), from.end()) < goal) busy_[i] = busy_pixels(film_, tiles_[i], enough_);
        if (goal <= counted_[i]) return;
        samples_counted_ += goal - counted_[i];
        counted_[i] = goal;
        report();
    }

    void report() {
        if (!control_.progress) return;
        const std::unique_lock<std::mutex> lock(report_mutex_, std::try_to_lock);
        const double now = seconds_since(start_);
        if (!lock || now - reported_at_ < kSecondsBetweenReports) return;
        reported_at_ = now;
        const double all = static_cast<double>(tiles_.size()) * stage_.options.samples;
        const double counted = static_cast<double>(samples_counted_), before = static_cast<double>(samples_before_);
        control_.progress({(before + counted) / all, now, now * (all - before - counted) / counted});
    }

    void count_samples(RenderResult& r) const {
        r.complete = least_begin(stage_.options.samples) == stage_.options.samples;
        r.samples_finished = tiles_.empty() ? 0 : stage_.options.samples;
        for (const TileRegion& tile : tiles_) {
            for (int y = tile.y; y < tile.y + tile.height; ++y)
                for (int x = tile.x; x < tile.x + tile.width; ++x) {
                    const int samples = static_cast<int>(film_.pixels[film_.index(x, y)].samples);
                    r.samples_finished = std::min(r.samples_finished, samples);
                    r.samples_most = std::max(r.samples_most, samples);
                }
        }
    }

    RenderResult finished() {
        RenderResult r;
        for (const Worker& worker : workers_) {
            RenderCounters counters = worker.counters;
            counters.engine += worker.scratch.counters;
            r.counters += counters;
        }
        if (std::vector<float>& plane = film_.planes[static_cast<std::size_t>(Aov::kVariance)]; !plane.empty())
            for (std::size_t i = 0; i < film_.pixels.size(); ++i) plane[i] = static_cast<float>(film_.variance(i));
        r.interrupted = control_.stop || control_.abort;
        count_samples(r);
        r.film = std::move(film_);
        r.exposure = stage_.lens.exposure;
        r.integrator = stage_.integrator;
        r.reason = stage_.reason;
        if (stage_.light_passes) r.counters.photons = stage_.light_passes->rays_sent();
        r.warnings = stage_.warnings;
        r.seconds = seconds_since(start_);
        if (control_.progress) control_.progress({1, r.seconds, 0});
        return r;
    }

    const Stage& stage_;
    const GoodEnough enough_{stage_.noise, stage_.noise > kCoarseNoise ? kFirstSamplesCoarse : kFirstSamples};
    RenderControl& control_;
    Film film_;
    std::vector<TileRegion> tiles_;
    std::vector<PixelMarks> busy_;  // by tile
    std::vector<int> counted_;      // samples a tile has, or was spared, for the progress
    tbb::enumerable_thread_specific<Worker> workers_{[this] { return Worker(stage_); }};
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::int64_t samples_before_ = 0;
    std::atomic<std::int64_t> samples_counted_{0};
    std::mutex report_mutex_;
    double reported_at_ = 0, kept_at_ = 0;
};

void count_skips(const Stage& stage, RenderCounters& c) {
    if (!stage.needs.shadows && !stage.needs.dark_lamps) c.skipped_shadows = c.camera;
    if (!stage.needs.see_through) c.skipped_media = c.camera;
    if (!stage.needs.lens) c.skipped_lens = c.camera;
    if (!stage.needs.shutter) c.skipped_shutter = c.camera;
    if (!stage.spectrum) c.skipped_spectrum = c.camera;
    if (!stage.light_passes) c.skipped_photons = c.camera;
    if (!stage.needs.soft_lights) c.skipped_areas = c.camera;
}

}  // namespace

RenderCounters& RenderCounters::operator+=(const RenderCounters& o) {
    camera += o.camera;
    shadow += o.shadow;
    reflection += o.reflection;
    refraction += o.refraction;
    diffuse += o.diffuse;
    photons += o.photons;
    media_stack += o.media_stack;
    normals += o.normals;
    wavelengths += o.wavelengths;
    draws += o.draws;
    skipped_shadows += o.skipped_shadows;
    skipped_media += o.skipped_media;
    skipped_lens += o.skipped_lens;
    skipped_shutter += o.skipped_shutter;
    skipped_spectrum += o.skipped_spectrum;
    skipped_photons += o.skipped_photons;
    skipped_areas += o.skipped_areas;
    no_numbers += o.no_numbers;
    engine += o.engine;
    return *this;
}

std::vector<TileRegion> tiles_of(const RenderOptions& options) {
    const TileRegion all = options.region.value_or(TileRegion{0, 0, options.width, options.height});
    std::vector<TileRegion> tiles;
    int number = 0;
    // The grid is the picture's, and tiles are whole: a tile's bytes never depend on which region asked for it.
    for (int y = all.y / kTileSide * kTileSide; y < all.y + all.height; y += kTileSide)
        for (int x = all.x / kTileSide * kTileSide; x < all.x + all.width; x += kTileSide) {
            if (number++ % options.shard.count != options.shard.index) continue;
            tiles.push_back({x, y, std::min(kTileSide, options.width - x), std::min(kTileSide, options.height - y)});
        }
    return tiles;
}

Result<RenderResult> render(std::shared_ptr<const Program> program, const RenderScene& scene, const RenderOptions& options, RenderControl& control, const Film* resume) {
    const Result<std::shared_ptr<const Stage>> stage = prepare(std::move(program), scene, options);
    if (!stage) return tl::unexpected<Error>(stage.error());
    const bool fits = resume && resume->width == options.width && resume->height == options.height && resume->aovs == options.aovs;
    if (resume && !fits) return fail(Fault::kCommand, "The rendering to resume has another size or other planes");
    Rendering rendering(**stage, control, resume ? *resume : Film(options.width, options.height, options.aovs));
    RenderResult result;
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    // More threads than cores are an arena's right only while this control lives; without it TBB prints a warning.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] { result = rendering.run(); });
    count_skips(**stage, result.counters);
    return result;
}

}  // namespace whittle
