// shapes.cpp — see shapes.h. Written for reading: the text of solid.h, line by line, as inequalities between exact polynomials.
#include "tests/reference/shapes.h"

#include <algorithm>
#include <cassert>

#include "csg/base/degrees.h"
#include "csg/solid/convex_body.h"
#include "tests/reference/convex.h"
#include "tests/reference/flat.h"

namespace whittle::reference {

namespace {

Form square(const Form& f) { return f * f; }

class ShapeFormula {
public:
    ShapeFormula(Formulas& formulas, const Solid& solid, const FormPoint& p) : f_(formulas), solid_(solid), p_(p) {}

    ExpressionId operator()(const shape::Box& s) { return box(s.lo, s.hi); }

    ExpressionId operator()(const shape::Ellipsoid& s) {
        const Form a = square(s.radii.x), b = square(s.radii.y), c = square(s.radii.z);
        return f_.negative(square(p_.x) * b * c + square(p_.y) * a * c + square(p_.z) * a * b - square(p_.w) * a * b * c);
    }

    ExpressionId operator()(const shape::Frustum& s) {
        const Form height = Form(s.z1) - Form(s.z0);
        const Form radius = Form(s.r0) * height * p_.w + (Form(s.r1) - Form(s.r0)) * (p_.z - Form(s.z0) * p_.w);  // times height and w
        return f_.all({above(p_.z, s.z0), below(p_.z, s.z1), f_.negative((square(p_.x) + square(p_.y)) * square(height) - square(radius))});
    }

    // (rho - R)^2 + z^2 < r^2 is k < 2 R rho with k = rho^2 + z^2 + R^2 - r^2.
    ExpressionId operator()(const shape::Torus& s) {
        const Form rho2 = square(p_.x) + square(p_.y);
        const Form k = rho2 + square(p_.z) + (square(s.major) - square(s.minor)) * square(p_.w);
        return f_.any({f_.negative(k), f_.negative(square(k) - Form(4.0) * square(s.major) * rho2 * square(p_.w))});
    }

    ExpressionId operator()(const shape::HalfSpace& s) { return f_.negative(Form(s.n.x) * p_.x + Form(s.n.y) * p_.y + Form(s.n.z) * p_.z - Form(s.d) * p_.w); }

    ExpressionId operator()(const shape::Quadric& s) {
        const Form product[10] = {p_.x * p_.x, p_.y * p_.y, p_.z * p_.z, p_.x * p_.y, p_.x * p_.z,
                                  p_.y * p_.z, p_.x * p_.w, p_.y * p_.w, p_.z * p_.w, p_.w * p_.w};
        Form sum;
        for (std::size_t i = 0; i < 10; ++i) sum = sum + Form(s.c[i]) * product[i];
        return f_.negative(sum);
    }

    ExpressionId operator()(const shape::Capsule& s) {
        const auto from = [&](const Vec3& c) { return std::array<Form, 3>{p_.x - Form(c.x) * p_.w, p_.y - Form(c.y) * p_.w, p_.z - Form(c.z) * p_.w}; };
        const auto dot = [](const std::array<Form, 3>& a, const std::array<Form, 3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
        const std::array<Form, 3> axis{Form(s.q.x) - Form(s.p.x), Form(s.q.y) - Form(s.p.y), Form(s.q.z) - Form(s.p.z)};
        const auto a = from(s.p), b = from(s.q);
        const Form length2 = dot(axis, axis), along = dot(a, axis), r2 = square(s.r) * square(p_.w);
        const ExpressionId tube = f_.all({f_.positive(along), f_.negative(along - length2 * p_.w),
                                          f_.negative(dot(a, a) * length2 - square(along) - r2 * length2)});
        return f_.any({tube, f_.negative(dot(a, a) - r2), f_.negative(dot(b, b) - r2)});
    }

    // The points within r of the inner box: three boxes, twelve tubes, eight balls.
    ExpressionId operator()(const shape::RoundBox& s) {
        const Form r(s.r);
        const Form x[3] = {p_.x, p_.y, p_.z};
        Form lo[3], hi[3];
        for (int i = 0; i < 3; ++i) lo[i] = Form(s.lo[i]) + r, hi[i] = Form(s.hi[i]) - r;
        std::vector<ExpressionId> parts;
        const auto between = [&](int i, const Form& l, const Form& h) { return f_.all({f_.positive(x[i] - l * p_.w), f_.negative(x[i] - h * p_.w)}); };
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            parts.push_back(f_.all({between(i, s.lo[i], s.hi[i]), between(j, lo[j], hi[j]), between(k, lo[k], hi[k])}));
        }
        for (int corner = 0; corner < 8; ++corner) {
            Form away[3];
            for (int i = 0; i < 3; ++i) away[i] = square(x[i] - ((corner >> i) & 1 ? hi[i] : lo[i]) * p_.w);
            const Form r2 = square(r * p_.w);
            parts.push_back(f_.negative(away[0] + away[1] + away[2] - r2));
            for (int i = 0; i < 3; ++i)
                if (!((corner >> i) & 1)) parts.push_back(f_.all({between(i, lo[i], hi[i]), f_.negative(away[(i + 1) % 3] + away[(i + 2) % 3] - r2)}));
        }
        return f_.any(std::move(parts));
    }

    ExpressionId operator()(const shape::ConvexBody& s) { return convex_formula(f_, s.hull->parts, p_); }

    ExpressionId operator()(const shape::Polyhedron& s) { return mesh(*s.mesh); }

    ExpressionId operator()(const shape::Extrusion& s) {
        const Form height = Form(s.z1) - Form(s.z0);
        const auto scale = [&](double top) { return height * p_.w + (Form(top) - Form(1.0)) * (p_.z - Form(s.z0) * p_.w); };  // times height and w
        FlatPoint<Form> flat{p_.x, p_.y, p_.w};
        if (s.scale_top.x != 1 || s.scale_top.y != 1) {
            const Form sx = scale(s.scale_top.x), sy = scale(s.scale_top.y);
            if (s.scale_top.x == s.scale_top.y) flat = {p_.x * height, p_.y * height, sx};
            else flat = {p_.x * height * sy, p_.y * height * sx, sx * sy};
        }
        return f_.all({above(p_.z, s.z0), below(p_.z, s.z1), flat_formula(f_, solid_, s.profile, flat)});
    }

    ExpressionId operator()(const shape::Revolution& s) {
        const Form rho2 = square(p_.x) + square(p_.y);
        const FlatPoint<Surd> flat{{Form(), Form(1.0), rho2}, {p_.z, Form(), rho2}, {p_.w, Form(), rho2}};
        const ExpressionId full = flat_formula(f_, solid_, s.profile, flat);
        if (s.angle_deg >= 360) return full;
        const auto left_of = [&](double deg) { return f_.positive(Form(cosd(deg)) * p_.y - Form(sind(deg)) * p_.x); };
        const ExpressionId after = left_of(s.start_deg), before = f_.none(left_of(s.start_deg + s.angle_deg));
        if (s.angle_deg == 180) return f_.all({full, after});
        return f_.all({full, s.angle_deg < 180 ? f_.all({after, before}) : f_.any({after, before})});
    }

    ExpressionId operator()(const shape::FacetedBall& s) {
        const int rings = (s.n + 1) / 2;
        std::vector<Vec2> outline;  // radius, z
        for (int i = 0; i < rings; ++i) outline.push_back({s.r * sind(180 * (i + 0.5) / rings), s.r * cosd(180 * (i + 0.5) / rings)});
        return mesh(turned(outline, s.n));
    }
    ExpressionId operator()(const shape::FacetedFrustum& s) { return mesh(turned({{s.r1, s.z1}, {s.r0, s.z0}}, s.n)); }

    template <class Flat>
    ExpressionId operator()(const Flat&) {
        assert(false && "a 2D shape outside an extrusion or revolution");
        return f_.never();
    }

private:
    ExpressionId above(const Form& x, double bound) { return f_.positive(x - Form(bound) * p_.w); }
    ExpressionId below(const Form& x, double bound) { return f_.negative(x - Form(bound) * p_.w); }
    ExpressionId box(const Vec3& lo, const Vec3& hi) {
        return f_.all({above(p_.x, lo.x), below(p_.x, hi.x), above(p_.y, lo.y), below(p_.y, hi.y), above(p_.z, lo.z), below(p_.z, hi.z)});
    }

    // The rings of n corners that an outline (radius, z; from above) makes, closed by its first and last.
    static FacetList turned(const std::vector<Vec2>& outline, int n) {
        FacetList m;
        const auto count = static_cast<std::uint32_t>(n), rings = static_cast<std::uint32_t>(outline.size());
        for (const Vec2& p : outline)
            for (int i = 0; i < n; ++i) m.points.push_back({p.x * cosd(360.0 * i / n), p.x * sind(360.0 * i / n), p.y});
        m.facets.resize(2);
        for (std::uint32_t i = 0; i < count; ++i) {
            m.facets[0].push_back(i);
            m.facets[1].push_back((rings - 1) * count + count - 1 - i);
            for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
                const std::uint32_t a = ring * count + i, b = ring * count + (i + 1) % count;
                m.facets.push_back({a, a + count, b + count, b});
            }
        }
        return m;
    }

    // Parity of the triangles (each facet a fan) that lie straight above the point.
    ExpressionId mesh(const FacetList& m) {
        std::vector<ExpressionId> over;
        for (const auto& facet : m.facets)
            for (std::size_t i = 2; i < facet.size(); ++i)
                if (const ExpressionId e = lies_below(m.points[facet[0]], m.points[facet[i - 1]], m.points[facet[i]]); e != f_.never()) over.push_back(e);
        return f_.odd(std::move(over));
    }

    ExpressionId lies_below(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto edge = [](const Vec3& from, const Vec3& to, int i) { return Dyadic(to[i]) - Dyadic(from[i]); };
        const auto minor = [&](int i, int j) { return edge(a, b, i) * edge(a, c, j) - edge(a, b, j) * edge(a, c, i); };
        const int up = minor(0, 1).sign();  // of the triangle's normal
        if (up == 0) return f_.never();
        const auto left_of = [&](const Vec3& from, const Vec3& to) {
            return Form(edge(from, to, 0)) * (p_.y - Form(from.y) * p_.w) - Form(edge(from, to, 1)) * (p_.x - Form(from.x) * p_.w);
        };
        const Form height = Form(minor(1, 2)) * (p_.x - Form(a.x) * p_.w) + Form(minor(2, 0)) * (p_.y - Form(a.y) * p_.w) +
                            Form(minor(0, 1)) * (p_.z - Form(a.z) * p_.w);
        const auto turned = [&](const Form& f) { return up > 0 ? f : -f; };
        return f_.all({f_.negative(turned(height)), f_.positive(turned(left_of(a, b))), f_.positive(turned(left_of(b, c))),
                       f_.positive(turned(left_of(c, a)))});
    }

    Formulas& f_;
    const Solid& solid_;
    const FormPoint& p_;
};

bool has_formula(const Shape& shape) {
    if (const auto* e = std::get_if<shape::Extrusion>(&shape)) return e->twist_deg == 0 && (e->slices == 0 || e->scale_top.x == e->scale_top.y);
    if (const auto* r = std::get_if<shape::Revolution>(&shape)) return r->fragments == 0;
    if (const auto* c = std::get_if<shape::ConvexBody>(&shape)) return has_convex_formula(c->hull->parts);
    return true;
}

}  // namespace

bool has_formula(const Solid& solid) {
    if (solid.root().motion != 0) return false;
    for (NodeId id = 0; id < solid.node_count(); ++id) {
        const Node& node = solid.node(id);
        if (const auto* s = std::get_if<Shape>(&node); s && !has_formula(*s)) return false;
        if (const auto* c = std::get_if<Combination>(&node))
            if (std::any_of(c->operands.begin(), c->operands.end(), [](const Use& u) { return u.motion != 0; })) return false;
    }
    return true;
}

ExpressionId shape_formula(Formulas& formulas, const Solid& solid, const Shape& shape, const FormPoint& p) {
    return std::visit(ShapeFormula(formulas, solid, p), shape);
}

ExpressionId solid_formula(Formulas& f, const Solid& solid, NodeId id, const FormPoint& p) {
    const Node& node = solid.node(id);
    if (const auto* shape = std::get_if<Shape>(&node)) return shape_formula(f, solid, *shape, p);
    const auto& combination = std::get<Combination>(node);
    std::vector<ExpressionId> operands;
    for (const Use& use : combination.operands) operands.push_back(solid_formula(f, solid, use.node, pulled_back(p, exact(use.placement))));
    return combined(f, combination.op, operands);
}

}  // namespace whittle::reference
