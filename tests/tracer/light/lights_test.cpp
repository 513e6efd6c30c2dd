#include <catch2/catch.hpp>

#include <cmath>

#include "tracer/light/lights.h"
#include "tracer/light/sampler.h"
#include "tracer/light/scattering.h"

using namespace whittle;

namespace {

// Irradiance at `at` on a surface with normal `n`, by `count` samples.
double irradiance(const LightSource& light, Vec3 at, Vec3 n, std::uint32_t count = 4096) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const LightSample s = sample_light(light, at, Sampler(1, 2, 3, i).pair(Draw::kLight));
        sum += s.radiance.x * std::max(0.0, glm::dot(n, s.direction));
    }
    return sum / count;
}

}  // namespace

TEST_CASE("a light without power lights a white matte surface at the model's centre to white") {
    const Vec3 centre(1, 2, 3), up(0, 0, 1);
    PointLight point;
    point.p = Vec3(1, 2, 10);
    CHECK(irradiance(resolve_light(point, centre), centre, up) == Approx(kPi));
    point.radius = 0.01;
    CHECK(irradiance(resolve_light(point, centre), centre, up) == Approx(kPi).epsilon(1e-4));
    CHECK(irradiance(resolve_light(SunLight{}), centre, up) == Approx(kPi));
    AreaLight area;
    area.p = Vec3(0.95, 1.95, 10);
    area.u = Vec3(0.1, 0, 0);
    area.v = Vec3(0, 0.1, 0);
    CHECK(irradiance(resolve_light(area, centre), centre, up) == Approx(kPi).epsilon(1e-3));
}

TEST_CASE("a point's irradiance is its flux over the sphere") {
    PointLight point;
    point.p = Vec3(0, 0, 2);
    point.power = 100;
    CHECK(irradiance(resolve_light(point, Vec3(0)), Vec3(0), Vec3(0, 0, 1)) == Approx(100 / (4 * kPi * 4)));
    CHECK(irradiance(resolve_light(point, Vec3(0)), Vec3(0, 2, 0), Vec3(0, 0, 1)) == Approx(100 / (4 * kPi * 8) * std::sqrt(0.5)));
}

TEST_CASE("a sphere's irradiance is pi L sin^2 of its half angle, the same flux as the point's from afar") {
    PointLight ball;
    ball.p = Vec3(0, 0, 5);
    ball.power = 100;
    for (double radius : {0.5, 2.0, 4.9}) {
        ball.radius = radius;
        const double radiance = 100 / (4 * kPi * kPi * radius * radius);
        CHECK(irradiance(resolve_light(ball, Vec3(0)), Vec3(0), Vec3(0, 0, 1)) == Approx(kPi * radiance * radius * radius / 25).epsilon(1e-5));
    }
}

TEST_CASE("a sun's disc keeps the irradiance") {
    SunLight sun;
    sun.irradiance = 2;
    for (double angle : {0.0, 0.53, 20.0}) {
        sun.angle_deg = angle;
        CHECK(irradiance(resolve_light(sun), Vec3(0), Vec3(0, 0, 1)) == Approx(2).epsilon(1e-5));
    }
}

TEST_CASE("a rectangle's irradiance is that of its form factor") {
    // Above the corner of an a x b rectangle at distance c (Hamilton and Morgan).
    const double a = 2, b = 3, c = 1.5;
    AreaLight light;
    light.p = Vec3(0, 0, c);
    light.u = Vec3(a, 0, 0);
    light.v = Vec3(0, b, 0);
    light.power = 50;
    const double radiance = 50 / (2 * kPi * a * b), x = a / c, y = b / c;
    const double rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
    const double factor = (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * kPi);
    CHECK(irradiance(resolve_light(light, Vec3(0)), Vec3(0), Vec3(0, 0, 1), 1U << 16) == Approx(kPi * radiance * factor).epsilon(1e-4));
}

TEST_CASE("what a ray meets agrees with what is sampled") {
    std::vector<LightSource> lights;
    PointLight ball;
    ball.p = Vec3(0, 0, 5);
    ball.radius = 1;
    lights.push_back(resolve_light(ball, Vec3(0)));
    AreaLight area;
    area.p = Vec3(3, 0, 2);
    area.u = Vec3(1, 0, 0.5);
    area.v = Vec3(0.2, 1, 0);
    lights.push_back(resolve_light(area, Vec3(0)));
    SunLight sun;
    sun.direction = Vec3(0, 1, -1);
    sun.angle_deg = 3;
    lights.push_back(resolve_light(sun));
    for (std::size_t k = 0; k < lights.size(); ++k)
        for (std::uint32_t i = 0; i < 200; ++i) {
            const LightSample s = sample_light(lights[k], Vec3(0), Sampler(1, 2, 3, i).pair(Draw::kLight));
            LightMet met;
            REQUIRE(meet_lights(lights, Vec3(0), s.direction, INFINITY, met));
            CHECK(met.light == k);
            CHECK(met.density == Approx(s.density));
            CHECK(met.radiance.x == Approx(s.radiance.x * s.density));
            if (std::isfinite(s.distance)) CHECK(met.t == Approx(s.distance).epsilon(1e-6));
        }
    LightMet met;
    CHECK(!meet_lights(lights, Vec3(0), Vec3(0, 0, -1), INFINITY, met));
    CHECK(!meet_lights(lights, Vec3(0), Vec3(0, 0, 1), 3.5, met));
}

TEST_CASE("lights without size, without direction or without number stay finite") {
    AreaLight flat;
    flat.v = flat.u;
    CHECK(resolve_light(flat, Vec3(5)).kind == LightKind::kPoint);
    PointLight at_centre;
    CHECK(std::isfinite(resolve_light(at_centre, Vec3(0)).emitted.x));
    CHECK(sample_light(resolve_light(at_centre, Vec3(0)), Vec3(0), Vec2(0.5)).radiance == Vec3(0));
    SunLight nowhere;
    nowhere.direction = Vec3(0);
    CHECK(glm::length(resolve_light(nowhere).p) == Approx(1));
    PointLight negative;
    negative.power = -5;
    CHECK(resolve_light(negative, Vec3(3)).emitted == Vec3(0));
}
