// filter.h — reconstruction filters, by drawing sample places from them.
//
// A sample belongs to one pixel only: its place is drawn with the density |f| and weighs sign(f), so tiles need not know their neighbours and the
// expected picture is the convolution with f. Source: Ernst, Stamminger, Greiner, Filter importance sampling (2006); Mitchell and Netravali (1988).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "csg/base/vec.h"

namespace whittle {

enum class FilterKind { kBox, kGaussian, kMitchell };
std::optional<FilterKind> filter_named(std::string_view name);

// Profile of the separable filter at `x` pixels from the centre; not normalised.
double filter_profile(FilterKind kind, double x);
// Half width in pixels: 0.5, 1.5, 2.
double filter_radius(FilterKind kind);

// Maps uniform numbers to places. One axis; both axes are alike.
class FilterSampler {
public:
    explicit FilterSampler(FilterKind kind);

    struct Place {
        Vec2 offset;    // from the pixel's centre
        double weight;  // +1 or -1
    };
    // `u` in [0,1)^2.
    Place place(Vec2 u) const;
    // As read by those who draw many places at once (tracer/light/lanes.h).
    static constexpr int kCells = 128, kGuessBits = 10;
    struct Table {
        double radius = 0, width = 0;  // width: of a cell
        std::array<double, kCells + 1> cumulative{};
        std::array<double, kCells> weights{};                         // the sign of the profile in a cell
        std::array<std::int32_t, 1 << kGuessBits> first_cells{};  // the cell in which a share of u begins
    };
    const Table& table() const { return table_; }
    // Integral of the filter over integral of |filter|, both axes: the expected weight of a sample.
    double expected_weight() const { return balance_ * balance_; }
    // Standard deviation of the filter along an axis, in pixels.
    double deviation() const { return deviation_; }

private:
    struct Axis { double offset, weight; };
    Axis axis(double u) const;
    std::size_t cell_of(double u, std::size_t first) const;

    Table table_;
    double balance_ = 1, deviation_ = 0;
};

}  // namespace whittle
