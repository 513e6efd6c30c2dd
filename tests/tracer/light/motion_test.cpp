// Motion over the shutter: what moves covers a pixel for its share of the time, and so does the hole of a cutter that moves.
#include "scenes.h"

#include <cmath>

using namespace whittle;
using namespace whittle::test;

namespace {

Material glowing() {
    Material m = preset("emissive");
    m.emission = Vec3(1);
    return m;
}

// A row of 40 pixels, one mm each, over x = -20..20, seen along y.
RenderScene straight_on() {
    RenderScene scene;
    scene.lights = {around(Vec3(0))};
    scene.camera = looking(Vec3(0, -100, 0));
    scene.camera->orthographic = true;
    // Half a mm of height at the target's distance.
    scene.camera->fov_deg = 2 * std::atan(0.5 / 100) * 180 / 3.14159265358979323846;
    return scene;
}

RenderOptions one_row(int samples) {
    RenderOptions o = small_options();
    o.width = 40;
    o.height = 1;
    o.samples = samples;
    o.filter = FilterKind::kBox;
    return o;
}

// Mean of max(0, ...) style coverage: share of (place in the pixel, time) where `inside` holds.
template <class Inside>
double share(double x0, Inside inside) {
    int n = 0;
    for (int i = 0; i < 200; ++i)
        for (int k = 0; k < 200; ++k) n += inside(x0 + (i + 0.5) / 200, (k + 0.5) / 200);
    return n / 40000.0;
}

}  // namespace

TEST_CASE("a moving edge covers each pixel for its share of the shutter") {
    SceneBuilder b;
    b.add(b.moving(b.box(Vec3(-15, 0, -5), Vec3(-5, 1, 5), glowing()), moved(12, 0, 0)));
    const RenderResult r = drawn(b.finish(), straight_on(), one_row(1024));
    CHECK(r.integrator == Integrator::kDistributed);
    CHECK(r.counters.skipped_shutter == 0);
    for (int x = 0; x < 40; ++x) {
        const double expected = share(x - 20, [](double at, double time) { return at > -15 + 12 * time && at < -5 + 12 * time; });
        INFO("pixel " << x);
        CHECK(r.film.color(static_cast<std::size_t>(x)).x == Approx(expected).margin(0.01));
    }
}

TEST_CASE("a moving cutter moves its hole") {
    SceneBuilder b;
    const Use hole = b.moving(b.box(Vec3(-8, -5, -20), Vec3(-4, 5, 20)), moved(9, 0, 0));
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-18, 0, -5), Vec3(18, 1, 5), glowing()), hole}));
    const Film film = drawn(b.finish(), straight_on(), one_row(1024)).film;
    for (int x = 0; x < 40; ++x) {
        const double expected =
            share(x - 20, [](double at, double time) { return std::abs(at) < 18 && !(at > -8 + 9 * time && at < -4 + 9 * time); });
        INFO("pixel " << x);
        CHECK(film.color(static_cast<std::size_t>(x)).x == Approx(expected).margin(0.01));
    }
}

TEST_CASE("a ball that grows over the shutter is as wide as the time says") {
    SceneBuilder b;
    Placement doubled{{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}};
    b.add(b.moving(b.ball(5, glowing()), doubled));
    const Film film = drawn(b.finish(), straight_on(), one_row(1024)).film;
    for (int x : {12, 14, 25, 29, 35}) {
        const double expected = share(x - 20, [](double at, double time) { return std::abs(at) < 5 * (1 + time); });
        INFO("pixel " << x);
        CHECK(film.color(static_cast<std::size_t>(x)).x == Approx(expected).margin(0.02));
    }
}

TEST_CASE("what stands still draws no times, and one sample shows the start") {
    SceneBuilder still;
    still.add(still.box(Vec3(-15, 0, -5), Vec3(-5, 1, 5), glowing()));
    const RenderResult r = drawn(still.finish(), straight_on(), one_row(1));
    CHECK(r.counters.skipped_shutter == r.counters.camera);
    SceneBuilder b;
    b.add(b.moving(b.box(Vec3(-15, 0, -5), Vec3(-5, 1, 5), glowing()), moved(12, 0, 0)));
    const Film start = drawn(b.finish(), straight_on(), one_row(1)).film;
    CHECK(start.color(7).x == Approx(1));
    CHECK(start.color(20).x == 0);
}

TEST_CASE("the shadow of what moves moves with it") {
    // The lamp is above: shadow and block have the same x.
    SceneBuilder b;
    b.add(b.moving(b.box(Vec3(-15, 20, 10), Vec3(-5, 30, 11), matte(0, 0, 0)), moved(12, 0, 0)));
    b.add(b.box(Vec3(-50, -50, -1), Vec3(50, 50, 0), matte(1, 1, 1)));
    RenderScene scene = straight_on();
    scene.camera->eye = Vec3(0, -75, 100);
    scene.camera->target = Vec3(0, 25, 0);
    SunLight sun;
    scene.lights = {Light{sun, {}}};
    scene.camera->fov_deg = 2 * std::atan(0.5 / std::sqrt(20000.0)) * 180 / 3.14159265358979323846;
    const Film film = drawn(b.finish(), scene, one_row(1024)).film;
    for (int x : {3, 8, 12, 16, 22, 30}) {
        const double expected = 1 - share(x - 20, [](double at, double time) { return at > -15 + 12 * time && at < -5 + 12 * time; });
        INFO("pixel " << x);
        CHECK(film.color(static_cast<std::size_t>(x)).x == Approx(expected).margin(0.02));
    }
}
