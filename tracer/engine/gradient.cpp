// gradient.cpp — gradients by kind.
#include "tracer/engine/gradient.h"

#include <algorithm>

#include "tracer/engine/convex.h"
#include "tracer/engine/turned.h"

namespace whittle {

namespace {

Vec3 plane_gradient(const Support& s) {
    const auto& p = s.p;
    Vec3 n{0};
    switch (s.kind) {
        case SupportKind::kAxisPlane: n[s.axis] = 1; return n;
        case SupportKind::kPlane: return {p[0], p[1], p[2]};
        case SupportKind::kEdgePlane:
            n[(s.axis + 1) % 3] = p[3] - p[1];
            n[(s.axis + 2) % 3] = p[0] - p[2];
            return n;
        default: return glm::cross(Vec3(p[3] - p[0], p[4] - p[1], p[5] - p[2]), Vec3(p[6] - p[0], p[7] - p[1], p[8] - p[2]));
    }
}

Vec3 curved_gradient(const Support& s, const Vec3& x) {
    const auto& p = s.p;
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3, w = s.axis;
    Vec3 n{0};
    switch (s.kind) {
        case SupportKind::kBall:
        case SupportKind::kTorusCore: return x - Vec3(p[0], p[1], p[2]);
        case SupportKind::kEllipsoid: return (x - Vec3(p[0], p[1], p[2])) / (Vec3(p[3], p[4], p[5]) * Vec3(p[3], p[4], p[5]));
        case SupportKind::kCylinder:
        case SupportKind::kCone:
            n[u] = x[u] - p[0];
            n[v] = x[v] - p[1];
            if (s.kind == SupportKind::kCone) {
                const double slope = (p[5] - p[4]) / (p[3] - p[2]);
                n[w] = -slope * (p[4] + slope * (x[w] - p[2]));
            }
            return n;
        case SupportKind::kTube: {
            const Vec3 a(p[0], p[1], p[2]), axis = Vec3(p[3], p[4], p[5]) - a;
            return (x - a) - axis * (glm::dot(x - a, axis) / glm::dot(axis, axis));
        }
        case SupportKind::kParabola: {
            const Vec2 a(p[0], p[1]), e = Vec2(p[4], p[5]) - a, g = 2.0 * (Vec2(p[2], p[3]) - a) - e, q = Vec2(x[u], x[v]) - a;
            const double whole = (e.x * g.y - e.y * g.x) / 2, across = whole + g.x * q.y - g.y * q.x;
            n[u] = (0 - across * g.y) - whole * e.y;
            n[v] = across * g.x + whole * e.x;
            return n;
        }
        case SupportKind::kTorus: {
            const Vec3 c = x - Vec3(p[0], p[1], p[2]);
            Vec3 flat = c;
            flat[w] = 0;
            const double rho = glm::length(flat);
            return rho > 0 ? c - flat * (p[3] / rho) : c;
        }
        default:
            return {2 * p[0] * x.x + p[3] * x.y + p[4] * x.z + p[6], 2 * p[1] * x.y + p[3] * x.x + p[5] * x.z + p[7],
                    2 * p[2] * x.z + p[4] * x.x + p[5] * x.y + p[8]};
    }
}

}  // namespace

Vec3 unit_vector(Vec3 n) {
    double square = n.x * n.x + n.y * n.y + n.z * n.z;
    if (!(square >= kLeastSafeSquare && square <= kMostSafeSquare)) {
        const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        if (!(most > 0)) return {0, 0, 1};
        n = {n.x / most, n.y / most, n.z / most};
        square = n.x * n.x + n.y * n.y + n.z * n.z;
    }
    const double inverse = 1 / std::sqrt(square);
    return {n.x * inverse, n.y * inverse, n.z * inverse};
}

Vec3 unit_gradient(const Support& support, const Frame& frame, const Vec3& point) {
    const Vec3 local = point_in_frame(frame, point);
    Vec3 n;
    if (support.kind == SupportKind::kConvex) n = convex_gradient(frame, local);
    else if (is_turned(support.kind)) n = turned_gradient(support, *frame.twist, local);
    else n = is_plane(support.kind) ? plane_gradient(support) : curved_gradient(support, local);
    return unit_vector(gradient_in_root(frame, n));
}

}  // namespace whittle
