#include "csg/solid/section.h"

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/convex_parts.h"
#include "csg/solid/facet_operations.h"
#include "csg/solid/facets.h"
#include "csg/solid/profile_line.h"
#include "csg/solid/section_askew.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// What a placement that keeps z does in the plane.
Placement in_plane(const Placement& a) { return {{a.m[0], a.m[1], 0, a.m[3], a.m[4], a.m[5], 0, a.m[7], 0, 0, 1, 0}}; }

std::optional<FacetList> facets_at(const SolidBuilder& builder, NodeId node, const Placement& at) {
    auto list = facets_of(builder.so_far(), node);
    if (!list) return std::nullopt;
    return placed_facets(*list, at);
}

// Are the facets of the shape its true surface?
bool is_faceted(const Shape& s) {
    if (const auto* e = std::get_if<shape::Extrusion>(&s)) return e->slices > 0;
    if (const auto* r = std::get_if<shape::Revolution>(&s)) return r->fragments > 0;
    return std::holds_alternative<shape::Box>(s) || std::holds_alternative<shape::FacetedBall>(s) || std::holds_alternative<shape::FacetedFrustum>(s) ||
           std::holds_alternative<shape::Polyhedron>(s);
}

// The level set of a shape at height z of its own frame, its upper neighbourhood counting.
struct LevelOf {
    SolidBuilder& builder;
    double z;

    std::optional<Use> nothing() { return use_of(kEmptyNode); }
    bool within(double lo, double hi) const { return z >= lo && z < hi; }
    std::optional<Use> disc(double r, Vec2 stretch = Vec2(1)) {
        if (!(r > 0)) return nothing();
        return use_of(builder.shape(shape::Disc{r}), {{stretch.x, 0, 0, 0, 0, stretch.y, 0, 0, 0, 0, 1, 0}});
    }

    std::optional<Use> operator()(const shape::Box& s) {
        if (!within(s.lo.z, s.hi.z)) return nothing();
        return use_of(builder.shape(shape::Rectangle{{s.lo.x, s.lo.y}, {s.hi.x, s.hi.y}}));
    }
    std::optional<Use> operator()(const shape::Ellipsoid& s) {
        const double share = z / s.radii.z;
        if (!(std::fabs(share) < 1)) return nothing();
        const double grown = std::sqrt((1 - share) * (1 + share));
        if (s.radii.x == s.radii.y) return disc(s.radii.x * grown);
        return disc(1, Vec2(s.radii.x, s.radii.y) * grown);
    }
    std::optional<Use> operator()(const shape::Frustum& s) {
        if (!within(s.z0, s.z1)) return nothing();
        if (s.r0 == s.r1) return disc(s.r0);
        const double t = (z - s.z0) / (s.z1 - s.z0);
        return disc(s.r0 + (s.r1 - s.r0) * t);
    }
    std::optional<Use> operator()(const shape::Torus& s) {
        if (!(std::fabs(z) < s.minor)) return nothing();
        const double reach = std::sqrt((s.minor - z) * (s.minor + z));
        const auto outer = disc(s.major + reach);
        if (!(s.major > reach)) return outer;
        return use_of(builder.combine(SetOp::kDifference, {*outer, *disc(s.major - reach)}));
    }
    std::optional<Use> operator()(const shape::Extrusion& s) {
        if (s.slices > 0) return std::nullopt;
        if (!within(s.z0, s.z1)) return nothing();
        const double t = (z - s.z0) / (s.z1 - s.z0), c = cosd(s.twist_deg * t), d = sind(s.twist_deg * t);  // clockwise
        const Vec2 scale = Vec2(1) + (s.scale_top - Vec2(1)) * t;
        return use_of(s.profile, {{scale.x * c, scale.x * d, 0, 0, -scale.y * d, scale.y * c, 0, 0, 0, 0, 1, 0}});
    }
    std::optional<Use> operator()(const shape::Revolution& s) {
        if (s.fragments > 0) return std::nullopt;
        const ProfileLine line{{0, z}, {1, 0}, {0, 1}};
        const auto whole = made_of_intervals(builder, use_of(s.profile), line, [&](const LineIntervals& in) { return rings(builder, in); });
        if (!whole || whole->node == kEmptyNode || s.angle_deg >= 360) return whole;
        return use_of(builder.combine(SetOp::kIntersection, {*whole, sector(s.start_deg, s.angle_deg, builder.bounds(s.profile).hi.x)}));
    }
    // With all of its arc farther out than r.
    Use sector(double start_deg, double angle_deg, double r) {
        constexpr int kSteps = 6;
        std::vector<Vec2> corners{{0, 0}};
        for (int i = 0; i <= kSteps; ++i) {
            const double at = start_deg + angle_deg * i / kSteps;
            corners.push_back(3 * r * Vec2(cosd(at), sind(at)));
        }
        return polygon_of(builder, {corners});
    }
    std::optional<Use> operator()(const auto&) { return std::nullopt; }
};

// Upright along an axis instead of z.
Placement along_axis(int axis) {
    Placement p;
    p.m.fill(0);
    for (int i = 0; i < 3; ++i) p.m[static_cast<std::size_t>(4 * ((axis + 1 + i) % 3) + i)] = 1;
    return p;
}

// What only looks like one shape: a box with round edges is boxes, posts along its edges and balls; a capsule a post and two balls. Empty: it is one.
std::vector<Use> parts_of_round(SolidBuilder& builder, const Shape& shape) {
    std::vector<Use> parts;
    const auto ball = [&](double r, const Vec3& at) { parts.push_back(use_of(builder.shape(shape::Ellipsoid{Vec3(r)}), Placement::translation(at))); };
    if (const auto* s = std::get_if<shape::Capsule>(&shape)) {
        const Vec3 way = s->q - s->p, z = glm::normalize(way), x = glm::normalize(glm::cross(std::fabs(z.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), z)), y = glm::cross(z, x);
        ball(s->r, s->p);
        ball(s->r, s->q);
        parts.push_back(use_of(builder.shape(shape::Frustum{0, glm::length(way), s->r, s->r}), {{x.x, y.x, z.x, s->p.x, x.y, y.y, z.y, s->p.y, x.z, y.z, z.z, s->p.z}}));
    }
    if (const auto* s = std::get_if<shape::RoundBox>(&shape)) {
        const Vec3 lo = s->lo + s->r, hi = s->hi - s->r;  // of the balls' centres
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 out(0);
            out[axis] = s->r;
            parts.push_back(use_of(builder.shape(shape::Box{lo - out, hi + out})));
            for (const int side : {0, 1, 2, 3}) {
                Vec3 at(0);
                at[(axis + 1) % 3] = side % 2 == 0 ? lo[(axis + 1) % 3] : hi[(axis + 1) % 3];
                at[(axis + 2) % 3] = side / 2 == 0 ? lo[(axis + 2) % 3] : hi[(axis + 2) % 3];
                if (lo[axis] < hi[axis])
                    parts.push_back(use_of(builder.shape(shape::Frustum{lo[axis], hi[axis], s->r, s->r}), Placement::translation(at) * along_axis(axis)));
            }
        }
        for (int k = 0; k < 8; ++k) ball(s->r, {k % 2 == 0 ? lo.x : hi.x, k / 2 % 2 == 0 ? lo.y : hi.y, k / 4 == 0 ? lo.z : hi.z});
    }
    return parts;
}

class Sections {
public:
    Sections(SolidBuilder& builder, const OutlineOf& outline) : builder_(builder), outline_(outline) {}

    // Of the use under a placement.
    std::optional<Use> of(const Use& use, const Placement& above) {
        if (use.node == kEmptyNode) return use_of(kEmptyNode);
        if (use.motion != 0) return std::nullopt;
        const Placement at = above * use.placement;
        const Node node = builder_.node(use.node);
        if (const auto* c = std::get_if<Combination>(&node)) return of_all(c->op, c->operands, at);
        const Shape& shape = std::get<Shape>(node);
        if (const auto parts = parts_of_round(builder_, shape); !parts.empty()) return of_all(SetOp::kUnion, parts, at);
        auto own = of_shape(use.node, shape, at);
        return own ? own : below_polygon(use_of(use.node, at));
    }

private:
    std::optional<Use> of_all(SetOp op, const std::vector<Use>& operands, const Placement& at) {
        std::vector<Use> parts;
        for (const Use& part : operands) {
            const auto own = of(part, at);
            if (!own) return std::nullopt;
            parts.push_back(*own);
        }
        if (parts.size() == 1) return parts[0];
        return use_of(builder_.combine(op, std::move(parts)));
    }

    // Of 2D shapes, where it is.
    std::optional<Use> of_shape(NodeId id, const Shape& s, const Placement& at) {
        if (is_faceted(s) && !(keeps_z(at) && std::holds_alternative<shape::Box>(s))) {
            const auto list = facets_at(builder_, id, at);
            if (!list) return std::nullopt;
            return polygon_of(builder_, section_of(*list));
        }
        const auto* ball = std::get_if<shape::Ellipsoid>(&s);
        if (ball && ball->radii.x == ball->radii.y && ball->radii.y == ball->radii.z) {  // however it is turned
            const auto scale = similarity_of(at, false);
            const double r = scale ? ball->radii.x * *scale : 0, z = at.offset(2);
            if (scale && std::fabs(z) >= r) return use_of(kEmptyNode);
            if (scale) return use_of(builder_.shape(shape::Disc{std::sqrt((r - z) * (r + z))}), Placement::translation({at.offset(0), at.offset(1), 0}));
        }
        if (!keeps_z(at)) return section_of_askew(builder_, id, s, at);
        const double up = at.linear(2, 2);
        if (up < 0) return std::nullopt;  // its lower neighbourhood would count
        auto level = std::visit(LevelOf{builder_, -at.offset(2) / up}, s);
        if (level && level->node != kEmptyNode) level = builder_.placed(in_plane(at), *level);
        return level;
    }

    std::optional<Use> below_polygon(const Use& solid) {
        if (!outline_) return std::nullopt;
        auto outline = outline_(solid);
        if (!outline) return std::nullopt;
        if (outline->contours.empty()) return use_of(kEmptyNode);
        const NodeId node = builder_.combine(SetOp::kUnion, {solid});
        return use_of(builder_.shape(shape::Polygon{std::make_shared<const Contours>(std::move(outline->contours)), node, outline->deviation}));
    }

    SolidBuilder& builder_;
    const OutlineOf& outline_;
};

std::optional<Use> shadow_at(SolidBuilder& builder, const Use& use, const Placement& above);

std::optional<Use> shadow_of_shape(SolidBuilder& builder, NodeId id, const Placement& at) {
    const Shape s = std::get<Shape>(builder.node(id));
    if (is_faceted(s) && !(keeps_z(at) && std::holds_alternative<shape::Box>(s))) {
        const auto list = facets_at(builder, id, at);
        if (!list) return std::nullopt;
        return polygon_of(builder, shadow_of(*list));
    }
    const auto* ball = std::get_if<shape::Ellipsoid>(&s);
    const auto scale = ball && ball->radii.x == ball->radii.y && ball->radii.y == ball->radii.z ? similarity_of(at, false) : std::nullopt;
    if (scale) return use_of(builder.shape(shape::Disc{ball->radii.x * *scale}), Placement::translation({at.offset(0), at.offset(1), 0}));
    if (!keeps_z(at)) return std::nullopt;
    const Placement flat = in_plane(at);
    if (const auto prism = prism_of(builder, use_of(id))) return builder.placed(flat, prism->profile);
    if (const auto* cone = std::get_if<shape::Frustum>(&s)) return builder.placed(flat, use_of(builder.shape(shape::Disc{std::max(cone->r0, cone->r1)})));
    if (const auto* ring = std::get_if<shape::Torus>(&s)) {
        const Use outer = use_of(builder.shape(shape::Disc{ring->major + ring->minor}));
        if (!(ring->major > ring->minor)) return builder.placed(flat, outer);
        return builder.placed(flat, use_of(builder.combine(SetOp::kDifference, {outer, use_of(builder.shape(shape::Disc{ring->major - ring->minor}))})));
    }
    return std::nullopt;
}

std::optional<Use> shadow_at(SolidBuilder& builder, const Use& use, const Placement& above) {
    if (use.motion != 0) return std::nullopt;
    const Placement at = above * use.placement;
    if (std::holds_alternative<Shape>(builder.node(use.node))) return shadow_of_shape(builder, use.node, at);
    const Combination c = std::get<Combination>(builder.node(use.node));
    if (c.op != SetOp::kUnion) return std::nullopt;
    std::vector<Use> parts;
    for (const Use& part : c.operands) {
        const auto own = shadow_at(builder, part, at);
        if (!own) return std::nullopt;
        parts.push_back(*own);
    }
    if (parts.size() == 1) return parts[0];
    return use_of(builder.combine(SetOp::kUnion, std::move(parts)));
}

}  // namespace

std::optional<Use> exact_section(SolidBuilder& builder, const Use& use, const OutlineOf& outline) { return Sections(builder, outline).of(use, {}); }

std::optional<Use> exact_shadow(SolidBuilder& builder, const Use& use) { return shadow_at(builder, use, {}); }

}  // namespace whittle
