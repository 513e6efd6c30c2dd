// vec.h — points, vectors and placements in double precision.
//
// GLM gives the arithmetic; the names below say which of the three meanings a triple has where that matters to a reader. A placement is
// twelve doubles: exact arithmetic on it (csg/solid) reads these twelve numbers and nothing else.
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace whittle {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;

// Axis-aligned box; empty when lo > hi in any coordinate.
struct Bounds {
    Vec3 lo{1, 1, 1};
    Vec3 hi{-1, -1, -1};

    bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    bool operator==(const Bounds&) const = default;
};

// Affine map p -> linear*p + offset. Row-major: row(i) is {m[4i], m[4i+1], m[4i+2] | m[4i+3]}.
struct Placement {
    std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    double linear(int row, int column) const { return m[static_cast<std::size_t>(4 * row + column)]; }
    double offset(int row) const { return m[static_cast<std::size_t>(4 * row + 3)]; }
    bool is_identity() const { return *this == Placement{}; }
    bool operator==(const Placement&) const = default;

    static Placement translation(Vec3 v) { return {{1, 0, 0, v.x, 0, 1, 0, v.y, 0, 0, 1, v.z}}; }
};

// The point, or the direction (offset ignored), after the map; rounded as GLM's double arithmetic rounds.
inline Vec3 apply_to_point(const Placement& a, Vec3 p) {
    return {a.m[0] * p.x + a.m[1] * p.y + a.m[2] * p.z + a.m[3], a.m[4] * p.x + a.m[5] * p.y + a.m[6] * p.z + a.m[7],
            a.m[8] * p.x + a.m[9] * p.y + a.m[10] * p.z + a.m[11]};
}
inline Vec3 apply_to_direction(const Placement& a, Vec3 d) {
    return {a.m[0] * d.x + a.m[1] * d.y + a.m[2] * d.z, a.m[4] * d.x + a.m[5] * d.y + a.m[6] * d.z, a.m[8] * d.x + a.m[9] * d.y + a.m[10] * d.z};
}
// outer after inner, in double (not for certified paths: those multiply exactly).
inline Placement operator*(const Placement& outer, const Placement& inner) {
    Placement r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) {
            double s = j == 3 ? outer.offset(i) : 0;
            for (int k = 0; k < 3; ++k) s += outer.linear(i, k) * inner.m[static_cast<std::size_t>(4 * k + j)];
            r.m[static_cast<std::size_t>(4 * i + j)] = s;
        }
    return r;
}
inline double determinant(const Placement& a) {
    return a.m[0] * (a.m[5] * a.m[10] - a.m[6] * a.m[9]) - a.m[1] * (a.m[4] * a.m[10] - a.m[6] * a.m[8]) + a.m[2] * (a.m[4] * a.m[9] - a.m[5] * a.m[8]);
}

}  // namespace whittle
