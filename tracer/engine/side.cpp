// side.cpp — orientation predicates of the ray against points and edges.
#include "tracer/engine/side.h"

#include <cmath>

#include "tracer/engine/bounded.h"
#include "tracer/engine/nudged.h"

namespace whittle {

namespace {

using exact::Nudged;
constexpr double u = kUnitRoundoff;

// The sign of what is s within the bound; 0 where double does not tell, or is not to be asked (EnginePass::kFilter).
int sign_in_double(RayContext& context, double s, double bound) {
    if (!context.filters() && kCertifies) return 0;
    const int sign = (s > bound) - (s < -bound);
    context.counters().skipped_by(EnginePass::kFilter) += sign != 0;
    return sign;
}

// The sign of an expression of the ray's line in the frame: in double-double, then exactly.
template <class Expression>
int sign_of(RayContext& context, FrameId frame, const Expression& expression) {
    if (!kCertifies) return 0;
    const Ray& ray = context.ray();
    ++context.counters().escalated_double_double;
    const std::array<Bounded, 3> origin{Bounded(ray.origin.x), Bounded(ray.origin.y), Bounded(ray.origin.z)};
    const Bounded close = expression(line_in_frame<Bounded>(context.frame(frame), origin, ray.direction), Bounded());
    if ((close.is_certain() && close.sign() != 0) || mutated(Mutation::kNoExactTier)) return close.sign();
    ++context.counters().escalated_exact;
    return expression(line_in_frame<Nudged>(context.frame(frame), exact::nudged_origin(ray), ray.direction), Nudged()).sign();
}

std::size_t next(int axis, int by) { return static_cast<std::size_t>((axis + by) % 3); }

}  // namespace

int side_of_point(RayContext& context, FrameId frame, int axis, Vec2 point) {
    const FrameRay& r = context.frame_ray(frame);
    const std::size_t i = next(axis, 1), j = next(axis, 2);
    if (r.d[i] == 0 && r.d[j] == 0 && r.ed[i] == 0 && r.ed[j] == 0) return 0;
    const double x = point.x - r.o[i], y = point.y - r.o[j];
    const double a = r.d[i] * y, b = r.d[j] * x, s = a - b;
    const double ex = u * std::abs(x) + r.eo[i], ey = u * std::abs(y) + r.eo[j];
    const double bound = !kCertifies ? 0 : (std::abs(r.d[i]) * ey + r.ed[i] * (std::abs(y) + ey) + std::abs(r.d[j]) * ex + r.ed[j] * (std::abs(x) + ex) +
                          3 * u * (std::abs(a) + std::abs(b))) * (1 + 16 * u);
    if (const int sign = sign_in_double(context, s, bound)) return sign;
    return sign_of(context, frame, [&]<class N>(const FrameLine<N>& line, N) {
        return line.d[i] * (line.w * N(point.y) - line.o[j]) - line.d[j] * (line.w * N(point.x) - line.o[i]);
    });
}

int side_of_edge(RayContext& context, FrameId frame, const Vec3& a, const Vec3& b) {
    const FrameRay& r = context.frame_ray(frame);
    double s = 0, bound = 0;
    std::array<double, 3> p, q, ep, eq;
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = a[static_cast<int>(i)] - r.o[i];
        q[i] = b[static_cast<int>(i)] - r.o[i];
        ep[i] = u * std::abs(p[i]) + r.eo[i];
        eq[i] = u * std::abs(q[i]) + r.eo[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double x = p[j] * q[k], y = p[k] * q[j], cross = x - y;
        const double size = std::abs(x) + std::abs(y);
        const double ecross = std::abs(p[j]) * eq[k] + std::abs(q[k]) * ep[j] + ep[j] * eq[k] + std::abs(p[k]) * eq[j] + std::abs(q[j]) * ep[k] + ep[k] * eq[j] +
                              3 * u * size;
        const double term = r.d[i] * cross;
        s += term;
        bound += std::abs(r.d[i]) * ecross + r.ed[i] * (size + ecross) + 4 * u * std::abs(term);
    }
    bound *= kCertifies ? 1 + 32 * u : 0;
    if (const int sign = sign_in_double(context, s, bound)) return sign;
    return sign_of(context, frame, [&]<class N>(const FrameLine<N>& line, N sum) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const auto rel = [&](const Vec3& v, std::size_t n) { return line.w * N(v[static_cast<int>(n)]) - line.o[n]; };
            sum = sum + line.d[i] * (rel(a, j) * rel(b, k) - rel(a, k) * rel(b, j));
        }
        return sum;
    });
}

int side_of_line(RayContext& context, FrameId frame, int axis, Vec2 a, Vec2 b) {
    const FrameRay& r = context.frame_ray(frame);
    const std::size_t i = next(axis, 1), j = next(axis, 2);
    const double x = b.x - a.x, y = b.y - a.y, ou = r.o[i] - a.x, ov = r.o[j] - a.y;
    const double left = x * ov, right = y * ou, s = left - right;
    const double bound = !kCertifies ? 0 : (std::abs(x) * r.eo[j] + std::abs(y) * r.eo[i] + 5 * u * (std::abs(left) + std::abs(right))) * (1 + 16 * u);
    if (const int sign = sign_in_double(context, s, bound)) return sign;
    return sign_of(context, frame, [&]<class N>(const FrameLine<N>& line, N) {
        return (N(b.x) - N(a.x)) * (line.o[j] - line.w * N(a.y)) - (N(b.y) - N(a.y)) * (line.o[i] - line.w * N(a.x));
    });
}

int height_against(RayContext& context, FrameId frame, int axis, double y) {
    const FrameRay& r = context.frame_ray(frame);
    const double h = r.o[next(axis, 2)] - y, bound = !kCertifies ? 0 : (r.eo[next(axis, 2)] + u * std::abs(h)) * (1 + 16 * u);
    if (const int sign = sign_in_double(context, h, bound)) return sign;
    return sign_of(context, frame, [&]<class N>(const FrameLine<N>& line, N) { return line.o[next(axis, 2)] - line.w * N(y); });
}

}  // namespace whittle
