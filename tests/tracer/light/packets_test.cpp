// Rays met together are the rays met alone.
#include "scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// Compares the films with and without packets; returns the rays that packets answered.
std::uint64_t same_film(const Solid& solid, const RenderScene& scene, RenderOptions options) {
    const RenderResult together = drawn(solid, scene, options);
    options.disabled_passes = {"packets"};
    const RenderResult alone = drawn(solid, scene, options);
    CHECK(together.film.pixels == alone.film.pixels);
    CHECK(together.counters.shadow == alone.counters.shadow);
    CHECK(alone.counters.engine.packet_rays == 0);
    return together.counters.engine.packet_rays;
}

}  // namespace

TEST_CASE("a picture has the same bits with its rays in packets and alone, by every integrator") {
    SceneBuilder clear;
    clear.add(clear.ball(8, preset("glass")));
    clear.add(clear.box(Vec3(-30, -30, -12), Vec3(30, 30, -8), matte(0.5, 0.5, 0.5)));
    const Solid opaque = classic(), glass = clear.finish();
    RenderOptions options = small_options();
    options.samples = 3;
    for (const Integrator integrator : {Integrator::kPreview, Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath}) {
        options.integrator = integrator;
        INFO(integrator_name(integrator));
        CHECK(same_film(opaque, {}, options) > 1000);
        CHECK(same_film(glass, {}, options) > 1000);
    }
}

TEST_CASE("shadows of many lamps are asked together, and those of too many as they come") {
    const Solid solid = classic();
    RenderOptions options = small_options();
    options.integrator = Integrator::kWhitted;
    for (const int lamps : {1, 3, 40}) {
        RenderScene scene;
        for (int i = 0; i < lamps; ++i) {
            PointLight p;
            p.p = Vec3(30 - i, -60, 20 + 3 * i);
            scene.lights.push_back(lamp(p));
        }
        scene.camera = looking(Vec3(40, -60, 50));
        CHECK(same_film(solid, scene, options) > 500);
    }
}
