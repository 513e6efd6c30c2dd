// Boxes whose radiosity is known: closed form for closed boxes and for plates, a numerical solution of the radiosity equation for a box of unlike walls.
#include "scenes.h"

#include <array>
#include <cmath>

#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Material wall_of(double albedo, double emission) {
    const double s = linear_to_srgb(albedo);
    Material m = matte(s, s, s);
    m.emission = Vec3(emission);
    return m;
}

RenderOptions paths(int samples, Integrator integrator) {
    RenderOptions o = small_options();
    o.width = o.height = 8;
    o.samples = samples;
    o.integrator = integrator;
    o.max_depth = 1000;
    return o;
}

double mean_light(const Film& film) {
    double sum = 0;
    for (std::size_t i = 0; i < film.pixels.size(); ++i) sum += film.color(i).x;
    return sum / static_cast<double>(film.pixels.size());
}

RenderScene within(Vec3 eye, Vec3 target) {
    RenderScene scene;
    scene.camera = looking(eye, target, 50);
    scene.lights = {around(Vec3(0))};
    return scene;
}

}  // namespace

TEST_CASE("in a closed box of albedo a that glows by e the radiance is e / (1 - a), in its corners too") {
    for (double albedo : {0.2, 0.5, 0.9}) {
        SceneBuilder b;
        b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-12, -8, -6), Vec3(12, 8, 6), wall_of(albedo, 1)), b.box(Vec3(-10, -7, -5), Vec3(10, 7, 5))}));
        const Solid solid = b.finish();
        for (const Vec3& target : {Vec3(10, 0, 0), Vec3(10, 7, 5), Vec3(-3, -7, -5)})
            for (Integrator kind : {Integrator::kPath, Integrator::kCaustics}) {
                INFO("albedo " << albedo << ", towards " << target.x << " by " << integrator_name(kind));
                CHECK(mean_light(drawn(solid, within(Vec3(1, 2, -1), target), paths(64, kind)).film) == Approx(1 / (1 - albedo)).epsilon(1e-2));
            }
    }
}

TEST_CASE("between two wide plates of albedos a and b, one of which glows, are e / (1 - a b) and b times that") {
    // 4 km wide, 1 mm apart: what leaves at the rim is less than a millionth.
    const double a = 0.6, c = 0.8, e = 2, wide = 2e6;
    SceneBuilder b;
    b.add(b.box(Vec3(-wide, -wide, -2), Vec3(wide, wide, 0), wall_of(a, e)));
    b.add(b.box(Vec3(-wide, -wide, 1), Vec3(wide, wide, 3), wall_of(c, 0)));
    const Solid solid = b.finish();
    const double below = e / (1 - a * c);
    CHECK(mean_light(drawn(solid, within(Vec3(0, 0, 0.5), Vec3(0, 0.1, 0)), paths(512, Integrator::kPath)).film) == Approx(below).epsilon(1e-2));
    CHECK(mean_light(drawn(solid, within(Vec3(0, 0, 0.5), Vec3(0, 0.1, 1)), paths(512, Integrator::kPath)).film) == Approx(c * below).epsilon(1e-2));
}

TEST_CASE("a cube with a glowing ceiling, a dark floor and grey walls sends the light that the radiosity equation says") {
    // The unknown is the radiosity over all six faces, each of n x n patches: Gathered by the patches' form factors between their middles, with one level of
    // finer patches where they are near. The mean of the floor is compared.
    constexpr int kSide = 12, kPatches = 6 * kSide * kSide;
    struct Patch { Vec3 p, n; };
    std::vector<Patch> patches;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double sign = face % 2 == 0 ? -1 : 1;
        for (int i = 0; i < kSide; ++i)
            for (int k = 0; k < kSide; ++k) {
                Patch x{Vec3(0), Vec3(0)};
                x.p[axis] = sign;
                x.p[(axis + 1) % 3] = (i + 0.5) * 2 / kSide - 1;
                x.p[(axis + 2) % 3] = (k + 0.5) * 2 / kSide - 1;
                x.n[axis] = -sign;
                patches.push_back(x);
            }
    }
    const auto on = [](int patch, int face) { return patch / (kSide * kSide) == face; };
    constexpr int kFloor = 4, kCeiling = 5;
    std::vector<double> albedo(kPatches), glow(kPatches, 0.0);
    for (int i = 0; i < kPatches; ++i) {
        albedo[static_cast<std::size_t>(i)] = on(i, kFloor) ? 0.3 : on(i, kCeiling) ? 0.5 : 0.7;
        if (on(i, kCeiling)) glow[static_cast<std::size_t>(i)] = 1;
    }
    std::vector<double> factors(static_cast<std::size_t>(kPatches) * kPatches, 0.0);
    const double cell = 2.0 / kSide;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        double sum = 0;
        double* row = &factors[i * kPatches];
        for (std::size_t k = 0; k < patches.size(); ++k) {
            if (patches[i].n == patches[k].n) continue;
            constexpr int kFine = 3;
            // The receiver's patch in 3 x 3.
            for (int s = 0; s < kFine * kFine; ++s) {
                const Vec3 u = cell * ((s % kFine + 0.5) / kFine - 0.5) * (patches[k].n.x != 0 ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
                const Vec3 v = cell * ((s / kFine + 0.5) / kFine - 0.5) * (patches[k].n.z != 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1));
                const Vec3 d = patches[k].p + u + v - patches[i].p;
                const double d2 = glm::dot(d, d), facing = glm::dot(d, patches[i].n), back = -glm::dot(d, patches[k].n);
                if (facing > 0 && back > 0) row[k] += facing * back / (kPi * d2 * d2) * cell * cell / (kFine * kFine);
            }
            sum += row[k];
        }
        // A closed box: the factors of a patch sum to one.
        for (std::size_t k = 0; k < patches.size(); ++k) row[k] /= sum;
    }
    std::vector<double> light = glow;
    for (int round = 0; round < 60; ++round) {
        std::vector<double> next = glow;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            double arrives = 0;
            for (std::size_t k = 0; k < patches.size(); ++k) arrives += factors[i * kPatches + k] * light[k];
            next[i] += albedo[i] * arrives;
        }
        light = std::move(next);
    }
    double floor = 0;
    for (int i = 0; i < kPatches; ++i)
        if (on(i, kFloor)) floor += light[static_cast<std::size_t>(i)] / (kSide * kSide);

    SceneBuilder b;
    const Material grey = wall_of(0.7, 0);
    b.add(b.box(Vec3(-1.2, -1.2, -1.2), Vec3(-1, 1.2, 1.2), grey));
    b.add(b.box(Vec3(1, -1.2, -1.2), Vec3(1.2, 1.2, 1.2), grey));
    b.add(b.box(Vec3(-1, -1.2, -1.2), Vec3(1, -1, 1.2), grey));
    b.add(b.box(Vec3(-1, 1, -1.2), Vec3(1, 1.2, 1.2), grey));
    b.add(b.box(Vec3(-1, -1, -1.2), Vec3(1, 1, -1), wall_of(0.3, 0)));
    b.add(b.box(Vec3(-1, -1, 1), Vec3(1, 1, 1.2), wall_of(0.5, 1)));
    // Parallel rays that begin under the ceiling meet the whole floor evenly.
    RenderScene scene = within(Vec3(0, 0, 0.9), Vec3(0, 0, -1));
    scene.camera->up = Vec3(0, 1, 0);
    scene.camera->orthographic = true;
    scene.camera->fov_deg = 2 * std::atan(1 / 1.9) * 180 / kPi;
    RenderOptions o = paths(512, Integrator::kPath);
    o.filter = FilterKind::kBox;
    CHECK(mean_light(drawn(b.finish(), scene, o).film) == Approx(floor).epsilon(1e-2));
}
