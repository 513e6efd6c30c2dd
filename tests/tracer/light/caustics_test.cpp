// Light from the lamps through what focuses: energy, and that it agrees with paths from the eye.
#include "ball_lens.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>

#include "tracer/light/aims.h"
#include "tracer/light/emission.h"
#include "tracer/light/light_pass.h"
#include "tracer/light/sampler.h"
#include "tracer/light/scattering.h"
#include "tracer/light/stage.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// A glass ball of radius 5 at height `z` over a grey floor.
Solid ball_over_floor(double z) {
    SceneBuilder b;
    b.add(b.ball(5, preset("glass"), moved(0, 0, z)));
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), matte(0.7, 0.7, 0.7)));
    return b.finish();
}

std::shared_ptr<const Stage> prepared(const Solid& solid, RenderScene scene, const RenderOptions& options) {
    const auto program = compile(solid);
    REQUIRE(program);
    scene.solid = &solid;
    auto stage = prepare(*program, scene, options);
    REQUIRE(stage);
    return *stage;
}

RenderOptions caustics_options(int size, int samples, Integrator integrator = Integrator::kCaustics) {
    RenderOptions o = small_options();
    o.width = o.height = size;
    o.samples = samples;
    o.integrator = integrator;
    o.max_depth = 64;
    o.filter = FilterKind::kBox;
    return o;
}

// A ball lamp beside the glass ball; the camera looks at its caustic from above.
RenderScene lamp_and_caustic() {
    PointLight p;
    p.p = Vec3(30, 0, 38);
    p.radius = 6;
    p.power = 2e5;
    RenderScene scene;
    scene.lights = {lamp(p), around(Vec3(0))};
    scene.camera = looking(Vec3(-25, -40, 45), Vec3(-6, 0, 0), 14);
    return scene;
}

struct TileMeans {
    std::vector<double> mean, variance;
};

TileMeans tiles_of_film(const Film& film, int side) {
    TileMeans t;
    for (int y0 = 0; y0 + side <= film.height; y0 += side)
        for (int x0 = 0; x0 + side <= film.width; x0 += side) {
            double mean = 0, variance = 0;
            for (int y = y0; y < y0 + side; ++y)
                for (int x = x0; x < x0 + side; ++x) {
                    const Vec3 c = film.color(film.index(x, y));
                    mean += 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
                    variance += film.variance(film.index(x, y));
                }
            t.mean.push_back(mean / (side * side));
            t.variance.push_back(variance / (side * side * side * side));
        }
    return t;
}

double chi_square(const TileMeans& a, const TileMeans& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.mean.size(); ++i) sum += (a.mean[i] - b.mean[i]) * (a.mean[i] - b.mean[i]) / (a.variance[i] + b.variance[i]);
    return sum;
}

}  // namespace

TEST_CASE("all the light that a glass ball takes in reaches the walls of the room, to 1 percent") {
    SceneBuilder b;
    b.add(b.ball(5, preset("glass")));
    const Use hollow = b.combined(SetOp::kDifference, {b.box(Vec3(-40), Vec3(40), matte(0.5, 0.5, 0.5)), b.box(Vec3(-39), Vec3(39))});
    b.add(hollow);
    PointLight p;
    p.p = Vec3(0, 0, 20);
    p.power = 4 * kPi * 100;
    RenderScene scene;
    scene.lights = {lamp(p), around(Vec3(0))};
    scene.camera = looking(Vec3(20, 0, 20));
    RenderOptions o = caustics_options(256, 1);
    o.max_depth = 1000;
    const Solid solid = b.finish();
    const auto stage = prepared(solid, scene, o);
    REQUIRE(stage->light_passes);
    double flux = 0;
    for (const Photon& photon : stage->light_passes->pass(0)->map().photons()) flux += photon.power.x;
    // Intensity 100 within the cone that touches the ball.
    CHECK(flux == Approx(100 * 2 * kPi * (1 - std::sqrt(1 - 0.25 * 0.25))).epsilon(1e-2));
}

TEST_CASE("the focus of a ball lens holds the energy that Snell and Fresnel send there, to 1 percent") {
    const Solid solid = ball_over_floor(7.5);
    SunLight sun;
    sun.irradiance = 1;
    RenderScene scene;
    scene.lights = {Light{sun, {}}, around(Vec3(0))};
    scene.camera = looking(Vec3(0, -60, 60));
    const auto stage = prepared(solid, scene, caustics_options(512, 1));
    REQUIRE(stage->light_passes);
    for (double spot : {0.4, 1.0, 2.0}) {
        double flux = 0;
        for (const Photon& photon : stage->light_passes->pass(0)->map().photons())
            if (photon.point.x * photon.point.x + photon.point.y * photon.point.y < spot * spot && photon.point.z > -1e-9) flux += photon.power.x;
        INFO("within " << spot << " mm");
        CHECK(flux == Approx(flux_by_snell(5, 1.5, 7.5, spot)).epsilon(1e-2));
    }
}

TEST_CASE("caustics drawn from the lamp, gathered as photons and found by paths from the eye agree") {
    const Solid solid = ball_over_floor(8);
    const RenderResult path = drawn(solid, lamp_and_caustic(), caustics_options(16, 1024, Integrator::kPath));
    const RenderResult lit = drawn(solid, lamp_and_caustic(), caustics_options(16, 64));
    CHECK(lit.counters.photons > 0);
    CHECK(path.counters.photons == 0);
    // 16 tiles; chi-square of 16 degrees exceeds 39.3 once in a thousand.
    CHECK(chi_square(tiles_of_film(path.film, 4), tiles_of_film(lit.film, 4)) < 39.3);

    RenderOptions photons_only = caustics_options(16, 64);
    photons_only.trace_onto_picture = false;
    const TileMeans gathered = tiles_of_film(drawn(solid, lamp_and_caustic(), photons_only).film, 16), whole = tiles_of_film(lit.film, 16);
    // The search radius spreads light over its disc: up to 4 percent here.
    CHECK(gathered.mean[0] == Approx(whole.mean[0]).epsilon(0.04));
    // The caustic is what is compared: without it the floor is much darker.
    RenderOptions none = caustics_options(16, 64, Integrator::kDistributed);
    SceneBuilder b;
    b.add(b.ball(5, matte(0, 0, 0), moved(0, 0, 8)));
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), matte(0.7, 0.7, 0.7)));
    CHECK(tiles_of_film(drawn(b.finish(), lamp_and_caustic(), none).film, 16).mean[0] < 0.8 * whole.mean[0]);
}

TEST_CASE("caustics by every sampler agree") {
    const Solid solid = ball_over_floor(8);
    const TileMeans sobol = tiles_of_film(drawn(solid, lamp_and_caustic(), caustics_options(16, 256)).film, 4);
    for (const SamplerKind kind : {SamplerKind::kStratified, SamplerKind::kIndependent}) {
        RenderOptions o = caustics_options(16, 256);
        o.sampler = kind;
        o.seed = 5;
        INFO(sampler_name(kind));
        CHECK(chi_square(sobol, tiles_of_film(drawn(solid, lamp_and_caustic(), o).film, 4)) < 39.3);
    }
}

TEST_CASE("a picture of the surroundings sends its light through what focuses, as paths from the eye find it") {
    // Dim all around, and a bright patch of about 22 degrees high up.
    const auto sky = [](const std::string&, const SourcePlace&) -> Result<Image> {
        Image image;
        image.width = 64;
        image.height = 32;
        image.channels = {"R", "G", "B"};
        image.types.assign(3, ChannelType::kFloat);
        image.floats.assign(64 * 32 * 3, 0.1f);
        for (std::size_t y = 6; y < 10; ++y)
            for (std::size_t x = 3 * 50; x < 3 * 54; ++x) image.floats[y * 64 * 3 + x] = 30;
        return image;
    };
    RenderScene scene = lamp_and_caustic();
    EnvironmentLight around;
    around.file = "sky";
    scene.lights = {Light{around, {}}};
    scene.read_picture = sky;
    const Solid solid = ball_over_floor(8);
    const RenderResult path = drawn(solid, scene, caustics_options(16, 1024, Integrator::kPath)), lit = drawn(solid, scene, caustics_options(16, 128));
    CHECK(path.counters.photons == 0);
    CHECK(lit.counters.photons > 0);
    CHECK(chi_square(tiles_of_film(path.film, 4), tiles_of_film(lit.film, 4)) < 39.3);
    // The light through the ball is of weight: less of it, and the pictures would differ.
    RenderOptions none = caustics_options(16, 1024, Integrator::kPath);
    none.max_depth = 1;
    CHECK(chi_square(tiles_of_film(drawn(solid, scene, none).film, 4), tiles_of_film(lit.film, 4)) > 100);
}

TEST_CASE("lamps shine at each thing that focuses, and what several balls catch is counted once") {
    // Far apart: two balls; near each other, or one within the other: one.
    const Bounds left{Vec3(-60, -5, -5), Vec3(-50, 5, 5)}, right{Vec3(50, -5, -5), Vec3(60, 5, 5)}, inside{Vec3(52, -2, -2), Vec3(55, 2, 2)};
    CHECK(aims_around({left, right, inside}).size() == 2);
    CHECK(aims_around({}).empty());
    std::vector<Bounds> many;
    for (int i = 0; i < 300; ++i) many.push_back({Vec3(i * 40, 0, 0), Vec3(i * 40 + 1, 1, 1)});
    const std::vector<Aim> aims = aims_around(many);
    CHECK(aims.size() <= kMostAims);
    for (const Bounds& thing : many)
        CHECK(std::any_of(aims.begin(), aims.end(), [&](const Aim& a) { return glm::length(thing.lo - a.centre) <= a.radius && glm::length(thing.hi - a.centre) <= a.radius; }));
    // Of two overlapping balls and one: the flux through a disc that both hold is the same.
    PointLight p;
    p.p = Vec3(0, 0, 50);
    p.power = 4 * kPi;
    SunLight sun;
    sun.direction = Vec3(0, 0, -1);
    sun.irradiance = 1;
    for (const LightSource& lamp : {resolve_light(p, Vec3(0)), resolve_light(sun)}) {
        const auto through_disc = [&](std::vector<Aim> balls) {
            const Emission emission({lamp}, std::move(balls), Bounds{Vec3(-60), Vec3(60)});
            double flux = 0;
            constexpr std::uint32_t kRays = 1U << 20;
            for (std::uint32_t i = 0; i < kRays; ++i) {
                const Sampler s(3, 1, 2, i);
                const Emitted e = emission.emit(s.pair(Draw::kPixel).x, s.pair(Draw::kLight), s.pair(Draw::kSky));
                const Vec3 at = e.origin - e.direction * (e.origin.z / e.direction.z);
                if (at.x * at.x + at.y * at.y < 9) flux += e.power.x / kRays;
            }
            return flux;
        };
        const double one = through_disc({{Vec3(0), 10}});
        CHECK(one > 0);
        CHECK(through_disc({{Vec3(0), 10}, {Vec3(4, 0, 0), 8}, {Vec3(40, 0, 0), 6}}) == Approx(one).epsilon(1e-2));
    }
}

TEST_CASE("the search radius shrinks as the sixth root of the passes") {
    const Solid solid = ball_over_floor(8);
    const auto stage = prepared(solid, lamp_and_caustic(), caustics_options(8, 1));
    REQUIRE(stage->light_passes);
    const double slope = std::log(stage->light_passes->radius(40000) / stage->light_passes->radius(5000)) / std::log(8.0);
    CHECK(slope == Approx(-1.0 / 6).epsilon(1e-3));
}

TEST_CASE("caustics have the same bits on any number of threads and after a resumption") {
    const Solid solid = ball_over_floor(8);
    RenderOptions o = caustics_options(20, 6);
    o.threads = 1;
    const Film one = drawn(solid, lamp_and_caustic(), o).film;
    o.threads = 3;
    CHECK(drawn(solid, lamp_and_caustic(), o).film.pixels == one.pixels);
    // A film that stopped after its first sample: the other samples are the same ones.
    const auto program = compile(solid);
    REQUIRE(program);
    RenderControl control;
    control.stop = true;
    RenderScene scene = lamp_and_caustic();
    scene.solid = &solid;
    const Result<RenderResult> stopped = render(*program, scene, o, control);
    REQUIRE(stopped);
    REQUIRE(stopped->samples_finished == 1);
    CHECK(drawn(solid, lamp_and_caustic(), o, &stopped->film).film.pixels == one.pixels);
}

TEST_CASE("no photons without something that focuses, without something dull, or without lamps") {
    const auto photons = [](const Material& ball, const Material& floor, std::vector<Light> lights) {
        SceneBuilder b;
        b.add(b.ball(5, ball, moved(0, 0, 8)));
        b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), floor));
        RenderScene scene = lamp_and_caustic();
        scene.lights = std::move(lights);
        const RenderResult r = drawn(b.finish(), scene, caustics_options(8, 1));
        CHECK(r.counters.skipped_photons == (r.counters.photons > 0 ? 0 : r.counters.camera));
        return r.counters.photons;
    };
    const std::vector<Light> lamps = lamp_and_caustic().lights;
    CHECK(photons(preset("glass"), matte(1, 1, 1), lamps) > 0);
    CHECK(photons(matte(1, 1, 1), matte(1, 1, 1), lamps) == 0);
    CHECK(photons(preset("glass"), preset("mirror"), lamps) == 0);
    CHECK(photons(preset("glass"), matte(1, 1, 1), {around(Vec3(1))}) == 0);
}

TEST_CASE("a rainbow: behind a dispersing ball red and blue have their foci apart, together they are white") {
    SceneBuilder b;
    Material glass = preset("glass");
    glass.dispersion = 10;
    b.add(b.ball(5, glass, moved(0, 0, 7.5)));
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), matte(0.7, 0.7, 0.7)));
    SunLight sun;
    sun.irradiance = 1;
    RenderScene scene;
    scene.lights = {Light{sun, {}}, around(Vec3(0))};
    scene.camera = looking(Vec3(0, -60, 60));
    const Solid solid = b.finish();
    const auto stage = prepared(solid, scene, caustics_options(256, 1));
    REQUIRE(stage->light_passes);
    Vec3 inner(0), all(0);
    for (const Photon& photon : stage->light_passes->pass(0)->map().photons()) {
        all += photon.power;
        if (glm::length(Vec2(photon.point)) < 0.3) inner += photon.power;
    }
    // Blue is reflected a little more.
    CHECK(all.x == Approx(all.z).epsilon(0.04));
    CHECK(std::abs(inner.x / inner.z - 1) > 0.1);
}
