// torus_roots.cpp — a quartic on the piece of the ray inside the torus's ball: Descartes' rule in the Bernstein basis, with every sign certain.
//
// The ray's origin is moved to the closest approach to the centre, so coefficients do not cancel. A piece with no sign variation holds no root, one
// with exactly one holds exactly one (all other coefficients certain), everything else is split; a piece too small to split means: not decidable here.
// Source: Lane and Riesenfeld, Bounds on a polynomial (1981); Eigenwillig et al., A Descartes algorithm for polynomials with bit-stream coefficients (2005).
#include "tracer/engine/torus_roots.h"

#include <cmath>

namespace whittle {

namespace {

constexpr double u = kUnitRoundoff;

// p(s) = sum c_k s^k, |c_k - exact| <= e_k.
struct Quartic {
    std::array<double, 5> c{}, e{};

    double value(double s) const { return (((c[4] * s + c[3]) * s + c[2]) * s + c[1]) * s + c[0]; }
    double slope(double s) const { return ((4 * c[4] * s + 3 * c[3]) * s + 2 * c[2]) * s + c[1]; }
    // Bound of value's error: the coefficients', and Horner's 2n u with room.
    double value_error(double s) const {
        const double a = std::abs(s);
        double sum = 0, power = 1;
        for (std::size_t k = 0; k < 5; ++k, power *= a) sum += (e[k] + 9 * u * std::abs(c[k])) * power;
        return sum * (1 + 16 * u);
    }
};

struct Piece {
    std::array<double, 5> b;
    double from, width, error;
};

// The polynomial on [-reach, reach] in the Bernstein basis: the blossom's values (m below: elementary symmetric functions of four signs).
Piece bernstein(const Quartic& q, double reach) {
    constexpr std::array<std::array<double, 5>, 5> m{{{1, 1, 1, 1, 1}, {-1, -0.5, 0, 0.5, 1}, {1, 0, -1.0 / 3, 0, 1}, {-1, 0.5, 0, -0.5, 1}, {1, -1, 1, -1, 1}}};
    Piece piece{{}, -reach, 2 * reach, 0};
    double power = 1;
    for (std::size_t k = 0; k < 5; ++k, power *= reach) {
        const double term = q.c[k] * power;
        for (std::size_t j = 0; j < 5; ++j) piece.b[j] += term * m[k][j];
        piece.error += (q.e[k] + 16 * u * std::abs(q.c[k])) * power;
    }
    piece.error *= 1 + 16 * u;
    return piece;
}

void split(const Piece& p, double ratio, Piece& left, Piece& right) {
    std::array<double, 5> b = p.b;
    double most = 0;
    for (const double x : b) most = std::max(most, std::abs(x));
    left.b[0] = b[0];
    right.b[4] = b[4];
    for (std::size_t level = 1; level < 5; ++level) {
        for (std::size_t j = 0; j + level < 5; ++j) b[j] = (1 - ratio) * b[j] + ratio * b[j + 1];
        left.b[level] = b[0];
        right.b[4 - level] = b[4 - level];
    }
    left.from = p.from;
    left.width = p.width * ratio;
    right.from = p.from + left.width;
    right.width = p.width - left.width;
    left.error = right.error = p.error + 16 * u * most;
}

enum class Look { kNone, kOne, kSplit };

Look look(const Piece& p) {
    // Signs with "unknown" (0): the most variations they can hide.
    const auto sign = [&](double x) { return x > p.error ? 1 : x < -p.error ? -1 : 0; };
    const int first = sign(p.b[0]), last = sign(p.b[4]);
    if (first == 0 || last == 0) return Look::kSplit;
    bool same = true;
    for (const double x : p.b) same = same && sign(x) == first;
    if (same) return Look::kNone;
    if (first == last) return Look::kSplit;
    // One variation for certain: once the sign has turned, or may have, it must stay turned.
    bool turned = false;
    int unknown_run = 0;
    for (const double x : p.b) {
        const int s = sign(x);
        if (s == 0) {
            ++unknown_run;
        } else if (s == first) {
            if (turned) return Look::kSplit;
            if (unknown_run > 0) return Look::kSplit;
        } else {
            if (!turned && unknown_run > 1) return Look::kSplit;
            if (turned && unknown_run > 0) return Look::kSplit;
            turned = true;
            unknown_run = 0;
        }
    }
    return Look::kOne;
}

// The torus's polynomial (G^2 - k H below) at a point of the line, made of the point's coordinates: what the line is off by comes in through the gradient, in which
// the greater part of both terms cancels.
struct Place {
    double value, error;
};

struct TorusOnLine {
    std::array<double, 3> v, ev, d, ed;  // v from the centre, at s = 0
    std::size_t axis = 0;
    double core = 0, ecore = 0, k = 0;  // R^2 - r^2, 4 R^2

    Place at(double s) const {
        std::array<double, 3> x, e;
        double g = core, h = 0, squares = 0, off = 0, along = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double step = s * d[i];
            x[i] = v[i] + step;
            e[i] = ev[i] + std::abs(s) * ed[i] + u * (std::abs(step) + std::abs(x[i]));
            const double xx = x[i] * x[i];
            squares += xx;
            if (i != axis) h += xx;
            off += e[i] * e[i];
            along += std::abs(x[i]) * e[i];
        }
        g += squares;
        // Of G, of its difference within the room of the coordinates, and of what is beyond the gradient in F.
        const double eg = ecore + 3 * u * squares + u * std::abs(g), dg = 2 * along + off;
        double spread = (2 * (std::abs(g) + eg) + k) * off + dg * dg;
        for (std::size_t i = 0; i < 3; ++i) spread += (std::abs(4 * g - (i != axis ? 2 * k : 0)) + 8 * u * (std::abs(g) + k) + 4 * eg) * std::abs(x[i]) * e[i];
        const double gg = g * g, kh = k * h, value = gg - kh;
        return {value, (spread + (2 * std::abs(g) + eg) * eg + u * (gg + 5 * kh + std::abs(value))) * (1 + 32 * u)};
    }
};

// The root in the piece, certified by opposite signs at s - error and s + error. `whole`: the torus itself, where the quartic is it.
bool refine(const Quartic& q, const TorusOnLine* whole, const Piece& p, double& s, double& error) {
    double lo = p.from, hi = p.from + p.width;
    const bool rising = p.b[0] < 0;
    s = lo + p.width * (p.b[0] / (p.b[0] - p.b[4]));
    for (int i = 0; i < 60; ++i) {
        const double v = q.value(s);
        ((v < 0) == rising ? lo : hi) = s;
        const double newton = s - v / q.slope(s);
        const double next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        if (std::abs(next - s) <= 4 * u * std::abs(s) || next == lo || next == hi) break;
        s = next;
    }
    const auto at = [&](double x) { return whole != nullptr ? whole->at(x) : Place{q.value(x), q.value_error(x)}; };
    const double slope = std::abs(q.slope(s));
    const Place here = at(s);
    error = 1.25 * (std::abs(here.value) + here.error) / slope + 2 * u * std::abs(s);
    for (int i = 0; i < 20 && std::isfinite(error); ++i, error *= 1.5) {
        if (s - error < p.from || s + error > p.from + p.width) return false;
        const Place a = at(s - error), b = at(s + error);
        if (std::abs(a.value) > a.error && std::abs(b.value) > b.error && (a.value < 0) != (b.value < 0)) return true;
    }
    return false;
}

// The torus's polynomial around t0 and a bound of |s| beyond which nothing of it lies. `reach` < 0: the ray misses the torus's ball.
Quartic quartic_around(const Support& support, const FrameRay& ray, double t0, TorusOnLine& whole, double& reach) {
    const auto& p = support.p;
    const double ring = p[3], tube = p[4];
    for (std::size_t i = 0; i < 3; ++i) {
        const double o = ray.o[i] - p[i], step = t0 * ray.d[i], v = o + step;
        whole.v[i] = v;
        whole.ev[i] = ray.eo[i] + u * (std::abs(o) + std::abs(step) + std::abs(v)) + std::abs(t0) * ray.ed[i];
    }
    whole.d = ray.d;
    whole.ed = ray.ed;
    whole.axis = support.axis;
    // G = g0 + 2 g1 s + g2 s^2 = |x|^2 + R^2 - r^2, H = the same of the two coordinates across the axis.
    double g0 = 0, g1 = 0, g2 = 0, e0 = 0, e1 = 0, e2 = 0, h0 = 0, h1 = 0, h2 = 0, f0 = 0, f1 = 0, f2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double v = whole.v[i], ev = whole.ev[i], d = ray.d[i], ed = ray.ed[i];
        const double vv = v * v, vd = v * d, d2 = d * d;
        const double a = 2 * std::abs(v) * ev + ev * ev + 4 * u * vv, b = std::abs(d) * ev + std::abs(v) * ed + ev * ed + 4 * u * std::abs(vd),
                     c = 2 * std::abs(d) * ed + ed * ed + 4 * u * d2;
        g0 += vv, g1 += vd, g2 += d2, e0 += a, e1 += b, e2 += c;
        if (i != support.axis) h0 += vv, h1 += vd, h2 += d2, f0 += a, f1 += b, f2 += c;
    }
    const double drift = (std::abs(g1) + e1) / (g2 - e2);
    const double reach2 = ((ring + tube) * (ring + tube) * (1 + 32 * u) - g0 + e0) / (g2 - e2) + drift * drift;
    // A little beyond the ball, so that both ends are outside for certain.
    reach = reach2 < 0 ? -1 : (std::sqrt(reach2) + drift) * 1.0625 + 0x1p-20 * (ring + tube) / std::sqrt(g2);
    const double core = ring * ring - tube * tube;
    e0 += 3 * u * (ring * ring + tube * tube) + 2 * u * (std::abs(g0) + std::abs(core));
    g0 += core;
    const double k = 4 * ring * ring, ek = 2 * u * k;
    whole.core = core;
    whole.ecore = u * (ring * ring + tube * tube + std::abs(core));
    whole.k = k;
    Quartic q;
    q.c = {g0 * g0 - k * h0, 4 * g0 * g1 - 2 * k * h1, 2 * g0 * g2 + 4 * g1 * g1 - k * h2, 4 * g1 * g2, g2 * g2};
    const double a0 = std::abs(g0) + e0, a1 = std::abs(g1) + e1, a2 = g2 + e2, b0 = h0 + f0, b1 = std::abs(h1) + f1, b2 = h2 + f2;
    q.e = {2 * a0 * e0 + k * f0 + ek * b0 + 4 * u * (a0 * a0 + k * b0), 4 * (a0 * e1 + a1 * e0) + 2 * (k * f1 + ek * b1) + 8 * u * (2 * a0 * a1 + k * b1),
           2 * (a0 * e2 + a2 * e0) + 8 * a1 * e1 + k * f2 + ek * b2 + 8 * u * (a0 * a2 + 2 * a1 * a1 + k * b2), 4 * (a1 * e2 + a2 * e1) + 8 * u * a1 * a2,
           2 * a2 * e2 + 4 * u * a2 * a2};
    return q;
}

// Roots in [-reach, reach], ascending, t = t0 + s.
bool isolate(const Quartic& q, const TorusOnLine* whole, double reach, double t0, Crossings& out) {
    std::array<Piece, 64> stack;
    int top = 0;
    stack[0] = bernstein(q, reach);
    const double least = stack[0].width * 0x1p-30;
    out.count = 0;
    while (top >= 0) {
        const Piece piece = stack[static_cast<std::size_t>(top--)];
        const Look seen = look(piece);
        if (seen == Look::kNone) continue;
        if (seen == Look::kSplit) {
            if (piece.width < least || top > 60) return false;
            Piece left, right;
            split(piece, 0.5, left, right);
            if (std::abs(right.b[0]) <= right.error) split(piece, 0.4375, left, right);
            stack[static_cast<std::size_t>(++top)] = right;
            stack[static_cast<std::size_t>(++top)] = left;
            continue;
        }
        double s = 0, error = 0;
        if (out.count == 4 || !refine(q, whole, piece, s, error)) return false;
        const std::size_t n = static_cast<std::size_t>(out.count++);
        out.t[n] = t0 + s;
        out.error[n] = error + u * std::abs(out.t[n]);
    }
    return true;
}

}  // namespace

bool filtered_torus(const Support& support, const FrameRay& ray, Crossings& out) {
    double along = 0, dd = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        along += (support.p[i] - ray.o[i]) * ray.d[i];
        dd += ray.d[i] * ray.d[i];
    }
    const double t0 = along / dd;
    if (!std::isfinite(t0)) return false;
    double reach = 0;
    TorusOnLine whole;
    const Quartic q = quartic_around(support, ray, t0, whole, reach);
    out.first_sign = 1;
    out.count = 0;
    if (reach < 0) return true;
    return isolate(q, &whole, reach, t0, out) && out.count % 2 == 0;
}

bool filtered_torus_departure(const Support& support, const FrameRay& ray, Crossings& out) {
    double reach = 0;
    TorusOnLine whole;
    const Quartic q = quartic_around(support, ray, 0, whole, reach);
    if (!(reach > 0) || !std::isfinite(reach)) return false;
    // Without the root at 0: q / t.
    Quartic rest;
    for (std::size_t k = 0; k < 4; ++k) {
        rest.c[k] = q.c[k + 1];
        rest.e[k] = q.e[k + 1];
    }
    if (!isolate(rest, nullptr, reach, 0, out) || out.count % 2 == 0) return false;
    std::size_t at = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(out.count); ++i) {
        if (std::abs(out.t[i]) <= out.error[i]) return false;
        if (out.t[i] < 0) at = i + 1;
    }
    for (auto i = static_cast<std::size_t>(out.count); i > at; --i) {
        out.t[i] = out.t[i - 1];
        out.error[i] = out.error[i - 1];
    }
    out.t[at] = out.error[at] = 0;
    ++out.count;
    out.first_sign = 1;
    return true;
}

}  // namespace whittle
