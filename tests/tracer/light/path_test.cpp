// Path tracing against closed forms and against the other integrators.
#include "scenes.h"

#include <cmath>

#include "tracer/light/scattering.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// Mean of all pixels.
Vec3 mean(const Film& film) {
    Vec3 sum(0);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) sum += film.color(i);
    return sum / static_cast<double>(film.pixels.size());
}

RenderOptions path_options(int samples) {
    RenderOptions o = small_options();
    o.width = o.height = 8;
    o.samples = samples;
    o.integrator = Integrator::kPath;
    o.max_depth = 200;
    return o;
}

RenderScene from_within(std::vector<Light> lights, double fov_deg = 60) {
    RenderScene scene;
    scene.camera = looking(Vec3(0.5, 0.3, -0.2), Vec3(3, 7, 1), fov_deg);
    scene.lights = std::move(lights);
    return scene;
}

}  // namespace

TEST_CASE("inside a glowing matte ball of albedo a the radiance is e / (1 - a) everywhere") {
    SceneBuilder b;
    Material wall = preset("matte");
    wall.color = Vec4(0.7353569830524495, 0.7353569830524495, 0.7353569830524495, 1);  // linear 0.5
    wall.emission = Vec3(1, 2, 0.5);
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-20), Vec3(20), wall), b.ball(10)}));
    RenderOptions options = path_options(256);
    const Film film = drawn(b.finish(), from_within({around(Vec3(0))}), options).film;
    CHECK(mean(film).x == Approx(2).epsilon(5e-3));
    CHECK(mean(film).y == Approx(4).epsilon(5e-3));
    CHECK(mean(film).z == Approx(1).epsilon(5e-3));
}

TEST_CASE("a point lamp amid a matte ball: the walls' radiance is E a / (pi (1 - a))") {
    // Uniform irradiance everywhere: each reflection multiplies by the albedo.
    SceneBuilder b;
    Material wall = preset("matte");
    wall.color = Vec4(0.7353569830524495, 0.7353569830524495, 0.7353569830524495, 1);
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-20), Vec3(20), wall), b.ball(10)}));
    PointLight p;
    p.power = 4 * kPi * 100;
    const Film film = drawn(b.finish(), from_within({lamp(p)}), path_options(256)).film;
    CHECK(mean(film).x == Approx(1 * 0.5 / (kPi * 0.5)).epsilon(5e-3));
}

TEST_CASE("in a white furnace nothing can be seen") {
    for (const char* name : {"matte", "glass", "diamond"}) {
        SceneBuilder b;
        Material white = preset(name);
        white.color = Vec4(1);
        white.dispersion = 0;
        b.add(b.ball(5, white));
        RenderScene scene;
        scene.camera = looking(Vec3(0, -30, 0));
        scene.lights = {around(Vec3(1))};
        const Film film = drawn(b.finish(), scene, path_options(64)).film;
        INFO(name);
        CHECK(mean(film).x == Approx(1).epsilon(5e-3));
    }
}

TEST_CASE("lamps found by chance and lamps sampled are weighed to the same light as lamps sampled alone") {
    // A glossy floor under a ball lamp; the distributed integrator samples the lamp only. One bounce: no light between surfaces.
    SceneBuilder b;
    Material floor = preset("plastic");
    floor.roughness = 0.4;
    b.add(b.box(Vec3(-500, -500, -1), Vec3(500, 500, 0), floor));
    const Solid solid = b.finish();
    PointLight p;
    p.p = Vec3(0, 40, 40);
    p.radius = 12;
    RenderScene scene;
    scene.camera = looking(Vec3(0, -40, 40), Vec3(0), 30);
    scene.lights = {lamp(p)};
    RenderOptions options = path_options(1024);
    const Vec3 path = mean(drawn(solid, scene, options).film);
    options.integrator = Integrator::kDistributed;
    const Vec3 distributed = mean(drawn(solid, scene, options).film);
    CHECK(path.x == Approx(distributed.x).epsilon(5e-3));
    CHECK(path.z == Approx(distributed.z).epsilon(5e-3));
}

TEST_CASE("a camera inside of glass sees a white room as white") {
    for (double roughness : {0.0, 0.6}) {
        SceneBuilder b;
        Material glass = preset("glass");
        glass.roughness = roughness;
        b.add(b.ball(10, glass));
        const Film film = drawn(b.finish(), from_within({around(Vec3(1))}), path_options(256)).film;
        INFO("roughness " << roughness);
        CHECK(mean(film).x == Approx(1).epsilon(5e-3));
    }
}

TEST_CASE("paths and photons agree tile by tile in a room of matte, glossy and clear things") {
    // 16 x 16 pixels a tile; chi-square of 4 degrees, of the 4 pictures compared in these tests together once in a thousand: 23.5.
    SceneBuilder b;
    Material plastic = preset("plastic");
    plastic.color = Vec4(0.3, 0.5, 0.8, 1);
    b.add(b.box(Vec3(-30, -30, -1), Vec3(30, 30, 0), matte(0.8, 0.7, 0.6)));
    b.add(b.box(Vec3(-12, 4, 0), Vec3(-4, 12, 9), plastic));
    b.add(b.ball(5, preset("glass"), moved(5, 0, 6)));
    const Solid solid = b.finish();
    PointLight p;
    p.p = Vec3(18, -12, 32);
    p.radius = 7;
    RenderScene scene;
    scene.camera = looking(Vec3(4, -60, 40), Vec3(0, 2, 3), 30);
    scene.lights = {lamp(p), around(Vec3(0.1))};
    RenderOptions o = path_options(128);
    o.width = o.height = 32;
    o.filter = FilterKind::kBox;
    o.max_depth = 12;
    const auto tiles = [&](Integrator kind) {
        o.integrator = kind;
        const Film film = drawn(solid, scene, o).film;
        std::vector<Vec2> sums(4, Vec2(0));
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const std::size_t i = film.index(x, y);
                const Vec3 c = film.color(i);
                sums[static_cast<std::size_t>(y / 16 * 2 + x / 16)] += Vec2(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z, film.variance(i));
            }
        return sums;
    };
    const std::vector<Vec2> path = tiles(Integrator::kPath), light = tiles(Integrator::kCaustics);
    double chi2 = 0;
    for (std::size_t i = 0; i < 4; ++i) chi2 += (path[i].x - light[i].x) * (path[i].x - light[i].x) / (path[i].y + light[i].y);
    CHECK(chi2 < 23.5);
}
