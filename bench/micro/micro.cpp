// micro.cpp — whittle-micro: the small pieces under Google Benchmark: crossings by kind and tier, the algebra of intervals, folding of tiles, compiling.
//
//     whittle-micro --benchmark_filter=crossings --benchmark_repetitions=7
#include <algorithm>
#include <random>

#include <benchmark/benchmark.h>

#include "bench/ray_sets.h"
#include "bench/scenes.h"
#include "csg/span/interval_set.h"
#include "tracer/engine/engine.h"
#include "tracer/engine/program.h"
#include "tracer/engine/roots.h"
#include "tracer/engine/tile.h"

namespace {

using namespace whittle;

Support support_of(SupportKind kind) {
    Support s{};
    s.kind = kind;
    s.axis = 2;
    if (kind == SupportKind::kAxisPlane) s.p[0] = 0.3;
    if (kind == SupportKind::kBall) s.p[0] = 0.1, s.p[1] = 0.2, s.p[2] = -0.1, s.p[3] = 1;
    if (kind == SupportKind::kCylinder) s.p[0] = 0.1, s.p[1] = 0.2, s.p[2] = 1;
    if (kind == SupportKind::kTorus) s.p[0] = 1, s.p[1] = 0.3;
    return s;
}

// From around the unit ball towards it.
std::vector<FrameRay> rays() {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<FrameRay> list(1024);
    for (FrameRay& r : list) {
        r = {};
        for (std::size_t i = 0; i < 3; ++i) r.o[i] = 3 * unit(random) + (i == 0 ? 4 : 0), r.d[i] = unit(random) - r.o[i];
    }
    return list;
}

void crossings(benchmark::State& state, SupportKind kind) {
    const Support support = support_of(kind);
    const auto list = rays();
    std::size_t i = 0;
    for (auto _ : state) {
        Crossings found;
        benchmark::DoNotOptimize(filtered_crossings(support, list[i++ % list.size()], found));
        benchmark::DoNotOptimize(found);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(crossings, axis_plane, SupportKind::kAxisPlane);
BENCHMARK_CAPTURE(crossings, ball, SupportKind::kBall);
BENCHMARK_CAPTURE(crossings, cylinder, SupportKind::kCylinder);
BENCHMARK_CAPTURE(crossings, torus, SupportKind::kTorus);

IntervalSet<double> intervals(std::size_t borders, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    IntervalSet<double> set;
    for (std::size_t i = 0; i < borders; ++i) set.borders.push_back(unit(random));
    std::sort(set.borders.begin(), set.borders.end());
    return set;
}

void subtracting_intervals(benchmark::State& state) {
    const auto borders = static_cast<std::size_t>(state.range(0));
    const IntervalSet<double> a = intervals(borders, 1), b = intervals(borders, 2);
    for (auto _ : state) benchmark::DoNotOptimize(subtract(a, b, [](double x, double y) { return x < y ? -1 : x > y ? 1 : 0; }));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(subtracting_intervals)->Arg(2)->Arg(16)->Arg(256);

TileExtremes extremes_of(const std::vector<Ray>& list, std::size_t first) {
    TileExtremes e{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, HUGE_VAL};
    for (std::size_t k = first; k < first + bench::kBatch; ++k) {
        e.least_square = std::min(e.least_square, glm::dot(list[k].direction, list[k].direction));
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            e.o_lo[i] = std::min(e.o_lo[i], list[k].origin[axis]), e.o_hi[i] = std::max(e.o_hi[i], list[k].origin[axis]);
            e.d_lo[i] = std::min(e.d_lo[i], list[k].direction[axis]), e.d_hi[i] = std::max(e.d_hi[i], list[k].direction[axis]);
        }
    }
    return e;
}

void folding_a_tile(benchmark::State& state, const char* name) {
    const bench::BenchScene scene = *bench::make_scene(name);
    const auto program = compile(scene.solid);
    const std::vector<Ray> list = bench::camera_rays(scene, 640, 480);
    TileTree tree;
    std::size_t tile = 0;
    for (auto _ : state) {
        const TileExtremes extremes = extremes_of(list, tile++ % (list.size() / bench::kBatch) * bench::kBatch);
        tree.begin(**program, tile_scope(extremes, (*program)->bounds));
        tree.build(**program, tile_bounds(extremes), (*program)->root, false);
        benchmark::DoNotOptimize(tree.leaf_count);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(folding_a_tile, S1, "S1");
BENCHMARK_CAPTURE(folding_a_tile, S2, "S2");
BENCHMARK_CAPTURE(folding_a_tile, S3, "S3");
BENCHMARK_CAPTURE(folding_a_tile, S6, "S6");

void compiling(benchmark::State& state, const char* name) {
    const bench::BenchScene scene = *bench::make_scene(name);
    for (auto _ : state) benchmark::DoNotOptimize(compile(scene.solid));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.primitives));
}
BENCHMARK_CAPTURE(compiling, S2, "S2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compiling, balls_10000, "balls10000")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
