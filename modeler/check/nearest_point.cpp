// nearest_point.cpp — round bodies are asked in their meridian half plane, flat ones facet by facet.
#include "modeler/check/nearest_point.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/convex_line.h"
#include "csg/solid/parabola.h"

namespace whittle {

namespace {

constexpr double kSameNormal = 0x1p-40;  // less than 1 by so little is the cosine of an angle that rounding makes
constexpr double kBelowFace = 0x1p-30;   // of a body's size

}  // namespace

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 ab = b - a;
    const double l2 = glm::dot(ab, ab);
    const double t = l2 > 0 ? std::clamp(glm::dot(p - a, ab) / l2, 0.0, 1.0) : 0;
    return glm::length(p - a - t * ab);
}

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 ab = b - a;
    const double l2 = glm::dot(ab, ab);
    const double t = l2 > 0 ? std::clamp(glm::dot(p - a, ab) / l2, 0.0, 1.0) : 0;
    return glm::length(p - a - t * ab);
}

namespace {

// Newell's normal, of the length of twice the area.
Vec3 polygon_normal(std::span<const Vec3> polygon) {
    Vec3 n(0);
    for (std::size_t i = 0; i < polygon.size(); ++i) n += glm::cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return n;
}

// Even-odd for a point of the polygon's plane, seen along the normal's largest coordinate.
bool is_in_polygon(Vec3 p, std::span<const Vec3> polygon, Vec3 n) {
    const Vec3 a = glm::abs(n);
    const int drop = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const int i = (drop + 1) % 3, j = (drop + 2) % 3;
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &u = polygon[k], &v = polygon[(k + 1) % polygon.size()];
        if ((u[j] > p[j]) == (v[j] > p[j])) continue;
        if (p[i] < u[i] + (p[j] - u[j]) / (v[j] - u[j]) * (v[i] - u[i])) inside = !inside;
    }
    return inside;
}

double distance_to_box(Vec3 p, Vec3 lo, Vec3 hi) {
    const Vec3 out = glm::max(glm::max(lo - p, p - hi), Vec3(0));
    const double outside = glm::length(out);
    if (outside > 0) return outside;
    const Vec3 in = glm::min(p - lo, hi - p);
    return std::min({in.x, in.y, in.z});
}

LeafDistance of(const shape::Box& s, Vec3 p) { return {kInfiniteDistance, distance_to_box(p, s.lo, s.hi)}; }
LeafDistance of(const shape::Ellipsoid& s, Vec3 p) { return {distance_to_ellipsoid(p, s.radii), kInfiniteDistance}; }
LeafDistance of(const shape::Frustum& s, Vec3 p) {
    const Vec2 q(std::hypot(p.x, p.y), p.z);
    const double wall = distance_to_segment(q, {s.r0, s.z0}, {s.r1, s.z1});
    const double bottom = s.r0 > 0 ? distance_to_segment(q, {0, s.z0}, {s.r0, s.z0}) : kInfiniteDistance;
    const double top = s.r1 > 0 ? distance_to_segment(q, {0, s.z1}, {s.r1, s.z1}) : kInfiniteDistance;
    return {wall, std::min(bottom, top)};
}
LeafDistance of(const shape::Torus& s, Vec3 p) {
    return {std::fabs(std::hypot(std::hypot(p.x, p.y) - s.major, p.z) - s.minor), kInfiniteDistance};
}
LeafDistance of(const shape::HalfSpace& s, Vec3 p) { return {kInfiniteDistance, std::fabs(glm::dot(s.n, p) - s.d) / glm::length(s.n)}; }
LeafDistance of(const shape::Quadric& s, Vec3 p) {
    const std::array<double, 10>& c = s.c;
    const double f = c[0] * p.x * p.x + c[1] * p.y * p.y + c[2] * p.z * p.z + c[3] * p.x * p.y + c[4] * p.x * p.z + c[5] * p.y * p.z + c[6] * p.x +
                     c[7] * p.y + c[8] * p.z + c[9];
    const Vec3 g(2 * c[0] * p.x + c[3] * p.y + c[4] * p.z + c[6], 2 * c[1] * p.y + c[3] * p.x + c[5] * p.z + c[7],
                 2 * c[2] * p.z + c[4] * p.x + c[5] * p.y + c[8]);
    const double slope = glm::length(g);
    return {slope > 0 ? std::fabs(f) / slope : kInfiniteDistance, kInfiniteDistance};
}
LeafDistance of(const shape::Capsule& s, Vec3 p) { return {std::fabs(distance_to_segment(p, s.p, s.q) - s.r), kInfiniteDistance}; }
LeafDistance of(const shape::RoundBox& s, Vec3 p) {
    const Vec3 lo = s.lo + s.r, hi = s.hi - s.r;
    const Vec3 out = glm::max(glm::max(lo - p, p - hi), Vec3(0));
    const double outside = glm::length(out);
    const double d = outside > 0 ? std::fabs(outside - s.r) : distance_to_box(p, s.lo, s.hi);
    // Off the core in one coordinate only: the flat part.
    const int off = (out.x > 0) + (out.y > 0) + (out.z > 0);
    return off > 1 ? LeafDistance{d, kInfiniteDistance} : LeafDistance{kInfiniteDistance, d};
}

// The face whose plane touches the body where the line from `from` through p leaves it, and p's distance from that plane.
struct Touching { const FlatFace* face = nullptr; double distance = kInfiniteDistance; };
Touching touching(const ConvexHullBody& body, Vec3 from, Vec3 p) {
    const ConvexSpan span = span_on_line(body, from, p - from, 0);
    if (span.kind != ConvexSpan::Kind::kMet) return {};
    const Vec3 n = span.out.normal;
    const auto is_flat = [&](const FlatFace& face) { return glm::dot(face.n, n) > 1 - kSameNormal; };
    const auto face = std::find_if(body.faces.begin(), body.faces.end(), is_flat);
    return {face != body.faces.end() ? &*face : nullptr, std::fabs(glm::dot(n, p) - reach(body.parts, n))};
}

// From the plane that touches the body beyond the point, seen from its middle: exact in the limit, as the border is neared. Of a flat face the rim too, sought
// from the face's middle a little below it.
LeafDistance of(const shape::ConvexBody& s, Vec3 p) {
    const ConvexHullBody& body = *s.hull;
    const Touching nearest = touching(body, body.middle, p);
    if (!nearest.face) return {nearest.distance, kInfiniteDistance};
    const FlatFace& face = *nearest.face;
    const Vec3 below = face.middle - kBelowFace * body.size * face.n, across = p - face.n * (glm::dot(face.n, p) - face.d + kBelowFace * body.size);
    const Touching rim = touching(body, below, across);
    return {rim.face ? kInfiniteDistance : std::max(rim.distance, nearest.distance), nearest.distance};
}
template <class Other>
LeafDistance of(const Other&, Vec3) { return {}; }

LeafDistance of_2d(const shape::Disc& s, Vec2 p) { return {std::fabs(glm::length(p) - s.r), kInfiniteDistance}; }
LeafDistance of_2d(const shape::Rectangle& s, Vec2 p) {
    const Vec2 out = glm::max(glm::max(s.lo - p, p - s.hi), Vec2(0));
    const Vec2 in = glm::min(p - s.lo, s.hi - p);
    const double outside = glm::length(out);
    return {kInfiniteDistance, outside > 0 ? outside : std::min(in.x, in.y)};
}
LeafDistance of_2d(const shape::Polygon& s, Vec2 p) {
    double best = kInfiniteDistance;
    for (const std::vector<Vec2>& contour : *s.contours)
        for (std::size_t i = 0; i < contour.size(); ++i) best = std::min(best, distance_to_segment(p, contour[i], contour[(i + 1) % contour.size()]));
    return s.section == kEmptyNode ? LeafDistance{kInfiniteDistance, best} : LeafDistance{best, kInfiniteDistance};
}
LeafDistance of_2d(const shape::ParabolicSegment& s, Vec2 p) { return {parabola_distance(s, p), distance_to_segment(p, s.a, s.b)}; }
template <class Other>
LeafDistance of_2d(const Other&, Vec2) { return {}; }

}  // namespace

double distance_to_polygon(Vec3 p, std::span<const Vec3> polygon) {
    double best = kInfiniteDistance;
    for (std::size_t i = 0; i < polygon.size(); ++i) best = std::min(best, distance_to_segment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
    const Vec3 n = polygon_normal(polygon);
    const double length = glm::length(n);
    if (!(length > 0)) return best;
    const double height = glm::dot(p - polygon[0], n) / length;
    return is_in_polygon(p - height * n / length, polygon, n) ? std::min(best, std::fabs(height)) : best;
}

double distance_to_ellipsoid(Vec3 p, Vec3 radii) {
    if (radii.x == radii.y && radii.y == radii.z) return std::fabs(glm::length(p) - radii.x);
    // Nearest point: x_i = r_i^2 p_i / (t + r_i^2), with g(t) = sum (r_i p_i / (t + r_i^2))^2 - 1 falling through 0 for t > -min r^2.
    const Vec3 q = glm::abs(p), r2 = radii * radii;
    const double least = std::min({r2.x, r2.y, r2.z});
    const auto g = [&](double t) {
        double sum = -1;
        for (int i = 0; i < 3; ++i)
            if (q[i] > 0) sum += std::pow(radii[i] * q[i] / (t + r2[i]), 2);
        return sum;
    };
    double lo = -least, hi = glm::length(radii * q);
    for (int k = 0; k < 200 && lo < hi; ++k) {
        const double middle = lo + (hi - lo) / 2;
        if (middle == lo || middle == hi) break;
        (g(middle) > 0 ? lo : hi) = middle;
    }
    Vec3 x(0);
    double rest = 1;
    int flattest = 0;
    for (int i = 0; i < 3; ++i) {
        if (r2[i] < r2[flattest]) flattest = i;
        if (hi + r2[i] > 0) x[i] = r2[i] * q[i] / (hi + r2[i]);
        rest -= x[i] * x[i] / r2[i];
    }
    if (q[flattest] == 0 && rest > 0 && hi <= -least * (1 - 0x1p-40)) x[flattest] = radii[flattest] * std::sqrt(rest);
    return glm::length(q - x);
}

LeafDistance boundary_distance(const Shape& shape, Vec3 p) {
    return std::visit([&](const auto& s) { return of(s, p); }, shape);
}

LeafDistance boundary_distance_2d(const Shape& shape, Vec2 p) {
    return std::visit([&](const auto& s) { return of_2d(s, p); }, shape);
}

}  // namespace whittle
