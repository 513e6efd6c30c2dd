// roots.cpp — the double filter of single rays for planes and quadrics. Tori: torus_roots.cpp.
#include "tracer/engine/roots.h"

#include <cmath>

#include "tracer/engine/dyadic.h"
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

namespace {

// A ray all but square to the plane of a section hardly moves in it: by how much only exact numbers tell.
void keep_slow_way(const Frame& frame, const Vec3& direction, FrameRay& local) {
    constexpr double kEnough = 0x1p-20;  // known to that, relative, double will do
    double way = 0, error = 0;
    for (std::size_t i = 0; i < 3; ++i) way += std::abs(local.d[i]), error += local.ed[i];
    if (error <= kEnough * way) return;
    const exact::Dyadic zero(0.0);
    const FrameLine<exact::Dyadic> line = line_in_frame<exact::Dyadic>(frame, {zero, zero, zero}, direction);
    for (std::size_t i = 0; i < 3; ++i) {
        local.d[i] = line.d[i].approximate() / line.w.approximate();
        local.ed[i] = 4 * u * std::abs(local.d[i]);
    }
}

}  // namespace

FrameRay ray_in_frame(const Frame& frame, const Ray& ray) {
    const auto line = single::line_in<double>(frame, {ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z});
    FrameRay local{line.o, line.d, line.eo, line.ed};
    if (frame.section && kCertifies) keep_slow_way(frame, ray.direction, local);
    return local;
}

bool filtered_crossings(const Support& support, const FrameRay& ray, Crossings& out) {
    if (is_plane(support.kind)) {
        return solve_plane(single::plane_form<double>(support, ray), out);
    }
    if (support.kind == SupportKind::kTorus) return filtered_torus(support, ray, out);
    if (support.kind == SupportKind::kBall) return round_crossings<3>({0, 1, 2}, {support.p[0], support.p[1], support.p[2]}, support.p[3], ray, out);
    if (support.kind == SupportKind::kCylinder)
        return round_crossings<2>({(support.axis + 1u) % 3, (support.axis + 2u) % 3}, {support.p[0], support.p[1]}, support.p[2], ray, out);
    const auto c = single::quadratic_crossing<double>(single::quadratic_form<double>(support, ray));
    out.count = c.met ? 2 : 0;
    out.first_sign = c.outside ? 1 : -1;
    out.t = {c.t0, c.t1, 0, 0};
    out.error = {c.error0, c.error1, 0, 0};
    return c.met || c.missed;
}

bool filtered_departure(const Support& support, const FrameRay& ray, Crossings& out) {
    if (support.kind == SupportKind::kTorus) return filtered_torus_departure(support, ray, out);
    if (is_plane(support.kind)) {
        const Form f = single::plane_form<double>(support, ray);
        return magnitude(f.s) > f.es && solve_plane({0, 0, f.s, f.es}, out);
    }
    const auto q = single::quadratic_form<double>(support, ray);
    // At t = 0 the exact surface has 2 b0 as slope: b0 = b - a t0. The other root is -2 b0 / a.
    const double step = q.a * q.t0, b0 = q.b - step, eb0 = q.eb + q.ea * magnitude(q.t0) + u * (magnitude(step) + magnitude(b0));
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
