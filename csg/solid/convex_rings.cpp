// convex_rings.cpp — see convex_rings.h.
#include "csg/solid/convex_rings.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "csg/solid/ear_clipping.h"
#include "csg/solid/predicates.h"

namespace whittle {

namespace {

// Turning left throughout, and once around: coordinates rise and fall once.
bool is_convex(const std::vector<Vec2>& ring) {
    const std::size_t n = ring.size();
    int changes = 0;
    const auto rises = [&](std::size_t i) {
        const Vec2 &a = ring[i % n], &b = ring[(i + 1) % n];
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (turn_of(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) < 0) return false;
        changes += rises(i) != rises(i + 1);
    }
    return n >= 3 && changes == 2;
}

// Rings that grow together over the edges they share while they stay convex.
class Merging {
public:
    Merging(const std::vector<Vec2>& points, const std::vector<IndexTriangle>& triangles) : points_(points) {
        for (const IndexTriangle& t : triangles) {
            if (turn_of(points[t[0]], points[t[1]], points[t[2]]) <= 0) continue;
            for (std::size_t i = 0; i < 3; ++i) ring_right_of_[{t[(i + 1) % 3], t[i]}] = rings_.size();
            rings_.emplace_back(t.begin(), t.end());
            into_.push_back(into_.size());
        }
    }

    std::vector<std::vector<Vec2>> merged() {
        for (std::size_t i = 0; i < rings_.size(); ++i)
            while (grow(i)) {}
        std::vector<std::vector<Vec2>> out;
        for (const auto& ring : rings_) {
            if (ring.empty()) continue;
            auto& into = out.emplace_back();
            for (const std::uint32_t p : ring) into.push_back(points_[p]);
        }
        return out;
    }

private:
    using Ring = std::vector<std::uint32_t>;

    std::size_t ring_now(std::size_t ring) const {
        while (into_[ring] != ring) ring = into_[ring];
        return ring;
    }

    // Over its first edge that allows it. False: none does.
    bool grow(std::size_t i) {
        const Ring& ring = rings_[i];
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const std::uint32_t a = ring[k], b = ring[(k + 1) % ring.size()];
            const auto beside = ring_right_of_.find({a, b});
            if (beside == ring_right_of_.end()) continue;
            const std::size_t j = ring_now(beside->second);
            if (j != i && join(i, k, j)) return true;
        }
        return false;
    }

    // Ring i, whose side k is also one of ring j, with that.
    bool join(std::size_t i, std::size_t k, std::size_t j) {
        const Ring &p = rings_[i], &q = rings_[j];
        const std::size_t n = p.size(), m = q.size();
        if (n + m - 2 > kMostSides) return false;
        const std::uint32_t a = p[k], b = p[(k + 1) % n];
        const auto at = static_cast<std::size_t>(std::find(q.begin(), q.end(), a) - q.begin());  // q goes from b to a
        if (at == m || q[(at + m - 1) % m] != b) return false;
        const auto turns_left = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return turn_of(points_[x], points_[y], points_[z]) > 0; };
        if (!turns_left(p[(k + n - 1) % n], a, q[(at + 1) % m]) || !turns_left(q[(at + m - 2) % m], b, p[(k + 2) % n])) return false;
        Ring joined;
        for (std::size_t x = 0; x < n; ++x) joined.push_back(p[(k + 1 + x) % n]);  // b ... a
        for (std::size_t x = 1; x + 1 < m; ++x) joined.push_back(q[(at + x) % m]);
        rings_[i] = std::move(joined);
        rings_[j].clear();
        into_[j] = i;
        return true;
    }

    static constexpr std::size_t kMostSides = 16;  // more are better found by boxes around parts

    const std::vector<Vec2>& points_;
    std::vector<Ring> rings_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> ring_right_of_;  // by edge, as first made
    std::vector<std::size_t> into_;                                                 // the ring that a ring has become part of
};

}  // namespace

std::optional<std::vector<std::vector<Vec2>>> convex_rings(std::vector<std::vector<Vec2>> contours) {
    if (contours.size() == 1 && is_convex(contours[0])) return contours;
    std::vector<Vec2> points;
    std::vector<std::vector<std::uint32_t>> indices;
    for (const auto& ring : contours) {
        auto& into = indices.emplace_back();
        for (const Vec2& p : ring) {
            into.push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back(p);
        }
    }
    const auto triangles = ear_clipped(points, indices);
    if (!triangles) return {};
    return Merging(points, *triangles).merged();
}

}  // namespace whittle
