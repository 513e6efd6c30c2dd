// Rough surfaces give back what they get, and the same both ways.
#include "scenes.h"

#include <cmath>

#include "tracer/light/bsdf.h"
#include "tracer/light/microsurface.h"
#include "tracer/light/sampler.h"

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr Vec3 kUp{0, 0, 1};

Vec3 at_cosine(double cosine, double turn = 0) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

Surface metal(double roughness, const char* name = "mirror") {
    Material m = preset(name);
    if (std::string(name) == "mirror") m.color = Vec4(1);
    m.roughness = roughness;
    return *resolve_surface(m);
}

Surface white_plastic(double roughness) {
    Material m = preset("plastic");
    m.color = Vec4(1);
    m.roughness = roughness;
    return *resolve_surface(m);
}

// What a surface makes of white light from everywhere, by its own draws.
double albedo(const Surface& s, double cosine) {
    const Bsdf bsdf(s, kUp, at_cosine(cosine));
    // Squares about the middle of the draws, dense at the rim, where the tail of the lobe is.
    const int rings = 160, places = 160;
    double sum = 0, weights = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < places; ++j) {
            const double v = (i + 0.5) / rings, half = 0.5 * std::sqrt(1 - v * v * v * v), along = 4 * (j + 0.5) / places, off = (along - std::floor(along)) * 2 - 1;
            const std::array<Vec2, 4> corners{Vec2(1, off), Vec2(-off, 1), Vec2(-1, -off), Vec2(off, -1)};
            const Vec2 u = Vec2(0.5) + half * corners[static_cast<std::size_t>(along)];
            weights += v * v * v;
            for (double choice : {0.0, 0.999999}) {
                // Both lobes at the same places; their draws weigh by the chance of either.
                const Bsdf::Drawn d = bsdf.draw(u, choice);
                if (d.density > 0) sum += v * v * v * d.share.x * (choice > 0.5 ? 1 - bsdf.gloss_chance() : bsdf.gloss_chance());
            }
        }
    return sum / weights;
}

// A direction at random, by the cosine, within a band of cosines.
Vec3 in_band(double low, double high, Stream& stream) {
    return at_cosine(std::sqrt(glm::mix(low * low, high * high, stream.next())), 2 * kPi * stream.next());
}

struct Bands {
    double low_a, high_a, low_b, high_b;
};

// Share of rays from band a, in front, that leave in band b (behind: through).
double flow(const Bands& bands, double eta, double alpha, bool through, int count) {
    Stream stream({0.3, eta / 10});
    int arrived = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 from = in_band(bands.low_a, bands.high_a, stream);
        const MicroWalk walk = walk_microsurface(-from, kUp, {eta, eta, eta, eta}, alpha, {stream.next(), stream.next()}, Stream({stream.next(), stream.next()}));
        const double cosine = std::abs(walk.direction.z);
        arrived += walk.left && walk.through == through && cosine >= bands.low_b && cosine < bands.high_b;
    }
    return static_cast<double>(arrived) / count;
}

}  // namespace

TEST_CASE("white furnace: a conductor of reflectance 1 returns all of the light, to 1e-3") {
    for (double roughness : {0.2, 0.4, 0.6, 0.8, 1.0})
        for (double cosine : {0.05, 0.2, 0.5, 0.8, 1.0}) {
            INFO("roughness " << roughness << " cosine " << cosine);
            CHECK(albedo(metal(roughness), cosine) == Approx(1).margin(1e-3));
        }
}

TEST_CASE("white furnace: white plastic returns all of the light") {
    for (double roughness : {0.2, 0.5, 1.0})
        for (double cosine : {0.1, 0.4, 0.9}) {
            INFO("roughness " << roughness << " cosine " << cosine);
            CHECK(albedo(white_plastic(roughness), cosine) == Approx(1).margin(2e-3));
        }
}

TEST_CASE("one bounce only would lose a third of the light on the roughest metal") {
    Surface uncompensated = metal(1);
    uncompensated.energy = nullptr;
    CHECK(albedo(uncompensated, 0.5) < 0.75);
}

TEST_CASE("scattering is reciprocal") {
    for (const Surface& s : {metal(0.5), metal(0.9, "gold"), metal(0.3, "copper"), white_plastic(0.3), white_plastic(0.9)})
        for (double a : {0.1, 0.45, 0.9})
            for (double b : {0.2, 0.6, 0.99}) {
                const Vec3 from = at_cosine(a), to = at_cosine(b, 2);
                const Vec3 there = Bsdf(s, kUp, to).value(from, a), back = Bsdf(s, kUp, from).value(to, b);
                for (int c = 0; c < 3; ++c) CHECK(there[c] == Approx(back[c]).epsilon(1e-12));
            }
}

TEST_CASE("rough glass loses no light: every walk leaves the border") {
    Stream stream({0.1, 0.2});
    for (double eta : {1 / 1.5, 1.5, 1 / 2.4, 2.4})
        for (double alpha : {0.04, 0.3, 1.0}) {
            int left = 0;
            const int count = 4000;
            for (int i = 0; i < count; ++i)
                left += walk_microsurface(-at_cosine(0.05 + 0.9 * stream.next()), kUp, {eta, eta, eta, eta}, alpha, {stream.next(), stream.next()},
                                          Stream({stream.next(), stream.next()})).left;
            CHECK(left == count);
        }
}

TEST_CASE("rough glass is reciprocal: as much flows one way as the other, by solid angle, cosine and index squared") {
    const Bands bands{0.3, 0.6, 0.75, 0.95};
    const Bands turned{bands.low_b, bands.high_b, bands.low_a, bands.high_a};
    const auto etendue = [](double low, double high) { return kPi * (high * high - low * low); };
    const double a = etendue(bands.low_a, bands.high_a), b = etendue(bands.low_b, bands.high_b);
    const int count = 80000;
    for (double alpha : {0.3, 0.8}) {
        INFO("alpha " << alpha);
        CHECK(flow(bands, 1 / 1.5, alpha, false, count) * a == Approx(flow(turned, 1 / 1.5, alpha, false, count) * b).epsilon(0.05));
        CHECK(flow(bands, 1 / 1.5, alpha, true, count) * a == Approx(flow(turned, 1.5, alpha, true, count) * b * 1.5 * 1.5).epsilon(0.05));
    }
}

TEST_CASE("white furnace: rough glass cannot be seen, to 5e-3") {
    for (double roughness : {0.3, 0.7, 1.0}) {
        SceneBuilder b;
        Material glass = preset("glass");
        glass.roughness = roughness;
        b.add(b.ball(5, glass));
        RenderScene scene;
        scene.camera = looking(Vec3(0, -30, 0));
        scene.lights = {around(Vec3(1))};
        RenderOptions o = small_options();
        o.width = o.height = 8;
        o.samples = 256;
        o.integrator = Integrator::kPath;
        o.max_depth = 400;
        const Film film = drawn(b.finish(), scene, o).film;
        double mean = 0;
        for (std::size_t i = 0; i < film.pixels.size(); ++i) mean += film.color(i).x / static_cast<double>(film.pixels.size());
        INFO("roughness " << roughness);
        CHECK(mean == Approx(1).epsilon(5e-3));
    }
}

TEST_CASE("metals by name reflect in front what their index and extinction say") {
    const auto front = [](const char* name) { return metal_reflectance(metal(0.2, name), 1); };
    // ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) by hand.
    CHECK(front("gold").x == Approx((0.85 * 0.85 + 3.6 * 3.6) / (1.15 * 1.15 + 3.6 * 3.6)));
    CHECK(front("gold").x > 1.9 * front("gold").z);
    CHECK(front("copper").x > 1.4 * front("copper").y);
    CHECK(front("silver").z > 0.94);
    for (const char* name : {"gold", "silver", "copper", "steel"}) CHECK(metal_reflectance(metal(0.2, name), 0).y == Approx(1));
    Material painted = preset("gold");
    painted.color = Vec4(0, 0, 1, 1);
    CHECK(metal_reflectance(*resolve_surface(painted), 1).x == Approx(0).margin(1e-12));
}
