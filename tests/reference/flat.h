// flat.h — 2D nodes as formulas, at a point of the plane whose coordinates are polynomials (extrusion) or numbers A + B rho (revolution).
#pragma once

#include <cassert>

#include "csg/solid/solid.h"
#include "tests/reference/formula.h"

namespace whittle::reference {

// Is the point, given in the frame of the 3D node, inside?
ExpressionId solid_formula(Formulas& f, const Solid& solid, NodeId id, const FormPoint& p);

template <class Number>
class FlatFormula {
public:
    FlatFormula(Formulas& formulas, const Solid& solid, const FlatPoint<Number>& p) : f_(formulas), solid_(solid), p_(p) {}

    ExpressionId operator()(const shape::Disc& s) { return f_.negative(p_.x * p_.x + p_.y * p_.y - (Dyadic(s.r) * Dyadic(s.r)) * (p_.w * p_.w)); }

    ExpressionId operator()(const shape::Rectangle& s) {
        return f_.all({f_.positive(p_.x - Dyadic(s.lo.x) * p_.w), f_.negative(p_.x - Dyadic(s.hi.x) * p_.w), f_.positive(p_.y - Dyadic(s.lo.y) * p_.w),
                       f_.negative(p_.y - Dyadic(s.hi.y) * p_.w)});
    }

    // Parity of the edges that the half-line towards +x crosses.
    ExpressionId operator()(const shape::Polygon& s) {
        if constexpr (std::is_same_v<Number, Form>)
            if (s.section != kEmptyNode) return solid_formula(f_, solid_, s.section, {p_.x, p_.y, Form::infinitesimal(), p_.w});
        std::vector<ExpressionId> crossed;
        for (const auto& contour : *s.contours)
            for (std::size_t i = 0; i < contour.size(); ++i) {
                const Vec2 &a = contour[i], &b = contour[(i + 1) % contour.size()];
                if (a.y == b.y) continue;
                const Vec2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
                const Number left = (Dyadic(high.x) - Dyadic(low.x)) * (p_.y - Dyadic(low.y) * p_.w) -
                                    (Dyadic(high.y) - Dyadic(low.y)) * (p_.x - Dyadic(low.x) * p_.w);
                crossed.push_back(f_.all({f_.positive(p_.y - Dyadic(low.y) * p_.w), f_.negative(p_.y - Dyadic(high.y) * p_.w), f_.positive(left)}));
            }
        return f_.odd(std::move(crossed));
    }

    // On the control point's side of the chord, where the squared weight of c is at most four times the product of those of a and b: the weights are areas of
    // the triangles that p makes with two of the three points.
    ExpressionId operator()(const shape::ParabolicSegment& s) {
        const auto area = [this](Vec2 m, Vec2 n) {
            return (Dyadic(m.x) - Dyadic(n.x)) * p_.y - (Dyadic(m.y) - Dyadic(n.y)) * p_.x + (Dyadic(n.x) * Dyadic(m.y) - Dyadic(m.x) * Dyadic(n.y)) * p_.w;
        };
        const Number chord = area(s.a, s.b), arc = chord * chord - Dyadic(4.0) * (area(s.c, s.b) * area(s.a, s.c));
        const bool left = ((Dyadic(s.a.x) - Dyadic(s.b.x)) * (Dyadic(s.c.y) - Dyadic(s.b.y)) - (Dyadic(s.a.y) - Dyadic(s.b.y)) * (Dyadic(s.c.x) - Dyadic(s.b.x))).sign() > 0;
        return f_.all({left ? f_.positive(chord) : f_.negative(chord), f_.negative(arc)});
    }

    template <class Solid3d>
    ExpressionId operator()(const Solid3d&) {
        assert(false && "a 3D shape in a 2D node");
        return f_.never();
    }

private:
    Formulas& f_;
    const Solid& solid_;
    const FlatPoint<Number>& p_;
};

inline ExpressionId combined(Formulas& f, SetOp op, const std::vector<ExpressionId>& operands) {
    if (operands.empty()) return f.never();
    if (op == SetOp::kUnion) return f.any(operands);
    if (op == SetOp::kIntersection) return f.all(operands);
    std::vector<ExpressionId> parts{operands[0]};
    for (std::size_t i = 1; i < operands.size(); ++i) parts.push_back(f.none(operands[i]));
    return f.all(std::move(parts));
}

template <class Number>
ExpressionId flat_formula(Formulas& f, const Solid& solid, NodeId id, const FlatPoint<Number>& p) {
    const Node& node = solid.node(id);
    if (const auto* shape = std::get_if<Shape>(&node)) return std::visit(FlatFormula<Number>(f, solid, p), *shape);
    const auto& combination = std::get<Combination>(node);
    std::vector<ExpressionId> operands;
    for (const Use& use : combination.operands) operands.push_back(flat_formula(f, solid, use.node, pulled_back(p, exact(use.placement))));
    return combined(f, combination.op, operands);
}

}  // namespace whittle::reference
