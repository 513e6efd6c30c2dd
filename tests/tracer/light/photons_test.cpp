// --photons N: Whitted's tree with caustics from one photon map. Its energy, and that it agrees with light tracing.
#include "ball_lens.h"
#include "scenes.h"

#include <cmath>

#include "tracer/light/light_pass.h"
#include "tracer/light/scattering.h"
#include "tracer/light/stage.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Solid ball_over(const Material& floor, double z = 8, double reach = 60, double thick = 1) {
    SceneBuilder b;
    b.add(b.ball(5, preset("glass"), moved(0, 0, z)));
    b.add(b.box(Vec3(-reach, -reach, -thick), Vec3(reach, reach, 0), floor));
    return b.finish();
}

// A lamp beside the ball; the camera looks at its caustic and the shadow around it, past the ball: of what glass shows faint images are left out by the tree.
RenderScene lamp_and_caustic(double radius = 0) {
    PointLight p;
    p.p = Vec3(30, 0, 38);
    p.radius = radius;
    p.power = 2e5;
    RenderScene scene;
    scene.lights = {lamp(p), around(Vec3(0))};
    scene.camera = looking(Vec3(-25, -40, 45), Vec3(-9, -3, 0), 7);
    return scene;
}

RenderOptions options_of(Integrator integrator, int photons, int samples) {
    RenderOptions o = small_options();
    o.width = o.height = 32;
    o.samples = samples;
    o.integrator = integrator;
    o.photons = photons;
    o.filter = FilterKind::kBox;
    return o;
}

std::vector<double> tile_means(const Film& film, int side) {
    std::vector<double> means;
    for (int y0 = 0; y0 < film.height; y0 += side)
        for (int x0 = 0; x0 < film.width; x0 += side) {
            double sum = 0;
            for (int y = y0; y < y0 + side; ++y)
                for (int x = x0; x < x0 + side; ++x) sum += film.color(film.index(x, y)).y / (side * side);
            means.push_back(sum);
        }
    return means;
}

double mean(const Film& film) { return tile_means(film, film.width)[0]; }

// Root of the mean square difference over the mean.
double apart(const Film& a, const Film& b, int side) {
    const std::vector<double> x = tile_means(a, side), y = tile_means(b, side);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - y[i]) * (x[i] - y[i]) / static_cast<double>(x.size());
    return std::sqrt(sum) / mean(b);
}

}  // namespace

TEST_CASE("what is gathered around a ball lens's focus is the light that Snell and Fresnel send there, to 1 percent") {
    const Solid solid = ball_over(matte(0.7, 0.7, 0.7), 7.5);
    SunLight sun;
    sun.irradiance = 1;
    RenderScene scene;
    scene.lights = {Light{sun, {}}, around(Vec3(0))};
    scene.camera = looking(Vec3(0, -60, 60));
    scene.solid = &solid;
    const auto program = compile(solid);
    REQUIRE(program);
    const auto stage = prepare(*program, scene, options_of(Integrator::kWhitted, 1 << 18, 4));
    REQUIRE(stage);
    REQUIRE((*stage)->light_passes);
    const PhotonMap& map = (*stage)->light_passes->pass(3)->map();
    CHECK(&map == &(*stage)->light_passes->pass(0)->map());
    CHECK((*stage)->light_passes->rays_sent() == 1 << 18);
    // A white surface whose facets return pi times less in all directions.
    Surface white;
    white.color = Vec3(1);
    white.alpha = 1;
    white.ior = 1;
    white.dielectric_f0 = 0;
    const Bsdf bsdf(white, Vec3(0, 0, 1), Vec3(0, 0, 1));
    const double value = bsdf.value(Vec3(0, 0, 1), 1).y;
    REQUIRE(value == Approx(bsdf.value(glm::normalize(Vec3(1, 0, 1)), std::sqrt(0.5)).y).epsilon(1e-3));
    for (const double spot : {1.0, 2.0}) {
        double flux = 0;
        const double step = 0.01;
        for (double x = -spot + step / 2; x < spot; x += step)
            for (double y = -spot + step / 2; y < spot; y += step)
                if (x * x + y * y < spot * spot) flux += map.radiance(Vec3(x, y, 0), Vec3(0, 0, 1), bsdf).y / value * step * step;
        INFO("within " << spot << " mm");
        CHECK(flux == Approx(flux_by_snell(5, 1.5, 7.5, spot)).epsilon(1e-2));
    }
}

TEST_CASE("a tree with photons agrees with light tracing where dull surfaces do not light each other") {
    // A dark floor: what it returns to itself by way of the ball, which only paths follow, is 2 percent of the caustic at most.
    const Material dark = matte(0.02, 0.02, 0.02);
    const Solid solid = ball_over(dark);
    for (const double radius : {0.0, 6.0}) {
        INFO("a lamp of radius " << radius);
        const Integrator tree = radius > 0 ? Integrator::kDistributed : Integrator::kWhitted;
        const Film traced = drawn(solid, lamp_and_caustic(radius), options_of(Integrator::kCaustics, 0, 256)).film;
        const RenderResult many = drawn(solid, lamp_and_caustic(radius), options_of(tree, 1 << 20, 64));
        CHECK(many.counters.photons == 1 << 20);
        CHECK(mean(many.film) == Approx(mean(traced)).epsilon(0.01));
        CHECK(apart(many.film, traced, 4) < 0.03);
        // With few the bias shows, and without any the light goes straight on.
        const Film few = drawn(solid, lamp_and_caustic(radius), options_of(tree, 1 << 12, 16)).film;
        CHECK(apart(few, traced, 4) > 1.5 * apart(many.film, traced, 4));
        CHECK(apart(drawn(solid, lamp_and_caustic(radius), options_of(tree, 0, 16)).film, traced, 4) > 0.1);
    }
}

TEST_CASE("on a rough metal light is counted once: by photons, not by the lamp that its mirror image shows behind glass") {
    Material steel = preset("steel");
    steel.roughness = 0.5;
    const Solid solid = ball_over(steel);
    const Film traced = drawn(solid, lamp_and_caustic(6), options_of(Integrator::kCaustics, 0, 512)).film;
    const Film tree = drawn(solid, lamp_and_caustic(6), options_of(Integrator::kDistributed, 1 << 20, 64)).film;
    CHECK(mean(tree) == Approx(mean(traced)).epsilon(0.02));
}

TEST_CASE("photons on what is half clear count as much as light drawn there") {
    Material milky = matte(0.02, 0.02, 0.02);
    milky.transmission = 0.5;
    milky.ior = 1;
    // A small plate: one that lets light through is itself aimed at, and the search is as wide as 3 percent of it.
    const Solid solid = ball_over(milky, 8, 14);
    RenderOptions onto = options_of(Integrator::kCaustics, 0, 128), gathered = onto;
    gathered.trace_onto_picture = false;
    const Film drawn_there = drawn(solid, lamp_and_caustic(), onto).film;
    CHECK(mean(drawn(solid, lamp_and_caustic(), gathered).film) == Approx(mean(drawn_there)).epsilon(0.02));
    CHECK(mean(drawn(solid, lamp_and_caustic(), options_of(Integrator::kWhitted, 1 << 20, 16)).film) == Approx(mean(drawn_there)).epsilon(0.02));
}

TEST_CASE("photons on a sheet that covers half: its upper face shows half of what an opaque one does, its lower face an eighth") {
    const auto seen = [](double coverage, const RenderOptions& by) {
        Material veil = matte(0.02, 0.02, 0.02);
        veil.color->w = coverage;
        return mean(drawn(ball_over(veil, 8, 14, 0.1), lamp_and_caustic(), by).film);
    };
    const RenderOptions photons = options_of(Integrator::kWhitted, 1 << 20, 64), traced = options_of(Integrator::kCaustics, 0, 256);
    CHECK(seen(0.5, photons) == Approx(0.625 * seen(1, photons)).epsilon(0.02));
    CHECK(seen(0.5, traced) == Approx(0.625 * seen(1, traced)).epsilon(0.02));
}

TEST_CASE("where something moves, every sample has photons of its own time") {
    SceneBuilder b;
    b.add(b.moving(b.ball(5, preset("glass"), moved(-1, 0, 8)), moved(2, 0, 0)));
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), matte(0.02, 0.02, 0.02)));
    const Solid solid = b.finish();
    const Film traced = drawn(solid, lamp_and_caustic(), options_of(Integrator::kCaustics, 0, 128)).film;
    const RenderResult tree = drawn(solid, lamp_and_caustic(), options_of(Integrator::kDistributed, 1 << 20, 128));
    CHECK(tree.counters.photons == 1 << 20);
    CHECK(mean(tree.film) == Approx(mean(traced)).epsilon(0.01));
    CHECK(apart(tree.film, traced, 4) < 0.03);
}

TEST_CASE("photons of a tree: the same bits on any number of threads, none where nothing focuses, and only by whitted and distributed") {
    const Solid solid = ball_over(matte(0.7, 0.7, 0.7));
    RenderOptions o = options_of(Integrator::kWhitted, 20000, 4);
    o.threads = 1;
    const Film one = drawn(solid, lamp_and_caustic(), o).film;
    o.threads = 3;
    CHECK(drawn(solid, lamp_and_caustic(), o).film.pixels == one.pixels);
    SceneBuilder dull;
    dull.add(dull.ball(5, matte(1, 1, 1), moved(0, 0, 8)));
    CHECK(drawn(dull.finish(), lamp_and_caustic(), o).counters.photons == 0);
    o.integrator = Integrator::kAuto;
    CHECK(drawn(solid, lamp_and_caustic(), o).integrator == Integrator::kWhitted);
    CHECK(drawn(solid, lamp_and_caustic(6), o).integrator == Integrator::kDistributed);
    const auto program = compile(solid);
    REQUIRE(program);
    for (const Integrator other : {Integrator::kPreview, Integrator::kPath, Integrator::kCaustics, Integrator::kCone}) {
        o.integrator = other;
        const auto refused = prepare(*program, lamp_and_caustic(), o);
        REQUIRE_FALSE(refused);
        CHECK(refused.error().fault == Fault::kCommand);
    }
}
