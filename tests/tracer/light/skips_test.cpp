// Passes that only save work: switched off, the picture keeps its bits and the counters of the work rise.
#include "scenes.h"

#include "csg/base/passes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// A block and a ball of the given matter on a matte floor.
Solid still_life(const Material& ball) {
    SceneBuilder b;
    b.add(b.box(Vec3(-30, -30, -1), Vec3(30, 30, 0), matte(0.8, 0.7, 0.6)));
    b.add(b.box(Vec3(-12, 4, 0), Vec3(-4, 12, 9), matte(0.3, 0.5, 0.8)));
    b.add(b.ball(5, ball, moved(5, 0, 6)));
    return b.finish();
}

PointLight lamp_above(double power = 3e4) {
    PointLight p;
    p.p = Vec3(18, -12, 32);
    p.power = power;
    return p;
}

RenderScene lit_by(std::vector<Light> lights) {
    RenderScene scene;
    scene.camera = looking(Vec3(4, -60, 40), Vec3(0, 2, 3), 30);
    scene.lights = std::move(lights);
    return scene;
}

struct Both {
    RenderCounters with, without;  // the pass
};

// Counters of both; checks that the bits are the same.
Both both_ways(const char* pass, const Solid& solid, const RenderScene& scene, Integrator integrator) {
    INFO(pass << " by " << integrator_name(integrator));
    RenderOptions o = small_options();
    o.samples = 4;
    o.integrator = integrator;
    const RenderResult with = drawn(solid, scene, o);
    o.disabled_passes = {pass};
    const RenderResult without = drawn(solid, scene, o);
    CHECK(with.film.pixels == without.film.pixels);
    return {with.counters, without.counters};
}

const std::vector<Integrator> kAll{Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath, Integrator::kCaustics};

}  // namespace

TEST_CASE("every pass of the light is in the table") {
    for (const char* name : {"shadows", "media", "photons", "spectrum", "lens", "shutter", "areas", "packets"}) {
        INFO(name);
        CHECK(std::any_of(known_passes().begin(), known_passes().end(), [&](const PassInfo& p) { return p.name == name; }));
    }
}

TEST_CASE("lamps that give no light get no shadow rays") {
    const Solid solid = still_life(matte(0.5, 0.5, 0.5));
    for (Integrator kind : kAll) {
        const Both black = both_ways("shadows", solid, lit_by({lamp(lamp_above(0)), around(Vec3(0.5))}), kind);
        CHECK(black.with.skipped_shadows == black.with.camera);
        CHECK(black.without.skipped_shadows == 0);
        // Distributed and path also look for the sky.
        CHECK(black.without.shadow >= black.with.shadow + 32 * 24);
        if (kind == Integrator::kWhitted) CHECK(black.with.shadow == 0);
    }
}

TEST_CASE("among opaque things no matter is kept along a shadow ray") {
    const Solid solid = still_life(matte(0.5, 0.5, 0.5));
    for (Integrator kind : kAll) {
        const Both media = both_ways("media", solid, lit_by({lamp(lamp_above())}), kind);
        CHECK(media.with.media_stack == 0);
        CHECK(media.with.skipped_media == media.with.camera);
        CHECK(media.without.media_stack >= 32 * 24);
        CHECK(media.without.skipped_media == 0);
    }
}

TEST_CASE("where nothing between lamp and floor focuses light no photons are sent") {
    const Both photons = both_ways("photons", still_life(matte(0.5, 0.5, 0.5)), lit_by({lamp(lamp_above())}), Integrator::kCaustics);
    CHECK(photons.with.photons == 0);
    CHECK(photons.with.skipped_photons == photons.with.camera);
    CHECK(photons.without.photons > 0);
    CHECK(photons.without.skipped_photons == 0);
}

TEST_CASE("without dispersion a path has three channels and no wavelength") {
    for (Integrator kind : {Integrator::kDistributed, Integrator::kPath, Integrator::kCaustics}) {
        const Both spectrum = both_ways("spectrum", still_life(preset("glass")), lit_by({lamp(lamp_above())}), kind);
        CHECK(spectrum.with.draws == 0);
        CHECK(spectrum.with.wavelengths == 0);
        CHECK(spectrum.with.skipped_spectrum == spectrum.with.camera);
        CHECK(spectrum.without.draws > 0);
        CHECK(spectrum.without.skipped_spectrum == 0);
    }
}

TEST_CASE("without an aperture, a motion or a lamp with a size no places and times are drawn") {
    const Solid solid = still_life(matte(0.5, 0.5, 0.5));
    const RenderScene scene = lit_by({lamp(lamp_above())});
    for (Integrator kind : {Integrator::kDistributed, Integrator::kPath, Integrator::kCaustics})
        for (const char* pass : {"lens", "shutter", "areas"}) {
            const Both both = both_ways(pass, solid, scene, kind);
            CHECK(both.with.draws == 0);
            CHECK(both.without.draws >= 32 * 24);
            CHECK(both.with.skipped_lens == both.with.camera);
            CHECK(both.with.skipped_shutter == both.with.camera);
            CHECK(both.with.skipped_areas == both.with.camera);
            CHECK((both.without.skipped_lens == 0) == (std::string(pass) == "lens"));
            CHECK((both.without.skipped_shutter == 0) == (std::string(pass) == "shutter"));
            CHECK((both.without.skipped_areas == 0) == (std::string(pass) == "areas"));
        }
}

TEST_CASE("with all passes off the picture is still the same") {
    const Solid solid = still_life(preset("glass"));
    RenderOptions o = small_options();
    o.samples = 4;
    for (Integrator kind : kAll) {
        o.integrator = kind;
        o.disabled_passes = {};
        const Film film = drawn(solid, lit_by({lamp(lamp_above()), around(Vec3(0.2))}), o).film;
        for (const PassInfo& pass : known_passes()) o.disabled_passes.emplace_back(pass.name);
        CHECK(drawn(solid, lit_by({lamp(lamp_above()), around(Vec3(0.2))}), o).film.pixels == film.pixels);
    }
}
