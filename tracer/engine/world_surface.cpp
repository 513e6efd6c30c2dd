// world_surface.cpp — supports taken to the root frame, and the distance of two quadrics.
#include "tracer/engine/world_surface.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

Real entry(const std::array<Real, 6>& m, std::size_t i, std::size_t j) {
    if (i == j) return m[i];
    return m[i + j + 2];
}

// Adds weight * (n.x + k)^2.
void add_square(WorldSurface& w, const std::array<Real, 3>& n, Real k, Real weight) {
    for (std::size_t e = 0; e < 6; ++e) w.m[e] += weight * n[kPairs[e][0]] * n[kPairs[e][1]];
    for (std::size_t i = 0; i < 3; ++i) w.b[i] += weight * n[i] * k;
    w.c += weight * k * k;
}

WorldSurface local_plane(const Support& s) {
    WorldSurface w;
    const auto& p = s.p;
    if (s.kind == SupportKind::kAxisPlane) {
        w.b[s.axis] = 1;
        w.c = -Real(p[0]);
    } else if (s.kind == SupportKind::kPlane) {
        for (std::size_t i = 0; i < 3; ++i) w.b[i] = p[i];
        w.c = -Real(p[3]);
    } else if (s.kind == SupportKind::kEdgePlane) {
        const std::size_t u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
        w.b[u] = Real(p[3]) - p[1];
        w.b[v] = Real(p[0]) - p[2];
        w.c = -(w.b[u] * p[0] + w.b[v] * p[1]);
    } else {
        std::array<Real, 3> e, f;
        for (std::size_t i = 0; i < 3; ++i) e[i] = Real(p[3 + i]) - p[i], f[i] = Real(p[6 + i]) - p[i];
        for (std::size_t i = 0; i < 3; ++i) {
            w.b[i] = e[(i + 1) % 3] * f[(i + 2) % 3] - e[(i + 2) % 3] * f[(i + 1) % 3];
            w.c -= w.b[i] * p[i];
        }
    }
    return w;
}

void add_tube(WorldSurface& w, const std::array<double, 10>& p) {
    std::array<Real, 3> axis;
    Real length2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        axis[i] = Real(p[3 + i]) - p[i];
        length2 += axis[i] * axis[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        std::array<Real, 3> n{};
        n[k] = axis[j];
        n[j] = -axis[k];
        add_square(w, n, -(axis[j] * p[k] - axis[k] * p[j]), 1);
    }
    w.c -= Real(p[6]) * p[6] * length2;
}

// support.h, parabola: S^2 + D T.
void add_parabola(WorldSurface& w, const Support& s, std::size_t u, std::size_t v) {
    const auto& p = s.p;
    const Real ex = Real(p[4]) - p[0], ey = Real(p[5]) - p[1], fx = Real(p[2]) - p[0], fy = Real(p[3]) - p[1];
    const Real gx = 2 * fx - ex, gy = 2 * fy - ey, whole = ex * fy - ey * fx;
    std::array<Real, 3> n{};
    n[u] = -gy, n[v] = gx;
    add_square(w, n, whole - gx * p[1] + gy * p[0], 1);
    w.b[u] -= whole * ey;
    w.b[v] += whole * ex;
    w.c -= whole * (whole + 2 * (ex * p[1] - ey * p[0]));
}

WorldSurface local_quadric(const Support& s) {
    WorldSurface w;
    w.form = WorldSurface::Form::kQuadric;
    const auto& p = s.p;
    const auto unit = [](std::size_t i) {
        std::array<Real, 3> n{};
        n[i] = 1;
        return n;
    };
    const std::size_t u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
    switch (s.kind) {
        case SupportKind::kBall:
        case SupportKind::kTorusCore:
            for (std::size_t i = 0; i < 3; ++i) add_square(w, unit(i), -Real(p[i]), 1);
            w.c += s.kind == SupportKind::kBall ? -Real(p[3]) * p[3] : Real(p[3]) * p[3] - Real(p[4]) * p[4];
            break;
        case SupportKind::kEllipsoid:
            for (std::size_t i = 0; i < 3; ++i) add_square(w, unit(i), -Real(p[i]), 1 / (Real(p[3 + i]) * p[3 + i]));
            w.c -= 1;
            break;
        case SupportKind::kCylinder:
            add_square(w, unit(u), -Real(p[0]), 1);
            add_square(w, unit(v), -Real(p[1]), 1);
            w.c -= Real(p[2]) * p[2];
            break;
        case SupportKind::kCone: {
            const Real slope = (Real(p[5]) - p[4]) / (Real(p[3]) - p[2]);
            add_square(w, unit(u), -Real(p[0]), 1);
            add_square(w, unit(v), -Real(p[1]), 1);
            std::array<Real, 3> n{};
            n[s.axis] = slope;
            add_square(w, n, p[4] - slope * p[2], -1);
            break;
        }
        case SupportKind::kTube: add_tube(w, p); break;
        case SupportKind::kParabola: add_parabola(w, s, u, v); break;
        default:
            w.m = {p[0], p[1], p[2], Real(p[3]) / 2, Real(p[4]) / 2, Real(p[5]) / 2};
            w.b = {Real(p[6]) / 2, Real(p[7]) / 2, Real(p[8]) / 2};
            w.c = p[9];
    }
    return w;
}

using Rows = std::array<std::array<Real, 3>, 3>;

Rows inverse_of(const Placement& a) {
    const auto at = [&](std::size_t r, std::size_t c) { return Real(a.m[4 * (r % 3) + c % 3]); };
    const auto minor = [&](std::size_t r, std::size_t c) { return at(r + 1, c + 1) * at(r + 2, c + 2) - at(r + 1, c + 2) * at(r + 2, c + 1); };
    const Real det = at(0, 0) * minor(0, 0) + at(0, 1) * minor(0, 1) + at(0, 2) * minor(0, 2);
    Rows r;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) r[i][j] = minor(j, i) / det;
    return r;
}

using Point = std::array<Real, 3>;

Point product(const Rows& a, const Point& p) {
    Point r{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) r[i] += a[i][j] * p[j];
    return r;
}

// A point x of the root frame is linear (x - entry) + lift in the frame.
struct WayIn {
    Rows linear{};
    Point entry{}, lift{};
};

WayIn way_into(const Frame& frame) {
    WayIn way;
    if (!frame.section) {
        way.linear = inverse_of(frame.placement);
        for (std::size_t i = 0; i < 3; ++i) way.entry[i] = frame.placement.m[4 * i + 3];
        return way;
    }
    WayIn above = way_into(frame.section->frame);
    above.linear[2] = {};
    above.lift[2] = 0;
    const Rows inverse = inverse_of(frame.placement);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) way.linear[i][j] += inverse[i][k] * above.linear[k][j];
        above.lift[i] -= frame.placement.m[4 * i + 3];
    }
    way.entry = above.entry;
    way.lift = product(inverse, above.lift);
    return way;
}

// Of x + by instead of x.
WorldSurface shifted(WorldSurface w, const Point& by) {
    Point moved{};
    Real linear = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        linear += w.b[i] * by[i];
        for (std::size_t j = 0; j < 3; ++j) {
            moved[i] += entry(w.m, i, j) * by[j];
            square += by[i] * entry(w.m, i, j) * by[j];
        }
    }
    if (w.form == WorldSurface::Form::kPlane) {
        w.c += linear;
        return w;
    }
    w.c += square + 2 * linear;
    for (std::size_t i = 0; i < 3; ++i) w.b[i] += moved[i];
    return w;
}

WorldSurface to_root(const WorldSurface& local, const Frame& frame) {
    if (frame.identity) return local;
    const WayIn way = way_into(frame);
    const WorldSurface lifted = frame.section ? shifted(local, way.lift) : local;
    WorldSurface w = lifted;
    w.b = {};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) w.b[j] += way.linear[i][j] * lifted.b[i];
    w.m = {};
    for (std::size_t e = 0; e < 6; ++e)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) w.m[e] += way.linear[i][kPairs[e][0]] * entry(lifted.m, i, j) * way.linear[j][kPairs[e][1]];
    return shifted(w, {-way.entry[0], -way.entry[1], -way.entry[2]});
}

Point placed(const Placement& a, const Point& p) {
    Point r;
    for (std::size_t i = 0; i < 3; ++i) {
        r[i] = a.m[4 * i + 3];
        for (std::size_t j = 0; j < 3; ++j) r[i] += Real(a.m[4 * i + j]) * p[j];
    }
    return r;
}

// Spread evenly and on no symmetry plane: k times an irrational slope, less its whole part, in [-1, 1).
Real spread(int k, std::size_t i) {
    const Real slope = i == 0 ? 0.8191725133961645L : i == 1 ? 0.6710436067037893L : 0.5497004779019703L;
    const Real turn = (k + 1) * slope;
    return 2 * (turn - std::floor(turn)) - 1;
}

// How many units of the root frame one of the frame is, on the mean over the axes.
Real mean_stretch(const Frame& frame) {
    const Rows inverse = inverse_of(frame.placement);
    Real inverse_det = 0;
    for (std::size_t j = 0; j < 3; ++j) inverse_det += inverse[0][j] * (inverse[1][(j + 1) % 3] * inverse[2][(j + 2) % 3] - inverse[1][(j + 2) % 3] * inverse[2][(j + 1) % 3]);
    const Real own = 1 / std::cbrt(magnitude(inverse_det));
    return frame.section ? own * mean_stretch(frame.section->frame) : own;
}

// How far outside of the torus's outer sheet a point of its frame is.
Real off_torus(const Support& s, const Point& p) {
    const std::size_t u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
    const Real x = p[u] - s.p[u], y = p[v] - s.p[v], z = p[s.axis] - s.p[s.axis], beyond = std::sqrt(x * x + y * y) - s.p[3];
    return std::sqrt(beyond * beyond + z * z) - s.p[4];
}

// The same of a point of the root frame, in its units.
Real off_placed_torus(const Support& s, const Frame& frame, const WayIn& way, Point x) {
    for (std::size_t i = 0; i < 3; ++i) x[i] -= way.entry[i];
    Point local = product(way.linear, x);
    for (std::size_t i = 0; i < 3; ++i) local[i] += way.lift[i];
    return off_torus(s, local) * mean_stretch(frame);
}

WorldSurface world_torus(const Support& s, const Frame& frame) {
    WorldSurface w;
    w.form = WorldSurface::Form::kTorus;
    const Real stretch = mean_stretch(frame);
    w.ring = stretch * Real(s.p[3]);
    w.tube = stretch * Real(s.p[4]);
    if (!frame.section) {
        w.b = placed(frame.placement, {s.p[0], s.p[1], s.p[2]});
        return w;
    }
    // Of a section there is no centre: how far three places are from it.
    const WayIn way = way_into(frame);
    for (int k = 0; k < 3; ++k) w.b[static_cast<std::size_t>(k)] = off_placed_torus(s, frame, way, {spread(k, 0), spread(k, 1), spread(k, 2)});
    return w;
}

// On the outer sheet of the torus, in the root frame.
Point torus_point(const Support& s, const Frame& frame, int k) {
    // Points of the unit circle by the tangent of half their angle: no sines, whose last bit is the library's.
    const Real about = 3 * spread(k, 0), along = spread(k, 1), n = 1 + about * about, m = 1 + along * along;
    const Real rho = s.p[3] + s.p[4] * (1 - along * along) / m;
    const std::size_t u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
    Point p{s.p[0], s.p[1], s.p[2]};
    p[u] += rho * (1 - about * about) / n;
    p[v] += rho * 2 * about / n;
    p[s.axis] += s.p[4] * 2 * along / m;
    return placed(frame.placement, p);
}

Real value_at(const QuadricForm& q, const Point& y, Point& gradient) {
    Real value = q[9];
    for (std::size_t i = 0; i < 3; ++i) {
        Real m = 0;
        for (std::size_t j = 0; j < 3; ++j) m += (i == j ? q[i] : q[i + j + 2]) * y[j];
        value += (m + 2 * q[6 + i]) * y[i];
        gradient[i] = 2 * (m + q[6 + i]);
    }
    return value;
}

// Moves the point onto the quadric: along the gradient to the nearer crossing, or, where there is none, to the least value, whose gradient lies across
// the one before. Newton's steps polish.
bool moved_onto(const QuadricForm& q, Point& y) {
    constexpr int kSteps = 40, kPolish = 3;
    Point g;
    int polished = 0;
    for (int step = 0; step < kSteps && polished < kPolish; ++step) {
        const Real v = value_at(q, y, g), g2 = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
        if (!(g2 > 0)) return false;
        Real bend = 0;
        for (std::size_t e = 0; e < 6; ++e) bend += (e < 3 ? 1 : 2) * q[e] * g[kPairs[e][0]] * g[kPairs[e][1]];
        const Real room = g2 * g2 - 4 * bend * v;
        const Real way = polished > 0 ? -v / g2 : room < 0 ? -g2 / (2 * bend) : -2 * v / (g2 + std::sqrt(room));
        if (room >= 0) ++polished;
        for (std::size_t i = 0; i < 3; ++i) y[i] += way * g[i];
    }
    const Real left = magnitude(value_at(q, y, g));
    return left < std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) * 0x1p-50L;
}

}  // namespace

WorldSurface world_surface(const Support& support, const Frame& frame) {
    WorldSurface w;
    if (is_plane(support.kind)) {
        w = to_root(local_plane(support), frame);
        const Real length = std::sqrt(w.b[0] * w.b[0] + w.b[1] * w.b[1] + w.b[2] * w.b[2]);
        if (!(length > 0)) return w;  // in a section, a plane along the section's own: it decides nothing
        for (Real& x : w.b) x /= length;
        w.c /= length;
        return w;
    }
    return support.kind == SupportKind::kTorus ? world_torus(support, frame) : to_root(local_quadric(support), frame);
}

Real torus_distance(const Support& a, const Frame& in_a, const Support& b, const Frame& in_b) {
    constexpr int kPoints = 24;
    const Rows inverse = inverse_of(in_b.placement);
    const std::size_t u = (b.axis + 1u) % 3, v = (b.axis + 2u) % 3;
    Real stretch2 = 0, worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) stretch2 += Real(in_b.placement.m[4 * i + j]) * in_b.placement.m[4 * i + j];
    for (int k = 0; k < kPoints; ++k) {
        Point p = torus_point(a, in_a, k), x;
        for (std::size_t i = 0; i < 3; ++i) p[i] -= in_b.placement.m[4 * i + 3];
        for (std::size_t i = 0; i < 3; ++i) x[i] = inverse[i][0] * p[0] + inverse[i][1] * p[1] + inverse[i][2] * p[2] - b.p[i];
        const Real beyond = std::sqrt(x[u] * x[u] + x[v] * x[v]) - b.p[3];
        worst = std::max(worst, magnitude(std::sqrt(beyond * beyond + x[b.axis] * x[b.axis]) - b.p[4]));
    }
    return worst * std::sqrt(stretch2);
}

Real section_torus_distance(const Support& a, const Frame& in_a, const Support& b, const Frame& in_b, const Bounds& box) {
    constexpr int kPoints = 24;
    const WayIn p = way_into(in_a), q = way_into(in_b);
    Real worst = 0;
    for (int k = 0; k < kPoints; ++k) {
        Point x;
        for (std::size_t i = 0; i < 3; ++i) {
            const double lo = box.lo[static_cast<int>(i)], hi = box.hi[static_cast<int>(i)];
            x[i] = 0.5L * (Real(lo) + hi) + 0.5L * (Real(hi) - lo) * spread(k, i);
        }
        worst = std::max(worst, magnitude(off_placed_torus(a, in_a, p, x) - off_placed_torus(b, in_b, q, x)));
    }
    return worst;
}

QuadricForm normalised(const WorldSurface& w, const Vec3& centre, double extent, bool& flipped) {
    std::array<Real, 3> mc{};
    Real c = w.c;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) mc[i] += entry(w.m, i, j) * centre[static_cast<int>(j)];
        c += (2 * w.b[i] + mc[i]) * centre[static_cast<int>(i)];
    }
    std::array<Real, 10> r{};
    for (std::size_t e = 0; e < 6; ++e) r[e] = w.m[e] * extent * Real(extent);
    for (std::size_t i = 0; i < 3; ++i) r[6 + i] = (w.b[i] + mc[i]) * extent;
    r[9] = c;
    Real most = 0;
    for (const Real x : r) most = std::max(most, magnitude(x));
    flipped = false;
    for (const Real x : r)
        if (magnitude(x) > most / 2) {
            flipped = x < 0;
            break;
        }
    for (Real& x : r) x = most > 0 ? (flipped ? -x : x) / most : x;
    return r;
}

Real quadric_distance(const QuadricForm& a, const QuadricForm& b, const Vec3& half) {
    constexpr int kStarts = 24, kEnough = 10;  // ten coefficients up to a factor: nine points tell two quadrics apart
    constexpr Real kAbout = 0.625;
    for (std::size_t i = 0; i < 10; ++i)
        if (magnitude(a[i] - b[i]) > 0x1p-20L) return 1;
    Real worst = 0;
    int reached = 0;
    for (int k = 0; k < kStarts; ++k) {
        Point y{half.x * spread(k, 0), half.y * spread(k, 1), half.z * spread(k, 2)}, g;
        if (!moved_onto(a, y) || std::max({magnitude(y[0]), magnitude(y[1]), magnitude(y[2])}) > kAbout) continue;
        const Real gap = magnitude(value_at(b, y, g)), steep = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        if (!(steep > 0)) continue;
        worst = std::max(worst, gap / steep);
        ++reached;
    }
    return reached >= kEnough ? worst : Real(1);
}

}  // namespace whittle
