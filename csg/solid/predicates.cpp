#include "csg/solid/predicates.h"

#include <array>
#include <cmath>

#include <gmpxx.h>

namespace whittle {
namespace {

constexpr double kHalfUlp = 0x1p-53;
// Roundings on the way to each determinant, with room for their products.
constexpr double kTurnError = 4 * kHalfUlp, kCrossError = 8 * kHalfUlp, kVolumeError = 16 * kHalfUlp;

using Exact = std::array<mpq_class, 3>;
Exact exact_difference(Vec3 a, Vec3 b) { return {mpq_class(a.x) - mpq_class(b.x), mpq_class(a.y) - mpq_class(b.y), mpq_class(a.z) - mpq_class(b.z)}; }

}  // namespace

int turn_of(Vec2 a, Vec2 b, Vec2 c) {
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x), det = left - right;
    if (std::fabs(det) > kTurnError * (std::fabs(left) + std::fabs(right))) return det > 0 ? 1 : -1;
    const mpq_class ax(a.x), ay(a.y);
    const mpq_class exact = (b.x - ax) * (c.y - ay) - (b.y - ay) * (c.x - ax);
    return sgn(exact);
}

bool are_collinear(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 u = b - a, v = c - a, n = glm::abs(glm::cross(u, v)), su = glm::abs(u), sv = glm::abs(v);
    const Vec3 size{su.y * sv.z + su.z * sv.y, su.z * sv.x + su.x * sv.z, su.x * sv.y + su.y * sv.x};
    for (int i = 0; i < 3; ++i)
        if (n[i] > kCrossError * size[i]) return false;
    const Exact p = exact_difference(b, a), q = exact_difference(c, a);
    return p[1] * q[2] == p[2] * q[1] && p[2] * q[0] == p[0] * q[2] && p[0] * q[1] == p[1] * q[0];
}

int side_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double det = glm::dot(w, glm::cross(u, v));
    const Vec3 su = glm::abs(u), sv = glm::abs(v), sw = glm::abs(w);
    const double size = sw.x * (su.y * sv.z + su.z * sv.y) + sw.y * (su.z * sv.x + su.x * sv.z) + sw.z * (su.x * sv.y + su.y * sv.x);
    if (std::fabs(det) > kVolumeError * size) return det > 0 ? 1 : -1;
    const Exact p = exact_difference(b, a), q = exact_difference(c, a), r = exact_difference(d, a);
    return sgn(mpq_class(r[0] * (p[1] * q[2] - p[2] * q[1]) + r[1] * (p[2] * q[0] - p[0] * q[2]) + r[2] * (p[0] * q[1] - p[1] * q[0])));
}

bool are_coplanar(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return side_of(a, b, c, d) == 0; }

}  // namespace whittle
