// N rays to a lamp with a size: what they cost, and how fast the strip of a soft shadow becomes smooth.
#include "scenes.h"

#include <cmath>

using namespace whittle;
using namespace whittle::test;

namespace {

// A matte floor and a bar above it, under a square lamp.
Solid bar_over_floor() {
    SceneBuilder b;
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), matte(1, 1, 1)));
    b.add(b.box(Vec3(-60, -50, 9), Vec3(60, -2, 10), matte(1, 1, 1)));
    return b.finish();
}

RenderResult strip(int light_samples, std::uint64_t seed = 0) {
    AreaLight area;
    area.p = Vec3(-8, -8, 30);
    area.u = Vec3(16, 0, 0);
    area.v = Vec3(0, 16, 0);
    RenderScene scene;
    scene.lights = {Light{area, {}}};
    // Along the bar's edge, below the bar: nothing but the penumbra is seen.
    scene.camera = looking(Vec3(0, 14, 7), Vec3(0, 0.5, 0), 40);
    RenderOptions o = small_options();
    o.width = 64;
    o.height = 16;
    o.samples = 1;
    o.integrator = Integrator::kDistributed;
    o.light_samples = light_samples;
    o.seed = seed;
    return drawn(bar_over_floor(), scene, o);
}

double rms(const Film& a, const Film& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += (a.color(i).x - b.color(i).x) * (a.color(i).x - b.color(i).x);
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

}  // namespace

TEST_CASE("a strip with 1, 10, 20 and 50 light samples at one pixel sample costs hits x lamps x N, and its error falls") {
    const Film truth = strip(1024, 9).film;
    double before = HUGE_VAL;
    for (int n : {1, 10, 20, 50}) {
        INFO(n << " samples");
        const RenderResult r = strip(n);
        // Hits, all of them on the floor's upper side, times lamps, times N.
        CHECK(r.counters.camera == 64 * 16);
        CHECK(r.counters.normals > 1000);
        CHECK(r.counters.shadow == r.counters.normals * 1 * static_cast<std::uint64_t>(n));
        const double error = rms(r.film, truth);
        CHECK(error < before);
        before = error;
    }
}

TEST_CASE("the error of an edge's shadow falls as stratified samples do, n^-3/4, and not as chance does, n^-1/2") {
    // Of a smooth edge through n strata the n^1/2 that it crosses are in doubt.
    const Film truth = strip(4096, 9).film;
    const auto error = [&](int n) {
        double sum = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const double e = rms(strip(n, seed).film, truth);
            sum += e * e;
        }
        return std::sqrt(sum / 4);
    };
    const double slope = std::log(error(256) / error(4)) / std::log(64.0);
    CHECK(slope < -0.68);
    CHECK(slope > -1.1);
}
