#include "csg/solid/support.h"

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/convex_body.h"
#include "csg/solid/facets.h"

namespace whittle {
namespace {

using Reach = std::optional<double>;

double in_plane(Vec3 d) { return std::hypot(d.x, d.y); }
double of_box(Vec3 lo, Vec3 hi, Vec3 d) {
    double h = 0;
    for (int i = 0; i < 3; ++i) h += std::max(lo[i] * d[i], hi[i] * d[i]);
    return h;
}
// A disc of radius r at height z, or OpenSCAD's n-gon in it.
double of_ring(double r, double z, int n, Vec3 d) {
    if (n == 0) return r * in_plane(d) + z * d.z;
    double h = r * d.x;
    for (const Vec2& p : circle_points(r, n)) h = std::max(h, p.x * d.x + p.y * d.y);
    return h + z * d.z;
}

struct ReachOf {
    const Solid& solid;
    Vec3 d;

    Reach operator()(const shape::Box& s) const { return of_box(s.lo, s.hi, d); }
    Reach operator()(const shape::Ellipsoid& s) const { return glm::length(s.radii * d); }
    Reach operator()(const shape::Frustum& s) const { return std::max(of_ring(s.r0, s.z0, 0, d), of_ring(s.r1, s.z1, 0, d)); }
    Reach operator()(const shape::Torus& s) const { return s.major * in_plane(d) + s.minor * glm::length(d); }
    Reach operator()(const shape::HalfSpace&) const { return std::nullopt; }
    Reach operator()(const shape::Quadric&) const { return std::nullopt; }
    Reach operator()(const shape::Capsule& s) const { return std::max(glm::dot(s.p, d), glm::dot(s.q, d)) + s.r * glm::length(d); }
    Reach operator()(const shape::RoundBox& s) const { return of_box(s.lo + s.r, s.hi - s.r, d) + s.r * glm::length(d); }
    Reach operator()(const shape::ConvexBody& s) const { return reach(s.hull->parts, d); }
    Reach operator()(const shape::FacetedBall& s) const {
        const int rings = (s.n + 1) / 2;
        double h = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < rings; ++i) {
            const double phi = 180.0 * (i + 0.5) / rings;
            h = std::max(h, of_ring(s.r * sind(phi), s.r * cosd(phi), s.n, d));
        }
        return h;
    }
    Reach operator()(const shape::FacetedFrustum& s) const { return std::max(of_ring(s.r0, s.z0, s.n, d), of_ring(s.r1, s.z1, s.n, d)); }
    Reach operator()(const shape::Polyhedron& s) const {
        double h = -std::numeric_limits<double>::infinity();
        for (const Vec3& p : s.mesh->points) h = std::max(h, glm::dot(p, d));
        return h;
    }
    Reach operator()(const shape::Extrusion& s) const {
        if (s.twist_deg != 0) return std::nullopt;
        const Reach bottom = support(solid, s.profile, {d.x, d.y, 0}), top = support(solid, s.profile, {d.x * s.scale_top.x, d.y * s.scale_top.y, 0});
        if (!bottom || !top) return std::nullopt;
        return std::max(*bottom + d.z * s.z0, *top + d.z * s.z1);
    }
    Reach operator()(const shape::Revolution& s) const {
        if (s.fragments != 0 || s.angle_deg < 360) return std::nullopt;
        return support(solid, s.profile, {in_plane(d), d.z, 0});
    }
    Reach operator()(const shape::Disc& s) const { return of_ring(s.r, 0, 0, d); }
    Reach operator()(const shape::Rectangle& s) const { return of_box({s.lo.x, s.lo.y, 0}, {s.hi.x, s.hi.y, 0}, d); }
    Reach operator()(const shape::Polygon& s) const {
        double h = -std::numeric_limits<double>::infinity();
        for (const auto& contour : *s.contours)
            for (const Vec2& p : contour) h = std::max(h, p.x * d.x + p.y * d.y);
        return h;
    }
    // Along d the curve is a + 2 (c - a) t + (a - 2 c + b) t^2: farthest at an end or where its slope is 0.
    Reach operator()(const shape::ParabolicSegment& s) const {
        const Vec2 way(d.x, d.y);
        const double a = glm::dot(s.a, way), b = glm::dot(s.b, way), rise = glm::dot(s.c - s.a, way), fall = glm::dot(s.c - s.b, way);
        return rise > 0 && fall > 0 ? a + rise * (rise / (rise + fall)) : std::max(a, b);
    }
};

Reach of_use(const Solid& solid, const Use& use, Vec3 d) {
    if (use.motion != 0) return std::nullopt;
    const Placement& a = use.placement;
    const Vec3 within{a.m[0] * d.x + a.m[4] * d.y + a.m[8] * d.z, a.m[1] * d.x + a.m[5] * d.y + a.m[9] * d.z, a.m[2] * d.x + a.m[6] * d.y + a.m[10] * d.z};
    const Reach h = support(solid, use.node, within);
    if (!h) return std::nullopt;
    return *h + a.offset(0) * d.x + a.offset(1) * d.y + a.offset(2) * d.z;
}

}  // namespace

std::optional<double> support(const Solid& solid, NodeId node, Vec3 direction) {
    if (const auto* s = std::get_if<Shape>(&solid.node(node))) return std::visit(ReachOf{solid, direction}, *s);
    const auto& c = std::get<Combination>(solid.node(node));
    if (c.operands.empty() || c.op != SetOp::kUnion) return std::nullopt;
    double most = -std::numeric_limits<double>::infinity();
    for (const Use& use : c.operands) {
        const Reach h = of_use(solid, use, direction);
        if (!h) return std::nullopt;
        most = std::max(most, *h);
    }
    return most;
}

std::optional<Bounds> tight_bounds(const Solid& solid, const Use& use) {
    Bounds b;
    for (int i = 0; i < 3; ++i) {
        Vec3 d(0);
        d[i] = 1;
        const Reach hi = of_use(solid, use, d), lo = of_use(solid, use, -d);
        if (!hi || !lo) return std::nullopt;
        b.lo[i] = -*lo;
        b.hi[i] = *hi;
    }
    return b;
}

}  // namespace whittle
