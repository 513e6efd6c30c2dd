// What a scene should not hold: every one has a result that is defined, or is told; no sample is no number, by any integrator.
#include "scenes.h"

#include <cmath>
#include <limits>

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

constexpr Integrator kAll[] = {Integrator::kPreview, Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath, Integrator::kCaustics, Integrator::kCone};

// A matte ball on a floor, or what stands for it.
Solid ball_on_floor(const Material& m = matte(1, 1, 1)) {
    SceneBuilder b;
    b.add(b.ball(5, m, moved(0, 0, 5)));
    b.add(b.box(Vec3(-50, -50, -1), Vec3(50, 50, 0), matte(1, 1, 1)));
    return b.finish();
}

RenderScene lit_by(std::vector<Light> lights, Vec3 eye = Vec3(0, -60, 30)) {
    RenderScene scene;
    scene.camera = looking(eye, Vec3(0, 0, 4), 30);
    scene.lights = std::move(lights);
    return scene;
}

// Every integrator's picture; checks that it holds numbers only.
template <class Use>
void each_picture(const Solid& solid, const RenderScene& scene, Use use) {
    for (Integrator kind : kAll) {
        INFO(integrator_name(kind));
        RenderOptions o = small_options();
        o.width = 16;
        o.height = 12;
        o.samples = 4;
        o.max_depth = 6;
        o.integrator = kind;
        const RenderResult r = drawn(solid, scene, o);
        CHECK(all_finite(r.film));
        CHECK(r.counters.no_numbers == 0);
        use(kind, r);
    }
}

double brightest(const Film& film) {
    double most = 0;
    for (std::size_t i = 0; i < film.pixels.size(); ++i) most = std::max(most, film.color(i).x + film.color(i).y + film.color(i).z);
    return most;
}

}  // namespace

TEST_CASE("a light inside a solid lights nothing outside of it") {
    for (double radius : {0.0, 3.0}) {
        PointLight p;
        p.p = Vec3(0, 0, 5);
        p.radius = radius;
        p.power = 1e5;
        INFO("radius " << radius);
        each_picture(ball_on_floor(), lit_by({lamp(p)}), [](Integrator kind, const RenderResult& r) {
            // The preview has no shadows.
            if (kind != Integrator::kPreview) CHECK(brightest(r.film) == 0);
        });
    }
}

TEST_CASE("a light that a solid's surface runs through lights the part outside") {
    PointLight p;
    p.p = Vec3(0, -5, 8);
    p.radius = 4;
    p.power = 1e5;
    each_picture(ball_on_floor(), lit_by({lamp(p)}), [](Integrator, const RenderResult& r) { CHECK(brightest(r.film) > 0); });
}

TEST_CASE("a camera inside glass sees out of it") {
    for (const char* matter : {"glass", "diamond", "water"}) {
        INFO(matter);
        each_picture(ball_on_floor(preset(matter)), lit_by({around(Vec3(1))}, Vec3(0, -1, 6)), [](Integrator, const RenderResult& r) { CHECK(brightest(r.film) > 0.1); });
    }
}

TEST_CASE("a camera inside opaque matter gives a picture of numbers") {
    each_picture(ball_on_floor(), lit_by({around(Vec3(1))}, Vec3(0, -1, 6)), [](Integrator, const RenderResult&) {});
}

TEST_CASE("a rectangle of no area is a point in its middle") {
    AreaLight line;
    line.p = Vec3(20, -20, 30);
    line.u = Vec3(4, 0, 0);
    line.v = Vec3(8, 0, 0);
    AreaLight nothing;
    nothing.p = line.p;
    nothing.u = nothing.v = Vec3(0);
    for (const AreaLight& flat : {line, nothing}) {
        PointLight point;
        point.p = flat.p + (flat.u + flat.v) / 2.0;
        std::vector<double> bright;
        each_picture(ball_on_floor(), lit_by({lamp(point)}), [&](Integrator, const RenderResult& r) { bright.push_back(brightest(r.film)); });
        std::size_t at = 0;
        each_picture(ball_on_floor(), lit_by({Light{flat, {}}}), [&](Integrator, const RenderResult& r) { CHECK(brightest(r.film) == Approx(bright[at++]).epsilon(1e-9)); });
    }
}

TEST_CASE("a sun without direction gives a picture of numbers") {
    SunLight sun;
    sun.direction = Vec3(0);
    each_picture(ball_on_floor(), lit_by({Light{sun, {}}}), [](Integrator, const RenderResult&) {});
}

TEST_CASE("a black scene is black, and it is said") {
    each_picture(ball_on_floor(), lit_by({around(Vec3(0))}), [](Integrator, const RenderResult& r) {
        CHECK(brightest(r.film) == 0);
        REQUIRE(r.warnings.size() == 1);
        CHECK(r.warnings[0].find("all black") != std::string::npos);
    });
}

TEST_CASE("emission and power without end come out finite") {
    Material glow = preset("emissive");
    glow.emission = Vec3(kEndless, 1, 1);
    each_picture(ball_on_floor(glow), lit_by({around(Vec3(0.5))}), [](Integrator, const RenderResult&) {});
    PointLight p;
    p.p = Vec3(20, -20, 30);
    p.power = kEndless;
    SunLight sun;
    sun.irradiance = kEndless;
    for (double radius : {0.0, 4.0}) {
        p.radius = radius;
        each_picture(ball_on_floor(), lit_by({lamp(p), Light{sun, {}}}), [](Integrator, const RenderResult&) {});
    }
}

TEST_CASE("a light at no place gives a picture of numbers") {
    PointLight p;
    p.p = Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    each_picture(ball_on_floor(), lit_by({lamp(p)}), [](Integrator, const RenderResult&) {});
}

TEST_CASE("ten thousand lamps together are as bright as one of their power") {
    std::vector<Light> many;
    for (int i = 0; i < 10000; ++i) {
        PointLight p;
        p.p = Vec3((i % 100 - 49.5) * 0.01, (i / 100 - 49.5) * 0.01, 60);
        p.power = 10;
        many.push_back(lamp(p));
    }
    PointLight one;
    one.p = Vec3(0, 0, 60);
    one.power = 1e5;
    RenderOptions o = small_options();
    o.width = o.height = 4;
    for (Integrator kind : {Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath, Integrator::kCone}) {
        INFO(integrator_name(kind));
        o.integrator = kind;
        o.max_depth = 1;
        const RenderResult all = drawn(ball_on_floor(), lit_by(many, Vec3(0, -1, 120)), o);
        CHECK(all.counters.no_numbers == 0);
        CHECK(middle(all.film).x == Approx(middle(drawn(ball_on_floor(), lit_by({lamp(one)}, Vec3(0, -1, 120)), o).film).x).epsilon(0.01));
    }
}
