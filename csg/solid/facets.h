// facets.h — OpenSCAD's facets, vertex for vertex.
//
// The formulas are those of OpenSCAD 2021.01 for objects that no boolean has touched; sines and cosines are csg/base/degrees. Facets are
// counter-clockwise seen from outside and the lists are closed.
#pragma once

#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle {

// $fn, $fa, $fs and $fe as a formula reads them: $fn > 0 fixes the number; else $fe > 0, the chord error of later versions, does, with 5 facets at least and
// none shorter than 0.01 or turning by less; else the finer need of angle and length, at least 5.
struct Resolution { double fn = 0, fa_deg = 12, fs = 2, fe = 0; };

// OpenSCAD's number of facets of a circle of radius r, at least 3; negative $fn counts as 0, $fa and $fs are at least 0.01.
int fragments(double r, const Resolution& resolution);

// Contours of a 2D set: outer ones counter-clockwise, holes clockwise, none crossing.
using Contours = std::vector<std::vector<Vec2>>;

// OpenSCAD's n-gon, first vertex on +x.
std::vector<Vec2> circle_points(double r, int n);

// The side of a slice is cut along its shorter diagonal; of two this close along the one that follows the twist (OpenSCAD's rule).
inline constexpr double kEqualDiagonals = 1e-5;

// OpenSCAD's number of slices of linear_extrude where the author gave none; 1 where the sides are flat.
int extrusion_slices(const Contours& profile, double height, double twist_deg, Vec2 scale_top, const Resolution& resolution);

// The facets of a box, a faceted ball or frustum, a polyhedron, an extrusion with flat or sliced sides, a revolution of fragments. Closed, counter-
// clockwise seen from outside, convex, so that any fan of a facet covers it; flat up to the rounding of the corners. True arcs in a profile become
// chords no further from it than the tolerance (0: kProfileTolerance of the profile's size). kScene fault for curved shapes and 2D nodes.
Result<FacetList> facets_of(const Solid& solid, NodeId node, double tolerance = 0);

}  // namespace whittle
