#include "csg/solid/convex_parts.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/facets.h"

namespace whittle {
namespace {

// Of products of rotations, whose entries carry a rounding each.
constexpr double kSimilarityRounding = 64 * 0x1p-53;

struct BallsOf {
    const Solid& solid;
    NodeId node;
    const Placement& at;
    std::vector<Ball>& out;

    bool corner(Vec3 p) {
        out.push_back({apply_to_point(at, p), 0});
        return true;
    }
    bool ball(Vec3 c, double r, bool flat) {
        const auto scale = similarity_of(at, flat);
        if (scale) out.push_back({apply_to_point(at, c), r * *scale});
        return scale.has_value();
    }
    bool corners_of_box(Vec3 lo, Vec3 hi) {
        for (int i = 0; i < 8; ++i) corner({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
        return true;
    }
    bool facets() {
        const auto list = facets_of(solid, node);
        if (!list) return false;
        for (const Vec3& p : list->points) corner(p);
        return true;
    }

    bool operator()(const shape::Box& s) { return corners_of_box(s.lo, s.hi); }
    bool operator()(const shape::Ellipsoid& s) { return s.radii.x == s.radii.y && s.radii.y == s.radii.z && ball(Vec3(0), s.radii.x, false); }
    bool operator()(const shape::Capsule& s) { return ball(s.p, s.r, false) && ball(s.q, s.r, false); }
    bool operator()(const shape::RoundBox& s) {
        const Vec3 lo = s.lo + s.r, hi = s.hi - s.r;
        for (int i = 0; i < 8; ++i)
            if (!ball({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z}, s.r, false)) return false;
        return true;
    }
    bool operator()(const shape::FacetedBall&) { return facets(); }
    bool operator()(const shape::FacetedFrustum&) { return facets(); }
    bool operator()(const shape::Polyhedron& s) {
        for (const Vec3& p : s.mesh->points) corner(p);
        return true;
    }
    bool operator()(const shape::Extrusion& s) {
        std::vector<Ball> flat;
        if (s.slices > 0) return facets();
        if (s.twist_deg != 0) return false;
        Use profile;
        profile.node = s.profile;
        const auto parts = balls_of(solid, profile);
        if (!parts || std::any_of(parts->begin(), parts->end(), [](const Ball& b) { return b.r > 0; })) return false;
        for (const Ball& b : *parts) {
            corner({b.c.x, b.c.y, s.z0});
            corner({b.c.x * s.scale_top.x, b.c.y * s.scale_top.y, s.z1});
        }
        return true;
    }
    bool operator()(const shape::Revolution& s) { return s.fragments > 0 && facets(); }
    bool operator()(const shape::Disc& s) { return ball(Vec3(0), s.r, true); }
    bool operator()(const shape::Rectangle& s) {
        for (const Vec2 p : {s.lo, Vec2(s.hi.x, s.lo.y), s.hi, Vec2(s.lo.x, s.hi.y)}) corner({p.x, p.y, 0});
        return true;
    }
    bool operator()(const shape::Polygon& s) {
        if (s.section != kEmptyNode) return false;
        for (const auto& contour : *s.contours)
            for (const Vec2& p : contour) corner({p.x, p.y, 0});
        return true;
    }
    bool operator()(const auto&) { return false; }
};

bool collect(const Solid& solid, const Use& use, const Placement& above, std::vector<Ball>& out) {
    if (use.motion != 0) return false;
    const Placement at = above * use.placement;
    const Node& node = solid.node(use.node);
    if (const auto* s = std::get_if<Shape>(&node)) return std::visit(BallsOf{solid, use.node, at, out}, *s);
    const auto& c = std::get<Combination>(node);
    return c.op == SetOp::kUnion && std::all_of(c.operands.begin(), c.operands.end(), [&](const Use& part) { return collect(solid, part, at, out); });
}

// The shape as profile and heights, in its own frame.
std::optional<Prism> upright(SolidBuilder& builder, NodeId id) {
    const auto* shape = std::get_if<Shape>(&builder.node(id));
    if (!shape) return std::nullopt;
    const Shape s = *shape;
    Prism out{};
    if (const auto* box = std::get_if<shape::Box>(&s)) {
        out = {{}, box->lo.z, box->hi.z};
        out.profile.node = builder.shape(shape::Rectangle{{box->lo.x, box->lo.y}, {box->hi.x, box->hi.y}});
    } else if (const auto* bar = std::get_if<shape::Frustum>(&s); bar && bar->r0 == bar->r1) {
        out = {{}, bar->z0, bar->z1};
        out.profile.node = builder.shape(shape::Disc{bar->r0});
    } else if (const auto* stick = std::get_if<shape::FacetedFrustum>(&s); stick && stick->r0 == stick->r1) {
        out = {{}, stick->z0, stick->z1};
        out.profile.node = builder.shape(shape::Polygon{std::make_shared<const Contours>(Contours{circle_points(stick->r0, stick->n)})});
    } else if (const auto* e = std::get_if<shape::Extrusion>(&s); e && e->twist_deg == 0 && e->scale_top == Vec2(1)) {
        out = {{}, e->z0, e->z1};
        out.profile.node = e->profile;
    } else {
        return std::nullopt;
    }
    return out;
}

}  // namespace

std::optional<std::vector<Ball>> balls_of(const Solid& solid, const Use& use) {
    std::vector<Ball> out;
    if (!collect(solid, use, {}, out)) return std::nullopt;
    return out;
}

bool keeps_z(const Placement& a) {
    return a.linear(0, 2) == 0 && a.linear(1, 2) == 0 && a.linear(2, 0) == 0 && a.linear(2, 1) == 0;
}

std::optional<double> similarity_of(const Placement& a, bool flat) {
    const int n = flat ? 2 : 3;
    double squared = 0;
    for (int i = 0; i < n; ++i) squared += a.linear(i, 0) * a.linear(i, 0);
    for (int j = 0; j < n; ++j)
        for (int k = j; k < n; ++k) {
            double dot = 0;
            for (int i = 0; i < n; ++i) dot += a.linear(i, j) * a.linear(i, k);
            if (std::fabs(dot - (j == k ? squared : 0)) > kSimilarityRounding * squared) return std::nullopt;
        }
    return std::sqrt(squared);
}

std::optional<Prism> prism_of(SolidBuilder& builder, const Use& use) {
    if (use.motion != 0 || !keeps_z(use.placement)) return std::nullopt;
    std::optional<Prism> out;
    const auto* c = std::get_if<Combination>(&builder.node(use.node));
    if (c && c->op == SetOp::kUnion && c->operands.size() == 1) {
        const Use inner = c->operands[0];
        out = prism_of(builder, inner);
    } else {
        out = upright(builder, use.node);
    }
    if (!out) return std::nullopt;
    const Placement& a = use.placement;
    const double z0 = a.linear(2, 2) * out->z0 + a.offset(2), z1 = a.linear(2, 2) * out->z1 + a.offset(2);
    out->z0 = std::min(z0, z1);
    out->z1 = std::max(z0, z1);
    out->profile = builder.placed({{a.m[0], a.m[1], 0, a.m[3], a.m[4], a.m[5], 0, a.m[7], 0, 0, 1, 0}}, out->profile);
    out->profile.label = kNoLabel;
    return out;
}

}  // namespace whittle
