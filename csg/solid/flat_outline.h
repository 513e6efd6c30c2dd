// flat_outline.h — the border of a 2D solid as lines, arcs and quadratic Bezier curves, for files that know them and for what grows or shrinks by a distance.
//
// Every side of every leaf is cut where it meets another; a piece is border where the set lies on one side of it only, which is asked of the set
// itself at two points beside the piece's middle; pieces are chained with the set on their left. Curves are never chords.
// Bounds: points nearer than kOutlineJoin of the set's size are one point; a gap or a wall thinner than 2^6 times that is not seen.
// Source: Requicha, Voelcker, Boolean Operations in Solid Modeling: Boundary Evaluation and Merging Algorithms (1985).
#pragma once

#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle {

inline constexpr double kOutlineJoin = 0x1p-38;

// A line to `end`, or a quadratic Bezier curve to it, or an arc along centre + u cos t + v sin t from t = from to t = to (counter-clockwise where to > from and u, v turn left).
struct OutlineSide {
    Vec2 end{0};
    bool curved = false;
    Vec2 centre{0}, u{0}, v{0};
    double from = 0, to = 0;
    bool quadratic = false;
    Vec2 control{0};
    // A circle's arc?
    bool round() const;
    // The arc's angle as it is seen in the plane, positive counter-clockwise.
    double turn() const;
};
struct Outline {
    Vec2 start{0};
    std::vector<OutlineSide> sides;  // the last ends at `start`
};

// Outer contours counter-clockwise, holes clockwise; in an order that depends on the set alone. Requires: a 2D root.
std::vector<Outline> outlines_of(const Solid& solid);
// Of a 2D use, in the frame above it; the solid need not have a root.
std::vector<Outline> outlines_of(const Solid& solid, const Use& use);

struct OutlineBox { Vec2 lo{0}, hi{0}; };
// Curves included. Requires: at least one outline.
OutlineBox box_of(const std::vector<Outline>& outlines);
double area_of(const std::vector<Outline>& outlines);

}  // namespace whittle
