#include "csg/solid/parabola.h"

#include <algorithm>
#include <cmath>

namespace whittle {
namespace {

constexpr double kMostChords = 4096;
constexpr double kMostParabolas = 256;

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

std::array<Vec2, 4> part_of_cubic(const std::array<Vec2, 4>& p, double t0, double t1) {
    // The blossom: the control points of a part are values of the curve's polar form at its ends.
    const auto blossom = [&p](double x, double y, double z) {
        std::array<Vec2, 3> q;
        for (std::size_t i = 0; i < 3; ++i) q[i] = glm::mix(p[i], p[i + 1], x);
        return glm::mix(glm::mix(q[0], q[1], y), glm::mix(q[1], q[2], y), z);
    };
    return {blossom(t0, t0, t0), blossom(t0, t0, t1), blossom(t0, t1, t1), blossom(t1, t1, t1)};
}

}  // namespace

Vec2 parabola_point(const shape::ParabolicSegment& s, double t) { return glm::mix(glm::mix(s.a, s.c, t), glm::mix(s.c, s.b, t), t); }

std::pair<shape::ParabolicSegment, shape::ParabolicSegment> parabola_halves(const shape::ParabolicSegment& s) {
    const Vec2 left = (s.a + s.c) / 2.0, right = (s.c + s.b) / 2.0, middle = (left + right) / 2.0;
    return {{s.a, left, middle}, {middle, right, s.b}};
}

int parabola_chords(const shape::ParabolicSegment& s, double tolerance) {
    const double n = std::sqrt(glm::length(s.a - 2.0 * s.c + s.b) / (4 * tolerance));
    return static_cast<int>(std::clamp(std::ceil(n), 1.0, kMostChords));
}

double parabola_error(const shape::ParabolicSegment& s, int n) { return glm::length(s.a - 2.0 * s.c + s.b) / (4.0 * n * n); }

std::vector<Vec2> parabola_corners(const shape::ParabolicSegment& s, int n) {
    std::vector<Vec2> out{s.a};
    for (int i = 1; i < n; ++i) out.push_back(parabola_point(s, 1.0 * i / n));
    out.push_back(s.b);
    return out;
}

// In the weights u, v, w of a, c, b the curve is v^2 = 4 u w.
bool is_inside(const shape::ParabolicSegment& s, Vec2 p) {
    const double whole = cross(s.b - s.a, s.c - s.a);
    const double v = cross(s.b - s.a, p - s.a) / whole, w = cross(p - s.a, s.c - s.a) / whole, u = 1 - v - w;
    return v > 0 && v * v < 4 * u * w;
}

// The nearest point is at an end or where the curve runs across the way to p: a root of a cubic, found between its two turning points.
double parabola_distance(const shape::ParabolicSegment& s, Vec2 p) {
    const Vec2 o = s.a - p, d = 2.0 * (s.c - s.a), e = s.a - 2.0 * s.c + s.b;  // o + d t + e t^2
    const auto slope = [&](double t) { return glm::dot(o + t * (d + t * e), d + 2 * t * e); };
    double best = std::min(glm::length(o), glm::length(s.b - p));
    const double a = 2 * glm::dot(e, e), b = 3 * glm::dot(d, e), c = glm::dot(d, d) + 2 * glm::dot(o, e);
    std::array<double, 4> ends{0, 1, 1, 1};
    if (const double room = b * b - 3 * a * c; a > 0 && room > 0) {
        ends[1] = std::clamp((-b - std::sqrt(room)) / (3 * a), 0.0, 1.0);
        ends[2] = std::clamp((-b + std::sqrt(room)) / (3 * a), 0.0, 1.0);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        double lo = ends[i], hi = ends[i + 1];
        if (!(slope(lo) < 0 && slope(hi) > 0)) continue;  // a largest distance, or none
        for (double middle = (lo + hi) / 2; middle > lo && middle < hi; middle = (lo + hi) / 2) (slope(middle) < 0 ? lo : hi) = middle;
        best = std::min(best, glm::length(parabola_point(s, lo) - p));
    }
    return best;
}

std::vector<shape::ParabolicSegment> parabolas_of_cubic(const std::array<Vec2, 4>& p, double tolerance) {
    const double off = std::sqrt(3.0) / 36 * glm::length(p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0]);
    const int n = static_cast<int>(std::clamp(std::ceil(std::cbrt(off / tolerance)), 1.0, kMostParabolas));
    std::vector<shape::ParabolicSegment> out;
    Vec2 from = p[0];
    for (int i = 0; i < n; ++i) {
        const auto part = part_of_cubic(p, 1.0 * i / n, 1.0 * (i + 1) / n);
        const Vec2 to = i + 1 == n ? p[3] : part[3];
        out.push_back({from, (3.0 * (part[1] + part[2]) - part[0] - part[3]) / 4.0, to});
        from = to;
    }
    return out;
}

}  // namespace whittle
