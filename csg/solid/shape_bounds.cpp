#include "csg/solid/shape_bounds.h"

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/convex_body.h"
#include "csg/solid/directed.h"
#include "csg/solid/placement.h"
#include "csg/solid/predicates.h"

namespace whittle {
namespace {

// Room for what is computed with sines, square roots or facets whose planes pass beside their rounded corners: a few dozen roundings of 2^-53.
constexpr double kRoom = 0x1p-44;
// A quadric's box is given only where its matrix is this far from singular; what long double loses is then below kQuadricRoom.
constexpr long double kQuadricRegular = 0x1p-20L;
constexpr double kQuadricRoom = 0x1p-30;

const Bounds kEverywhere{Vec3(-kInfinity), Vec3(kInfinity)};

// Heights are the author's numbers and stay; `axes` says how many coordinates are computed ones.
Bounds widened(Bounds b, double relative, int axes = 2) {
    for (int i = 0; i < axes; ++i) {
        const double room = relative * std::max(std::fabs(b.lo[i]), std::fabs(b.hi[i]));
        if (room == 0) continue;
        b.lo[i] = add_down(b.lo[i], -room);
        b.hi[i] = add_up(b.hi[i], room);
    }
    return b;
}
void include(Bounds& b, Vec3 p) { b = around(b, {p, p}); }

Bounds round_bar(double radius, double z0, double z1) { return {{-radius, -radius, z0}, {radius, radius, z1}}; }

// Half-spaces along an axis are bounded on one side; all others on none.
Bounds half_space_bounds(const shape::HalfSpace& s) {
    Bounds b = kEverywhere;
    const int nonzero = (s.n.x != 0) + (s.n.y != 0) + (s.n.z != 0);
    if (nonzero != 1) return b;
    const int axis = s.n.x != 0 ? 0 : s.n.y != 0 ? 1 : 2;
    const double at = s.d / s.n[axis];
    if (s.n[axis] > 0) b.hi[axis] = next_up(at);
    else b.lo[axis] = next_down(at);
    return b;
}

// An ellipsoid p.Ap + b.p + c <= 0 has its centre at -A^-1 b / 2 and reaches sqrt(k (A^-1)_ii) from it, k = b.A^-1 b / 4 - c.
Bounds quadric_bounds(const shape::Quadric& s) {
    using Real = long double;
    const Real a = s.c[0], b = s.c[1], c = s.c[2], f = Real(s.c[3]) / 2, g = Real(s.c[4]) / 2, h = Real(s.c[5]) / 2;
    const Real minor = a * b - f * f, det = a * (b * c - h * h) - f * (f * c - h * g) + g * (f * h - b * g);
    if (!(a > 0 && b > 0 && c > 0 && minor > kQuadricRegular * a * b && det > kQuadricRegular * a * b * c)) return kEverywhere;
    const Real inverse[3][3] = {{(b * c - h * h) / det, (g * h - f * c) / det, (f * h - g * b) / det},
                                {(g * h - f * c) / det, (a * c - g * g) / det, (f * g - a * h) / det},
                                {(f * h - g * b) / det, (f * g - a * h) / det, (a * b - f * f) / det}};
    Real centre[3], k = 0, size = std::fabs(Real(s.c[9]));
    for (int i = 0; i < 3; ++i) {
        centre[i] = 0;
        for (int j = 0; j < 3; ++j) {
            centre[i] -= inverse[i][j] * Real(s.c[static_cast<std::size_t>(6 + j)]) / 2;
            size += std::fabs(inverse[i][j] * Real(s.c[static_cast<std::size_t>(6 + i)]) * Real(s.c[static_cast<std::size_t>(6 + j)]) / 4);
        }
        k -= centre[i] * Real(s.c[static_cast<std::size_t>(6 + i)]) / 2;
    }
    k += kQuadricRoom * size - Real(s.c[9]);
    if (!(k >= 0)) return {};
    Bounds r;
    for (int i = 0; i < 3; ++i) {
        const Real reach = std::sqrt(inverse[i][i] * k) * (1 + Real(kQuadricRoom)) + std::fabs(centre[i]) * Real(kQuadricRoom);
        r.lo[i] = next_down(static_cast<double>(centre[i] - reach));
        r.hi[i] = next_up(static_cast<double>(centre[i] + reach));
    }
    return r;
}

Bounds capsule_bounds(const shape::Capsule& s) {
    Bounds b;
    for (int i = 0; i < 3; ++i) {
        b.lo[i] = add_down(std::min(s.p[i], s.q[i]), -s.r);
        b.hi[i] = add_up(std::max(s.p[i], s.q[i]), s.r);
    }
    return b;
}

Bounds convex_bounds(const shape::ConvexBody& s) {
    Bounds b;
    for (int i = 0; i < 3; ++i) {
        Vec3 way(0);
        way[i] = 1;
        b.hi[i] = reach(s.hull->parts, way);
        b.lo[i] = -reach(s.hull->parts, -way);
    }
    const double room = kRoom * s.hull->size;
    for (int i = 0; i < 3; ++i) b.lo[i] = add_down(b.lo[i], -room), b.hi[i] = add_up(b.hi[i], room);
    return b;
}

Bounds extrusion_bounds(const shape::Extrusion& s, const Bounds& profile) {
    if (profile.empty()) return {};
    Bounds b{{profile.lo.x, profile.lo.y, s.z0}, {profile.hi.x, profile.hi.y, s.z1}};
    if (s.twist_deg != 0) {
        const double x = std::max(std::fabs(profile.lo.x), std::fabs(profile.hi.x)), y = std::max(std::fabs(profile.lo.y), std::fabs(profile.hi.y));
        const double grown = std::max({1.0, s.scale_top.x, s.scale_top.y}), radius = std::hypot(x, y) * grown;
        return widened(round_bar(radius, s.z0, s.z1), kRoom);
    }
    const Bounds top = placed_bounds(profile, {{s.scale_top.x, 0, 0, 0, 0, s.scale_top.y, 0, 0, 0, 0, 1, 0}});
    b.lo = glm::min(b.lo, {top.lo.x, top.lo.y, s.z0});
    b.hi = glm::max(b.hi, {top.hi.x, top.hi.y, s.z1});
    return s.slices > 0 ? widened(b, kRoom) : b;
}

Bounds revolution_bounds(const shape::Revolution& s, const Bounds& profile) {
    if (profile.empty()) return {};
    const double radius = std::max(std::fabs(profile.lo.x), std::fabs(profile.hi.x));
    if (s.angle_deg >= 360) return widened(round_bar(radius, profile.lo.y, profile.hi.y), s.fragments > 0 ? kRoom : 0);
    Bounds flat;  // the corners of the sector, and the quarter turns within it
    const double end = s.start_deg + s.angle_deg;
    const auto add = [&](double deg) {
        for (const double x : {profile.lo.x, profile.hi.x}) include(flat, {x * cosd(deg), x * sind(deg), 0});
    };
    add(s.start_deg);
    add(end);
    for (double quarter = 90 * std::ceil(s.start_deg / 90); quarter < end; quarter += 90) add(quarter);
    flat = widened(flat, kRoom);
    const double room = radius * kRoom;  // a sector's side on an axis has rounded coordinates beside it
    return {{flat.lo.x - room, flat.lo.y - room, profile.lo.y}, {flat.hi.x + room, flat.hi.y + room, profile.hi.y}};
}

struct BoundsOf {
    const Bounds& part;

    Bounds operator()(const shape::Box& s) const { return {s.lo, s.hi}; }
    Bounds operator()(const shape::Ellipsoid& s) const { return {-s.radii, s.radii}; }
    Bounds operator()(const shape::Frustum& s) const { return round_bar(std::max(s.r0, s.r1), s.z0, s.z1); }
    Bounds operator()(const shape::Torus& s) const { return round_bar(add_up(s.major, s.minor), -s.minor, s.minor); }
    Bounds operator()(const shape::HalfSpace& s) const { return half_space_bounds(s); }
    Bounds operator()(const shape::Quadric& s) const { return quadric_bounds(s); }
    Bounds operator()(const shape::Capsule& s) const { return capsule_bounds(s); }
    Bounds operator()(const shape::RoundBox& s) const { return {s.lo, s.hi}; }
    Bounds operator()(const shape::ConvexBody& s) const { return convex_bounds(s); }
    Bounds operator()(const shape::FacetedBall& s) const { return widened(round_bar(s.r, -s.r, s.r), kRoom, 3); }
    Bounds operator()(const shape::FacetedFrustum& s) const {
        return widened(round_bar(std::max(s.r0, s.r1), s.z0, s.z1), kRoom);
    }
    Bounds operator()(const shape::Polyhedron& s) const {
        Bounds b;
        for (const Vec3& p : s.mesh->points) include(b, p);
        return b;
    }
    Bounds operator()(const shape::Extrusion& s) const { return extrusion_bounds(s, part); }
    Bounds operator()(const shape::Revolution& s) const { return revolution_bounds(s, part); }
    Bounds operator()(const shape::Disc& s) const { return round_bar(s.r, 0, 0); }
    Bounds operator()(const shape::Rectangle& s) const { return {{s.lo.x, s.lo.y, 0}, {s.hi.x, s.hi.y, 0}}; }
    Bounds operator()(const shape::Polygon& s) const {
        if (s.section != kEmptyNode) return part.empty() ? part : Bounds{{part.lo.x, part.lo.y, 0}, {part.hi.x, part.hi.y, 0}};
        Bounds b;
        for (const auto& contour : *s.contours)
            for (const Vec2& p : contour) include(b, {p.x, p.y, 0});
        return b;
    }
    // The arc stays below the tangent along the chord, which halves the control point's two sides.
    Bounds operator()(const shape::ParabolicSegment& s) const {
        Bounds b;
        if (turn_of(s.a, s.c, s.b) == 0) return b;
        for (const Vec2& p : {s.a, (s.a + s.c) / 2.0, (s.c + s.b) / 2.0, s.b}) include(b, {p.x, p.y, 0});
        return {{next_down(b.lo.x), next_down(b.lo.y), 0}, {next_up(b.hi.x), next_up(b.hi.y), 0}};
    }
};

}  // namespace

Bounds shape_bounds(const Shape& shape, const Bounds& part) { return std::visit(BoundsOf{part}, shape); }

}  // namespace whittle
