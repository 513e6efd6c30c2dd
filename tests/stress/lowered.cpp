// lowered.cpp — see lowered.h.
#include "tests/stress/lowered.h"

#include "csg/solid/convex_body.h"
#include "tests/reference/convex.h"
#include "tracer/engine/lower.h"

namespace whittle::stress {

namespace {

using reference::Dyadic;
using reference::ExpressionId;
using reference::Facet;
using reference::Faceted;
using reference::Form;
using reference::FormPoint;
using reference::Line;
using reference::Triple;

Form square(const Form& f) { return f * f; }

// The support's polynomial, positive outside, at a point of its frame.
class SupportForm {
public:
    SupportForm(const Support& support, const Twist* twist, const FormPoint& p) : s_(support), twist_(twist), p_(p), x_{p.x, p.y, p.z}, u_((s_.axis + 1u) % 3), v_((s_.axis + 2u) % 3) {}

    Form operator()() const {
        switch (s_.kind) {
            case SupportKind::kAxisPlane: return from(s_.axis, 0);
            case SupportKind::kPlane: return n(0) * p_.x + n(1) * p_.y + n(2) * p_.z - n(3) * p_.w;
            case SupportKind::kPlanePoints: return through_points();
            case SupportKind::kEdgePlane: return (n(3) - n(1)) * from(u_, 0) - (n(2) - n(0)) * from(v_, 1);
            case SupportKind::kBall: return from_centre() - square(n(3) * p_.w);
            case SupportKind::kEllipsoid: {
                const Form a = square(n(3)), b = square(n(4)), c = square(n(5));
                return square(from(0, 0)) * b * c + square(from(1, 1)) * a * c + square(from(2, 2)) * a * b - a * b * c * square(p_.w);
            }
            case SupportKind::kCylinder: return square(from(u_, 0)) + square(from(v_, 1)) - square(n(2) * p_.w);
            case SupportKind::kCone: return cone();
            case SupportKind::kTube: return tube();
            case SupportKind::kQuadric: return quadric();
            case SupportKind::kTorus: return square(core()) - Form(4.0) * square(n(3) * p_.w) * (square(from(u_, u_)) + square(from(v_, v_)));
            case SupportKind::kTorusCore: return core();
            case SupportKind::kParabola: return parabola(x_[u_], x_[v_], p_.w);
            case SupportKind::kTurnedSide:
            case SupportKind::kTurnedEllipse:
            case SupportKind::kTurnedParabola: return swept();
            case SupportKind::kConvex: return {};  // no single form: see Reader::body()
        }
        return {};
    }

private:
    Form n(std::size_t i) const { return Form(s_.p[i]); }
    Form from(std::size_t axis, std::size_t parameter) const { return x_[axis] - n(parameter) * p_.w; }
    Form from_centre() const { return square(from(0, 0)) + square(from(1, 1)) + square(from(2, 2)); }
    Form core() const { return from_centre() + (square(n(3)) - square(n(4))) * square(p_.w); }

    Form through_points() const {
        const auto minor = [&](std::size_t i, std::size_t j) { return (n(3 + i) - n(i)) * (n(6 + j) - n(j)) - (n(3 + j) - n(j)) * (n(6 + i) - n(i)); };
        return minor(1, 2) * from(0, 0) + minor(2, 0) * from(1, 1) + minor(0, 1) * from(2, 2);
    }
    Form cone() const {
        const Form height = n(3) - n(2);
        const Form radius = n(4) * height * p_.w + (n(5) - n(4)) * from(s_.axis, 2);
        return square(height) * (square(from(u_, 0)) + square(from(v_, 1))) - square(radius);
    }
    // Squared distance from the axis, times its length squared: |x|^2 |a|^2 - (x.a)^2.
    Form tube() const {
        Form length2, along;
        for (std::size_t i = 0; i < 3; ++i) {
            const Form a = n(3 + i) - n(i);
            length2 = length2 + square(a);
            along = along + a * from(i, i);
        }
        return from_centre() * length2 - square(along) - square(n(6) * p_.w) * length2;
    }
    // Of what is scaled unevenly, not turned: the curve in x / k_x and y / k_y, times k_x k_y.
    Form swept() const {
        const auto scale = [&](double top) { return Form(twist_->z1 - twist_->z0) * p_.w + Form(top - 1) * (p_.z - Form(twist_->z0) * p_.w); };
        const Form height = Form(twist_->z1 - twist_->z0), kx = scale(twist_->scale_x), ky = scale(twist_->scale_y);
        // Where both scales are one the engine divides by it once: leaving a surface takes the constant term away, so the factor matters.
        const bool even = twist_->scale_x == twist_->scale_y;
        const Form x = even ? height * p_.x : height * p_.x * ky, y = even ? height * p_.y : height * p_.y * kx, unit = even ? kx : kx * ky;
        const Form u = x - n(0) * unit, v = y - n(1) * unit;
        if (s_.kind == SupportKind::kTurnedSide) return (n(3) - n(1)) * u - (n(2) - n(0)) * v;
        if (s_.kind == SupportKind::kTurnedParabola) return parabola(x, y, unit);
        return square(n(5) * u - n(3) * v) + square(n(2) * v - n(4) * u) - square((n(2) * n(5) - n(3) * n(4)) * unit);
    }
    // v^2 - 4 u w in the weights of the three points, times the square of twice the triangle's area: of degree two, as the engine has it.
    Form parabola(const Form& x, const Form& y, const Form& unit) const {
        const Form px = x - n(0) * unit, py = y - n(1) * unit, ex = n(4) - n(0), ey = n(5) - n(1), fx = n(2) - n(0), fy = n(3) - n(1);
        const Form area = ex * fy - ey * fx, two = Form(2.0), gx = two * fx - ex, gy = two * fy - ey;
        const Form across = area * unit + gx * py - gy * px, along = two * (ex * py - ey * px) - area * unit;
        return square(across) + area * unit * along;
    }
    Form quadric() const {
        const Form product[10] = {p_.x * p_.x, p_.y * p_.y, p_.z * p_.z, p_.x * p_.y, p_.x * p_.z, p_.y * p_.z, p_.x * p_.w, p_.y * p_.w, p_.z * p_.w, p_.w * p_.w};
        Form sum;
        for (std::size_t i = 0; i < 10; ++i) sum = sum + n(i) * product[i];
        return sum;
    }

    const Support& s_;
    const Twist* twist_;
    const FormPoint& p_;
    const std::array<Form, 3> x_;
    const std::size_t u_, v_;
};

class Reader {
public:
    Reader(const Formula& formula, const Classes& classes) : formula_(formula), classes_(classes) {
        for (const Frame& f : formula.table.frames) frames_.push_back(point_of(f));
        std::vector<Form> of_class;
        for (const Support& s : classes.supports) {
            bool flipped = false;
            of_class.push_back(SupportForm(s, formula.table.frames[s.frame].twist.get(), frames_[s.frame])());
            // A plane along the section that it stands in decides nothing, and is on no face.
            out_.support_of_class.push_back(of_class.back().is_constant() ? kNoSupport : out_.tree.formulas.support(of_class.back(), flipped));
        }
        for (const ClassOfSupport& c : classes.of) forms_.push_back(c.flipped ? -of_class[c.id] : of_class[c.id]);
    }

    Lowered read() {
        tree_.root = grow(formula_.root);
        return std::move(out_);
    }

private:
    // A point of the root frame, in the frame.
    static FormPoint point_of(const Frame& frame) {
        FormPoint above = reference::root_frame_point();
        if (frame.section) {
            above = point_of(frame.section->frame);
            above.z = Form();
        }
        return reference::pulled_back(above, reference::exact(frame.placement));
    }

    std::size_t grow(FormulaId id) {
        const FormulaNode& n = formula_.nodes[id];
        reference::Branch b;
        if (n.kind == FormulaKind::kAnd || n.kind == FormulaKind::kOr) {
            b.op = n.kind == FormulaKind::kAnd ? SetOp::kIntersection : SetOp::kUnion;
            for (const FormulaId child : n.children) b.operands.push_back(grow(child));
            return add(std::move(b));
        }
        b.is_leaf = true;
        b.leaf = static_cast<std::uint32_t>(tree_.leaves.size());
        uses_.push_back(n.use);
        const ExpressionId what = n.kind == FormulaKind::kCell ? cell(n) : n.kind == FormulaKind::kEverything ? tree_.formulas.always() : tree_.formulas.never();
        tree_.leaves.push_back(n.negated ? tree_.formulas.none(what) : what);
        if (n.kind == FormulaKind::kPrism) tree_.faceted[b.leaf] = walls(formula_.prisms[n.data]);
        if (n.kind == FormulaKind::kMesh) tree_.faceted[b.leaf] = triangles(formula_.meshes[n.data]);
        const bool turn = n.negated && tree_.faceted.count(b.leaf) != 0;
        const std::size_t leaf = add(std::move(b));
        return turn ? add({SetOp::kDifference, false, 0, {everything(), leaf}}) : leaf;
    }

    std::size_t add(reference::Branch b) {
        tree_.branches.push_back(std::move(b));
        return tree_.branches.size() - 1;
    }

    std::size_t everything() {
        reference::Branch b;
        b.is_leaf = true;
        b.leaf = static_cast<std::uint32_t>(tree_.leaves.size());
        uses_.push_back(0);
        tree_.leaves.push_back(tree_.formulas.always());
        return add(std::move(b));
    }

    ExpressionId cell(const FormulaNode& n) {
        std::vector<ExpressionId> sides;
        for (const HalfSpaceRef& h : n.half_spaces) {
            const ClassId id = classes_.of[h.support].id;
            if (classes_.supports[id].kind == SupportKind::kConvex) sides.push_back(h.inverted ? tree_.formulas.none(body(id)) : body(id));
            else sides.push_back(h.inverted ? tree_.formulas.positive(forms_[h.support]) : tree_.formulas.negative(forms_[h.support]));
        }
        return tree_.formulas.all(std::move(sides));
    }

    ExpressionId body(ClassId id) {
        const auto [at, fresh] = bodies_.try_emplace(id, 0);
        const FrameId frame = classes_.supports[id].frame;
        if (!fresh) return at->second;
        const ConvexHullBody& body = *formula_.table.frames[frame].body;
        std::vector<ExpressionId> grown{reference::convex_formula(tree_.formulas, body.parts, frames_[frame])};
        for (const FlatFace& face : body.faces) grown.push_back(beyond(body, face, frames_[frame]));
        return at->second = tree_.formulas.any(std::move(grown));
    }

    // The plane of a flat face, as it was rounded in reading, says where the body ends: what lies over the face is in the body otherwise.
    ExpressionId beyond(const ConvexHullBody& body, const FlatFace& face, const FormPoint& p) {
        const std::size_t axis = std::abs(face.n.x) == 1 ? 0 : std::abs(face.n.y) == 1 ? 1 : 2;
        const double up = face.n[static_cast<int>(axis)], deep = face.d - 0x1p-49 * (body.size + std::abs(face.d));
        std::array<Form, 3> x{p.x, p.y, p.z};
        const Form height = Form(up) * x[axis];
        x[axis] = Form(up * deep) * p.w;
        return tree_.formulas.all({tree_.formulas.positive(height - Form(deep) * p.w), tree_.formulas.negative(height - Form(face.d + 0x1p-26 * body.size) * p.w),
                                   reference::convex_formula(tree_.formulas, body.parts, {x[0], x[1], x[2], p.w})});
    }

    Triple placed(FrameId frame, const Triple& p, bool is_point) const {
        const auto m = reference::exact(formula_.table.frames[frame].placement);
        Triple r;
        for (std::size_t i = 0; i < 3; ++i) {
            r[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2];
            if (is_point) r[i] += m[4 * i + 3];
        }
        return r;
    }
    Triple placed(FrameId frame, const Vec3& p) const { return placed(frame, {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)}, true); }

    Faceted walls(const PrismData& prism) {
        std::vector<Facet> facets;
        Triple axis, other;
        axis[prism.axis] = Dyadic(1.0);
        other[(prism.axis + 1u) % 3] = Dyadic(1.0);
        const Triple along = placed(prism.frame, axis, false), across = placed(prism.frame, other, false), against{-along[0], -along[1], -along[2]};
        const auto corner = [&](const Vec2& v) {
            Vec3 p{0};
            p[(prism.axis + 1) % 3] = v.x;
            p[(prism.axis + 2) % 3] = v.y;
            return placed(prism.frame, p);
        };
        std::size_t edge = 0;
        for (const auto& contour : prism.contours)
            for (std::size_t i = 0; i < contour.size(); ++i, ++edge) {
                if (prism.edges[edge] == kNoSupport) continue;
                const Triple a = corner(contour[i]), b = corner(contour[(i + 1) % contour.size()]);
                facets.push_back({support(prism.edges[edge]), own(prism.edges[edge]), reference::cross(reference::minus(b, a), along), {{a, along}, {b, against}}});
            }
        return {std::move(facets), along, across};
    }

    Faceted triangles(const MeshData& part) {
        std::vector<Facet> facets;
        for (std::size_t i = 0; i < part.facets.size(); ++i) {
            if (part.facets[i] == kNoSupport) continue;
            const auto& t = part.mesh->triangles[i];
            const Triple a = placed(part.frame, part.mesh->points[t[0]]), b = placed(part.frame, part.mesh->points[t[1]]), c = placed(part.frame, part.mesh->points[t[2]]);
            const Triple ab = reference::minus(b, a), bc = reference::minus(c, b), ca = reference::minus(a, c);
            facets.push_back({support(part.facets[i]), own(part.facets[i]), reference::cross(ab, bc), {{a, ab}, {b, bc}, {c, ca}}});
        }
        return {std::move(facets), {}, {}};
    }

    std::uint32_t support(SupportId id) {
        bool flipped = false;
        return tree_.formulas.support(forms_[id], flipped);
    }

    std::uint32_t own(SupportId id) const { return out_.support_of_class[classes_.own[id]]; }

    const Formula& formula_;
    const Classes& classes_;
    std::vector<FormPoint> frames_;
    std::vector<Form> forms_;  // by support
    std::map<ClassId, ExpressionId> bodies_;
    Lowered out_;
    reference::Tree& tree_ = out_.tree;
    std::vector<std::uint32_t>& uses_ = out_.use_of_leaf;
};

}  // namespace

Lowered lowered(const Formula& formula, const Classes& classes) { return Reader(formula, classes).read(); }

Result<Lowered> lowered(const Solid& solid, bool snap) {
    const Result<Formula> formula = lower(solid);
    if (!formula) return tl::unexpected<Error>(formula.error());
    for (const Frame& f : formula->table.frames)
        if (f.body && !reference::has_convex_formula(f.body->parts)) return fail(Fault::kScene, "a convex body of no known formula");
    return lowered(*formula, find_classes(*formula, snap));
}

}  // namespace whittle::stress
