#include "tracer/image/filter.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace whittle {

std::optional<FilterKind> filter_named(std::string_view name) {
    if (name == "box") return FilterKind::kBox;
    if (name == "gaussian") return FilterKind::kGaussian;
    if (name == "mitchell") return FilterKind::kMitchell;
    return std::nullopt;
}

namespace {

// Standard deviation in pixels: the width at which a slanted edge shows neither stairs nor blur at 16 samples.
constexpr double kGaussianSigma = 0.45;

// Mitchell and Netravali's B = C = 1/3, x in pixels (radius 2).
double mitchell(double x) {
    x = std::abs(x);
    if (x < 1) return (7 * x * x * x - 12 * x * x + 16.0 / 3) / 6;
    if (x < 2) return (-7.0 / 3 * x * x * x + 12 * x * x - 20 * x + 32.0 / 3) / 6;
    return 0;
}

double gaussian(double x) { return Sleef_cinz_expd1_u10purec(-x * x / (2 * kGaussianSigma * kGaussianSigma)); }

}  // namespace

double filter_profile(FilterKind kind, double x) {
    if (std::abs(x) > filter_radius(kind)) return 0;
    switch (kind) {
        case FilterKind::kBox: return 1;
        // Lowered to 0 at the border, so that no step is seen there.
        case FilterKind::kGaussian: return gaussian(x) - gaussian(filter_radius(kind));
        case FilterKind::kMitchell: return mitchell(x);
    }
    return 0;
}

double filter_radius(FilterKind kind) {
    switch (kind) {
        case FilterKind::kBox: return 0.5;
        case FilterKind::kGaussian: return 1.5;
        case FilterKind::kMitchell: return 2;
    }
    return 0.5;
}

FilterSampler::FilterSampler(FilterKind kind) {
    Table& t = table_;
    t.radius = filter_radius(kind);
    t.width = 2 * t.radius / kCells;
    double total = 0, signed_total = 0, of_squares = 0;
    for (int i = 0; i < kCells; ++i) {
        const double x = -t.radius + (i + 0.5) * t.width, value = filter_profile(kind, x);
        total += std::abs(value);
        signed_total += value;
        of_squares += value * x * x;
        t.cumulative[static_cast<std::size_t>(i + 1)] = total;
        t.weights[static_cast<std::size_t>(i)] = value < 0 ? -1 : 1;
    }
    for (double& c : t.cumulative) c /= total;
    balance_ = signed_total / total;
    deviation_ = std::sqrt(of_squares / signed_total);
    const double guesses = static_cast<double>(t.first_cells.size());
    for (std::size_t g = 0; g < t.first_cells.size(); ++g) t.first_cells[g] = static_cast<std::int32_t>(cell_of(static_cast<double>(g) / guesses, 0));
}

// The last cell that begins at or before `u`, not before the cell `first`.
std::size_t FilterSampler::cell_of(double u, std::size_t first) const {
    std::size_t cell = first;
    while (table_.cumulative[cell + 1] <= u) ++cell;
    return cell;
}

FilterSampler::Axis FilterSampler::axis(double u) const {
    const Table& t = table_;
    const std::size_t cell = cell_of(u, static_cast<std::size_t>(t.first_cells[static_cast<std::size_t>(u * static_cast<double>(t.first_cells.size()))]));
    const double within = (u - t.cumulative[cell]) / (t.cumulative[cell + 1] - t.cumulative[cell]);
    return {-t.radius + (static_cast<double>(cell) + within) * t.width, t.weights[cell]};
}

FilterSampler::Place FilterSampler::place(Vec2 u) const {
    const Axis x = axis(u.x), y = axis(u.y);
    return {{x.offset, y.offset}, x.weight * y.weight};
}

}  // namespace whittle
