// What the reconstruction filters make of known pictures: every pixel against the filter's integral.
#include <array>
#include <cmath>
#include <random>

#include "scenes.h"
#include "tracer/light/splats.h"

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr int kSide = 16;
constexpr int kSamples = 1024;

// A pixel is one millimetre of the plane y = 0; x to the right, z up, the middle of the picture at 0.
Film seen_from_afar(const Solid& solid, FilterKind filter) {
    RenderOptions options;
    options.width = options.height = kSide;
    options.samples = kSamples;
    options.integrator = Integrator::kPreview;
    options.filter = filter;
    RenderScene scene;
    scene.camera = looking(Vec3(0, -1000, 0), Vec3(0), 2 * std::atan(kSide / 2.0 / 1000) * 180 / 3.14159265358979323846);
    return drawn(solid, scene, options).film;
}

// The filter's weights on a grid around a pixel's middle, along one axis.
struct Weights {
    static constexpr int kSteps = 80;
    std::array<double, kSteps> place, weight;
    double sum = 0;
    explicit Weights(FilterKind filter) {
        const double step = 2 * filter_radius(filter) / kSteps;
        for (std::size_t i = 0; i < kSteps; ++i) {
            place[i] = -filter_radius(filter) + (static_cast<double>(i) + 0.5) * step;
            weight[i] = filter_profile(filter, place[i]);
            sum += weight[i];
        }
    }
};

// Largest distance of the film's coverage from the filter's integral over what `covered(x, z)` tells, in every third row.
template <class Covered>
double worst_distance(const Film& film, FilterKind filter, Covered covered) {
    const Weights w(filter);
    double worst = 0;
    for (int y = 0; y < kSide; y += 3)
        for (int x = 0; x < kSide; ++x) {
            double sum = 0;
            for (std::size_t i = 0; i < Weights::kSteps; ++i)
                for (std::size_t k = 0; k < Weights::kSteps; ++k)
                    if (covered(x + 0.5 + w.place[i] - kSide / 2.0, kSide / 2.0 - (y + 0.5 + w.place[k]))) sum += w.weight[i] * w.weight[k];
            const PixelSums& p = film.pixels[film.index(x, y)];
            worst = std::max(worst, std::abs(p.coverage / p.weight - sum / (w.sum * w.sum)));
        }
    return worst;
}

// Four standard errors of independent samples that weigh +-1; the samples are better than independent.
double bound(FilterKind filter) { return 4 * 0.5 / std::sqrt(kSamples) / FilterSampler(filter).expected_weight(); }

// The same where one sample stands in each of kCells x kCells cells and a straight edge crosses at most 2 kCells of them: the others have no error.
constexpr int kCells = 32;
static_assert(kCells * kCells == kSamples);
double edge_bound(FilterKind filter) { return 4 * 0.5 * std::sqrt(2.0 * kCells) / kSamples / FilterSampler(filter).expected_weight(); }

// A thin plate less what stands out of the half plane x cos a + z sin a < 0, a = 10 degrees: a slanted edge.
constexpr double kCos = 0.98480775301220802, kSin = 0.17364817766693033;

Solid slanted_edge() {
    SceneBuilder b;
    Use plate = b.box(Vec3(-100, 0, -100), Vec3(0, 0x1p-10, 100));
    plate.placement = Placement{{kCos, 0, -kSin, 0, 0, 1, 0, 0, kSin, 0, kCos, 0}};
    b.add(plate);
    return b.finish();
}

// Rings between radii r0 sqrt(2k) and r0 sqrt(2k + 1): finer than half a pixel at the border.
constexpr double kRing = 2.5;
constexpr int kRings = 6;

Solid zone_plate() {
    SceneBuilder b;
    for (int k = 0; k < kRings; ++k) {
        Use ring = b.rod(-0x1p-10, 0, kRing * std::sqrt(2 * k + 1));
        if (k > 0) ring = b.combined(SetOp::kDifference, {ring, b.rod(-1, 1, kRing * std::sqrt(2 * k))});
        ring.placement = Placement{{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}};
        b.add(ring);
    }
    return b.finish();
}

}  // namespace

TEST_CASE("a slanted edge is the integral of the filter, in every pixel and by every filter") {
    const Solid solid = slanted_edge();
    const auto covered = [](double x, double z) { return x * kCos + z * kSin < 0; };
    for (const FilterKind filter : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell}) {
        const Film film = seen_from_afar(solid, filter);
        CHECK(worst_distance(film, filter, covered) < edge_bound(filter));
        // The bound tells the filters apart.
        for (const FilterKind other : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell})
            if (other != filter) CHECK(worst_distance(film, other, covered) > edge_bound(filter));
    }
}

TEST_CASE("a zone plate is the integral of the filter, also where its rings are finer than pixels") {
    const Solid solid = zone_plate();
    const auto covered = [](double x, double z) {
        const double ring = (x * x + z * z) / (kRing * kRing);
        return ring < 2 * kRings - 1 && static_cast<int>(ring) % 2 == 0;
    };
    for (const FilterKind filter : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell}) CHECK(worst_distance(seen_from_afar(solid, filter), filter, covered) < bound(filter));
}

TEST_CASE("places drawn on a picture weigh in each pixel near what samples there would, and are all found") {
    constexpr int kWidth = 9, kHeight = 7;
    for (const auto& [kind, alone] : {std::pair(FilterKind::kBox, false), {FilterKind::kGaussian, false}, {FilterKind::kMitchell, false}, {FilterKind::kMitchell, true}}) {
        const SplatFilter filter(kind, alone);
        double integral = 0, magnitude = 0;
        constexpr int kSteps = 4000;
        for (int i = 0; i < kSteps; ++i) {
            const double w = filter.weight(filter.radius() * (2 * (i + 0.5) / kSteps - 1)) * 2 * filter.radius() / kSteps;
            integral += w;
            magnitude += std::abs(w);
        }
        CHECK(magnitude == Approx(1).epsilon(1e-4));
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> column(-3, kWidth + 3), row(-3, kHeight + 3), bright(0, 1);
        const Splats empty(filter, kWidth, kHeight);
        std::vector<Splat> shown;
        double inner = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Splat s{{column(random), row(random)}, Vec3(bright(random), 1, 0)};
            const double reach = filter.radius() - 0.5;
            CHECK(empty.shows(s.at) == (s.at.x >= -reach && s.at.x < kWidth + reach && s.at.y >= -reach && s.at.y < kHeight + reach));
            if (!empty.shows(s.at)) continue;
            shown.push_back(s);
            inner += s.at.x >= 0 && s.at.x < kWidth && s.at.y >= 0 && s.at.y < kHeight ? 1 : 0;
        }
        Splats splats(filter, kWidth, kHeight);
        splats.take(shown);
        double all = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                Vec3 sum(0);
                for (const Splat& s : shown) {
                    const Vec2 off = s.at - Vec2(x + 0.5, y + 0.5);
                    if (off.x >= -filter.radius() && off.x < filter.radius() && off.y >= -filter.radius() && off.y < filter.radius())
                        sum += s.light * (filter.weight(off.x) * filter.weight(off.y));
                }
                const Vec3 found = splats.on_pixel(x, y);
                CHECK(found.x == Approx(sum.x).epsilon(1e-9));
                CHECK(found.y == Approx(sum.y).epsilon(1e-9));
                all += found.y;
            }
        // What falls on the picture is what its pixels get; a filter with lobes below zero keeps its share of that.
        CHECK(all == Approx(inner * integral * integral).epsilon(0.05));
    }
}
