#include "csg/solid/ear_clipping.h"

#include <algorithm>

#include "csg/solid/predicates.h"

namespace whittle {
namespace {

using Ring = std::vector<std::uint32_t>;

class EarClipping {
public:
    explicit EarClipping(const std::vector<Vec2>& points) : points_(points) {}

    double twice_area(const Ring& ring) const {
        double sum = 0;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            const Vec2 u = points_[ring[i]] - points_[ring[0]], v = points_[ring[i + 1]] - points_[ring[0]];
            sum += u.x * v.y - u.y * v.x;
        }
        return sum;
    }

    // Even-odd; a point on the border counts as either.
    bool holds(const Ring& ring, Vec2 p) const {
        bool inside = false;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 a = points_[ring[i]], b = points_[ring[(i + 1) % ring.size()]];
            if ((a.y > p.y) != (b.y > p.y) && (turn_of(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
        }
        return inside;
    }

    std::uint32_t leftmost(const Ring& ring) const {
        return *std::min_element(ring.begin(), ring.end(), [&](std::uint32_t a, std::uint32_t b) { return is_left(a, b); });
    }
    bool is_left(std::uint32_t a, std::uint32_t b) const {
        return points_[a].x != points_[b].x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
    }

    // Walks from the nearest corner of the ring that sees the hole's leftmost corner, around the hole, and back. Only corners to its left: the way
    // there cannot cross the hole, and one of them is in sight.
    bool join(Ring& ring, const Ring& hole) const {
        const std::uint32_t tip = leftmost(hole);
        std::vector<std::size_t> order(ring.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto distance = [&](std::size_t i) { return glm::dot(points_[ring[i]] - points_[tip], points_[ring[i]] - points_[tip]); };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
        const auto from = std::find_if(order.begin(), order.end(), [&](std::size_t i) {
            return is_left(ring[i], tip) && opens_towards(ring, i, tip) && sees(ring, i, tip);
        });
        if (from == order.end()) return false;
        Ring walk;
        const std::size_t start = static_cast<std::size_t>(std::find(hole.begin(), hole.end(), tip) - hole.begin());
        for (std::size_t i = 0; i <= hole.size(); ++i) walk.push_back(hole[(start + i) % hole.size()]);
        walk.push_back(ring[*from]);
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(*from) + 1, walk.begin(), walk.end());
        return true;
    }

    bool clip(Ring ring, std::vector<IndexTriangle>& out) const {
        std::size_t at = 0, misses = 0;
        while (ring.size() > 3) {
            const std::size_t n = ring.size();
            at %= n;
            if (!is_ear(ring, at)) {
                ++at;
                if (++misses > n) return false;
                continue;
            }
            out.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
            ++at;  // the next ear elsewhere: no fan of slivers
            misses = 0;
        }
        if (turn(ring[0], ring[1], ring[2]) <= 0) return false;
        out.push_back({ring[0], ring[1], ring[2]});
        return true;
    }

private:
    int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const { return turn_of(points_[a], points_[b], points_[c]); }

    // A convex corner whose triangle holds no other corner. The second walk of a bridge stands at a corner of the triangle: it is in the way only
    // where it leads into it.
    bool is_ear(const Ring& ring, std::size_t at) const {
        const std::size_t n = ring.size();
        const std::uint32_t a = ring[(at + n - 1) % n], b = ring[at], c = ring[(at + 1) % n];
        if (turn(a, b, c) <= 0) return false;
        const Vec2 lo = glm::min(glm::min(points_[a], points_[b]), points_[c]), hi = glm::max(glm::max(points_[a], points_[b]), points_[c]);
        for (std::size_t k = 0; k < n; ++k) {
            if (k == at || k == (at + n - 1) % n || k == (at + 1) % n) continue;
            const std::uint32_t p = ring[k];
            const Vec2 q = points_[p];
            if (q.x < lo.x || q.x > hi.x || q.y < lo.y || q.y > hi.y) continue;
            if (p == a || p == b || p == c) {
                if (leads_into(a, b, c, p, ring[(k + n - 1) % n]) || leads_into(a, b, c, p, ring[(k + 1) % n])) return false;
            } else if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) {
                return false;
            }
        }
        return true;
    }
    // Does the way from corner `at` to `to` start inside the open triangle?
    bool leads_into(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t at, std::uint32_t to) const {
        const int ab = turn(a, b, to), bc = turn(b, c, to), ca = turn(c, a, to);
        if (at == a) return ab > 0 && ca > 0;
        if (at == b) return ab > 0 && bc > 0;
        return bc > 0 && ca > 0;
    }

    bool opens_towards(const Ring& ring, std::size_t i, std::uint32_t to) const {
        const std::size_t n = ring.size();
        const std::uint32_t a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
        if (turn(a, b, c) > 0) return turn(a, b, to) > 0 && turn(b, c, to) > 0;
        return turn(a, b, to) > 0 || turn(b, c, to) > 0;
    }
    // Nothing of the ring crosses or touches the open segment.
    bool sees(const Ring& ring, std::size_t i, std::uint32_t to) const {
        const std::uint32_t from = ring[i];
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const std::uint32_t a = ring[k], b = ring[(k + 1) % ring.size()];
            if (a != from && turn(from, to, a) == 0 && glm::dot(points_[a] - points_[from], points_[a] - points_[to]) < 0) return false;
            if (a == from || b == from) continue;
            if (turn(from, to, a) * turn(from, to, b) < 0 && turn(a, b, from) * turn(a, b, to) < 0) return false;
        }
        return true;
    }

    const std::vector<Vec2>& points_;
};

}  // namespace

std::optional<std::vector<IndexTriangle>> ear_clipped(const std::vector<Vec2>& points, const std::vector<Ring>& contours) {
    const EarClipping clipping(points);
    struct Region { Ring ring; double area; std::vector<const Ring*> holes; };
    std::vector<Region> regions;
    for (const Ring& c : contours)
        if (const double area = clipping.twice_area(c); area > 0) regions.push_back({c, area, {}});
    for (const Ring& c : contours) {
        if (clipping.twice_area(c) >= 0) continue;
        Region* home = nullptr;  // the smallest outer contour around the hole
        for (Region& r : regions) {
            const auto corners_within = std::count_if(c.begin(), c.end(), [&](std::uint32_t i) { return clipping.holds(r.ring, points[i]); });
            if (2 * static_cast<std::size_t>(corners_within) > c.size() && (!home || r.area < home->area)) home = &r;
        }
        if (!home) return std::nullopt;
        home->holes.push_back(&c);
    }
    std::vector<IndexTriangle> triangles;
    for (Region& r : regions) {
        std::stable_sort(r.holes.begin(), r.holes.end(), [&](const Ring* a, const Ring* b) {
            return points[clipping.leftmost(*a)].x < points[clipping.leftmost(*b)].x;
        });
        for (const Ring* hole : r.holes)
            if (!clipping.join(r.ring, *hole)) return std::nullopt;
        if (!clipping.clip(r.ring, triangles)) return std::nullopt;
    }
    return triangles;
}

}  // namespace whittle
