// gloss_energy.h — how much light the rough lobes of a surface return, so that what one bounce among microfacets loses can be given back.
//
// The GGX lobes count light that leaves the microsurface after one bounce. The rest leaves after more, in all directions: it is added as a lobe of its own
// (conductors), or it reaches the matter under the coat (dielectrics). Both lobes have the form (1 - E(in)) (1 - E(out)) / (pi (1 - mean of E)), so they
// are reciprocal and a white surface returns exactly what it gets.
// Sources: Kelemen and Szirmay-Kalos (2001); Kulla and Conty, Revisiting Physically Based Shading at Imageworks (2017).
#pragma once

#include <array>

namespace whittle {

class GlossEnergy {
public:
    // Of GGX with `alpha` (0: ideal), under a dielectric coat of index `ior`.
    GlossEnergy(double alpha, double ior);

    // Albedo at the cosine of a direction: of a mirror of reflectance 1 and of the coat.
    double mirror(double cosine) const { return at(mirror_, cosine); }
    double coat(double cosine) const { return at(coat_, cosine); }
    // Means over the hemisphere, weighted by the cosine.
    double mirror_mean() const { return mirror_mean_; }
    double coat_mean() const { return coat_mean_; }

private:
    static constexpr int kCells = 64;  // over the root of the cosine, so that grazing directions have the most
    using Table = std::array<double, kCells + 1>;
    static double at(const Table& table, double cosine);
    static double mean_of(const Table& table);
    Table mirror_{}, coat_{};
    double mirror_mean_ = 1, coat_mean_ = 0;
};

}  // namespace whittle
