// Dispersion: Cauchy's index, the eye's weights, a prism's spectrum; and that nobody pays who does not disperse.
#include "scenes.h"

#include <cmath>

#include "tracer/light/clear.h"
#include "tracer/light/scattering.h"
#include "tracer/light/spectrum.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Surface flint() {
    Material m = preset("glass");
    m.ior = 1.62;
    m.dispersion = 36;
    return *resolve_surface(m);
}

Material dispersing_glass(double abbe) {
    Material m = preset("glass");
    m.dispersion = abbe;
    return m;
}

RenderOptions furnace_options(Integrator integrator) {
    RenderOptions o = small_options();
    o.width = o.height = 8;
    o.samples = 512;
    o.integrator = integrator;
    o.max_depth = 64;
    return o;
}

}  // namespace

TEST_CASE("Cauchy's index has the Abbe number it was made from") {
    const Surface s = flint();
    CHECK(index_at(s, kLineD) == Approx(1.62).epsilon(1e-15));
    CHECK((index_at(s, kLineD) - 1) / (index_at(s, kLineF) - index_at(s, kLineC)) == Approx(36).epsilon(1e-12));
    CHECK(index_at(s, 0) == 1.62);
    Surface plain = s;
    plain.abbe = 0;
    CHECK(index_at(plain, 400) == 1.62);
}

TEST_CASE("wavelengths together weigh white, alone what the eye sees of them") {
    const Spectrum spectrum;
    Vec3 sum(0);
    const int n = 200000;
    for (int i = 0; i < n; ++i) sum += spectrum.weight(spectrum.wavelength((i + 0.5) / n));
    for (int c = 0; c < 3; ++c) CHECK(sum[c] / n == Approx(1).epsilon(1e-3));
    CHECK(spectrum.weight(450).z > spectrum.weight(450).x);
    CHECK(spectrum.weight(540).y > spectrum.weight(540).z);
    CHECK(spectrum.weight(640).x > spectrum.weight(640).y);
}

TEST_CASE("a prism spreads the lines F and C by as much as Snell's law says") {
    // Apex 60 degrees up at z; the faces lean by 30 degrees to either side.
    const double apex = kPi / 3, s = std::sin(apex / 2), c = std::cos(apex / 2);
    SceneBuilder b;
    Material glass = preset("glass");
    glass.ior = 1.62;
    glass.dispersion = 36;
    SolidBuilder& shapes = b.shapes();
    const Use left = b.use(shapes.shape(shape::HalfSpace{Vec3(-c, 0, s), 0}), glass), right = b.use(shapes.shape(shape::HalfSpace{Vec3(c, 0, s), 0}), glass);
    b.add(b.combined(SetOp::kIntersection, {left, right, b.box(Vec3(-100, -50, -40), Vec3(100, 50, 10), glass)}));
    const Solid solid = b.finish();
    const auto program = compile(solid);
    REQUIRE(program);
    const Result<World> world = World::make(*program, &solid);
    REQUIRE(world);
    const double incidence = 55 * kPi / 180;
    const Vec3 in = -std::cos(incidence) * Vec3(-c, 0, s) + std::sin(incidence) * Vec3(s, 0, c);
    Scratch scratch;
    const auto deviation = [&](double nm) {
        Ray ray;
        ray.origin = Vec3(-20 * s / c, 0, -20) - 100.0 * in;
        ray.direction = in;
        Leaving leaving;
        for (int i = 0; i < 2; ++i) {
            Border border;
            REQUIRE(world->next(ray, i > 0 ? &leaving : nullptr, 1e9, scratch, border));
            const std::optional<Vec3> bent = refracted(ray.direction, border.normal, eta_at(border, nm));
            REQUIRE(bent);
            ray.origin = border.point;
            ray.direction = *bent;
            leaving = border.leaving;
        }
        return std::acos(glm::dot(in, ray.direction));
    };
    const auto closed = [&](double nm) {
        const double n = index_at(flint(), nm), within = std::asin(std::sin(incidence) / n);
        return incidence + std::asin(n * std::sin(apex - within)) - apex;
    };
    CHECK(deviation(kLineF) - deviation(kLineC) == Approx(closed(kLineF) - closed(kLineC)).epsilon(1e-9));
    CHECK(deviation(kLineF) == Approx(closed(kLineF)).epsilon(1e-10));
    CHECK(deviation(kLineF) > deviation(kLineC));
}

// One wavelength a path: the mean of 32,768 of them has a standard error of 1 percent a channel.
TEST_CASE("in white light a dispersing ball is as white as any other") {
    for (Integrator integrator : {Integrator::kPath, Integrator::kDistributed})
        for (double roughness : {0.0, 0.5}) {
            SceneBuilder b;
            Material glass = dispersing_glass(10);
            glass.roughness = roughness;
            b.add(b.ball(5, glass));
            RenderScene scene;
            scene.camera = looking(Vec3(0, -30, 0));
            scene.lights = {around(Vec3(1))};
            const RenderResult r = drawn(b.finish(), scene, furnace_options(integrator));
            INFO(integrator_name(integrator) << ", roughness " << roughness);
            Vec3 mean(0);
            for (std::size_t i = 0; i < r.film.pixels.size(); ++i) mean += r.film.color(i) / static_cast<double>(r.film.pixels.size());
            for (int channel = 0; channel < 3; ++channel) CHECK(mean[channel] == Approx(1).epsilon(2.5e-2));
            CHECK(r.counters.wavelengths > 0);
        }
}

TEST_CASE("without dispersion no wavelength is drawn, and the picture is that of an Abbe number of nothing") {
    const auto ball = [](const Material& m) {
        SceneBuilder b;
        b.add(b.ball(5, m));
        RenderScene scene;
        scene.camera = looking(Vec3(0, -30, 0));
        RenderOptions o = furnace_options(Integrator::kPath);
        o.samples = 4;
        return drawn(b.finish(), scene, o);
    };
    const RenderResult plain = ball(preset("glass"));
    CHECK(plain.counters.wavelengths == 0);
    CHECK(plain.counters.skipped_spectrum == plain.counters.camera);
    CHECK(plain.film.pixels == ball(dispersing_glass(0)).film.pixels);
    CHECK(ball(dispersing_glass(30)).counters.skipped_spectrum == 0);
}
