// What light does at surfaces, against closed forms.
#include "scenes.h"

#include <cmath>

#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

using namespace whittle;
using namespace whittle::test;

namespace {

const Vec3 kWhite(1);

// A floor z <= 0 seen from above.
SceneBuilder floor_scene(const Material& m = matte(1, 1, 1)) {
    SceneBuilder b;
    b.add(b.box(Vec3(-50, -50, -1), Vec3(50, 50, 0), m));
    return b;
}

RenderScene seen_from(Vec3 eye, std::vector<Light> lights) {
    RenderScene scene;
    scene.camera = looking(eye);
    scene.lights = std::move(lights);
    return scene;
}

RenderOptions with_odd_size() {
    RenderOptions o = small_options();
    o.width = o.height = 17;
    return o;
}

}  // namespace

TEST_CASE("a point light on a matte floor is I cos / d^2 / pi") {
    PointLight p;
    p.p = Vec3(3, 0, 4);
    p.power = 400;
    const Film film = drawn(floor_scene(matte(1, 1, 1)).finish(), seen_from(Vec3(0, -1, 90), {lamp(p)}), with_odd_size()).film;
    CHECK(middle(film).x == Approx(400 / (4 * kPi) / 25 * (4.0 / 5) / kPi));
}

TEST_CASE("a shadow ray is counted for every hit and lamp, none without lamps") {
    PointLight p;
    p.p = Vec3(3, 0, 40);
    const Solid solid = floor_scene().finish();
    const RenderResult two = drawn(solid, seen_from(Vec3(0, -1, 90), {lamp(p), lamp(p)}), with_odd_size());
    CHECK(two.counters.camera == 17 * 17);
    CHECK(two.counters.shadow == 2 * 17 * 17);
    const RenderResult none = drawn(solid, seen_from(Vec3(0, -1, 90), {around(kWhite)}), with_odd_size());
    CHECK(none.counters.shadow == 0);
    CHECK(none.counters.skipped_shadows == 17 * 17);
    CHECK(none.counters.skipped_media == 17 * 17);
    CHECK(middle(none.film).x == Approx(1));
}

TEST_CASE("an area lamp costs hits x lamps x samples") {
    PointLight p;
    p.p = Vec3(30, 0, 40);
    p.radius = 2;
    RenderOptions options = with_odd_size();
    options.light_samples = 10;
    const RenderResult r = drawn(floor_scene().finish(), seen_from(Vec3(0, -1, 90), {lamp(p)}), options);
    CHECK(r.integrator == Integrator::kDistributed);
    CHECK(r.counters.shadow == 17 * 17 * 10);
}

TEST_CASE("a ball lamp's penumbra reaches as far as the tangents say") {
    // A slab over y < 0, its edge at y = 0 from z = 10 to 11; the ball (r = 2) at z = 31 above the edge; the floor seen from below the slab.
    SceneBuilder b = floor_scene();
    b.add(b.box(Vec3(-40, -40, 10), Vec3(40, 0, 11), matte(1, 1, 1)));
    PointLight p;
    p.p = Vec3(0, 0, 31);
    p.radius = 2;
    RenderOptions options = small_options();
    options.width = 1;
    options.height = 1201;
    options.light_samples = 64;
    options.aovs = aov_bit(Aov::kPosition);
    RenderScene scene;
    scene.lights = {lamp(p)};
    scene.camera = looking(Vec3(0, 20, 9), Vec3(0), 60);
    const Film film = drawn(b.finish(), scene, options).film;
    double brightest = 0, dark_until = -100, lit_from = 100;
    const auto each = [&](auto use) {
        for (std::size_t i = 0; i < film.pixels.size(); ++i) {
            const float* at = &film.planes[static_cast<int>(Aov::kPosition)][i * 3];
            if (film.coverage(i) > 0 && std::abs(at[2]) < 1e-4f && std::abs(at[1]) < 3) use(static_cast<double>(at[1]), film.color(i).x);
        }
    };
    each([&](double, double light) { brightest = std::max(brightest, light); });
    each([&](double y, double light) {
        if (light <= 0) dark_until = std::max(dark_until, y);
        if (light >= 0.95 * brightest) lit_from = std::min(lit_from, y);
    });
    // Tangents at the slab's lower edge (21 below the ball) and upper edge (20 below). One sample of 64, and five percent, are the disc's caps of height
    // 0.11 r and 0.2 r.
    const double dark = -10 * 2 / std::sqrt(21.0 * 21 - 4), lit = 11 * 2 / std::sqrt(20.0 * 20 - 4);
    CHECK(dark_until > dark - 0.05);
    CHECK(dark_until < dark * 0.75);
    CHECK(lit_from > lit * 0.7);
    CHECK(lit_from < lit + 0.05);
}

TEST_CASE("two facing mirrors show what the depth allows, each image weaker by the reflectance") {
    // Rays at 45 degrees: y = 5 at z = 5, y = -5 at z = 15, then the glowing box.
    SceneBuilder b;
    Material glow = preset("emissive");
    glow.emission = Vec3(7);
    b.add(b.box(Vec3(-50, 5, -50), Vec3(50, 6, 50), preset("mirror")));
    b.add(b.box(Vec3(-50, -6, 2), Vec3(50, -5, 50), preset("mirror")));
    b.add(b.box(Vec3(-50, 3, 23.5), Vec3(50, 4.9, 26), glow));
    const Solid solid = b.finish();
    RenderOptions options = with_odd_size();
    RenderScene scene = seen_from(Vec3(0), {around(Vec3(0))});
    scene.camera = looking(Vec3(0), Vec3(0, 5, 5), 1);
    const double reflectance = fresnel_schlick(0.95, std::sqrt(0.5));
    for (int depth : {0, 1, 2, 3}) {
        options.max_depth = depth;
        INFO("depth " << depth);
        CHECK(middle(drawn(solid, scene, options).film).x == Approx(depth < 2 ? 0 : 7 * reflectance * reflectance));
    }
}

TEST_CASE("absorption is exponential in the length inside") {
    SceneBuilder b;
    Material tinted = preset("glass");
    tinted.ior = 1;
    tinted.absorption = Vec3(0.1, 0.2, 0);
    b.add(b.box(Vec3(-10, 0, -10), Vec3(10, 7, 10), tinted));
    const Film film = drawn(b.finish(), seen_from(Vec3(0, -50, 0), {around(kWhite)}), with_odd_size()).film;
    CHECK(middle(film).x == Approx(std::exp(-0.7)).epsilon(1e-4));
    CHECK(middle(film).y == Approx(std::exp(-1.4)).epsilon(1e-4));
    CHECK(middle(film).z == Approx(1).epsilon(1e-4));
}

TEST_CASE("a pane in a white room is white: what is not reflected is let through") {
    SceneBuilder b;
    b.add(b.box(Vec3(-10, 0, -10), Vec3(10, 1, 10), preset("glass")));
    const Film film = drawn(b.finish(), seen_from(Vec3(0, -50, 20), {around(kWhite)}), with_odd_size()).film;
    CHECK(middle(film).x == Approx(1).epsilon(5e-3));
}

TEST_CASE("a white pane's mirror image is weaker by Fresnel's formula") {
    // Black room but for a glowing wall behind the camera: seen in both faces of the pane, a white floor of reflections summed by hand.
    SceneBuilder b;
    Material glow = preset("emissive");
    glow.emission = Vec3(1);
    b.add(b.box(Vec3(-10, 0, -10), Vec3(10, 1, 10), preset("glass")));
    b.add(b.box(Vec3(-100, -61, -100), Vec3(100, -60, 100), glow));
    const Film film = drawn(b.finish(), seen_from(Vec3(0, -50, 0), {around(Vec3(0))}), with_odd_size()).film;
    // Both faces, all orders: 2R/(1+R).
    CHECK(middle(film).x == Approx(2 * 0.04 / 1.04).epsilon(0.03));
}

TEST_CASE("liquid in a glass: overlapping and touching walls give the same picture") {
    const auto glass_of_water = [](double water_radius, double priority) {
        SceneBuilder b;
        Material glass = preset("glass"), water = preset("water");
        glass.priority = priority;
        b.add(b.combined(SetOp::kDifference, {b.rod(0, 20, 10, glass), b.rod(2, 21, 8)}));
        b.add(b.rod(2, 15, water_radius, water));
        b.add(b.box(Vec3(-30, 15, -5), Vec3(30, 16, 40), matte(0.9, 0.2, 0.1)));
        return b.finish();
    };
    RenderScene scene = seen_from(Vec3(0, -80, 30), {around(kWhite)});
    scene.camera->target = Vec3(0, 0, 10);
    const Film touching = drawn(glass_of_water(8, 0), scene, small_options()).film;
    const Film overlapping = drawn(glass_of_water(9, 1), scene, small_options()).film;
    const Film gap = drawn(glass_of_water(7.9, 0), scene, small_options()).film;
    double worst = 0, worst_gap = 0;
    for (std::size_t i = 0; i < touching.pixels.size(); ++i) {
        worst = std::max(worst, glm::length(touching.color(i) - overlapping.color(i)));
        worst_gap = std::max(worst_gap, glm::length(touching.color(i) - gap.color(i)));
    }
    CHECK(worst < 1e-9);
    CHECK(worst_gap > 0.05);
}

TEST_CASE("of a ball and a clear block that overlap the first in the text shows, unless priorities say otherwise") {
    const auto green_seen = [](bool ball_first, double block_priority) {
        SceneBuilder b;
        Material clear = preset("glass");
        clear.ior = 1;
        clear.priority = block_priority;
        const Use block = b.box(Vec3(-10), Vec3(10), clear), ball = b.ball(5, matte(1, 0, 0));
        b.add(ball_first ? ball : block);
        b.add(ball_first ? block : ball);
        // Another red thing aside, written first: what is opaque is not one part.
        b.add(b.box(Vec3(40, 0, 0), Vec3(41, 1, 1), matte(1, 0, 0)));
        const Vec3 seen = middle(drawn(b.finish(), seen_from(Vec3(0, -50, 0), {around(kWhite)}), with_odd_size()).film);
        CHECK(seen.x == Approx(1).epsilon(1e-6));
        return seen.y;
    };
    CHECK(green_seen(true, 0) == Approx(0).margin(1e-6));
    CHECK(green_seen(false, 0) == Approx(1));
    CHECK(green_seen(true, 1) == Approx(1));
    CHECK(green_seen(false, -1) == Approx(0).margin(1e-6));
}

TEST_CASE("of two opaque things in a clear block the one written before it shows, the one after does not") {
    SceneBuilder b;
    Material clear = preset("glass");
    clear.ior = 1;
    b.add(b.ball(3, matte(1, 0, 0), moved(-6, 0, 0)));
    b.add(b.box(Vec3(-10), Vec3(10), clear));
    b.add(b.ball(3, matte(1, 0, 0), moved(6, 0, 0)));
    const Solid solid = b.finish();
    const auto green_at = [&](double x) {
        RenderScene scene = seen_from(Vec3(x, -50, 0), {around(kWhite)});
        scene.camera->target = Vec3(x, 0, 0);
        return middle(drawn(solid, scene, with_odd_size()).film).y;
    };
    CHECK(green_at(-6) == Approx(0).margin(1e-6));
    CHECK(green_at(6) == Approx(1));
}

TEST_CASE("a cutter's colour tints the face it cuts into glass, which stays glass") {
    const auto cut = [](const Material& cutter) {
        SceneBuilder b;
        Material glass = preset("glass");
        glass.ior = 1;
        b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-10), Vec3(10), glass), b.box(Vec3(-20, -20, -20), Vec3(20, 0, 20), cutter)}));
        return middle(drawn(b.finish(), seen_from(Vec3(0, -50, 0), {around(kWhite)}), with_odd_size()).film);
    };
    Material red;
    red.color = Vec4(1, 0, 0, 1);
    CHECK(cut(Material{}).y == Approx(1).epsilon(1e-3));
    CHECK(cut(red).x == Approx(1).epsilon(1e-3));
    CHECK(cut(red).y == Approx(0).margin(1e-3));
}

TEST_CASE("an opaque cutter without colour leaves the face in the solid's colour, a coloured one in its own") {
    const auto cut = [](const Material& cutter) {
        SceneBuilder b;
        b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-10), Vec3(10), matte(0, 1, 0)), b.box(Vec3(-20, -20, -20), Vec3(20, 0, 20), cutter)}));
        return middle(drawn(b.finish(), seen_from(Vec3(0, -50, 0), {around(kWhite)}), with_odd_size()).film);
    };
    CHECK(cut(Material{}).x == Approx(0).margin(1e-9));
    CHECK(cut(Material{}).y == Approx(1));
    CHECK(cut(matte(1, 0, 0)).x == Approx(1));
}

TEST_CASE("half transparent colour shows half of what is behind") {
    SceneBuilder b;
    Material veil = preset("matte");
    veil.color = Vec4(0, 0, 0, 0.5);
    b.add(b.box(Vec3(-10, 0, -10), Vec3(10, 1, 10), veil));
    b.add(b.box(Vec3(-10, 20, -10), Vec3(10, 21, 10), matte(1, 1, 1)));
    const Film film = drawn(b.finish(), seen_from(Vec3(0, -50, 0), {around(kWhite)}), with_odd_size()).film;
    // Two faces of the veil, each lets a half through.
    CHECK(middle(film).x == Approx(0.25));
}

TEST_CASE("contact shadows are the same at every scale") {
    const auto picture = [](double scale) {
        SceneBuilder b;
        b.add(b.box(Vec3(-50, -50, -1) * scale, Vec3(50, 50, 0) * scale, matte(1, 1, 1)));
        b.add(b.ball(10 * scale, matte(0.5, 0.5, 1), moved(0, 0, 10 * scale)));
        PointLight p;
        p.p = Vec3(30, -20, 60) * scale;
        RenderScene scene = seen_from(Vec3(20, -80, 70) * scale, {lamp(p)});
        return drawn(b.finish(), scene, small_options()).film;
    };
    const Film one = picture(1);
    for (double scale : {0x1p-20, 0x1p20, 1e-6, 1e6}) {
        const Film other = picture(scale);
        int different = 0;
        for (std::size_t i = 0; i < one.pixels.size(); ++i) different += glm::length(one.color(i) - other.color(i)) > 1e-6 * (1 + glm::length(one.color(i)));
        INFO("scale " << scale);
        CHECK(different == 0);
    }
}

TEST_CASE("the picture follows the integrator that shows all its matter") {
    const auto chosen = [](const Material& m, std::vector<Light> lights = {}) {
        SceneBuilder b;
        b.add(b.ball(5, m));
        RenderOptions o = small_options();
        o.width = o.height = 4;
        return drawn(b.finish(), seen_from(Vec3(0, -50, 0), std::move(lights)), o).integrator;
    };
    CHECK(chosen(Material{}) == Integrator::kWhitted);
    CHECK(chosen(preset("glass")) == Integrator::kWhitted);
    CHECK(chosen(preset("brushed")) == Integrator::kDistributed);
    PointLight soft;
    soft.radius = 3;
    soft.p = Vec3(30);
    CHECK(chosen(Material{}, {lamp(soft)}) == Integrator::kDistributed);
}

TEST_CASE("an unknown material is an error that lists the known ones") {
    SceneBuilder b;
    b.add(b.ball(5, preset("cheese")));
    const Solid solid = b.finish();
    const auto program = compile(solid);
    REQUIRE(program);
    RenderControl control;
    const Result<RenderResult> result = render(*program, {}, small_options(), control);
    REQUIRE(!result);
    CHECK(result.error().fault == Fault::kScene);
    CHECK(result.error().message.find("cheese") != std::string::npos);
    CHECK(result.error().message.find("brushed") != std::string::npos);
}
