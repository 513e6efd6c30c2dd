// lower_revolution.cpp — a 2D set turned about z: discs become tori or balls, polygons become rings of cones and cylinders between planes; polygons
// stand for ellipses and parabolas.
//
// Revolution commutes with set operations, so only leaves matter. A polygon is cut at the heights of its vertices; between two heights its edges
// do not cross and, in pairs, bound rings. The cutting planes are shared classes, so the rings join without seams.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/base/degrees.h"
#include "csg/solid/facets.h"
#include "csg/solid/parabola.h"
#include "tracer/engine/formula_builder.h"
#include "tracer/engine/turned_chords.h"

namespace whittle {

namespace {

// Of an ellipse, which its polygon equals in area and so, turned, in volume (Pappus): nowhere farther away than 2^-12.
constexpr int kTurnedChords = 128;

std::vector<Vec2> polygon_like_disc(double r) {
    const double step_deg = 360.0 / kTurnedChords, area = std::numbers::pi / 180 * step_deg;
    return circle_points(r * std::sqrt(area / sind(step_deg)), kTurnedChords);
}

struct Matrix2 {
    double xx, xy, yx, yy, x, y;
    Vec2 apply(Vec2 p) const { return {xx * p.x + xy * p.y + x, yx * p.x + yy * p.y + y}; }
};

Matrix2 flat(const Chain& chain) {
    const Placement p = chain.whole();
    return {p.linear(0, 0), p.linear(0, 1), p.linear(1, 0), p.linear(1, 1), p.offset(0), p.offset(1)};
}

// A similarity of the plane keeps discs discs.
bool keeps_discs(const Matrix2& m, double& scale) {
    scale = std::sqrt(std::abs(m.xx * m.yy - m.xy * m.yx));
    const double room = 0x1p-48 * scale;
    return (std::abs(m.xx - m.yy) <= room && std::abs(m.xy + m.yx) <= room) || (std::abs(m.xx + m.yy) <= room && std::abs(m.xy - m.yx) <= room);
}

struct Edge {
    Vec2 low, high;
    double radius_at(double z) const {
        if (z == low.y) return low.x;
        if (z == high.y) return high.x;
        return low.x + (high.x - low.x) * ((z - low.y) / (high.y - low.y));
    }
};

std::vector<Edge> edges_of(const std::vector<std::vector<Vec2>>& contours) {
    std::vector<Edge> edges;
    for (const auto& c : contours)
        for (std::size_t i = 0; i < c.size(); ++i) {
            const Vec2 a = c[i], b = c[(i + 1) % c.size()];
            if (a.y != b.y) edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
        }
    return edges;
}

// Heights at which edges begin, end, cross or pass the axis, behind which a cone would open again (a crossing's height is rounded: part of reading).
std::vector<double> cuts_of(const std::vector<Edge>& edges) {
    std::vector<double> cuts;
    for (const Edge& e : edges) {
        cuts.push_back(e.low.y);
        cuts.push_back(e.high.y);
        if ((e.low.x < 0 && e.high.x > 0) || (e.low.x > 0 && e.high.x < 0)) cuts.push_back(e.low.y + (e.high.y - e.low.y) * (e.low.x / (e.low.x - e.high.x)));
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const double lo = std::max(edges[i].low.y, edges[j].low.y), hi = std::min(edges[i].high.y, edges[j].high.y);
            if (!(lo < hi)) continue;
            const double a = edges[i].radius_at(lo) - edges[j].radius_at(lo), b = edges[i].radius_at(hi) - edges[j].radius_at(hi);
            if ((a < 0 && b > 0) || (a > 0 && b < 0)) cuts.push_back(lo + (hi - lo) * (a / (a - b)));
        }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

}  // namespace

FormulaId FormulaBuilder::operator_shape(const shape::Revolution& s, const Site& site) {
    const FormulaId whole = revolved(s.profile, Chain(), site);
    if (s.angle_deg >= 360) return whole;
    const Bounds& flat_box = solid_.bounds(s.profile);
    const double r = std::max(std::abs(flat_box.lo.x), std::abs(flat_box.hi.x));
    return all_of({whole, wedge(s.start_deg, s.angle_deg, {Vec3(-r, -r, flat_box.lo.y), Vec3(r, r, flat_box.hi.y)}, site)}, site);
}

FormulaId FormulaBuilder::wedge(double start_deg, double angle_deg, const Bounds& box, const Site& site) {
    const auto side = [&](double at_deg, double sign) {
        const Vec3 n{sign * sind(at_deg), -sign * cosd(at_deg), 0};
        const bool axis = n.x == 0 || n.y == 0;
        Placer p(out_, site.chain, site.motion, box, axis ? Absorb::kAny : Absorb::kRigid);
        return cell({p.plane(n, 0)}, everywhere(), site);
    };
    const FormulaId from = side(start_deg, 1), to = side(start_deg + angle_deg, -1);
    if (angle_deg == 180) return from;
    return angle_deg < 180 ? all_of({from, to}, site) : any_of({from, to}, site);
}

FormulaId FormulaBuilder::revolved(NodeId id, const Chain& plane, const Site& site) {
    const Node& n = solid_.node(id);
    if (const auto* c = std::get_if<Combination>(&n)) {
        std::vector<FormulaId> parts;
        for (std::size_t i = 0; i < c->operands.size(); ++i) {
            Site each = site;
            if (c->op == SetOp::kDifference && i > 0) each.negated = !site.negated;
            parts.push_back(revolved(c->operands[i].node, plane.then(c->operands[i].placement), each));
        }
        return c->op == SetOp::kUnion ? any_of(std::move(parts), site) : all_of(std::move(parts), site);
    }
    const Matrix2 m = flat(plane);
    const Shape& shape = std::get<Shape>(n);
    if (const auto* disc = std::get_if<shape::Disc>(&shape)) {
        double scale = 1;
        if (keeps_discs(m, scale)) return revolved_disc(m.x, m.y, disc->r * scale, site);
    }
    std::vector<std::vector<Vec2>> contours;
    Site where = site;
    if (const auto* r = std::get_if<shape::Rectangle>(&shape)) {
        contours = {{r->lo, {r->hi.x, r->lo.y}, r->hi, {r->lo.x, r->hi.y}}};
    } else if (const auto* disc = std::get_if<shape::Disc>(&shape)) {
        contours = {polygon_like_disc(disc->r)};
        where.exact = false;
    } else if (const auto* segment = std::get_if<shape::ParabolicSegment>(&shape)) {
        const double size = glm::length(solid_.bounds(id).hi - solid_.bounds(id).lo);
        contours = {parabola_corners(*segment, parabola_chords(*segment, size * kTurnedTolerance))};
        where.exact = false;
    } else {
        const auto& polygon = std::get<shape::Polygon>(shape);
        contours = *polygon.contours;
        where.exact = where.exact && polygon.section == kEmptyNode;
    }
    for (auto& contour : contours)
        for (Vec2& v : contour) v = m.apply(v);
    return revolved_polygon(contours, where);
}

FormulaId FormulaBuilder::revolved_disc(double x, double z, double r, const Site& site) {
    const double reach = std::abs(x) + r;
    Placer p(out_, site.chain, site.motion, {Vec3(-reach, -reach, z - r), Vec3(reach, reach, z + r)}, Absorb::kUniformScale);
    const Vec3 centre{0, 0, z};
    if (x == 0) return cell({p.ball(centre, r)}, p.root_box(), site);
    const double ring = std::abs(x);
    const HalfSpaceRef sheet = p.torus(centre, ring, r);
    if (x > 0) {
        const FormulaId outer = cell({sheet}, p.root_box(), site);
        return r <= ring ? outer : any_of({outer, cell({p.torus_core(centre, ring, r)}, p.root_box(), site)}, site);
    }
    // The part of the disc beyond the axis: inside the core, outside the sheet.
    if (r <= ring) return constant(site.negated);
    return cell({p.torus_core(centre, ring, r), {sheet.support, !sheet.inverted}}, p.root_box(), site);
}

FormulaId FormulaBuilder::revolved_polygon(const std::vector<std::vector<Vec2>>& contours, const Site& site) {
    const std::vector<Edge> edges = edges_of(contours);
    const std::vector<double> cuts = cuts_of(edges);
    std::vector<FormulaId> rings;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double z0 = cuts[i], z1 = cuts[i + 1], middle = 0.5 * (z0 + z1);
        std::vector<const Edge*> across;
        for (const Edge& e : edges)
            if (e.low.y <= z0 && e.high.y >= z1) across.push_back(&e);
        std::stable_sort(across.begin(), across.end(), [&](const Edge* a, const Edge* b) { return a->radius_at(middle) < b->radius_at(middle); });
        for (std::size_t k = 0; k + 1 < across.size(); k += 2) {
            const Edge &in = *across[k], &out = *across[k + 1];
            if (out.radius_at(middle) <= 0) continue;
            const bool has_inner = std::max(in.low.x, in.high.x) > 0 && in.radius_at(middle) > 0;
            rings.push_back(ring(z0, z1, in.low, in.high, out.low, out.high, has_inner, site));
        }
    }
    return any_of(std::move(rings), site);
}

FormulaId FormulaBuilder::ring(double z0, double z1, Vec2 inner0, Vec2 inner1, Vec2 outer0, Vec2 outer1, bool has_inner, const Site& site) {
    const double r = std::max(outer0.x, outer1.x);
    Placer p(out_, site.chain, site.motion, {Vec3(-r, -r, z0), Vec3(r, r, z1)}, Absorb::kUniformScale);
    const auto side = [&](Vec2 a, Vec2 b) { return a.x == b.x ? p.cylinder(2, Vec3(0), a.x) : p.cone(2, Vec3(0), a.y, b.y, a.x, b.x); };
    std::vector<HalfSpaceRef> faces{p.axis_plane(2, z0, false), p.axis_plane(2, z1, true), side(outer0, outer1)};
    if (has_inner) {
        HalfSpaceRef hole = side(inner0, inner1);
        hole.inverted = !hole.inverted;
        faces.push_back(hole);
    }
    return cell(std::move(faces), p.root_box(), site);
}

}  // namespace whittle
