// Shadows, mirrors and refractions have no epsilon: the same picture at every scale and place.
#include "scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// A floor, a mirroring ball, a lens, and a shell of glass whose wall is 1e-9 of its size.
Film picture(double scale, const Vec3& shift = Vec3(0)) {
    SceneBuilder b;
    const auto at = [&](double x, double y, double z) { return Placement::translation(scale * Vec3(x, y, z) + shift); };
    const auto ball = [&](double r, const char* what, const Placement& p) { return b.ball(r * scale, preset(what), p); };
    Use floor = b.box(Vec3(-50, -50, -1) * scale, Vec3(50, 50, 0) * scale, matte(1, 0.75, 0.5));
    floor.placement = at(0, 0, 0);
    b.add(floor);
    b.add(ball(8, "mirror", at(-14, 6, 8)));
    b.add(ball(5, "glass", at(10, -16, 5)));
    b.add(b.combined(SetOp::kDifference, {ball(9, "glass", at(12, 4, 9)), ball(9 * (1 - 1e-9), "glass", at(12, 4, 9))}));
    PointLight p;
    p.p = scale * Vec3(30, -20, 60) + shift;
    RenderScene scene;
    scene.camera = looking(scale * Vec3(0, -80, 50) + shift, scale * Vec3(0, 0, 6) + shift, 30);
    scene.lights = {lamp(p), around(Vec3(0.5))};
    RenderOptions options = small_options();
    options.width = 64;
    options.height = 48;
    return drawn(b.finish(), scene, options).film;
}

int different(const Film& a, const Film& b, double room) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += glm::length(a.color(i) - b.color(i)) > room * (1 + glm::length(a.color(i)));
    return count;
}

}  // namespace

TEST_CASE("mirrors and glass and shadows are the same to the bit at powers of two, and within 1e-6 at other scales and places") {
    const Film one = picture(1);
    for (const double scale : {0x1p-20, 0x1p-3, 0x1p20}) CHECK(picture(scale).pixels == one.pixels);
    for (const double scale : {1e-6, 1e-3, 7.3, 1e6}) {
        INFO("scale " << scale);
        CHECK(different(one, picture(scale), 1e-6) == 0);
    }
    // The lamp's rays too, which are aimed by boxes around what focuses: nothing of those may be rounded by more than the scene is.
    for (const Vec3& shift : {Vec3(128, -256, 64), Vec3(1000.1, 20, -3000)}) CHECK(different(one, picture(1, shift), 1e-6) == 0);
}
