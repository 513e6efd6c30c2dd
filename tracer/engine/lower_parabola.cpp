// lower_parabola.cpp — segments of parabolas, upright and as cones: a chord's plane and a quadric.
#include "csg/solid/predicates.h"
#include "tracer/engine/formula_builder.h"

namespace whittle {

// The chord is the plane of a polygon's edge, so a segment that stands on a polygon shares its class.
FormulaId FormulaBuilder::operator_shape(const shape::ParabolicSegment& s, const Site& site) {
    const Vec2 left = (s.a + s.c) / 2.0, right = (s.c + s.b) / 2.0;
    const Vec2 lo = glm::min(glm::min(s.a, s.b), glm::min(left, right)), hi = glm::max(glm::max(s.a, s.b), glm::max(left, right));
    Placer p(out_, site.chain, site.motion, swept(lo, hi, site), Absorb::kAny);
    const int axis = p.axis_of(2), u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto at = [&](Vec2 corner) {
        const Vec3 q = p.point(Vec3(corner, 0));
        return Vec2(q[u], q[v]);
    };
    const Vec2 a = at(s.a), c = at(s.c), b = at(s.b);
    if (turn_of(a, c, b) == 0) return constant(site.negated);
    const HalfSpaceRef chord = turn_of(a, b, c) > 0 ? p.edge_side(axis, a, b) : p.edge_side(axis, b, a);
    return cell({chord, {p.parabola(axis, a, c, b), false}}, p.root_box(), site);
}

const shape::ParabolicSegment* FormulaBuilder::profile_segment(const shape::Extrusion& s) const {
    const Shape* profile = std::get_if<Shape>(&solid_.node(s.profile));
    return profile ? std::get_if<shape::ParabolicSegment>(profile) : nullptr;
}

// A parabola that shrinks or grows evenly on its way up is a cone: S^2 + D T = 0 (support.h) with S and T homogeneous, the scale k = k0 + lean z in the place
// of 1. Its chord is the facet of a polygon that shrinks likewise.
FormulaId FormulaBuilder::tapered(NodeId id, const shape::Extrusion& e, const shape::ParabolicSegment& s, const Site& site) {
    if (turn_of(s.a, s.b, s.c) == 0) return constant(site.negated);
    const auto cross = [](Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; };
    const Vec2 chord = s.b - s.a, side = s.c - s.a, bend = 2.0 * side - chord;
    const double whole = cross(chord, side), lean = (e.scale_top.x - 1) / (e.z1 - e.z0), k0 = 1 - lean * e.z0;
    // S = sx x + sy y + s1 k and T = tx x + ty y + t1 k.
    const double sx = -bend.y, sy = bend.x, s1 = whole - cross(bend, s.a), tx = -2 * chord.y, ty = 2 * chord.x, t1 = -whole - 2 * cross(chord, s.a);
    const double xk = 2 * sx * s1 + whole * tx, yk = 2 * sy * s1 + whole * ty, kk = s1 * s1 + whole * t1;
    Placer p(out_, site.chain, site.motion, solid_.bounds(id), Absorb::kExact);
    const HalfSpaceRef cone = p.quadric({sx * sx, sy * sy, kk * lean * lean, 2 * sx * sy, xk * lean, yk * lean, xk * k0, yk * k0, 2 * kk * k0 * lean, kk * k0 * k0});
    const bool turns_left = turn_of(s.a, s.b, s.c) > 0;
    const Vec2 first = turns_left ? s.a : s.b, second = turns_left ? s.b : s.a;
    const double top = 1 - (1 - e.scale_top.x);  // as the facets of a polygon are scaled
    const HalfSpaceRef wall = p.side(Vec3(first, e.z0), Vec3(second, e.z0), Vec3(second * top, e.z1));
    return cell({p.axis_plane(2, e.z0, false), p.axis_plane(2, e.z1, true), cone, wall}, p.root_box(), site);
}

}  // namespace whittle
