// imports.h — files that import() and surface() name: what kind their suffix says, and their drawings as 2D sets. Internal to csg/eval.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "csg/solid/imported.h"
#include "csg/solid/solid.h"

namespace whittle {

// ".stl" of "part.STL"; empty where there is none.
std::string suffix_of(std::string_view path);
bool is_mesh_suffix(std::string_view suffix);
bool is_drawing_suffix(std::string_view suffix);

// Number of facets of a full circle of that radius, 0 for the true one.
using FacetsOfCircle = std::function<int(double radius)>;

// A drawing as a 2D set: curves stay curves (polygons of the chords, with segments of discs and parabolas added and taken away) unless facets are asked for,
// as many chords for a Bezier curve as a circle of the drawing's size has facets. Cubic Bezier curves are told by quadratic ones within 2^-17 of the size.
// Requires: finite coordinates.
Use drawn_set(SolidBuilder& builder, const Drawing& drawing, const FacetsOfCircle& facets);

// The solid under a height map, as OpenSCAD makes it: four triangles a cell that meet at the cell's mean, walls down to the floor, which lies one
// below the lowest point or at 0. Empty for fewer than 2 x 2 heights.
FacetList height_solid(const HeightMap& map, Vec2 offset);

}  // namespace whittle
