#include "tracer/light/gloss_energy.h"

#include <algorithm>
#include <cmath>

#include "tracer/light/scattering.h"

namespace whittle {

namespace {

// Visible normals a direction: rings of the disc by directions on it. The tail of the lobe lies in a rim of width alpha^2, so rings are set by the fourth
// root of what lies outside of them. Albedos come out to 3e-4 for roughness 0.2 to 1 (docs/light.md).
constexpr int kRings = 96, kSpokes = 32;

struct Albedos {
    double mirror = 0, coat = 0;
};

// Half of the spokes: the others are their mirror images in the plane of view and normal.
std::array<Vec2, kSpokes / 2> half_the_spokes() {
    std::array<Vec2, kSpokes / 2> spokes;
    for (std::size_t j = 0; j < spokes.size(); ++j) spokes[j] = on_circle((static_cast<double>(j) + 0.5) / kSpokes - 0.25);
    return spokes;
}

Albedos albedos(double cosine, double alpha, double ior) {
    static const std::array<Vec2, kSpokes / 2> kHalf = half_the_spokes();
    const Vec3 view(std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine);
    Albedos sum;
    double weights = 0;
    for (int i = 0; i < kRings; ++i) {
        const double v = (i + 0.5) / kRings, outside = v * v * v * v, weight = v * v * v, radius = std::sqrt(1 - outside);
        weights += static_cast<double>(kHalf.size()) * weight;
        for (const Vec2& spoke : kHalf) {
            const Vec3 micro = ggx_normal_on_disc(view, alpha, radius * spoke);
            const double along = glm::dot(view, micro), out = 2 * along * micro.z - view.z;
            if (!(out > 0)) continue;
            const double share = weight * ggx_visibility(out, cosine, alpha) * 4 * out * cosine / ggx_masking(cosine, alpha);
            sum.mirror += share;
            sum.coat += share * fresnel_dielectric(std::min(1.0, along), 1 / ior);
        }
    }
    return {std::min(1.0, sum.mirror / weights), std::min(1.0, sum.coat / weights)};
}

}  // namespace

GlossEnergy::GlossEnergy(double alpha, double ior) {
    // In the face itself masking leaves nothing to divide by.
    constexpr double kLeastCosine = 1e-6;
    for (std::size_t i = 0; i <= kCells; ++i) {
        const double root = static_cast<double>(i) / kCells, cosine = std::max(kLeastCosine, root * root);
        const Albedos a = alpha > 0 ? albedos(cosine, alpha, ior) : Albedos{1, fresnel_dielectric(cosine, 1 / ior)};
        mirror_[i] = a.mirror;
        coat_[i] = a.coat;
    }
    mirror_mean_ = mean_of(mirror_);
    coat_mean_ = mean_of(coat_);
}

double GlossEnergy::at(const Table& table, double cosine) {
    const double x = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * kCells;
    const std::size_t cell = std::min<std::size_t>(static_cast<std::size_t>(x), kCells - 1);
    return glm::mix(table[cell], table[cell + 1], x - static_cast<double>(cell));
}

// 2 * integral of E(cosine) cosine, with the cosine = x^2: 4 x^3 E. Three Gauss points a cell are exact for what at() returns.
double GlossEnergy::mean_of(const Table& table) {
    constexpr std::array<double, 3> kPlaces{0.11270166537925831, 0.5, 0.8872983346207417}, kWeights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (std::size_t cell = 0; cell < kCells; ++cell)
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = (static_cast<double>(cell) + kPlaces[k]) / kCells;
            sum += kWeights[k] * 4 * x * x * x * glm::mix(table[cell], table[cell + 1], kPlaces[k]);
        }
    return sum / kCells;
}

}  // namespace whittle
