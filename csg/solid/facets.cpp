#include "csg/solid/facets.h"

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"

namespace whittle {
namespace {

// A circle smaller than OpenSCAD's fine grid is a triangle.
constexpr double kGridFine = 0x1p-20;
constexpr double kSmallestResolution = 0.01;
constexpr double kPi = 3.14159265358979323846;
// More facets than memory holds would be asked for by mistake only.
constexpr double kMostFragments = 1 << 24;

int to_count(double x, double least) { return static_cast<int>(std::clamp(x, least, kMostFragments)); }

// Of the radius: how far a pentagon's sides are from its circle, 1 - cos 36 degrees.
constexpr double kErrorOfFive = 0.19098300562505255;

double square(double x) { return x * x; }

// Length of the curve r = a + b*angle, angle from 0 to `turn`; the polar arc length integral in closed form.
double spiral_length(double a, double b, double turn) {
    if (b == 0) return a * turn;
    const auto primitive = [b](double r) {
        const double s = std::sqrt(r * r + b * b);
        return (r * s + b * b * std::log(r + s)) / (2 * b);
    };
    return std::fabs(primitive(a + b * turn) - primitive(a));
}

}  // namespace

int fragments(double r, const Resolution& resolution) {
    if (r < kGridFine || !std::isfinite(resolution.fn)) return 3;
    if (resolution.fn > 0) return to_count(resolution.fn, 3);
    if (const double share = resolution.fe / r; resolution.fe >= kGridFine) {
        const double most = std::max(std::min(360 / kSmallestResolution, r * 2 * kPi / kSmallestResolution), 5.0);
        return share < kErrorOfFive ? to_count(std::ceil(std::min(most, kPi / std::acos(1 - share))), 5) : 5;
    }
    const double fa = std::max(resolution.fa_deg, kSmallestResolution), fs = std::max(resolution.fs, kSmallestResolution);
    return to_count(std::ceil(std::max(std::min(360 / fa, r * 2 * kPi / fs), 5.0)), 3);
}

std::vector<Vec2> circle_points(double r, int n) {
    std::vector<Vec2> points;
    points.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        const double deg = 360.0 * i / n;
        points.push_back({r * cosd(deg), r * sind(deg)});
    }
    return points;
}

int extrusion_slices(const Contours& profile, double height, double twist_deg, Vec2 scale_top, const Resolution& resolution) {
    const double fn = resolution.fn, fs = std::max(resolution.fs, kSmallestResolution), fa = std::max(resolution.fa_deg, kSmallestResolution);
    double farthest = 0, longest_shift = 0;
    for (const auto& contour : profile)
        for (const Vec2& p : contour) {
            farthest = std::max(farthest, square(p.x) + square(p.y));
            longest_shift = std::max(longest_shift, square(p.x - p.x * scale_top.x) + square(p.y - p.y * scale_top.y));
        }
    const bool uniform = scale_top.x == scale_top.y;
    if (twist_deg == 0) {
        if (uniform) return 1;
        return fn > 0 ? to_count(fn, 1) : to_count(std::ceil(std::sqrt(longest_shift + square(height)) / fs), 1);
    }
    const double turn_deg = std::fabs(twist_deg), least = std::max(1.0, std::ceil(turn_deg / 120));
    if (fn > 0) return to_count(std::ceil(turn_deg / 360 * fn), least);
    const double turn = turn_deg * kPi / 180, radius = std::sqrt(farthest);
    const bool spiral_up = uniform && scale_top.x != 1;
    if (resolution.fe > 0 && !spiral_up)  // the chord of a step of a helix, its ends on a circle
        return resolution.fe < radius ? to_count(std::ceil(turn / (2 * std::acos(1 - resolution.fe / radius))), least) : static_cast<int>(least);
    double length;
    if (spiral_up) {
        const double base = scale_top.x > 1 ? radius / scale_top.x : radius;  // OpenSCAD lets the farthest corner end, not start, at its radius
        const double spiral = spiral_length(base, base * (scale_top.x - 1) / turn, turn);
        length = std::sqrt(square(spiral) + square(height));
    } else {
        length = turn * std::sqrt(square(radius) + square(height / turn));
    }
    return to_count(std::min(std::ceil(turn_deg / fa), std::ceil(length / fs)), least);
}

}  // namespace whittle
