#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <random>

#include <hwy/targets.h>

#include "tracer/light/camera.h"
#include "tracer/light/lanes.h"
#include "tracer/light/lights.h"
#include "tracer/light/scattering.h"

using namespace whittle;

namespace {

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same(Vec3 a, Vec3 b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

struct Numbers {
    lanes::Row<std::uint32_t> x, y, keys, indices, u, v;
};

// Of `count` pixels here and there.
Numbers numbers_of(std::uint64_t seed, std::uint32_t index, const PairOf& draw, std::size_t count) {
    Numbers n;
    for (std::size_t k = 0; k < count; ++k) n.x[k] = static_cast<std::uint32_t>(k * 37 % 5000), n.y[k] = static_cast<std::uint32_t>(k * k % 3001);
    lanes::keys_of(seed, n.x.data(), n.y.data(), count, n.keys.data());
    for (std::size_t k = 0; k < count; ++k) n.indices[k] = index + static_cast<std::uint32_t>(k % 3);
    lanes::pairs_of(n.keys.data(), n.indices.data(), count, draw, n.u.data(), n.v.data());
    return n;
}

template <class Check>
void on_every_target(const Check& check) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        INFO(hwy::TargetName(target));
        check();
    }
    hwy::SetSupportedTargetsForTest(0);
}

constexpr std::size_t kCounts[] = {1, 3, 16, 17, 200, 256};

}  // namespace

TEST_CASE("numbers drawn for many pixels are those of each") {
    on_every_target([] {
        for (const std::size_t count : kCounts)
            for (const PairOf draw : {PairOf{Draw::kPixel}, PairOf{Draw::kLight, 65, 2, 5}, PairOf{Draw::kLobe, 3}})
                for (const std::uint32_t index : {0U, 7U, 0xffffffffU}) {
                    const Numbers n = numbers_of(1ULL << 40 | 9, index, draw, count);
                    std::size_t wrong = 0;
                    for (std::size_t k = 0; k < count; ++k) {
                        const Sampler one(1ULL << 40 | 9, static_cast<int>(n.x[k]), static_cast<int>(n.y[k]), n.indices[k]);
                        const Vec2 pair = one.pair(draw);
                        wrong += one.key() != n.keys[k] || sobol::unit(n.u[k]) != pair.x || sobol::unit(n.v[k]) != pair.y;
                    }
                    CHECK(wrong == 0);
                }
    });
}

TEST_CASE("numbers of other samplers drawn for many pixels are those of each") {
    lanes::Row<std::uint32_t> keys, indices, u, v;
    for (std::size_t k = 0; k < lanes::kMost; ++k) keys[k] = sobol::hash(static_cast<std::uint32_t>(k)), indices[k] = static_cast<std::uint32_t>(k % 7);
    for (const Sequence sequence : {Sequence{SamplerKind::kStratified, 12}, Sequence{SamplerKind::kIndependent, 12}}) {
        lanes::pairs_of(keys.data(), indices.data(), lanes::kMost, {Draw::kLight, 65, 2, 5}, u.data(), v.data(), sequence);
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < lanes::kMost; ++k) {
            const Vec2 pair = Sampler(keys[k], indices[k], sequence).pair({Draw::kLight, 65, 2, 5});
            wrong += sobol::unit(u[k]) != pair.x || sobol::unit(v[k]) != pair.y;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("places in the filter drawn for many pixels are those of each") {
    on_every_target([] {
        for (const FilterKind kind : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell}) {
            const FilterSampler filter(kind);
            Numbers n = numbers_of(3, 5, {Draw::kPixel}, lanes::kMost);
            n.u[0] = 0, n.u[1] = 0xffffffffU, n.u[2] = 0x80000000U;
            lanes::Row<double> offsets, weights;
            lanes::places_of(filter.table(), n.u.data(), lanes::kMost, offsets.data(), weights.data());
            std::size_t wrong = 0;
            for (std::size_t k = 0; k < lanes::kMost; ++k) {
                const FilterSampler::Place one = filter.place({sobol::unit(n.u[k]), 0.5});
                const double middle = filter.place({0.5, 0.5}).weight;
                wrong += !same(one.offset.x, offsets[k]) || !same(one.weight, weights[k] * middle);
            }
            CHECK(wrong == 0);
        }
    });
}

TEST_CASE("camera rays of many pixels are those of each") {
    Lens lens;
    lens.eye = {3, -5, 2};
    lens.forward = glm::normalize(Vec3(-3, 5, -2));
    lens.right = glm::normalize(glm::cross(lens.forward, Vec3(0, 0, 1)));
    lens.up = glm::cross(lens.right, lens.forward);
    lens.half_height = 0.2;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    lanes::Row<double> x, y, dx, dy, dz;
    for (std::size_t k = 0; k < lanes::kMost; ++k) x[k] = place(random), y[k] = place(random);
    on_every_target([&] {
        lanes::through_window({lens.forward, lens.right, lens.up, lens.half_height}, x.data(), y.data(), lanes::kMost, {dx.data(), dy.data(), dz.data()});
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < lanes::kMost; ++k) wrong += !same(camera_ray(lens, x[k], y[k]).direction, {dx[k], dy[k], dz[k]});
        CHECK(wrong == 0);
    });
}

TEST_CASE("camera rays of many pixels through a lens are those of each") {
    Lens lens;
    lens.eye = {3, -5, 2};
    lens.forward = glm::normalize(Vec3(-3, 5, -2));
    lens.right = glm::normalize(glm::cross(lens.forward, Vec3(0, 0, 1)));
    lens.up = glm::cross(lens.right, lens.forward);
    lens.aperture = 3;
    lens.focus = 17;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    lanes::Row<double> x, y, dx, dy, dz, ox, oy, oz;
    for (std::size_t k = 0; k < lanes::kMost; ++k) x[k] = place(random), y[k] = place(random);
    on_every_target([&] {
        const Numbers n = numbers_of(4, 9, {Draw::kLens}, lanes::kMost);
        const lanes::Directions rays{dx.data(), dy.data(), dz.data()};
        lanes::through_window({lens.forward, lens.right, lens.up, lens.half_height}, x.data(), y.data(), lanes::kMost, rays);
        lanes::through_disc({lens.eye, lens.right, lens.up, lens.forward, lens.aperture / 2, lens.focus}, n.u.data(), n.v.data(), lanes::kMost, {ox.data(), oy.data(), oz.data()},
                            rays);
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < lanes::kMost; ++k) {
            const Ray one = camera_ray(lens, x[k], y[k], {sobol::unit(n.u[k]), sobol::unit(n.v[k])});
            wrong += !same(one.direction, {dx[k], dy[k], dz[k]}) || !same(one.origin, {ox[k], oy[k], oz[k]});
        }
        CHECK(wrong == 0);
    });
}

TEST_CASE("samples of a lamp for many places are those of each") {
    PointLight ball;
    ball.p = {9, 4, 30};
    ball.radius = 2;
    SunLight disc, point;
    disc.direction = {1, -2, -3};
    disc.angle_deg = 5;
    AreaLight area;
    area.p = {-4, -4, 20};
    area.u = {8, 0, 0};
    area.v = {0, 8, 0};
    const std::vector<LightSource> lamps{resolve_light(ball, Vec3(0)), resolve_light(disc), resolve_light(point), resolve_light(area, Vec3(0))};
    on_every_target([&] {
        for (const LightSource& lamp : lamps) {
            const Numbers n = numbers_of(8, 2, {Draw::kLight}, lanes::kMost);
            std::vector<Vec3> from(lanes::kMost);
            std::vector<LightSample> many(lanes::kMost);
            for (std::size_t k = 0; k < lanes::kMost; ++k) from[k] = Vec3(n.x[k] * 1e-3, n.y[k] * 1e-3, 1);
            sample_light(lamp, from.data(), n.u.data(), n.v.data(), lanes::kMost, many.data());
            std::size_t wrong = 0;
            for (std::size_t k = 0; k < lanes::kMost; ++k) {
                const LightSample one = sample_light(lamp, from[k], {sobol::unit(n.u[k]), sobol::unit(n.v[k])});
                wrong += !same(one.direction, many[k].direction) || !same(one.radiance, many[k].radiance) || !same(one.distance, many[k].distance) || !same(one.density, many[k].density);
            }
            CHECK(wrong == 0);
        }
    });
}

TEST_CASE("points on a circle are cosine and sine to a few ulp") {
    double worst = 0;
    for (int i = -4000; i < 8000; ++i) {
        const double turns = i / 4000.0 + 1e-5 * (i % 7);
        const Vec2 p = on_circle(turns);
        const long double angle = 6.283185307179586476925286766559L * static_cast<long double>(turns);
        worst = std::max({worst, static_cast<double>(std::fabs(p.x - std::cos(angle))), static_cast<double>(std::fabs(p.y - std::sin(angle)))});
    }
    CHECK(worst < 0x1p-51);
    CHECK(on_circle(0) == Vec2(1, 0));
    CHECK(on_circle(0.25) == Vec2(0, 1));
    CHECK(on_circle(0.5) == Vec2(-1, 0));
    CHECK(on_circle(-0.25) == Vec2(0, -1));
}
