#include <catch2/catch.hpp>

#include <cmath>

#include "tracer/light/sampler.h"
#include "tracer/light/scattering.h"

using namespace whittle;

namespace {

Vec3 at_angle(double degrees) { return {std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180)}; }
Vec2 draw(std::uint32_t i) { return Sampler(3, 1, 1, i).pair(Draw::kLobe); }

// Share of white light from everywhere that a GGX mirror of reflectance 1 sends to `view`, by its own sampling.
double single_scattering_albedo(double alpha, Vec3 view) {
    double sum = 0;
    const std::uint32_t n = 4096;
    for (std::uint32_t i = 0; i < n; ++i) {
        const Vec3 micro = ggx_visible_normal(view, alpha, draw(i));
        const Vec3 out = mirrored(-view, micro);
        if (out.z > 0) sum += ggx_visibility(out.z, view.z, alpha) * 4 * out.z * view.z / ggx_masking(view.z, alpha);
    }
    return sum / n;
}

}  // namespace

TEST_CASE("a corner of three mirrors sends every ray back") {
    for (std::uint32_t i = 0; i < 50; ++i) {
        const Vec2 u = draw(i);
        const Vec3 d = glm::normalize(Vec3(u.x - 1.1, u.y - 1.1, -0.3 - u.x * u.y));
        const Vec3 back = mirrored(mirrored(mirrored(d, {1, 0, 0}), {0, 1, 0}), {0, 0, 1});
        CHECK(glm::length(back + d) < 1e-15);
    }
}

TEST_CASE("refraction obeys Snell and is reversible") {
    for (double angle : {1.0, 20.0, 45.0, 80.0, 89.9}) {
        const auto bent = refracted(-at_angle(angle), {0, 0, 1}, 1 / 1.5);
        REQUIRE(bent);
        CHECK(std::abs(bent->x) == Approx(std::sin(angle * kPi / 180) / 1.5).epsilon(1e-14));
        const auto back = refracted(*bent, {0, 0, 1}, 1.5);
        REQUIRE(back);
        CHECK(glm::length(*back + at_angle(angle)) < 1e-12);
    }
}

TEST_CASE("the critical angle is met to 1e-6 degrees") {
    const double critical = std::asin(1 / 1.5) * 180 / kPi;
    CHECK(refracted(-at_angle(critical - 1e-6), {0, 0, 1}, 1.5));
    CHECK(!refracted(-at_angle(critical + 1e-6), {0, 0, 1}, 1.5));
    CHECK(fresnel_dielectric(std::cos((critical + 1e-6) * kPi / 180), 1.5) == 1);
}

TEST_CASE("Fresnel: four percent in front, nothing polarised at Brewster's angle, symmetric, one at grazing") {
    CHECK(fresnel_dielectric(1, 1 / 1.5) == Approx(0.04));
    CHECK(fresnel_dielectric(1, 1.5) == Approx(0.04));
    CHECK(fresnel_dielectric(1e-9, 1 / 1.5) == Approx(1).margin(1e-7));
    const double brewster = std::atan(1.5), s = std::sin(brewster - std::asin(std::sin(brewster) / 1.5));
    CHECK(fresnel_dielectric(std::cos(brewster), 1 / 1.5) == Approx(0.5 * s * s));
    const auto inside = refracted(-at_angle(50), {0, 0, 1}, 1 / 1.5);
    CHECK(fresnel_dielectric(std::cos(50 * kPi / 180), 1 / 1.5) == Approx(fresnel_dielectric(-inside->z, 1.5)));
}

TEST_CASE("the minimum deviation of a prism is that of the formula") {
    const double apex = 60 * kPi / 180, index = 1.5;
    const double closed = 2 * std::asin(index * std::sin(apex / 2)) - apex;
    const Vec3 first(-std::cos(apex / 2), 0, std::sin(apex / 2)), second(std::cos(apex / 2), 0, std::sin(apex / 2));
    double least = 10;
    for (int i = 0; i <= 20000; ++i) {
        const double angle = (30 + 40.0 * i / 20000) * kPi / 180;
        const Vec3 tangent(std::sin(apex / 2), 0, std::cos(apex / 2));
        const Vec3 in = -std::cos(angle) * first + std::sin(angle) * tangent;
        const auto within = refracted(in, first, 1 / index);
        const auto out = refracted(*within, -second, index);
        if (out) least = std::min(least, std::acos(glm::dot(in, *out)));
    }
    CHECK(least == Approx(closed).epsilon(1e-8));
}

TEST_CASE("the density of GGX normals, projected, sums to one") {
    for (double alpha : {0.05, 0.3, 0.8}) {
        double total = 0;
        const int n = 200000;
        for (int i = 0; i < n; ++i) {
            const double c = (i + 0.5) / n;
            total += ggx_density(c, alpha) * c * 2 * kPi / n;
        }
        CHECK(total == Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("sampling visible normals in the furnace gives the energy that one bounce keeps") {
    // Compared with plain integration over the hemisphere of outgoing directions.
    for (double alpha : {0.2, 0.6})
        for (double angle : {0.0, 60.0}) {
            const Vec3 view = at_angle(angle);
            double plain = 0;
            const std::uint32_t n = 1U << 18;
            for (std::uint32_t i = 0; i < n; ++i) {
                const Vec3 out = on_cosine_hemisphere(draw(i));
                const Vec3 half = glm::normalize(out + view);
                plain += ggx_density(half.z, alpha) * ggx_visibility(out.z, view.z, alpha) * kPi / n;
            }
            CHECK(single_scattering_albedo(alpha, view) == Approx(plain).epsilon(5e-3));
            CHECK(plain <= 1 + 1e-3);
        }
}

TEST_CASE("frames are orthonormal and right-handed") {
    for (std::uint32_t i = 0; i < 200; ++i) {
        const Vec3 n = on_cap(draw(i), 2);
        const ShadingFrame f(n);
        CHECK(glm::length(glm::cross(f.x, f.y) - f.z) < 1e-14);
        CHECK(std::abs(glm::dot(f.x, f.z)) < 1e-14);
        CHECK(glm::length(f.to_local(f.to_world(Vec3(1, 2, 3))) - Vec3(1, 2, 3)) < 1e-13);
    }
}
