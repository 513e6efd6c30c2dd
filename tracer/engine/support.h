// support.h — the unbounded surfaces that faces lie on, and the polynomial each makes on a ray.
//
// A support is a kind and a few doubles in its frame; a frame is twelve doubles. Those numbers define the canonical solid: the polynomial below is
// written once, over any ring that holds the doubles, so that the double-double tier and the exact tier cannot disagree about what a surface is.
// A positive value means outside. docs/numerics.md, supports.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "csg/base/vec.h"
#include "csg/solid/solid.h"
#include "csg/span/ray.h"

namespace whittle {

using FrameId = std::uint32_t;

// How the third axis of a frame turns and scales what is swept along it: the profile at z0, turned by `degrees` clockwise and scaled on its way to z1, both
// linear in z. Only the heights [from, to] and what is nearer than `reach` to the axis matter to the sides in the frame.
struct Twist {
    double z0 = 0, z1 = 1, degrees = 0, scale_x = 1, scale_y = 1;
    double from = 0, to = 1, reach = 1;
    bool operator==(const Twist&) const = default;
};

struct SectionPlane;

// A placement shared by many supports. `inverse` rows are the inverse of the linear part, each entry within
// a unit of roundoff and 2^-64 of itself: a filter only, it never decides.
//
// With `section`, what stands in the frame is the section of a solid swept along the z axis of another frame: a point goes into that, drops to its plane z = 0
// and goes on through the placement. `inverse` is the linear part of all of that then, and singular.
struct Frame {
    Placement placement;
    std::shared_ptr<const SectionPlane> section;
    std::shared_ptr<const Twist> twist;  // of turned sides: null for all others
    std::shared_ptr<const ConvexHullBody> body;  // of a convex body likewise
    std::array<double, 9> inverse{1, 0, 0, 0, 1, 0, 0, 0, 1};
    MotionId motion = 0;  // the placement is then the one inside the motion; the whole one depends on the time
    bool identity = true;
    std::int8_t determinant_sign = 1;
    // What entering the frame rounds: entry by entry, of the magnitude it is multiplied by, for an origin (inverse, difference, product) and a direction (no
    // difference); and, row by row, of each sum's magnitude. With a little room.
    std::array<double, 9> origin_room{}, direction_room{};
    std::array<double, 3> sum_room{};

    // The frame's coordinates of a point x are inverse (x - entry) + lift.
    double entry(int j) const;
    double lift(std::size_t i) const;
};

struct SectionPlane {
    Frame frame;
    std::array<double, 3> entry{}, lift{}, lift_room{};  // of the frame that has the section; lift_room bounds what rounding leaves out of lift
};

inline double Frame::entry(int j) const { return section ? section->entry[static_cast<std::size_t>(j)] : placement.offset(j); }
inline double Frame::lift(std::size_t i) const { return section ? section->lift[i] : 0; }

// Requires: the linear part is regular and finite.
Frame make_frame(const Placement& placement);
// With the section in the plane z = 0 of `outer`.
Frame make_frame(const Placement& placement, const Frame& outer);
// The frame carried along.
Frame moved_frame(const Frame& frame, const Placement& motion);
// Are the frames' own placements, and all above them, equal?
bool stand_alike(const Frame& a, const Frame& b);

Vec3 point_in_frame(const Frame& frame, const Vec3& point);
// The gradient in the root frame of what has this gradient in the frame.
Vec3 gradient_in_root(const Frame& frame, const Vec3& gradient);

enum class SupportKind : std::uint8_t {
    kAxisPlane,   // x_axis = p0
    kPlane,       // (p0,p1,p2).x = p3
    kPlanePoints, // through the points p0-2, p3-5, p6-8, counter-clockwise seen from outside
    kEdgePlane,   // parallel to the axis, through (p0,p1) and (p2,p3) in the coordinates axis+1, axis+2; inside on the left
    kBall,        // centre p0-2, radius p3
    kEllipsoid,   // centre p0-2, radii p3-5
    kCylinder,    // about the axis, through (p0,p1) in axis+1, axis+2; radius p2
    kCone,        // about the axis, through (p0,p1); radius p4 at p2, p5 at p3
    kTube,        // about the line p0-2 to p3-5, radius p6
    kQuadric,     // the ten coefficients of shape::Quadric
    kTorus,       // centre p0-2, about the axis, radii p3 (ring), p4 (tube); both sheets
    kTorusCore,   // of the same torus: rho^2 + z^2 + R^2 - r^2
    kParabola,    // parallel to the axis, the quadratic Bezier curve from p0-1 to p4-5 with control point p2-3 in axis+1, axis+2
    // Swept along the third axis of a frame with a twist (turned.h), given in the profile: polynomials on a ray only where it does not turn.
    kTurnedSide,     // the line through (p0,p1) and (p2,p3), inside on the left
    kTurnedEllipse,  // centre p0-1, the image of the unit disc under the matrix p2 p3 / p4 p5
    kTurnedParabola, // from p0-1 to p4-5 with control point p2-3
    kConvex          // the convex body of the frame (convex.h)
};

struct Support {
    SupportKind kind = SupportKind::kAxisPlane;
    std::uint8_t axis = 0;
    FrameId frame = 0;
    std::array<double, 10> p{};
    bool operator==(const Support&) const = default;
};

inline bool is_plane(SupportKind k) { return k <= SupportKind::kEdgePlane; }

inline bool is_turned(SupportKind k) { return k >= SupportKind::kTurnedSide && k <= SupportKind::kTurnedParabola; }

// Has the support a polynomial on every ray?
inline bool has_polynomial(SupportKind k) { return k < SupportKind::kTurnedSide; }

// Is the support in the frame no algebraic surface, for which there is no exact tier?
inline bool is_transcendental(SupportKind k, const Frame& frame) { return k == SupportKind::kConvex || (is_turned(k) && frame.twist->degrees != 0); }

// Degree of the support's polynomial on a ray: 1, 2 or 4; 0 of turned sides, which may have none, and of convex bodies.
inline int degree_of(SupportKind k) { return !has_polynomial(k) ? 0 : is_plane(k) ? 1 : k == SupportKind::kTorus ? 4 : 2; }

// A ray in a frame, homogeneous: local point = (o + t d) / w, with w > 0.
template <class N>
struct FrameLine {
    std::array<N, 3> o, d;
    N w{1.0};
};

// Coefficients of 1, t, t^2 ...
template <class N>
struct LinePolynomial {
    std::array<N, 5> c{};
    int degree = 0;
};

namespace detail {

// (from + t d) / w by the adjugate of the placement's linear part, scaled so that the new w keeps its sign. `from` is measured from w times the offset.
template <class N>
FrameLine<N> line_under(const Placement& placement, bool flip, const std::array<N, 3>& from, const std::array<N, 3>& direction) {
    std::array<std::array<N, 3>, 3> a;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) a[i][j] = N(placement.linear(i, j));
    const auto minor = [&](int r, int c) {
        const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        return a[r1][c1] * a[r2][c2] - a[r1][c2] * a[r2][c1];
    };
    FrameLine<N> line;
    for (int i = 0; i < 3; ++i) {
        N o{0.0}, d{0.0};
        for (int j = 0; j < 3; ++j) {
            const N adjugate = flip ? -minor(j, i) : minor(j, i);
            o = o + adjugate * from[j];
            d = d + adjugate * direction[j];
        }
        line.o[i] = o;
        line.d[i] = d;
    }
    const N det = a[0][0] * minor(0, 0) + a[0][1] * minor(0, 1) + a[0][2] * minor(0, 2);
    line.w = flip ? -det : det;
    return line;
}

}  // namespace detail

// The ray (its origin given in the ring: the symbolic perturbation adds to it) in the frame, by the adjugate, scaled so that w > 0.
template <class N>
FrameLine<N> line_in_frame(const Frame& frame, const std::array<N, 3>& origin, const Vec3& direction) {
    const bool flip = frame.determinant_sign < 0;
    std::array<N, 3> from;
    if (frame.section) {
        const FrameLine<N> above = line_in_frame(frame.section->frame, origin, direction);
        for (int i = 0; i < 3; ++i) from[i] = (i == 2 ? N{0.0} : above.o[i]) - N(frame.placement.offset(i)) * above.w;
        FrameLine<N> line = detail::line_under<N>(frame.placement, flip, from, {above.d[0], above.d[1], N{0.0}});
        line.w = line.w * above.w;
        return line;
    }
    if (frame.identity) return {origin, {N(direction.x), N(direction.y), N(direction.z)}, N{1.0}};
    for (int i = 0; i < 3; ++i) from[i] = origin[i] - N(frame.placement.offset(i));
    return detail::line_under<N>(frame.placement, flip, from, {N(direction.x), N(direction.y), N(direction.z)});
}

namespace polynomial {

template <class N>
struct Linear {  // value at 1, slope in t
    N v{0.0}, s{0.0};
};

template <class N>
struct Quadratic {
    N c0{0.0}, c1{0.0}, c2{0.0};
};

template <class N>
Linear<N> coordinate(const FrameLine<N>& l, int i, double centre) {
    if (centre == 0) return {l.o[i], l.d[i]};
    return {l.o[i] - l.w * N(centre), l.d[i]};
}
template <class N>
Linear<N> operator+(const Linear<N>& a, const Linear<N>& b) { return {a.v + b.v, a.s + b.s}; }
template <class N>
Linear<N> operator*(const N& k, const Linear<N>& a) { return {k * a.v, k * a.s}; }
template <class N>
Quadratic<N> operator*(const Linear<N>& a, const Linear<N>& b) { return {a.v * b.v, a.v * b.s + a.s * b.v, a.s * b.s}; }
template <class N>
Quadratic<N> operator+(const Quadratic<N>& a, const Quadratic<N>& b) { return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2}; }
template <class N>
Quadratic<N> operator-(const Quadratic<N>& a, const Quadratic<N>& b) { return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2}; }
template <class N>
Quadratic<N> operator*(const N& k, const Quadratic<N>& a) { return {k * a.c0, k * a.c1, k * a.c2}; }
template <class N>
Quadratic<N> square(const Linear<N>& a) {
    const N cross = a.v * a.s;
    return {a.v * a.v, cross + cross, a.s * a.s};
}
template <class N>
Quadratic<N> constant(const N& k) { return {k, N{0.0}, N{0.0}}; }

template <class N>
LinePolynomial<N> of(const Linear<N>& a) { return {{a.v, a.s}, 1}; }
template <class N>
LinePolynomial<N> of(const Quadratic<N>& a) { return {{a.c0, a.c1, a.c2}, 2}; }

template <class N>
Linear<N> plane(const Support& s, const FrameLine<N>& l) {
    const auto& p = s.p;
    if (s.kind == SupportKind::kAxisPlane) return coordinate(l, s.axis, p[0]);
    if (s.kind == SupportKind::kPlane) {
        Linear<N> r{-(l.w * N(p[3])), N{0.0}};
        for (int i = 0; i < 3; ++i) r = r + N(p[i]) * Linear<N>{l.o[i], l.d[i]};
        return r;
    }
    if (s.kind == SupportKind::kEdgePlane) {
        const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
        return (N(p[3]) - N(p[1])) * coordinate(l, u, p[0]) + (N(p[0]) - N(p[2])) * coordinate(l, v, p[1]);
    }
    std::array<N, 3> a, b;
    for (int i = 0; i < 3; ++i) {
        a[i] = N(p[3 + i]) - N(p[i]);
        b[i] = N(p[6 + i]) - N(p[i]);
    }
    Linear<N> r;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        r = r + (a[j] * b[k] - a[k] * b[j]) * coordinate(l, i, p[i]);
    }
    return r;
}

template <class N>
Quadratic<N> tube(const Support& s, const FrameLine<N>& l) {
    std::array<N, 3> axis;
    std::array<Linear<N>, 3> x;
    N length2{0.0};
    for (int i = 0; i < 3; ++i) {
        axis[i] = N(s.p[3 + i]) - N(s.p[i]);
        x[i] = coordinate(l, i, s.p[i]);
        length2 = length2 + axis[i] * axis[i];
    }
    Quadratic<N> r;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        r = r + square(axis[j] * x[k] + (-axis[k]) * x[j]);
    }
    const N radius = l.w * N(s.p[6]);
    return r - constant(radius * radius * length2);
}

template <class N>
Quadratic<N> general(const Support& s, const FrameLine<N>& l) {
    const Linear<N> x{l.o[0], l.d[0]}, y{l.o[1], l.d[1]}, z{l.o[2], l.d[2]}, w{l.w, N{0.0}};
    const auto& c = s.p;
    const auto term = [](double k, const Linear<N>& a, const Linear<N>& b) { return k == 0 ? Quadratic<N>{} : N(k) * (a * b); };
    return term(c[0], x, x) + term(c[1], y, y) + term(c[2], z, z) + term(c[3], x, y) + term(c[4], x, z) + term(c[5], y, z) + term(c[6], x, w) +
           term(c[7], y, w) + term(c[8], z, w) + term(c[9], w, w);
}

template <class N>
Quadratic<N> ellipsoid(const Support& s, const FrameLine<N>& l) {
    Quadratic<N> r;
    const N a(s.p[3]), b(s.p[4]), c(s.p[5]);
    const std::array<N, 3> k{b * c, a * c, a * b};
    for (int i = 0; i < 3; ++i) r = r + square(k[i] * coordinate(l, i, s.p[i]));
    const N whole = a * b * c * l.w;
    return r - constant(whole * whole);
}

// With e = b - a, f = c - a, D = e x f and weights u, v, w of a, c, b the curve is v^2 = 4 u w. That is S^2 + D T = 0, where S = D + (2 f - e) x (p - a) is
// D (u - w) and T = 2 e x (p - a) - D is D (2 v - 1).
template <class N>
Quadratic<N> parabola(const Support& s, const FrameLine<N>& l) {
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
    const auto& p = s.p;
    const N ex = N(p[4]) - N(p[0]), ey = N(p[5]) - N(p[1]), fx = N(p[2]) - N(p[0]), fy = N(p[3]) - N(p[1]);
    const N gx = (fx + fx) - ex, gy = (fy + fy) - ey, whole = ex * fy - ey * fx;
    const Linear<N> x = coordinate(l, u, p[0]), y = coordinate(l, v, p[1]), unit{l.w, N{0.0}};
    const Linear<N> across = whole * unit + (gx * y + (-gy) * x);
    const Linear<N> along = N(2.0) * (ex * y + (-ey) * x) + (-whole) * unit;
    return square(across) + whole * (unit * along);
}

template <class N>
Quadratic<N> quadratic(const Support& s, const FrameLine<N>& l) {
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
    const auto& p = s.p;
    switch (s.kind) {
        case SupportKind::kBall: {
            const N r = l.w * N(p[3]);
            return square(coordinate(l, 0, p[0])) + square(coordinate(l, 1, p[1])) + square(coordinate(l, 2, p[2])) - constant(r * r);
        }
        case SupportKind::kEllipsoid: return ellipsoid(s, l);
        case SupportKind::kCylinder: {
            const N r = l.w * N(p[2]);
            return square(coordinate(l, u, p[0])) + square(coordinate(l, v, p[1])) - constant(r * r);
        }
        case SupportKind::kCone: {
            const N height = N(p[3]) - N(p[2]);
            const Linear<N> radius = (N(p[5]) - N(p[4])) * coordinate(l, s.axis, p[2]) + Linear<N>{l.w * (N(p[4]) * height), N{0.0}};
            return square(height * coordinate(l, u, p[0])) + square(height * coordinate(l, v, p[1])) - square(radius);
        }
        case SupportKind::kTube: return tube(s, l);
        case SupportKind::kParabola: return parabola(s, l);
        case SupportKind::kTorusCore: {
            const N k = l.w * l.w * (N(p[3]) * N(p[3]) - N(p[4]) * N(p[4]));
            return square(coordinate(l, 0, p[0])) + square(coordinate(l, 1, p[1])) + square(coordinate(l, 2, p[2])) + constant(k);
        }
        default: return general(s, l);
    }
}

template <class N>
LinePolynomial<N> torus(const Support& s, const FrameLine<N>& l) {
    Support core = s;
    core.kind = SupportKind::kTorusCore;
    const Quadratic<N> g = quadratic(core, l);
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
    const N ring = l.w * N(s.p[3]);
    const N four = N(4.0) * ring * ring;
    const Quadratic<N> h = four * (square(coordinate(l, u, s.p[u])) + square(coordinate(l, v, s.p[v])));
    LinePolynomial<N> r;
    r.degree = 4;
    r.c[0] = g.c0 * g.c0 - h.c0;
    r.c[1] = N(2.0) * (g.c0 * g.c1) - h.c1;
    r.c[2] = N(2.0) * (g.c0 * g.c2) + g.c1 * g.c1 - h.c2;
    r.c[3] = N(2.0) * (g.c1 * g.c2);
    r.c[4] = g.c2 * g.c2;
    return r;
}

}  // namespace polynomial

// The support's polynomial along a line given in its frame. Requires: has_polynomial().
template <class N>
LinePolynomial<N> support_polynomial(const Support& s, const FrameLine<N>& line) {
    if (is_plane(s.kind)) return polynomial::of(polynomial::plane(s, line));
    if (s.kind == SupportKind::kTorus) return polynomial::torus(s, line);
    return polynomial::of(polynomial::quadratic(s, line));
}

}  // namespace whittle
