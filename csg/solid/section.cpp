#include "csg/solid/section.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/convex_parts.h"
#include "csg/solid/facet_operations.h"
#include "csg/solid/facets.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// What a placement that keeps z does in the plane.
Placement in_plane(const Placement& a) { return {{a.m[0], a.m[1], 0, a.m[3], a.m[4], a.m[5], 0, a.m[7], 0, 0, 1, 0}}; }

std::optional<Use> polygon(SolidBuilder& builder, Contours contours) {
    if (contours.empty()) return use_of(kEmptyNode);
    return use_of(builder.shape(shape::Polygon{std::make_shared<const Contours>(std::move(contours))}));
}

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
        if (s.twist_deg != 0 || s.slices > 0) return std::nullopt;
        if (!within(s.z0, s.z1)) return nothing();
        if (s.scale_top == Vec2(1)) return use_of(s.profile);
        const double t = (z - s.z0) / (s.z1 - s.z0);
        const Vec2 scale = Vec2(1) + (s.scale_top - Vec2(1)) * t;
        return use_of(s.profile, {{scale.x, 0, 0, 0, 0, scale.y, 0, 0, 0, 0, 1, 0}});
    }
    std::optional<Use> operator()(const auto&) { return std::nullopt; }
};

// The corners of a convex polygon where `value`, which is linear, is not negative.
template <class Value>
std::vector<Vec2> clipped(const std::vector<Vec2>& corners, Value value) {
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double from = value(a), to = value(b);
        if (from >= 0) kept.push_back(a);
        if ((from < 0) != (to < 0) && from != 0 && to != 0) kept.push_back(a + (b - a) * (from / (from - to)));
    }
    return kept;
}

// A prism that stands askew: its profile, seen along its axis from the plane, as far as the plane is between its ends. Nothing where it all but lies in the plane.
std::optional<Use> section_of_askew(SolidBuilder& builder, const Prism& prism, const Placement& at) {
    // A flatter one is a million times as long as its profile is wide: corners found on it would have lost six of their digits.
    constexpr double kLeastRise = 1e-6;
    const double a = at.linear(2, 0), b = at.linear(2, 1), up = at.linear(2, 2), off = at.offset(2);
    if (!(std::fabs(up) > kLeastRise * std::hypot(a, b))) return std::nullopt;
    const auto height = [&](const Vec2& p) { return -(a * p.x + b * p.y + off) / up; };
    const Bounds box = builder.bounds(prism.profile);
    const Vec3 room = 0.0625 * (box.hi - box.lo), lo = box.lo - room, hi = box.hi + room;
    const std::vector<Vec2> whole{{lo.x, lo.y}, {hi.x, lo.y}, {hi.x, hi.y}, {lo.x, hi.y}};
    std::vector<Vec2> between = clipped(whole, [&](const Vec2& p) { return height(p) - prism.z0; });
    if (between.size() >= 3) between = clipped(between, [&](const Vec2& p) { return prism.z1 - height(p); });
    if (between.size() < 3) return use_of(kEmptyNode);
    Use part = prism.profile;
    if (between != whole) part = use_of(builder.combine(SetOp::kIntersection, {part, *polygon(builder, {between})}));
    Placement seen;
    for (int i = 0; i < 2; ++i) {
        const double along = at.linear(i, 2) / up;
        seen.m[static_cast<std::size_t>(4 * i)] = at.linear(i, 0) - along * a;
        seen.m[static_cast<std::size_t>(4 * i + 1)] = at.linear(i, 1) - along * b;
        seen.m[static_cast<std::size_t>(4 * i + 2)] = 0;
        seen.m[static_cast<std::size_t>(4 * i + 3)] = at.offset(i) - along * off;
    }
    return builder.placed(seen, part);
}

// A cylinder whose axis is parallel to the plane.
std::optional<Use> section_of_lying(SolidBuilder& builder, const shape::Frustum& s, const Placement& at) {
    const double a = at.linear(2, 0), b = at.linear(2, 1), n = std::hypot(a, b), d = at.offset(2) / n;
    if (!(std::fabs(d) < s.r0)) return use_of(kEmptyNode);
    const double half = std::sqrt((s.r0 - d) * (s.r0 + d));
    std::vector<Vec2> corners;
    for (const auto& [side, z] : {std::pair(-half, s.z0), std::pair(half, s.z0), std::pair(half, s.z1), std::pair(-half, s.z1)}) {
        const Vec3 p = apply_to_point(at, Vec3((-d * a - side * b) / n, (-d * b + side * a) / n, z));
        corners.push_back({p.x, p.y});
    }
    return polygon(builder, {corners});
}

// An ellipsoid however it is placed: a circle of the unit ball, whose plane's normal is what z is there.
std::optional<Use> section_of_ball(SolidBuilder& builder, const shape::Ellipsoid& s, const Placement& at) {
    const auto row = [&](int i) { return Vec3(at.linear(i, 0) * s.radii.x, at.linear(i, 1) * s.radii.y, at.linear(i, 2) * s.radii.z); };
    const Vec3 rise = row(2);
    const double d = -at.offset(2) / glm::length(rise);
    if (!(std::fabs(d) < 1)) return use_of(kEmptyNode);
    const Vec3 normal = glm::normalize(rise), size = glm::abs(normal);
    const Vec3 aside = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0) : size.y <= size.z ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const double r = std::sqrt((1 - d) * (1 + d));
    const Vec3 u = r * glm::normalize(glm::cross(normal, aside)), v = glm::cross(normal, u);
    const Vec3 x = row(0), y = row(1);
    const Placement seen{{glm::dot(x, u), glm::dot(x, v), 0, at.offset(0) + d * glm::dot(x, normal), glm::dot(y, u), glm::dot(y, v), 0, at.offset(1) + d * glm::dot(y, normal), 0, 0, 1, 0}};
    return builder.placed(seen, use_of(builder.shape(shape::Disc{1})));
}

std::optional<Use> section_of_turned(SolidBuilder& builder, NodeId id, const Shape& s, const Placement& at) {
    if (const auto* ball = std::get_if<shape::Ellipsoid>(&s)) return section_of_ball(builder, *ball, at);
    const auto* frustum = std::get_if<shape::Frustum>(&s);
    if (frustum && frustum->r0 == frustum->r1 && at.linear(2, 2) == 0) return section_of_lying(builder, *frustum, at);
    const auto prism = prism_of(builder, use_of(id));
    return prism ? section_of_askew(builder, *prism, at) : std::nullopt;
}

std::optional<Use> section_of_shape(SolidBuilder& builder, NodeId id, const Placement& at) {
    const Shape s = std::get<Shape>(builder.node(id));
    if (is_faceted(s) && !(keeps_z(at) && std::holds_alternative<shape::Box>(s))) {
        const auto list = facets_at(builder, id, at);
        if (!list) return std::nullopt;
        return polygon(builder, section_of(*list));
    }
    const auto* ball = std::get_if<shape::Ellipsoid>(&s);
    if (ball && ball->radii.x == ball->radii.y && ball->radii.y == ball->radii.z) {  // however it is turned
        const auto scale = similarity_of(at, false);
        const double r = scale ? ball->radii.x * *scale : 0, z = at.offset(2);
        if (scale && std::fabs(z) >= r) return use_of(kEmptyNode);
        if (scale) return use_of(builder.shape(shape::Disc{std::sqrt((r - z) * (r + z))}), Placement::translation({at.offset(0), at.offset(1), 0}));
    }
    if (!keeps_z(at)) return section_of_turned(builder, id, s, at);
    const double up = at.linear(2, 2);
    if (up < 0) return std::nullopt;  // its lower neighbourhood would count
    auto level = std::visit(LevelOf{builder, -at.offset(2) / up}, s);
    if (level && level->node != kEmptyNode) level = builder.placed(in_plane(at), *level);
    return level;
}

std::optional<Use> section_at(SolidBuilder& builder, const Use& use, const Placement& above) {
    if (use.motion != 0 || use.node == kEmptyNode) return use.node == kEmptyNode ? std::optional(use_of(kEmptyNode)) : std::nullopt;
    const Placement at = above * use.placement;
    if (std::holds_alternative<Shape>(builder.node(use.node))) return section_of_shape(builder, use.node, at);
    const Combination c = std::get<Combination>(builder.node(use.node));
    std::vector<Use> parts;
    for (const Use& part : c.operands) {
        const auto own = section_at(builder, part, at);
        if (!own) return std::nullopt;
        parts.push_back(*own);
    }
    if (parts.size() == 1) return parts[0];
    return use_of(builder.combine(c.op, std::move(parts)));
}

std::optional<Use> shadow_at(SolidBuilder& builder, const Use& use, const Placement& above);

std::optional<Use> shadow_of_shape(SolidBuilder& builder, NodeId id, const Placement& at) {
    const Shape s = std::get<Shape>(builder.node(id));
    if (is_faceted(s) && !(keeps_z(at) && std::holds_alternative<shape::Box>(s))) {
        const auto list = facets_at(builder, id, at);
        if (!list) return std::nullopt;
        return polygon(builder, shadow_of(*list));
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

std::optional<Use> exact_section(SolidBuilder& builder, const Use& use) { return section_at(builder, use, {}); }

std::optional<Use> exact_shadow(SolidBuilder& builder, const Use& use) { return shadow_at(builder, use, {}); }

}  // namespace whittle
