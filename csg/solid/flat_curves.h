// flat_curves.h — the sides of 2D leaves, where they meet, and whether a point is in the set. Internal to flat_outline.cpp.
#pragma once

#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// a + (b - a) t, 0 <= t <= 1, or the quadratic Bezier curve from a to b with control point c likewise, or centre + u cos t + v sin t, 0 <= t <= 2 pi.
struct FlatCurve {
    bool curved = false;       // an ellipse
    bool quadratic = false;
    Vec2 a{0}, c{0}, b{0};     // of a line or a Bezier curve
    Vec2 centre{0}, u{0}, v{0};
    Vec2 lo{0}, hi{0};         // its box
    Vec2 at(double t) const;
    Vec2 along(double t) const;  // derivative
    // The parameter of the nearest point of an ellipse in its own frame, of a line by projection, of a Bezier curve along its axis.
    double parameter(Vec2 p) const;
    // The control point of the part of a Bezier curve from t0 to t1.
    Vec2 control(double t0, double t1) const;
    double last() const;       // the end of the parameter's range
};

FlatCurve flat_line(Vec2 a, Vec2 b);
FlatCurve flat_parabola(Vec2 a, Vec2 c, Vec2 b);
FlatCurve flat_ellipse(Vec2 centre, Vec2 u, Vec2 v);

// Points that both have, up to `tolerance`; ends of one that lie on the other among them. Curves that are the same have none.
void meetings(const FlatCurve& p, const FlatCurve& q, double tolerance, std::vector<Vec2>& out);

class FlatSet {
public:
    FlatSet(const Solid& solid, const Use& use);
    const std::vector<FlatCurve>& curves() const { return curves_; }
    bool contains(Vec2 p) const;

private:
    struct Leaf { const Shape* shape; Placement inverse; Vec2 lo, hi; };
    struct Node { SetOp op; std::vector<std::uint32_t> operands; std::uint32_t leaf; bool is_leaf; };
    std::uint32_t add(const Solid& solid, NodeId id, const Placement& placement);
    bool contains(std::uint32_t node, Vec2 p) const;
    std::vector<FlatCurve> curves_;
    std::vector<Leaf> leaves_;
    std::vector<Node> nodes_;
    std::uint32_t root_ = 0;
};

}  // namespace whittle
