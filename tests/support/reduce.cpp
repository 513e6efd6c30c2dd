// reduce.cpp — see reduce.h.
#include "tests/support/reduce.h"

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "csg/solid/convex_body.h"

namespace whittle::support {

namespace {

// Each attempt compiles and asks anew: enough for a few hundred leaves, and an end for those that only fail now and then.
constexpr int kMostAttempts = 2000;

// A solid as a tree of its own: a placed shape, over what it is made of if it is made of a node, or a placed set operation.
struct Piece {
    Placement placement;
    std::optional<Shape> shape;
    SetOp op = SetOp::kUnion;
    std::vector<Piece> parts;  // the operands; of a shape what it is made of, if anything
};

NodeId* made_of(Shape& s) {
    if (auto* e = std::get_if<shape::Extrusion>(&s)) return &e->profile;
    if (auto* r = std::get_if<shape::Revolution>(&s)) return &r->profile;
    if (auto* p = std::get_if<shape::Polygon>(&s); p && p->section != kEmptyNode) return &p->section;
    return nullptr;
}

Piece piece_of(const Solid& solid, NodeId id, const Placement& placement) {
    Piece p;
    p.placement = placement;
    if (const auto* shape = std::get_if<Shape>(&solid.node(id))) {
        p.shape = *shape;
        if (const NodeId* part = made_of(*p.shape)) p.parts.push_back(piece_of(solid, *part, {}));
        return p;
    }
    const auto& c = std::get<Combination>(solid.node(id));
    p.op = c.op;
    for (const Use& use : c.operands) p.parts.push_back(piece_of(solid, use.node, use.placement));
    return p;
}

NodeId build(SolidBuilder& b, const Piece& p) {
    if (p.shape) {
        Shape s = *p.shape;
        if (NodeId* part = made_of(s)) {
            Use use;
            use.node = build(b, p.parts[0]);
            use.placement = p.parts[0].placement;
            *part = use.placement.is_identity() ? use.node : b.combine(SetOp::kUnion, {use});
        }
        return b.shape(std::move(s));
    }
    std::vector<Use> uses;
    for (const Piece& part : p.parts) {
        Use use;
        use.node = build(b, part);
        use.placement = part.placement;
        uses.push_back(use);
    }
    return b.combine(p.op, std::move(uses));
}

Solid solid_of(const Piece& p) {
    SolidBuilder b({false, false, false});
    Use root;
    root.node = build(b, p);
    root.placement = p.placement;
    return b.finish(root);
}

class Reducer {
public:
    Reducer(Piece whole, const std::function<bool(const Solid&)>& fails) : whole_(std::move(whole)), fails_(fails) {}

    Piece run() {
        while (shrink(whole_)) {}
        return std::move(whole_);
    }

private:
    // Tries `change` on the piece; keeps it if the whole still fails.
    template <class Change>
    bool tried(Piece& p, Change change) {
        if (++attempts_ > kMostAttempts) return false;
        Piece before = p;
        change(p);
        if (fails_(solid_of(whole_))) return true;
        p = std::move(before);
        return false;
    }

    bool shrink(Piece& p) {
        bool changed = false;
        for (std::size_t i = p.shape ? 0 : p.parts.size(); i-- > 0;) {
            changed |= tried(p, [&](Piece& x) {
                Piece only = x.parts[i];
                x.shape = {};
                x.op = SetOp::kUnion;
                x.parts = {std::move(only)};
            }) && p.parts.size() > 1;
            if (p.parts.size() < 2 || i >= p.parts.size()) break;
            changed |= tried(p, [&](Piece& x) { x.parts.erase(x.parts.begin() + static_cast<std::ptrdiff_t>(i)); });
        }
        if (!p.placement.is_identity()) changed |= tried(p, [](Piece& x) { x.placement = {}; });
        if (!p.shape && p.parts.size() == 1 && (p.placement.is_identity() || p.parts[0].placement.is_identity()))
            changed |= tried(p, [](Piece& x) {
                Piece only = x.parts[0];
                if (only.placement.is_identity()) only.placement = x.placement;
                x = std::move(only);
            });
        for (std::size_t i = 0; i < p.parts.size(); ++i) changed |= shrink(p.parts[i]);
        return changed;
    }

    Piece whole_;
    const std::function<bool(const Solid&)>& fails_;
    int attempts_ = 0;
};

// Writes shapes and uses; `place` is the text of a placement, empty for the identity.
class Writer {
public:
    std::string expression(const Piece& p) const {
        if (p.shape) return fmt::format("b.shape({})", std::visit([&](const auto& s) { return text(s, p); }, *p.shape));
        constexpr const char* ops[] = {"kUnion", "kIntersection", "kDifference"};
        std::string uses;
        for (const Piece& part : p.parts) uses += fmt::format("{}use({}{})", uses.empty() ? "" : ", ", expression(part), placement(part.placement));
        return fmt::format("b.combine(SetOp::{}, {{{}}})", ops[static_cast<int>(p.op)], uses);
    }
    static std::string placement(const Placement& p) {
        if (p.is_identity()) return {};
        std::string numbers;
        for (const double x : p.m) numbers += (numbers.empty() ? "" : ", ") + number(x);
        return fmt::format(", Placement{{{{{}}}}}", numbers);
    }

private:
    static std::string number(double x) {
        const std::string decimal = fmt::format("{}", x);
        return decimal.size() < 12 ? decimal : fmt::format("{:a}", x);
    }
    static std::string text(const Vec3& v) { return fmt::format("{{{}, {}, {}}}", number(v.x), number(v.y), number(v.z)); }
    static std::string text(const Vec2& v) { return fmt::format("{{{}, {}}}", number(v.x), number(v.y)); }
    std::string text(const shape::Box& s, const Piece&) const { return fmt::format("shape::Box{{{}, {}}}", text(s.lo), text(s.hi)); }
    std::string text(const shape::Ellipsoid& s, const Piece&) const { return fmt::format("shape::Ellipsoid{{{}}}", text(s.radii)); }
    std::string text(const shape::Frustum& s, const Piece&) const {
        return fmt::format("shape::Frustum{{{}, {}, {}, {}}}", number(s.z0), number(s.z1), number(s.r0), number(s.r1));
    }
    std::string text(const shape::Torus& s, const Piece&) const { return fmt::format("shape::Torus{{{}, {}}}", number(s.major), number(s.minor)); }
    std::string text(const shape::HalfSpace& s, const Piece&) const { return fmt::format("shape::HalfSpace{{{}, {}}}", text(s.n), number(s.d)); }
    std::string text(const shape::Quadric& s, const Piece&) const {
        std::string numbers;
        for (const double x : s.c) numbers += (numbers.empty() ? "" : ", ") + number(x);
        return fmt::format("shape::Quadric{{{{{}}}}}", numbers);
    }
    std::string text(const shape::Capsule& s, const Piece&) const { return fmt::format("shape::Capsule{{{}, {}, {}}}", text(s.p), text(s.q), number(s.r)); }
    std::string text(const shape::RoundBox& s, const Piece&) const {
        return fmt::format("shape::RoundBox{{{}, {}, {}}}", text(s.lo), text(s.hi), number(s.r));
    }
    std::string text(const shape::ConvexBody& s, const Piece&) const {
        std::string parts;
        for (const ConvexPart& part : s.hull->parts) {
            std::string images;
            for (const BallImage& i : part.images) images += fmt::format("{}{{{}, {}, {}}}", images.empty() ? "" : ", ", text(i.u), text(i.v), text(i.w));
            parts += fmt::format("{}{{{}, {{{}}}}}", parts.empty() ? "" : ", ", text(part.centre), images);
        }
        return fmt::format("shape::ConvexBody{{std::make_shared<const ConvexHullBody>(ConvexParts{{{}}})}}", parts);
    }
    std::string text(const shape::FacetedBall& s, const Piece&) const { return fmt::format("shape::FacetedBall{{{}, {}}}", number(s.r), s.n); }
    std::string text(const shape::FacetedFrustum& s, const Piece&) const {
        return fmt::format("shape::FacetedFrustum{{{}, {}, {}, {}, {}}}", number(s.z0), number(s.z1), number(s.r0), number(s.r1), s.n);
    }
    std::string text(const shape::Polyhedron& s, const Piece&) const {
        std::string points, facets;
        for (const Vec3& p : s.mesh->points) points += (points.empty() ? "" : ", ") + fmt::format("Vec3{}", text(p));
        for (const auto& f : s.mesh->facets) facets += fmt::format("{}{{{}}}", facets.empty() ? "" : ", ", fmt::join(f, ", "));
        return fmt::format("polyhedron({{{}}}, {{{}}})", points, facets);
    }
    std::string text(const shape::Extrusion& s, const Piece& p) const {
        return fmt::format("shape::Extrusion{{{}, {}, {}, {}, {}, {}}}", made_of(p), number(s.z0), number(s.z1), number(s.twist_deg), text(s.scale_top), s.slices);
    }
    std::string text(const shape::Revolution& s, const Piece& p) const {
        return fmt::format("shape::Revolution{{{}, {}, {}, {}}}", made_of(p), number(s.start_deg), number(s.angle_deg), s.fragments);
    }
    std::string text(const shape::ParabolicSegment& s, const Piece&) const {
        return fmt::format("shape::ParabolicSegment{{{}, {}, {}}}", text(s.a), text(s.c), text(s.b));
    }
    std::string text(const shape::Disc& s, const Piece&) const { return fmt::format("shape::Disc{{{}}}", number(s.r)); }
    std::string text(const shape::Rectangle& s, const Piece&) const { return fmt::format("shape::Rectangle{{{}, {}}}", text(s.lo), text(s.hi)); }
    std::string text(const shape::Polygon& s, const Piece& p) const {
        std::string contours;
        for (const auto& c : *s.contours) {
            std::string points;
            for (const Vec2& corner : c) points += (points.empty() ? "" : ", ") + fmt::format("Vec2{}", text(corner));
            contours += fmt::format("{}{{{}}}", contours.empty() ? "" : ", ", points);
        }
        return s.section == kEmptyNode ? fmt::format("polygon({{{}}})", contours) : fmt::format("polygon({{{}}}, {})", contours, made_of(p));
    }
    std::string made_of(const Piece& p) const {
        const Piece& part = p.parts[0];
        if (part.placement.is_identity()) return expression(part);
        return fmt::format("b.combine(SetOp::kUnion, {{use({}{})}})", expression(part), placement(part.placement));
    }
};

}  // namespace

Solid reduced(const Solid& solid, const std::function<bool(const Solid&)>& fails) {
    const Use root = solid.root();
    Piece whole = piece_of(solid, root.node, root.placement);
    if (!fails(solid_of(whole))) return solid;
    return solid_of(Reducer(std::move(whole), fails).run());
}

std::string to_code(const Solid& solid) {
    const Use root = solid.root();
    const Piece p = piece_of(solid, root.node, root.placement);
    return fmt::format("b.finish(use({}{}))", Writer().expression(p), Writer::placement(p.placement));
}

}  // namespace whittle::support
