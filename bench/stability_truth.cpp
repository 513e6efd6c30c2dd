// stability_truth.cpp — see stability_truth.h.
#include "bench/stability_truth.h"

#include <algorithm>
#include <cmath>

namespace whittle::bench {

// Newton's step doubles the 53 bits that double gives; the second is for the last bits.
Quad square_root(Quad x) {
    if (x <= 0) return 0;
    Quad r = std::sqrt(static_cast<double>(x));
    if (r == 0) return 0;
    for (int i = 0; i < 3; ++i) r = (r + x / r) / 2;
    return r;
}

namespace {

Quad dot(const Quad3& a, const Quad3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// By Cramer's rule.
Quad3 solved(const std::array<Quad3, 3>& m, const Quad3& v) {
    const auto minor = [&](int r, int c) {
        const auto r1 = static_cast<std::size_t>((r + 1) % 3), r2 = static_cast<std::size_t>((r + 2) % 3), c1 = static_cast<std::size_t>((c + 1) % 3),
                   c2 = static_cast<std::size_t>((c + 2) % 3);
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const Quad det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    Quad3 r;
    for (int i = 0; i < 3; ++i) r[static_cast<std::size_t>(i)] = (minor(0, i) * v[0] + minor(1, i) * v[1] + minor(2, i) * v[2]) / det;
    return r;
}

bool interval(const NestedShape& s, const Quad3& o, const Quad3& d, Quad& from, Quad& to) {
    const Quad h = s.half;
    if (s.is_ball) {
        const Quad a = dot(d, d), b = dot(o, d), disc = b * b - a * (dot(o, o) - h * h);
        if (disc <= 0) return false;
        const Quad root = square_root(disc);
        from = (-b - root) / a;
        to = (-b + root) / a;
        return true;
    }
    from = -1e30, to = 1e30;
    for (std::size_t i = 0; i < 3; ++i) {
        if (d[i] == 0) {
            if (o[i] < -h || o[i] > h) return false;
            continue;
        }
        Quad x = (-h - o[i]) / d[i], y = (h - o[i]) / d[i];
        if (x > y) std::swap(x, y);
        from = std::max(from, x);
        to = std::min(to, y);
    }
    return from < to;
}

}  // namespace

Quad3 quad(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 rounded(const Quad3& v) { return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])}; }
Quad3 apply_to_direction(const QuadPlacement& m, const Quad3& d) { return {dot(m.linear[0], d), dot(m.linear[1], d), dot(m.linear[2], d)}; }
Quad3 apply_to_point(const QuadPlacement& m, const Quad3& p) {
    Quad3 r = apply_to_direction(m, p);
    for (std::size_t i = 0; i < 3; ++i) r[i] += m.offset[i];
    return r;
}

std::vector<Quad> crossings(const std::vector<NestedShape>& nest, const QuadPlacement& placement, const Quad3& o, const Quad3& d) {
    Quad3 from = o;
    for (std::size_t i = 0; i < 3; ++i) from[i] -= placement.offset[i];
    const Quad3 p = solved(placement.linear, from), v = solved(placement.linear, d);
    std::vector<Quad> all;
    for (const NestedShape& s : nest) {
        Quad a = 0, b = 0;
        if (!interval(s, p, v, a, b)) break;
        if (a >= 0) all.push_back(a);
        if (b >= 0) all.push_back(b);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace whittle::bench
