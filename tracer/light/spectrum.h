// spectrum.h — wavelengths, for matter whose index depends on them.
//
// Colours are three numbers until a path is bent by such matter; then it carries four wavelengths of which the first, the hero, says where it goes. The
// others go on as long as they would have gone the same way (a mirror), each by its own probability (balance heuristic over the four choices of the hero).
// A wavelength weighs as much of each channel as the eye sees of it, divided by the density it was drawn with; over all wavelengths the weights are white,
// so matter without dispersion keeps its colour.
// Sources: Wilkie et al., Hero Wavelength Spectral Sampling (2014); Wyman, Sloan, Shirley, Simple Analytic Approximations to the CIE XYZ Color Matching
// Functions (2013).
#pragma once

#include <array>

#include "csg/base/vec.h"
#include "tracer/light/surface.h"

namespace whittle {

// Nanometres. The lines d, F and C, by which Abbe numbers are defined.
inline constexpr double kLineD = 587.5618, kLineF = 486.1327, kLineC = 656.2725;

// Index of refraction at a wavelength in nm, by Cauchy's two terms: `ior` at the line d, (n_d - 1) / (n_F - n_C) the Abbe number. 0 nm: `ior`.
double index_at(const Surface& surface, double nm);

// Tables of the eye, made once for a scene that disperses.
class Spectrum {
public:
    Spectrum();
    // `u` in [0, 1).
    double wavelength(double u) const;
    // Linear Rec.709 of one unit at `nm` over the density of wavelength(); its mean over `u` is (1, 1, 1). Components may be negative.
    Vec3 weight(double nm) const;

    static constexpr double kShortest = 380, kLongest = 720;

private:
    static constexpr int kBins = 340;
    static int bin_of(double nm);
    std::array<Vec3, kBins> weights_;
    std::array<double, kBins + 1> cumulative_;
};

// The wavelengths of one path.
class Hues {
public:
    // Not yet bent by what disperses: all channels together.
    bool white() const { return nm_[0] == 0; }
    void begin(const Spectrum& spectrum, double u);
    // Of the hero; 0 while white.
    double hero() const { return nm_[0]; }
    // The path goes where the hero goes with density `p` for each wavelength: of the four, or of the hero alone.
    void go_on(const Spectrum& spectrum, const std::array<double, 4>& p);
    void hero_alone(const Spectrum& spectrum);
    const std::array<double, 4>& wavelengths() const { return nm_; }
    // What the path weighs by channels.
    Vec3 color() const { return color_; }

private:
    void weigh(const Spectrum& spectrum);
    std::array<double, 4> nm_{};
    std::array<double, 4> density_{};
    Vec3 color_{1};
};

}  // namespace whittle
