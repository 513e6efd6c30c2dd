#include "modeler/mesh/tessellate.h"

#include <cmath>

#include "csg/base/degrees.h"

namespace whittle {

void join_rings(LeafMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        mesh.quad(a + i, a + j, b + j, b + i);
    }
}

// A zigzag from both ends: triangles stay wider than in a fan.
void close_ring(LeafMesh& mesh, std::uint32_t first, std::uint32_t n, Facing facing) {
    const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back(facing == Facing::kAsListed ? Triangle{first + a, first + b, first + c} : Triangle{first + a, first + c, first + b});
    };
    std::uint32_t low = 0, high = n - 1;
    while (high - low >= 2) {
        put(low, low + 1, high);
        ++low;
        if (high - low < 2) break;
        put(low, high - 1, high);
        --high;
    }
}

Tessellation tessellate_box(const Vec3& lo, const Vec3& hi) {
    Tessellation out;
    out.mesh.points = {{lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z},
                       {lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}};
    out.mesh.quad(0, 3, 2, 1);
    out.mesh.quad(4, 5, 6, 7);
    for (std::uint32_t i = 0; i < 4; ++i) out.mesh.quad(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4);
    return out;
}

namespace {

// n points, the first at `offset` steps.
std::uint32_t add_circle(LeafMesh& mesh, double r, double z, int n, double offset = 0) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (int i = 0; i < n; ++i) {
        const double a = 360.0 * (i + offset) / n;
        mesh.points.emplace_back(r * cosd(a), r * sind(a), z);
    }
    return first;
}

Tessellation frustum_of(double z0, double z1, double r0, double r1, int n) {
    Tessellation out;
    const std::uint32_t low = add_circle(out.mesh, r0, z0, n), high = add_circle(out.mesh, r1, z1, n);
    const auto count = static_cast<std::uint32_t>(n);
    join_rings(out.mesh, low, high, count);
    if (r0 > 0) close_ring(out.mesh, low, count, Facing::kReversed);
    if (r1 > 0) close_ring(out.mesh, high, count, Facing::kAsListed);
    return out;
}

}  // namespace

Tessellation tessellate_frustum(const shape::Frustum& s, const CurveRule& rule) {
    const double r = std::max(s.r0, s.r1);
    Tessellation out = frustum_of(s.z0, s.z1, s.r0, s.r1, rule.turn(r));
    out.error = rule.chord(r) * rule.scale;
    return out;
}

Tessellation tessellate_faceted_frustum(const shape::FacetedFrustum& s) { return frustum_of(s.z0, s.z1, s.r0, s.r1, s.n); }

// Rings at half steps of latitude, no poles: flat n-gons at both ends.
Tessellation tessellate_faceted_ball(const shape::FacetedBall& s) {
    Tessellation out;
    const int rings = (s.n + 1) / 2;
    const auto n = static_cast<std::uint32_t>(s.n);
    for (int i = 0; i < rings; ++i) {
        const double phi = 180.0 * (i + 0.5) / rings;
        add_circle(out.mesh, s.r * sind(phi), s.r * cosd(phi), s.n);
        if (i > 0) join_rings(out.mesh, static_cast<std::uint32_t>(i) * n, static_cast<std::uint32_t>(i - 1) * n, n);
    }
    close_ring(out.mesh, 0, n, Facing::kAsListed);
    close_ring(out.mesh, static_cast<std::uint32_t>(rings - 1) * n, n, Facing::kReversed);
    return out;
}

namespace {

// Circles by which a tube is cut: every other one is turned by half a step, so that triangles are nearly equilateral. In lengths in which both curvatures are one, such a
// triangle's width has 3/4 of the bulge over the triangle, its height 9/16.
Tessellation tube_of(const shape::Torus& s, const CurveRule& rule) {
    constexpr double kWidth = 0.75, kHeight = 0.5625;
    Tessellation out;
    const double outer = s.major + s.minor;
    const int around = rule.turn_within(outer, rule.chord(outer) * kWidth), along = rule.turn_within(s.minor, rule.chord(s.minor) * kHeight);
    const auto n = static_cast<std::uint32_t>(around);
    const bool horn = s.minor == s.major;  // touches itself on the axis; half a step aside it is a surface again, open there by less than the tolerance
    for (int i = 0; i < along; ++i) {
        const double a = -180 + 360 * (i + (horn ? 0.5 : 0.0)) / along;
        add_circle(out.mesh, s.major + s.minor * cosd(a), s.minor * sind(a), around, i % 2 == 0 ? 0 : 0.5);
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(along); ++i) {
        const std::uint32_t low = i * n, high = (i + 1) % static_cast<std::uint32_t>(along) * n, ahead = i % 2;  // from a turned circle the next point is the one ahead
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t tip = (k + ahead) % n;
            out.mesh.triangles.push_back({low + k, low + (k + 1) % n, high + tip});
            out.mesh.triangles.push_back({low + (k + 1) % n, high + (tip + 1) % n, high + tip});
        }
    }
    out.error = rule.chord(outer) * rule.scale;
    return out;
}

// Where the tube reaches over the axis, only the part of its circle on this side of the axis is outer surface.
Tessellation spindle_of(const shape::Torus& s, const CurveRule& rule) {
    Tessellation out;
    const double outer = s.major + s.minor;
    const int around = rule.turn_within(outer, rule.chord(outer) / 2), along = rule.turn_within(s.minor, rule.chord(s.minor) / 2);
    const auto n = static_cast<std::uint32_t>(around);
    const double half_deg = std::acos(-s.major / s.minor) / kRadiansPerDegree;
    const int steps = static_cast<int>(std::ceil(along * half_deg / 180));
    for (int i = 0; i <= steps; ++i) {
        const double a = -half_deg + 2 * half_deg * i / steps;
        const bool pole = i == 0 || i == steps;
        const double z = pole ? std::sqrt((s.minor - s.major) * (s.minor + s.major)) * (i == 0 ? -1 : 1) : s.minor * sind(a);
        add_circle(out.mesh, pole ? 0 : s.major + s.minor * cosd(a), z, around);
        if (i > 0) join_rings(out.mesh, static_cast<std::uint32_t>(i - 1) * n, static_cast<std::uint32_t>(i) * n, n);
    }
    out.error = rule.chord(outer) * rule.scale;
    return out;
}

}  // namespace

Tessellation tessellate_torus(const shape::Torus& s, const CurveRule& rule) { return s.minor > s.major ? spindle_of(s, rule) : tube_of(s, rule); }

Result<Tessellation> tessellate(const Solid& solid, NodeId node, const CurveRule& rule, const Bounds& room) {
    struct Visitor {
        const Solid& solid;
        const CurveRule& rule;
        const Bounds& room;
        using Answer = Result<Tessellation>;

        Answer operator()(const shape::Box& s) const { return tessellate_box(s.lo, s.hi); }
        Answer operator()(const shape::Ellipsoid& s) const { return tessellate_ellipsoid(s.radii, rule); }
        Answer operator()(const shape::Frustum& s) const { return tessellate_frustum(s, rule); }
        Answer operator()(const shape::Torus& s) const { return tessellate_torus(s, rule); }
        Answer operator()(const shape::HalfSpace& s) const { return tessellate_half_space(s, room); }
        Answer operator()(const shape::Quadric& s) const { return tessellate_quadric(s, rule, room); }
        Answer operator()(const shape::Capsule& s) const { return tessellate_capsule(s, rule); }
        Answer operator()(const shape::RoundBox& s) const { return tessellate_rounded(s.lo + s.r, s.hi - s.r, s.r, rule); }
        Answer operator()(const shape::ConvexBody& s) const { return tessellate_convex(s, rule); }
        Answer operator()(const shape::FacetedBall& s) const { return tessellate_faceted_ball(s); }
        Answer operator()(const shape::FacetedFrustum& s) const { return tessellate_faceted_frustum(s); }
        Answer operator()(const shape::Polyhedron& s) const { return tessellate_polyhedron(*s.mesh); }
        Answer operator()(const shape::Extrusion& s) const { return tessellate_extrusion(solid, s, rule); }
        Answer operator()(const shape::Revolution& s) const { return tessellate_revolution(solid, s, rule); }
        Answer operator()(const shape::Disc&) const { return flat(); }
        Answer operator()(const shape::Rectangle&) const { return flat(); }
        Answer operator()(const shape::Polygon&) const { return flat(); }
        Answer operator()(const shape::ParabolicSegment&) const { return flat(); }
        static Answer flat() { return fail(Fault::kScene, "a 2D shape has no mesh"); }
    };
    return std::visit(Visitor{solid, rule, room}, std::get<Shape>(solid.node(node)));
}

}  // namespace whittle
