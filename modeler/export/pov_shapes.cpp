#include "modeler/export/pov_shapes.h"

#include <algorithm>
#include <cmath>

#include "modeler/export/number_text.h"

namespace whittle {
namespace {

// POV-Ray sweeps along y; ours is z.
constexpr const char* kUpright = " matrix<1,0,0,0,0,1,0,1,0,0,0,0>";

std::string sphere(const Vec3& centre, double r) { return "sphere{" + pov_vector(centre) + "," + shortest(r); }
std::string cylinder(const Vec3& a, const Vec3& b, double r) { return "cylinder{" + pov_vector(a) + "," + pov_vector(b) + "," + shortest(r); }
std::string box(const Vec3& lo, const Vec3& hi) { return "box{" + pov_vector(lo) + "," + pov_vector(hi); }

std::string frustum(double z0, double z1, double r0, double r1) {
    if (r0 == r1) return cylinder({0, 0, z0}, {0, 0, z1}, r0);
    return "cone{" + pov_vector(Vec3(0, 0, z0)) + "," + shortest(r0) + "," + pov_vector(Vec3(0, 0, z1)) + "," + shortest(r1);
}

// The spindle's inside is what the torus and the sphere through its tips cover.
std::string torus(double major, double minor, double z) {
    const std::string ring = "torus{" + shortest(major) + "," + shortest(minor) + " sturm" + kUpright;
    const std::string lift = z != 0 ? " translate " + shortest(z) + "*z" : "";
    if (minor <= major) return ring + lift;
    return "merge{" + ring + "} " + sphere(Vec3(0), std::sqrt((minor - major) * (minor + major))) + "}" + lift;
}

std::string ellipsoid(const Vec3& r) {
    if (r.x == r.y && r.y == r.z) return sphere(Vec3(0), r.x);
    return sphere(Vec3(0), 1) + " scale " + pov_vector(r);
}

std::string capsule(const shape::Capsule& c) { return "merge{" + sphere(c.p, c.r) + "} " + sphere(c.q, c.r) + "} " + cylinder(c.p, c.q, c.r) + "}"; }

// Three boxes, twelve rods, eight balls.
std::string round_box(const shape::RoundBox& b) {
    const Vec3 lo = b.lo + b.r, hi = b.hi - b.r;
    std::string out = "merge{";
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 from = lo, to = hi;
        from[axis] = b.lo[axis], to[axis] = b.hi[axis];
        if (from.x < to.x && from.y < to.y && from.z < to.z) out += box(from, to) + "} ";
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 p = lo, q = hi;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            p[u] = q[u] = corner & 1 ? hi[u] : lo[u];
            p[v] = q[v] = corner & 2 ? hi[v] : lo[v];
            if (p[axis] < q[axis]) out += cylinder(p, q, b.r) + "} ";
        }
    }
    for (int corner = 0; corner < 8; ++corner) out += sphere({corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z}, b.r) + "} ";
    return out;
}

std::string quadric(const std::array<double, 10>& c) {
    return "quadric{" + pov_vector(Vec3(c[0], c[1], c[2])) + "," + pov_vector(Vec3(c[3], c[4], c[5])) + "," + pov_vector(Vec3(c[6], c[7], c[8])) + "," + shortest(c[9]);
}

using Ring = std::vector<Vec2>;

std::string prism(const std::vector<Ring>& rings, double z0, double z1) {
    std::size_t count = 0;
    for (const Ring& ring : rings) count += ring.size() + 1;
    std::string out = "prism{linear_sweep linear_spline " + shortest(z0) + "," + shortest(z1) + "," + std::to_string(count);
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i <= ring.size(); ++i) out += "," + pov_vector(ring[i % ring.size()]);
    return out + kUpright;
}

// A prism of cubic Bezier curves: the arc raised to degree three, and its chord.
std::string prism(const shape::ParabolicSegment& s, double z0, double z1) {
    const auto cubic = [](Vec2 a, Vec2 c, Vec2 b) { return pov_vector(a) + "," + pov_vector((a + 2.0 * c) / 3.0) + "," + pov_vector((b + 2.0 * c) / 3.0) + "," + pov_vector(b); };
    return "prism{bezier_spline linear_sweep " + shortest(z0) + "," + shortest(z1) + ",8," + cubic(s.a, s.c, s.b) + "," + cubic(s.b, (s.a + s.b) / 2.0, s.a) + kUpright;
}

std::optional<std::string> lathe(const Ring& ring) {
    std::string out = "lathe{linear_spline " + std::to_string(ring.size() + 1);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
        if (ring[i % ring.size()].x < 0) return std::nullopt;
        out += "," + pov_vector(ring[i % ring.size()]);
    }
    return out + " sturm" + kUpright;
}

Ring placed(const Ring& ring, const Placement& placement) {
    Ring out;
    for (const Vec2& p : ring) {
        const Vec3 q = apply_to_point(placement, {p.x, p.y, 0});
        out.push_back({q.x, q.y});
    }
    return out;
}
Ring corners(const shape::Rectangle& r) { return {r.lo, {r.hi.x, r.lo.y}, r.hi, {r.lo.x, r.hi.y}}; }

}  // namespace

std::optional<std::string> pov_shape(const Shape& shape) {
    if (const auto* s = std::get_if<shape::Box>(&shape)) return box(s->lo, s->hi);
    if (const auto* s = std::get_if<shape::Ellipsoid>(&shape)) return ellipsoid(s->radii);
    if (const auto* s = std::get_if<shape::Frustum>(&shape)) return frustum(s->z0, s->z1, s->r0, s->r1);
    if (const auto* s = std::get_if<shape::Torus>(&shape)) return torus(s->major, s->minor, 0);
    if (const auto* s = std::get_if<shape::HalfSpace>(&shape)) return "plane{" + pov_vector(s->n) + "," + shortest(s->d / glm::length(s->n));
    if (const auto* s = std::get_if<shape::Quadric>(&shape)) return quadric(s->c);
    if (const auto* s = std::get_if<shape::Capsule>(&shape)) return capsule(*s);
    if (const auto* s = std::get_if<shape::RoundBox>(&shape)) return round_box(*s);
    return std::nullopt;
}

std::optional<std::string> pov_raised(const Shape& flat, double z0, double z1) {
    if (const auto* s = std::get_if<shape::Disc>(&flat)) return frustum(z0, z1, s->r, s->r);
    if (const auto* s = std::get_if<shape::Rectangle>(&flat)) return box({s->lo, z0}, {s->hi, z1});
    if (const auto* s = std::get_if<shape::Polygon>(&flat)) return prism(*s->contours, z0, z1);
    if (const auto* s = std::get_if<shape::ParabolicSegment>(&flat)) return prism(*s, z0, z1);
    return std::nullopt;
}

std::optional<std::string> pov_turned(const Shape& flat, const Placement& a) {
    if (const auto* s = std::get_if<shape::Disc>(&flat)) {
        const bool round = a.m[0] * a.m[0] + a.m[4] * a.m[4] == a.m[1] * a.m[1] + a.m[5] * a.m[5] && a.m[0] * a.m[1] + a.m[4] * a.m[5] == 0;
        const double r = s->r * std::hypot(a.m[0], a.m[4]);
        if (!round || a.offset(0) < 0) return std::nullopt;
        return a.offset(0) == 0 ? sphere({0, 0, a.offset(1)}, r) : torus(a.offset(0), r, a.offset(1));
    }
    if (const auto* s = std::get_if<shape::Rectangle>(&flat)) return lathe(placed(corners(*s), a));
    if (const auto* s = std::get_if<shape::Polygon>(&flat)) {
        if (s->contours->size() == 1) return lathe(placed(s->contours->front(), a));
    }
    return std::nullopt;
}

// An odd direction, so that rays that count crossings meet no edge of what people draw.
std::string pov_mesh(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    std::string out = "mesh2{vertex_vectors{" + std::to_string(points.size());
    for (const Vec3& p : points) out += "," + pov_vector(p);
    out += "} face_indices{" + std::to_string(triangles.size());
    for (const Triangle& t : triangles) out += ",<" + std::to_string(t[0]) + "," + std::to_string(t[1]) + "," + std::to_string(t[2]) + ">";
    return out + "} inside_vector <0.6173,0.5441,0.5682>";
}

std::string pov_matrix(const Placement& p) {
    if (p.is_identity()) return {};
    if (p == Placement::translation({p.offset(0), p.offset(1), p.offset(2)})) return " translate " + pov_vector(Vec3(p.offset(0), p.offset(1), p.offset(2)));
    std::string out = " matrix<";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) out += (column + row > 0 ? "," : "") + shortest(p.m[static_cast<std::size_t>(4 * row + column)]);
    return out + ">";
}

}  // namespace whittle
