// crossings.cpp — signs of determinants of doubles: filtered, else as integers of one common exponent.
#include "modeler/arrange/crossings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "modeler/arrange/box_tree.h"
#include "modeler/arrange/wide.h"

namespace whittle {
namespace {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;

class Signs {
public:
    explicit Signs(std::span<const Vec3> points) : points_(points) {
        low_of_.reserve(points.size());
        int low = kNoBits;
        for (const Vec3& p : points) {
            int lowest = kNoBits;
            for (int i = 0; i < 3; ++i) {
                if (p[i] == 0) continue;
                int exponent = 0;
                const double mantissa = std::frexp(p[i], &exponent);
                const auto whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
                high_ = std::max(high_, exponent);
                lowest = std::min(lowest, exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(whole)));
            }
            low = std::min(low, lowest);
            low_of_.push_back(static_cast<std::int16_t>(lowest));
        }
        constexpr int kBits = 250;  // what lies lower against the largest coordinate is left out: 2^-250 of the model
        low_ = std::max(low, high_ - kBits);
    }

    // Sign of det(b - a, c - a, d - a).
    int volume(Index a, Index b, Index c, Index d) const {
        const Vec3 &p = points_[a], u = points_[b] - p, v = points_[c] - p, w = points_[d] - p;
        const double x = v.y * w.z, x2 = v.z * w.y, y = v.z * w.x, y2 = v.x * w.z, z = v.x * w.y, z2 = v.y * w.x;
        const double det = u.x * (x - x2) + u.y * (y - y2) + u.z * (z - z2);
        const double size = std::fabs(u.x) * (std::fabs(x) + std::fabs(x2)) + std::fabs(u.y) * (std::fabs(y) + std::fabs(y2)) +
                            std::fabs(u.z) * (std::fabs(z) + std::fabs(z2));
        constexpr double kVolumeError = 0x1p-49;  // Shewchuk's (7 + 56e)e is 2^-50.2
        if (std::fabs(det) > kVolumeError * size) return det > 0 ? 1 : -1;
        if (size == 0 || a == b || a == c || a == d || b == c || b == d || c == d) return 0;
        return exact_volume(a, b, c, d);
    }
    // Sign of the area of (a, b, c) seen along an axis.
    int area(Index a, Index b, Index c, int axis) const {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const Vec3 &p = points_[a], u = points_[b] - p, v = points_[c] - p;
        const double one = u[i] * v[j], two = u[j] * v[i];
        constexpr double kAreaError = 0x1p-51;
        if (std::fabs(one - two) > kAreaError * (std::fabs(one) + std::fabs(two))) return one > two ? 1 : -1;
        if (one == 0 && two == 0) return 0;
        const auto e = [&](Index q, int k) { return integer(points_[q][k]) - integer(p[k]); };
        return (e(b, i) * e(c, j) - e(b, j) * e(c, i)).sign();
    }
    // An axis along which the triangle has an area; -1 where it has none.
    int seeing_axis(const Corners& t) const {
        const Vec3 n = glm::abs(glm::cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]));
        int best = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
        for (int k = 0; k < 3; ++k, best = (best + 1) % 3)
            if (area(t[0], t[1], t[2], best) != 0) return best;
        return -1;
    }

private:
    Wide<4> integer(double x) const {
        if (x == 0) return {};
        int exponent = 0;
        const auto whole = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
        int shift = exponent - 53 - low_;
        if (shift < 0) return Wide<4>(shift < -62 ? 0 : whole >> -shift);
        Wide<4> out(whole);
        for (; shift >= 63; shift -= 63) out = out << 63;
        return shift > 0 ? out << shift : out;
    }
    // In as few limbs as the four points' own bits take.
    int exact_volume(Index a, Index b, Index c, Index d) const {
        const int low = std::max<int>(low_, std::min({low_of_[a], low_of_[b], low_of_[c], low_of_[d]})), bits = high_ - low;
        const double scale = std::ldexp(1.0, -low);
        // With room for the sign, two differences and the sum of three products.
        if (bits <= 60) return volume_in<1>(a, b, c, d, [&](double x) { return Wide<1>(static_cast<std::int64_t>(x * scale)); });
        if (bits <= 122 && low > -1000) return volume_in<2>(a, b, c, d, [&](double x) { return Wide<2>(static_cast<Int128>(x * scale)); });
        return volume_in<4>(a, b, c, d, [&](double x) { return integer(x); });
    }
    template <int n, typename Whole>
    int volume_in(Index a, Index b, Index c, Index d, Whole whole) const {
        std::array<std::array<Wide<n>, 3>, 3> m;
        const std::array<Index, 3> others{b, c, d};
        for (int k = 0; k < 3; ++k) {
            const Wide<n> from = whole(points_[a][k]);
            for (std::size_t r = 0; r < 3; ++r) m[r][static_cast<std::size_t>(k)] = whole(points_[others[r]][k]) - from;
        }
        Wide<3 * n> det;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            det = det + m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
        }
        return det.sign();
    }

    static constexpr int kNoBits = 1100;
    std::span<const Vec3> points_;
    std::vector<std::int16_t> low_of_;  // by point: of its lowest bit the exponent; kNoBits where all are 0
    int low_ = 0, high_ = -kNoBits;
};

class Pairs {
public:
    Pairs(const Signs& signs, std::span<const Corners> triangles) : signs_(signs), triangles_(triangles) {}

    bool meet(Index i, Index j) const {
        const Corners &s = triangles_[i], &t = triangles_[j];
        std::array<std::size_t, 3> in_s{}, in_t{};
        std::size_t common = 0;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                if (s[a] == t[b]) in_s[common] = a, in_t[common] = b, ++common;
        if (common == 3) return true;
        if (common == 2) return meet_at_edge(s, 3 - in_s[0] - in_s[1], t, 3 - in_t[0] - in_t[1]);
        if (common == 1) return meet_at_corner(turned(s, in_s[0]), turned(t, in_t[0]));
        return meet_apart(s, t);
    }

private:
    static Corners turned(const Corners& t, std::size_t k) { return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]}; }

    bool meet_at_edge(const Corners& s, std::size_t apex, const Corners& t, std::size_t other) const {
        const Index u = s[(apex + 1) % 3], v = s[(apex + 2) % 3], a = s[apex], b = t[other];
        if (signs_.volume(u, v, a, b) != 0) return false;
        const int axis = signs_.seeing_axis(s);
        return axis < 0 || signs_.area(u, v, a, axis) == signs_.area(u, v, b, axis);
    }

    // s[0] == t[0].
    bool meet_at_corner(const Corners& s, const Corners& t) const {
        const int c = signs_.volume(s[0], s[1], s[2], t[1]), d = signs_.volume(s[0], s[1], s[2], t[2]);
        if (c * d > 0) return false;
        const int a = signs_.volume(t[0], t[1], t[2], s[1]), b = signs_.volume(t[0], t[1], t[2], s[2]);
        if (a * b > 0) return false;
        if (c == 0 && d == 0) {
            const int axis = signs_.seeing_axis(s);
            return axis < 0 || in_angle(s, t[1], axis) || in_angle(s, t[2], axis) || in_angle(t, s[1], axis) || in_angle(t, s[2], axis);
        }
        return pierces(s[1], s[2], t) || pierces(t[1], t[2], s);
    }
    // Is p in the angle at t[0], legs included?
    bool in_angle(const Corners& t, Index p, int axis) const {
        const int way = signs_.area(t[0], t[1], t[2], axis), one = signs_.area(t[0], t[1], p, axis) * way, two = signs_.area(t[0], p, t[2], axis) * way;
        return way != 0 && one >= 0 && two >= 0;
    }

    // Does the segment meet the closed triangle, in whose plane it does not lie?
    bool pierces(Index p, Index q, const Corners& t) const {
        const int above = signs_.volume(t[0], t[1], t[2], p), below = signs_.volume(t[0], t[1], t[2], q);
        if (above * below > 0 || (above == 0 && below == 0)) return false;
        const int x = signs_.volume(p, q, t[0], t[1]), y = signs_.volume(p, q, t[1], t[2]), z = signs_.volume(p, q, t[2], t[0]);
        return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
    }

    bool meet_apart(const Corners& s, const Corners& t) const {
        int low = 1, high = -1;
        for (const Index v : t) {
            const int side = signs_.volume(s[0], s[1], s[2], v);
            low = std::min(low, side), high = std::max(high, side);
        }
        if (low > 0 || high < 0) return false;
        if (low == 0 && high == 0) return overlap_flat(s, t);
        for (std::size_t k = 0; k < 3; ++k)
            if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
        return false;
    }
    bool overlap_flat(const Corners& s, const Corners& t) const {
        const int axis = signs_.seeing_axis(s);
        if (axis < 0) return true;
        // Two convex polygons are apart where an edge of one has the other on its far side.
        const auto apart = [&](const Corners& p, const Corners& q) {
            const int way = signs_.area(p[0], p[1], p[2], axis);
            for (std::size_t k = 0; k < 3; ++k) {
                bool beyond = true;
                for (const Index v : q) beyond = beyond && signs_.area(p[k], p[(k + 1) % 3], v, axis) * way < 0;
                if (beyond) return true;
            }
            return false;
        };
        return !apart(s, t) && !apart(t, s);
    }

    const Signs& signs_;
    std::span<const Corners> triangles_;
};

// visit(i, j) for every pair that crosses.
template <class Visit>
void each_crossing(std::span<const Vec3> points, std::span<const Corners> triangles, const Visit& visit) {
    std::vector<DoubleBox> boxes;
    boxes.reserve(triangles.size());
    for (const Corners& t : triangles) {
        const auto at = [&](std::size_t k) { return std::array<double, 3>{points[t[k]].x, points[t[k]].y, points[t[k]].z}; };
        boxes.push_back(DoubleBox::at(at(0)));
        boxes.back().include(at(1));
        boxes.back().include(at(2));
    }
    const Signs signs(points);
    const Pairs pairs(signs, triangles);
    const BoxTree tree(std::move(boxes), std::vector<std::uint32_t>(triangles.size(), BoxTree::kMixed));
    tree.pairs([&](std::uint32_t i, std::uint32_t j) {
        if (pairs.meet(i, j)) visit(i, j);
    });
}

}  // namespace

std::uint64_t count_crossings(std::span<const Vec3> points, std::span<const Corners> triangles) {
    std::uint64_t count = 0;
    each_crossing(points, triangles, [&](std::uint32_t, std::uint32_t) { ++count; });
    return count;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(std::span<const Vec3> points, std::span<const Corners> triangles, std::size_t most) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    each_crossing(points, triangles, [&](std::uint32_t i, std::uint32_t j) {
        if (out.size() < most) out.emplace_back(i, j);
    });
    return out;
}

}  // namespace whittle
