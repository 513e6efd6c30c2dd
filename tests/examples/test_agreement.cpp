// test_agreement.cpp — integrators that follow different rays make the same pictures of the gallery.
//
// Means of tiles of 16 x 16 pixels are compared by chi-square, their variances estimated from the samples; over all scenes and pairs together a wrong alarm
// has a chance of one in a thousand. Seeds are fixed: what passes once passes always. The scenes are drawn with larger lamps than their own, so that rays by
// chance find them.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/examples/lit_scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr int kTile = 16;

struct Tile {
    double mean = 0, variance = 0;
};

std::vector<Tile> tiles_of(const Film& film) {
    std::vector<Tile> tiles;
    for (int y0 = 0; y0 + kTile <= film.height; y0 += kTile)
        for (int x0 = 0; x0 + kTile <= film.width; x0 += kTile) {
            Tile t;
            for (int y = y0; y < y0 + kTile; ++y)
                for (int x = x0; x < x0 + kTile; ++x) {
                    const std::size_t i = film.index(x, y);
                    const Vec3 c = film.color(i);
                    t.mean += 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
                    t.variance += film.variance(i);
                }
            t.mean /= kTile * kTile;
            t.variance /= kTile * kTile * kTile * kTile;
            tiles.push_back(t);
        }
    return tiles;
}

// Chance that chi-square of an even number of degrees exceeds `x`.
double chance_above(double x, int degrees) {
    double term = std::exp(-x / 2), sum = 0;
    for (int j = 0; j < degrees / 2; ++j) {
        sum += term;
        term *= x / 2 / (j + 1);
    }
    return sum;
}

// Chance of such a difference; `bias`: what the second may be off by, as a share of the mean.
double chance(const std::vector<Tile>& a, const std::vector<Tile>& b, double bias) {
    double chi2 = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double off = bias * a[i].mean, variance = a[i].variance + b[i].variance + off * off;
        // A tile without light in both pictures agrees.
        if (variance > 0) chi2 += (a[i].mean - b[i].mean) * (a[i].mean - b[i].mean) / variance;
        else if (a[i].mean != b[i].mean) return 0;
    }
    return chance_above(chi2, static_cast<int>(a.size()));
}

void enlarge(Light& light) {
    constexpr double kShareOfDistance = 0.25, kLeastAngle = 30;
    if (auto* point = std::get_if<PointLight>(&light.what)) point->radius = std::max(point->radius, kShareOfDistance * glm::length(point->p));
    if (auto* sun = std::get_if<SunLight>(&light.what)) sun->angle_deg = std::max(sun->angle_deg, kLeastAngle);
}

// Of the gallery. In the studio there is one estimator only: its lamps are no things and throw no caustics.
std::vector<std::string> lit_paths() {
    std::vector<std::string> paths = scenes_in(WHITTLE_SOURCE_DIR "/examples/light");
    for (const std::string& path : scenes_in(WHITTLE_SOURCE_DIR "/examples"))
        if (!lit_scene(path).scene.lights.empty()) paths.push_back(path);
    return paths;
}

struct Size {
    int width, height, samples;
};

// Paths that sample lamps and paths that meet them by chance have no bias. Photons have that of their search radius, where the eye comes by glass or mirrors.
constexpr double kPhotonBias = 0.05;

void compare(const Size& size) {
    RenderOptions o;
    o.width = size.width;
    o.height = size.height;
    o.filter = FilterKind::kBox;
    o.max_depth = 24;
    const std::vector<std::string> paths = lit_paths();
    const double alpha = 0.001 / (2.0 * static_cast<double>(paths.size()));
    for (const std::string& path : paths) {
        INFO(path);
        LitScene lit = lit_scene(path);
        for (Light& light : lit.scene.lights) enlarge(light);
        const auto picture = [&](Integrator kind, bool sample_lamps, std::uint64_t seed, int samples) {
            RenderOptions own = o;
            own.integrator = kind;
            own.sample_lamps = sample_lamps;
            own.seed = seed;
            own.samples = samples;
            return tiles_of(drawn(lit, own).film);
        };
        const std::vector<Tile> sampled = picture(Integrator::kPath, true, 1, size.samples), by_chance = picture(Integrator::kPath, false, 2, size.samples),
                                caustics = picture(Integrator::kCaustics, true, 3, size.samples);
        CHECK(chance(sampled, by_chance, 0) > alpha);
        CHECK(chance(sampled, caustics, kPhotonBias) > alpha);
    }
}

}  // namespace

TEST_CASE("over the gallery lamps sampled and lamps met by chance agree, and photons within their bias") { compare({32, 32, 32}); }

TEST_CASE("tiles tell apart what leaves out light between walls") {
    const LitScene room = lit_scene(WHITTLE_SOURCE_DIR "/examples/light/room.scad");
    RenderOptions o;
    o.width = o.height = 32;
    o.samples = 32;
    o.filter = FilterKind::kBox;
    o.integrator = Integrator::kPath;
    const std::vector<Tile> paths = tiles_of(drawn(room, o).film);
    o.integrator = Integrator::kDistributed;
    CHECK(chance(paths, tiles_of(drawn(room, o).film), kPhotonBias) < 1e-6);
}

TEST_CASE("over the gallery in more pixels and samples the integrators agree", "[.soak]") { compare({96, 64, 512}); }
