#include "tracer/light/spectrum.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace whittle {

namespace {

struct Bell {
    double height, centre_nm, left, right;  // inverse widths per nm
};

double bell(const Bell& b, double nm) {
    const double t = (nm - b.centre_nm) * (nm < b.centre_nm ? b.left : b.right);
    return b.height * Sleef_cinz_expd1_u10purec(-0.5 * t * t);
}

// CIE 1931 2 degree colour-matching functions.
Vec3 xyz_at(double nm) {
    const double x = bell({0.362, 442.0, 0.0624, 0.0374}, nm) + bell({1.056, 599.8, 0.0264, 0.0323}, nm) + bell({-0.065, 501.1, 0.0490, 0.0382}, nm);
    const double y = bell({0.821, 568.8, 0.0213, 0.0247}, nm) + bell({0.286, 530.9, 0.0613, 0.0322}, nm);
    const double z = bell({1.217, 437.0, 0.0845, 0.0278}, nm) + bell({0.681, 459.0, 0.0385, 0.0725}, nm);
    return {x, y, z};
}

Vec3 rec709(Vec3 c) {
    return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z, -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
            0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

}  // namespace

double index_at(const Surface& s, double nm) {
    if (nm == 0 || !(s.abbe > 0)) return s.ior;
    const auto inverse_square = [](double w) { return 1 / (w * w); };
    const double slope = (s.ior - 1) / (s.abbe * (inverse_square(kLineF) - inverse_square(kLineC)));
    // A glass of a tiny Abbe number would be rarer than air in the red.
    return std::max(1.0, s.ior + slope * (inverse_square(nm) - inverse_square(kLineD)));
}

Spectrum::Spectrum() {
    constexpr double kWidth = (kLongest - kShortest) / kBins;
    Vec3 sum(0);
    for (int i = 0; i < kBins; ++i) {
        weights_[static_cast<std::size_t>(i)] = rec709(xyz_at(kShortest + (i + 0.5) * kWidth));
        sum += weights_[static_cast<std::size_t>(i)];
    }
    cumulative_[0] = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        weights_[i] /= sum;
        cumulative_[i + 1] = cumulative_[i] + std::abs(weights_[i].x) + std::abs(weights_[i].y) + std::abs(weights_[i].z);
    }
    for (std::size_t i = 0; i < kBins; ++i) weights_[i] *= cumulative_[kBins] / (std::abs(weights_[i].x) + std::abs(weights_[i].y) + std::abs(weights_[i].z));
    for (double& c : cumulative_) c /= cumulative_[kBins] > 0 ? cumulative_[kBins] : 1;
}

int Spectrum::bin_of(double nm) { return std::clamp(static_cast<int>((nm - kShortest) * (kBins / (kLongest - kShortest))), 0, kBins - 1); }

double Spectrum::wavelength(double u) const {
    const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end(), u);
    const std::size_t bin = std::clamp<std::size_t>(static_cast<std::size_t>(above - cumulative_.begin()), 1, kBins) - 1;
    const double width = cumulative_[bin + 1] - cumulative_[bin];
    const double within = width > 0 ? std::clamp((u - cumulative_[bin]) / width, 0.0, 1.0) : 0.5;
    return kShortest + (static_cast<double>(bin) + within) * ((kLongest - kShortest) / kBins);
}

Vec3 Spectrum::weight(double nm) const { return weights_[static_cast<std::size_t>(bin_of(nm))]; }

void Hues::begin(const Spectrum& spectrum, double u) {
    for (std::size_t i = 0; i < nm_.size(); ++i) {
        const double v = u + 0.25 * static_cast<double>(i);
        nm_[i] = spectrum.wavelength(v < 1 ? v : v - 1);
        density_[i] = 1;
    }
    weigh(spectrum);
}

void Hues::go_on(const Spectrum& spectrum, const std::array<double, 4>& p) {
    for (std::size_t i = 1; i < p.size(); ++i) density_[i] *= p[i] / p[0];
    weigh(spectrum);
}

void Hues::hero_alone(const Spectrum& spectrum) {
    density_ = {1, 0, 0, 0};
    weigh(spectrum);
}

void Hues::weigh(const Spectrum& spectrum) {
    Vec3 sum(0);
    double all = 0;
    for (std::size_t i = 0; i < nm_.size(); ++i) {
        if (density_[i] > 0) sum += density_[i] * spectrum.weight(nm_[i]);
        all += density_[i];
    }
    color_ = sum / all;
}

}  // namespace whittle
