// roots.cpp — the double filter for planes and quadrics. Tori: torus_roots.cpp.
#include "tracer/engine/roots.h"

#include <cmath>

#include "tracer/engine/torus_roots.h"

namespace whittle {

namespace {

constexpr double u = kUnitRoundoff;

double magnitude(double x) { return std::abs(x); }

using Form = single::LinearForm<double>;

bool solve_plane(const Form& f, Crossings& out) {
    const auto c = single::plane_crossing<double>(f);
    out.t[0] = c.t;
    out.error[0] = c.error;
    out.count = c.met ? 1 : 0;
    out.first_sign = c.outside ? 1 : -1;
    return c.met || c.missed;
}

// A t^2 + 2 B t + C with bounds.
struct Quadratic {
    double a = 0, ea = 0, b = 0, eb = 0, c = 0, ec = 0;
};

// Adds weight * form^2 (|weight - exact| <= weight_error). What a sum rounds is a unit of the sum so far, not of all that goes into it.
void add_square(Quadratic& q, const Form& f, double weight, double weight_error) {
    const double ss = f.s * f.s, vs = f.v * f.s, vv = f.v * f.v, w = magnitude(weight) + weight_error, rounding = 2 * u * w + weight_error;
    q.a += weight * ss;
    q.b += weight * vs;
    q.c += weight * vv;
    q.ea += w * (2 * magnitude(f.s) * f.es + f.es * f.es) + rounding * ss + u * magnitude(q.a);
    q.eb += w * (magnitude(f.v) * f.es + magnitude(f.s) * f.ev + f.ev * f.es) + rounding * magnitude(vs) + u * magnitude(q.b);
    q.ec += w * (2 * magnitude(f.v) * f.ev + f.ev * f.ev) + rounding * vv + u * magnitude(q.c);
}

// Moves the ray's origin to t0 (exactly this double) and measures from the centre.
Form coordinate(const FrameRay& ray, std::size_t i, double centre, double t0) {
    const double o = ray.o[i] - centre, step = t0 * ray.d[i], v = o + step;
    return {v, ray.eo[i] + u * magnitude(o) + magnitude(t0) * ray.ed[i] + u * magnitude(step) + u * magnitude(v), ray.d[i], ray.ed[i]};
}

// The parameter near which the ray is closest to the centre, in the coordinates of the mask.
double closest(const FrameRay& ray, const std::array<double, 3>& centre, const std::array<bool, 3>& use) {
    double along = 0, length2 = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (use[i]) {
            along += (centre[i] - ray.o[i]) * ray.d[i];
            length2 += ray.d[i] * ray.d[i];
        }
    const double t = along / length2;
    return std::isfinite(t) ? t : 0;
}

// c may be off by `error` and the rounding of one product.
void add_constant(Quadratic& q, double c, double error) {
    q.c += c;
    q.ec += error + u * magnitude(c) + u * magnitude(q.c);
}

Quadratic round_quadric(const Support& s, const FrameRay& ray, double& t0) {
    const auto& p = s.p;
    Quadratic q;
    if (s.kind == SupportKind::kCylinder) {
        const std::size_t i = (s.axis + 1u) % 3, j = (s.axis + 2u) % 3;
        std::array<double, 3> centre{};
        std::array<bool, 3> use{};
        centre[i] = p[0], centre[j] = p[1];
        use[i] = use[j] = true;
        t0 = closest(ray, centre, use);
        add_square(q, coordinate(ray, i, p[0], t0), 1, 0);
        add_square(q, coordinate(ray, j, p[1], t0), 1, 0);
        add_constant(q, -(p[2] * p[2]), 0);
        return q;
    }
    t0 = closest(ray, {p[0], p[1], p[2]}, {true, true, true});
    if (s.kind == SupportKind::kEllipsoid) {
        const double a = p[3], b = p[4], c = p[5];
        const std::array<double, 3> k{b * c * (b * c), a * c * (a * c), a * b * (a * b)};
        for (std::size_t i = 0; i < 3; ++i) add_square(q, coordinate(ray, i, p[i], t0), k[i], 4 * u * k[i]);
        const double whole = a * b * c;
        add_constant(q, -(whole * whole), 6 * u * whole * whole);
        return q;
    }
    for (std::size_t i = 0; i < 3; ++i) add_square(q, coordinate(ray, i, p[i], t0), 1, 0);
    if (s.kind == SupportKind::kBall) {
        add_constant(q, -(p[3] * p[3]), 0);
    } else {
        const double x = p[3] * p[3], y = p[4] * p[4];
        add_constant(q, x - y, 2 * u * (x + y));
    }
    return q;
}

Quadratic cone(const Support& s, const FrameRay& ray, double& t0) {
    const auto& p = s.p;
    const std::size_t i = (s.axis + 1u) % 3, j = (s.axis + 2u) % 3, k = s.axis;
    std::array<double, 3> centre{};
    centre[i] = p[0], centre[j] = p[1], centre[k] = p[2];
    t0 = closest(ray, centre, {true, true, true});
    Quadratic q;
    add_square(q, coordinate(ray, i, p[0], t0), 1, 0);
    add_square(q, coordinate(ray, j, p[1], t0), 1, 0);
    const double slope = (p[5] - p[4]) / (p[3] - p[2]), eslope = 4 * u * magnitude(slope);
    const Form z = coordinate(ray, k, p[2], t0);
    const double term = slope * z.v, v = p[4] + term;
    const Form radius{v, magnitude(slope) * z.ev + eslope * (magnitude(z.v) + z.ev) + 2 * u * (magnitude(term) + magnitude(v)), slope * z.s,
                      magnitude(slope) * z.es + eslope * (magnitude(z.s) + z.es) + u * magnitude(slope * z.s)};
    add_square(q, radius, -1, 0);
    return q;
}

Quadratic tube(const Support& s, const FrameRay& ray, double& t0) {
    const auto& p = s.p;
    t0 = closest(ray, {p[0], p[1], p[2]}, {true, true, true});
    std::array<Form, 3> x;
    std::array<double, 3> axis;
    double length2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = coordinate(ray, i, p[i], t0);
        axis[i] = p[3 + i] - p[i];
        length2 += axis[i] * axis[i];
    }
    Quadratic q;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double a = magnitude(axis[j]), b = magnitude(axis[k]);
        const double v = axis[j] * x[k].v - axis[k] * x[j].v, slope = axis[j] * x[k].s - axis[k] * x[j].s;
        // The axis, its products, their difference: a unit each.
        const Form f{v, a * x[k].ev + b * x[j].ev + 2 * u * (a * (magnitude(x[k].v) + x[k].ev) + b * (magnitude(x[j].v) + x[j].ev)) + u * magnitude(v), slope,
                     a * x[k].es + b * x[j].es + 2 * u * (a * (magnitude(x[k].s) + x[k].es) + b * (magnitude(x[j].s) + x[j].es)) + u * magnitude(slope)};
        add_square(q, f, 1, 0);
    }
    const double whole = p[6] * p[6] * length2;
    add_constant(q, -whole, 8 * u * whole);
    return q;
}

Quadratic general(const Support& s, const FrameRay& ray, double& t0) {
    const auto& c = s.p;
    t0 = closest(ray, {0, 0, 0}, {true, true, true});
    const std::array<Form, 4> x{coordinate(ray, 0, 0, t0), coordinate(ray, 1, 0, t0), coordinate(ray, 2, 0, t0), Form{1, 0, 0, 0}};
    constexpr std::array<std::array<std::size_t, 2>, 10> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};
    Quadratic q;
    for (std::size_t i = 0; i < 10; ++i) {
        const Form &f = x[pairs[i][0]], &g = x[pairs[i][1]];
        if (c[i] == 0) continue;
        const double w = magnitude(c[i]);
        const double fv = magnitude(f.v), gv = magnitude(g.v), fs = magnitude(f.s), gs = magnitude(g.s);
        q.a += c[i] * (f.s * g.s);
        q.b += 0.5 * c[i] * (f.v * g.s + f.s * g.v);
        q.c += c[i] * (f.v * g.v);
        q.ea += w * (f.es * gs + fs * g.es + f.es * g.es + 2 * u * fs * gs) + u * magnitude(q.a);
        q.eb += 0.5 * w * (f.ev * gs + fv * g.es + f.ev * g.es + f.es * gv + fs * g.ev + f.es * g.ev + 3 * u * (fv * gs + fs * gv)) + u * magnitude(q.b);
        q.ec += w * (f.ev * gv + fv * g.ev + f.ev * g.ev + 2 * u * fv * gv) + u * magnitude(q.c);
    }
    return q;
}

Quadratic quadratic_near(const Support& s, const FrameRay& ray, double& t0) {
    Quadratic q = s.kind == SupportKind::kCone      ? cone(s, ray, t0)
                  : s.kind == SupportKind::kTube    ? tube(s, ray, t0)
                  : s.kind == SupportKind::kQuadric ? general(s, ray, t0)
                                                    : round_quadric(s, ray, t0);
    // Bounds are sums of some forty rounded terms that are not negative.
    constexpr double kOwnRounding = 1 + 64 * u;
    q.ea *= kOwnRounding;
    q.eb *= kOwnRounding;
    q.ec *= kOwnRounding;
    return q;
}

// Two crossings at t0 + s, s the roots of the quadratic; or none; false where a sign is not certain.
bool solve_quadratic(const Quadratic& q, double t0, Crossings& out) {
    if (!(magnitude(q.a) > q.ea)) {
        if (q.a != 0 || q.ea != 0 || q.b != 0 || q.eb != 0 || !(magnitude(q.c) > q.ec)) return false;
        out.count = 0;
        out.first_sign = q.c > 0 ? 1 : -1;
        return true;
    }
    const double bb = q.b * q.b, ac = q.a * q.c, disc = bb - ac;
    const double edisc = (2 * magnitude(q.b) * q.eb + q.eb * q.eb + magnitude(q.a) * q.ec + magnitude(q.c) * q.ea + q.ea * q.ec + u * (bb + magnitude(ac) + magnitude(disc))) *
                         (1 + 16 * u);
    out.first_sign = q.a > 0 ? 1 : -1;
    if (disc < -edisc) {
        out.count = 0;
        return true;
    }
    if (!(disc > edisc)) return false;
    const double h = std::sqrt(disc), eh = single::root_error(edisc, h);
    const double m = -(q.b + std::copysign(h, q.b)), em = q.eb + eh + u * magnitude(m);
    const double r1 = m / q.a, r2 = q.c / m;
    const double e1 = (em + magnitude(r1) * q.ea) / (magnitude(q.a) - q.ea) + u * magnitude(r1);
    const double room = magnitude(m) - em;
    if (!(room > 0)) return false;
    const double e2 = (q.ec + magnitude(r2) * em) / room + u * magnitude(r2);
    const double t1 = t0 + r1, t2 = t0 + r2;
    const double b1 = (e1 + u * magnitude(t1)) * (1 + 32 * u), b2 = (e2 + u * magnitude(t2)) * (1 + 32 * u);
    const bool swap = r1 > r2;
    out.count = 2;
    out.t[0] = swap ? t2 : t1;
    out.error[0] = swap ? b2 : b1;
    out.t[1] = swap ? t1 : t2;
    out.error[1] = swap ? b1 : b2;
    return std::isfinite(t1) && std::isfinite(t2);
}

template <std::size_t n>
bool round_crossings(const std::array<std::size_t, n>& axes, const std::array<double, n>& centre, double r, const FrameRay& ray, Crossings& out) {
    std::array<double, n> o, eo, d, ed;
    for (std::size_t i = 0; i < n; ++i) {
        o[i] = ray.o[axes[i]] - centre[i];
        d[i] = ray.d[axes[i]];
        eo[i] = ray.eo[axes[i]];
        ed[i] = ray.ed[axes[i]];
    }
    const auto c = single::round_crossing(o, eo, single::round_direction(d, ed), r);
    out.count = c.met ? 2 : 0;
    out.first_sign = c.within ? -1 : 1;
    out.t[0] = c.t0;
    out.t[1] = c.t1;
    out.error[0] = c.error0;
    out.error[1] = c.error1;
    return c.met || c.missed;
}

}  // namespace

FrameRay ray_in_frame(const Frame& frame, const Ray& ray) {
    const auto line = single::line_in<double>(frame, {ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z});
    return {line.o, line.d, line.eo, line.ed};
}

bool filtered_crossings(const Support& support, const FrameRay& ray, Crossings& out) {
    if (is_plane(support.kind)) {
        return solve_plane(single::plane_form<double>(support, ray), out);
    }
    if (support.kind == SupportKind::kTorus) return filtered_torus(support, ray, out);
    if (support.kind == SupportKind::kBall) return round_crossings<3>({0, 1, 2}, {support.p[0], support.p[1], support.p[2]}, support.p[3], ray, out);
    if (support.kind == SupportKind::kCylinder)
        return round_crossings<2>({(support.axis + 1u) % 3, (support.axis + 2u) % 3}, {support.p[0], support.p[1]}, support.p[2], ray, out);
    double t0 = 0;
    const Quadratic q = quadratic_near(support, ray, t0);
    return solve_quadratic(q, t0, out);
}

bool filtered_departure(const Support& support, const FrameRay& ray, Crossings& out) {
    if (support.kind == SupportKind::kTorus) return filtered_torus_departure(support, ray, out);
    if (is_plane(support.kind)) {
        const Form f = single::plane_form<double>(support, ray);
        return magnitude(f.s) > f.es && solve_plane({0, 0, f.s, f.es}, out);
    }
    double t0 = 0;
    const Quadratic q = quadratic_near(support, ray, t0);
    // At t = 0 the exact surface has 2 b0 as slope: b0 = b - a t0. The other root is -2 b0 / a.
    const double step = q.a * t0, b0 = q.b - step, eb0 = q.eb + q.ea * magnitude(t0) + u * (magnitude(step) + magnitude(b0));
    if (!(magnitude(q.a) > q.ea) || !(magnitude(b0) > eb0)) return false;
    const double t = -2 * b0 / q.a, et = (2 * eb0 + magnitude(t) * q.ea) / (magnitude(q.a) - q.ea) * (1 + 8 * u) + 2 * u * magnitude(t);
    const std::size_t at = t > 0 ? 1 : 0;
    out.t[at] = t;
    out.error[at] = et;
    out.t[1 - at] = out.error[1 - at] = 0;
    out.count = 2;
    out.first_sign = q.a > 0 ? 1 : -1;
    return true;
}

}  // namespace whittle
