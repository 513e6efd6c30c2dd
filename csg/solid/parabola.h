// parabola.h — quadratic Bezier curves: points on them, chords, halves, and cubic ones as several of them.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

Vec2 parabola_point(const shape::ParabolicSegment& s, double t);
std::pair<shape::ParabolicSegment, shape::ParabolicSegment> parabola_halves(const shape::ParabolicSegment& s);

// Chords of equal shares of t that stay within the tolerance: a chord over h of t is off by at most |a - 2c + b| h^2 / 4. From 1 to 4096.
int parabola_chords(const shape::ParabolicSegment& s, double tolerance);

// By how much n chords are off.
double parabola_error(const shape::ParabolicSegment& s, int n);

// The corners a, ..., b of n chords.
std::vector<Vec2> parabola_corners(const shape::ParabolicSegment& s, int n);

bool is_inside(const shape::ParabolicSegment& s, Vec2 p);

// From p to the curve.
double parabola_distance(const shape::ParabolicSegment& s, Vec2 p);

// A cubic Bezier curve as quadratic ones (ends and control points) that share its ends and are nowhere farther from it than the tolerance: of n equal
// shares each is off by at most sqrt(3)/36 |p3 - 3 p2 + 3 p1 - p0| / n^3. Source: Truong, Quadratic approximation of cubic Bezier curves (2020).
std::vector<shape::ParabolicSegment> parabolas_of_cubic(const std::array<Vec2, 4>& p, double tolerance);

}  // namespace whittle
