#include "tracer/light/light_pass.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "tracer/light/light_walk.h"

namespace whittle {

namespace {

// Rays of one pass that one task follows.
constexpr int kChunk = 2048;

// Share of the photons in a search that the next pass keeps, in the mean (Knaus and Zwicker's alpha).
constexpr double kKeep = 2.0 / 3;

// First search radius, of the ball around what focuses.
constexpr double kFirstRadius = 0.03;

// Rays that have it, where all are sent at once: with more it shrinks as it does from pass to pass.
constexpr double kRaysAtFirst = 0x1p14;

}  // namespace

struct LightPasses::Kept {
    std::mutex mutex;
    std::map<int, std::shared_ptr<const LightPass>> passes;
    std::uint64_t rays = 0;

    std::shared_ptr<const LightPass> find(int index) {
        const std::lock_guard<std::mutex> lock(mutex);
        const auto found = passes.find(index);
        return found == passes.end() ? nullptr : found->second;
    }
    void keep(int index, std::shared_ptr<const LightPass> pass, int sent) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!passes.emplace(index, std::move(pass)).second) return;
        rays += static_cast<std::uint64_t>(sent);
        // The oldest goes, never the one just asked for.
        if (passes.size() > kKept) passes.erase(passes.begin()->first == index ? std::prev(passes.end()) : passes.begin());
    }
};

LightPasses::LightPasses(const Stage& stage, const PassPlan& plan) : stage_(stage), plan_(plan), kept_(std::make_unique<Kept>()) {}
LightPasses::~LightPasses() = default;

std::uint64_t LightPasses::rays_sent() const {
    const std::lock_guard<std::mutex> lock(kept_->mutex);
    return kept_->rays;
}

double LightPasses::radius(int index) const {
    const double first = kFirstRadius * stage_.emission.reach();
    if (plan_.shrunk_for > 0) return first * std::pow(static_cast<double>(plan_.shrunk_for) / kRaysAtFirst, -1.0 / 6);
    double r2 = 1;
    for (int i = 1; i <= index; ++i) r2 *= (i + kKeep) / (i + 1);
    return first * std::sqrt(r2);
}

void LightPasses::make(int begin, int end) const {
    if (plan_.once) begin = 0, end = 1;
    for (int i = begin; i < std::min(end, begin + kKept); ++i) pass(i);
}

std::shared_ptr<const LightPass> LightPasses::pass(int sample) const {
    const int index = number_of(sample);
    if (auto found = kept_->find(index)) return found;
    // A thread that waits for its own chunks must not begin another tile, which would ask for the same pass.
    std::shared_ptr<const LightPass> fresh;
    tbb::this_task_arena::isolate([&] { fresh = made(index); });
    kept_->keep(index, fresh, plan_.rays);
    return fresh;
}

std::shared_ptr<const LightPass> LightPasses::made(int index) const {
    const int rays = plan_.rays, chunks = (rays + kChunk - 1) / kChunk;
    const bool on_picture = plan_.draws == PassPlan::Draws::kOntoPicture;
    std::vector<LightLeft> left(static_cast<std::size_t>(chunks));
    tbb::parallel_for(0, chunks, [&](int c) {
        LightWalker walker(stage_, index, rays, on_picture);
        walker.walk(c * kChunk, std::min(rays, (c + 1) * kChunk), left[static_cast<std::size_t>(c)]);
    });
    std::vector<Photon> photons;
    std::vector<Splat> splats;
    for (const LightLeft& part : left) {
        photons.insert(photons.end(), part.photons.begin(), part.photons.end());
        splats.insert(splats.end(), part.splats.begin(), part.splats.end());
    }
    Splats drawn = picture_of(stage_.options);
    drawn.take(std::move(splats));
    return std::make_shared<LightPass>(PhotonMap(std::move(photons), radius(index)), std::move(drawn), on_picture);
}

}  // namespace whittle
