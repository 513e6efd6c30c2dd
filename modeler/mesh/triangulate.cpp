#include "modeler/mesh/triangulate.h"

#include <algorithm>
#include <limits>

namespace whittle {

Int128 cross(const GridPoint2& a, const GridPoint2& b, const GridPoint2& c) {
    return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

namespace {

using Contour = std::vector<std::uint32_t>;

Int128 twice_area(const std::vector<GridPoint2>& points, const Contour& c) {
    Int128 sum = 0;
    for (std::size_t i = 1; i + 1 < c.size(); ++i) sum += cross(points[c[0]], points[c[i]], points[c[i + 1]]);
    return sum;
}

// Even-odd: is the point strictly inside or on the border of the contour?
bool contains(const std::vector<GridPoint2>& points, const Contour& c, const GridPoint2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const GridPoint2 &a = points[c[i]], &b = points[c[(i + 1) % c.size()]];
        const Int128 side = cross(a, b, p);
        if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y)) return true;
        if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

// A polygon without holes as a ring in which bridges to holes are walked twice.
class Ring {
public:
    Ring(const std::vector<GridPoint2>& points, const Contour& outer) : points_(points) {
        for (std::size_t i = 0; i < outer.size(); ++i) {
            const auto n = static_cast<std::uint32_t>(outer.size()), k = static_cast<std::uint32_t>(i);
            nodes_.push_back({outer[i], (k + n - 1) % n, (k + 1) % n});
        }
        size_ = outer.size();
    }

    // Joins a hole by the shortest bridge that crosses nothing: from its leftmost vertex to a vertex of the ring to the left of it.
    bool add_hole(const Contour& hole) {
        const auto left = std::min_element(hole.begin(), hole.end(), [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; });
        const auto bridge = bridge_from(points_[*left]);
        if (!bridge) return false;
        splice(*bridge, hole, static_cast<std::size_t>(left - hole.begin()));
        return true;
    }

    bool clip(std::vector<Triangle>& out) {
        std::uint32_t at = 0, misses = 0;
        while (size_ > 3) {
            if (is_ear(at)) {
                const Node n = nodes_[at];
                out.push_back({nodes_[n.previous].point, n.point, nodes_[n.next].point});
                unlink(at);
                at = nodes_[n.next].next;  // skipping one keeps triangles from fanning out of one vertex
                misses = 0;
            } else {
                at = nodes_[at].next;
                if (++misses > size_) return false;
            }
        }
        const Node n = nodes_[at];
        if (turn(at) <= 0) return false;
        out.push_back({nodes_[n.previous].point, n.point, nodes_[n.next].point});
        return true;
    }

private:
    struct Node { std::uint32_t point, previous, next; };

    const GridPoint2& at(std::uint32_t node) const { return points_[nodes_[node].point]; }
    Int128 turn(std::uint32_t n) const { return cross(at(nodes_[n].previous), at(n), at(nodes_[n].next)); }
    void unlink(std::uint32_t n) {
        nodes_[nodes_[n].previous].next = nodes_[n].next;
        nodes_[nodes_[n].next].previous = nodes_[n].previous;
        --size_;
    }

    // A convex vertex whose triangle holds no vertex but its own corners. A vertex on the border of the triangle is in the way, one at the place of
    // a corner (the other walk of a bridge) is not.
    bool is_ear(std::uint32_t n) const {
        const std::uint32_t before = nodes_[n].previous, after = nodes_[n].next;
        const GridPoint2 &a = at(before), &b = at(n), &c = at(after);
        if (cross(a, b, c) <= 0) return false;
        const auto [lo_x, hi_x] = std::minmax({a.x, b.x, c.x});
        const auto [lo_y, hi_y] = std::minmax({a.y, b.y, c.y});
        for (std::uint32_t k = nodes_[after].next; k != before; k = nodes_[k].next) {
            const GridPoint2& p = at(k);
            if (p.x < lo_x || p.x > hi_x || p.y < lo_y || p.y > hi_y) continue;
            if (p == a || p == b || p == c) {
                if (leaves_through(k, a, b, c)) return false;
                continue;
            }
            if (cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0) return false;
        }
        return true;
    }
    // A vertex at the place of a corner: does the ring go on from it into the open triangle?
    bool leaves_through(std::uint32_t k, const GridPoint2& a, const GridPoint2& b, const GridPoint2& c) const {
        const auto into = [&](const GridPoint2& p) {
            const GridPoint2& v = at(k);
            if (v == a) return cross(a, b, p) > 0 && cross(c, a, p) > 0;
            if (v == b) return cross(b, c, p) > 0 && cross(a, b, p) > 0;
            return cross(c, a, p) > 0 && cross(b, c, p) > 0;
        };
        return into(at(nodes_[k].previous)) || into(at(nodes_[k].next));
    }

    std::optional<std::uint32_t> bridge_from(const GridPoint2& from) const {
        // Candidates by distance; the nearest that sees `from` is taken.
        std::vector<std::pair<Int128, std::uint32_t>> candidates;
        std::uint32_t n = first();
        for (std::size_t i = 0; i < size_; ++i, n = nodes_[n].next) {
            const GridPoint2& p = at(n);
            if (from < p) continue;
            const Int128 dx = p.x - from.x, dy = p.y - from.y;
            candidates.emplace_back(dx * dx + dy * dy, n);
        }
        std::make_heap(candidates.begin(), candidates.end(), std::greater<>());
        while (!candidates.empty()) {
            std::pop_heap(candidates.begin(), candidates.end(), std::greater<>());
            const std::uint32_t node = candidates.back().second;
            candidates.pop_back();
            if (opens_towards(node, from) && sees(node, from)) return node;
        }
        return std::nullopt;
    }
    std::uint32_t first() const { return 0; }  // nothing is unlinked before all holes are joined

    // Does the ray from the vertex to `p` start inside the polygon?
    bool opens_towards(std::uint32_t n, const GridPoint2& p) const {
        const GridPoint2 &a = at(nodes_[n].previous), &b = at(n), &c = at(nodes_[n].next);
        if (b == p) return true;
        if (cross(a, b, c) > 0) return cross(a, b, p) > 0 && cross(b, c, p) > 0;
        return !(cross(a, b, p) <= 0 && cross(b, c, p) <= 0);
    }
    // No edge crosses the open segment, no vertex lies on it.
    bool sees(std::uint32_t node, const GridPoint2& p) const {
        const GridPoint2& q = at(node);
        std::uint32_t n = first();
        for (std::size_t i = 0; i < size_; ++i, n = nodes_[n].next) {
            const GridPoint2 &a = at(n), &b = at(nodes_[n].next);
            if (a != q && a != p && cross(p, q, a) == 0 && between(p, q, a)) return false;
            if (a == q || b == q || a == p || b == p) continue;
            const Int128 s1 = cross(p, q, a), s2 = cross(p, q, b), s3 = cross(a, b, p), s4 = cross(a, b, q);
            if (((s1 > 0 && s2 < 0) || (s1 < 0 && s2 > 0)) && ((s3 > 0 && s4 < 0) || (s3 < 0 && s4 > 0))) return false;
        }
        return true;
    }
    static bool between(const GridPoint2& p, const GridPoint2& q, const GridPoint2& a) {
        return std::min(p.x, q.x) <= a.x && a.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= a.y && a.y <= std::max(p.y, q.y);
    }

    // ... bridge, hole[left], ..., hole[left] again, bridge again, ...
    void splice(std::uint32_t bridge, const Contour& hole, std::size_t left) {
        const std::uint32_t after = nodes_[bridge].next;
        std::uint32_t previous = bridge;
        const auto link = [&](std::uint32_t point) {
            const auto fresh = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back({point, previous, after});
            nodes_[previous].next = fresh;
            nodes_[after].previous = fresh;
            previous = fresh;
            ++size_;
        };
        for (std::size_t i = 0; i <= hole.size(); ++i) link(hole[(left + i) % hole.size()]);
        link(nodes_[bridge].point);
    }

    const std::vector<GridPoint2>& points_;
    std::vector<Node> nodes_;
    std::size_t size_ = 0;
};

}  // namespace

std::optional<std::vector<Triangle>> triangulate(const std::vector<GridPoint2>& points, const std::vector<Contour>& contours) {
    struct Outer {
        const Contour* contour;
        Int128 area;
        std::vector<const Contour*> holes;
    };
    std::vector<Outer> outers;
    for (const Contour& c : contours)
        if (const Int128 area = twice_area(points, c); area > 0) outers.push_back({&c, area, {}});
    for (const Contour& c : contours) {
        if (twice_area(points, c) >= 0) continue;
        Outer* home = nullptr;  // the smallest outer contour around the hole
        for (Outer& o : outers) {
            const bool around = std::all_of(c.begin(), c.end(), [&](std::uint32_t v) { return contains(points, *o.contour, points[v]); });
            if (around && (!home || o.area < home->area)) home = &o;
        }
        if (!home) return std::nullopt;
        home->holes.push_back(&c);
    }
    std::vector<Triangle> triangles;
    for (Outer& o : outers) {
        const auto leftmost = [&](const Contour* c) {
            GridPoint2 p = points[(*c)[0]];
            for (const std::uint32_t v : *c) p = std::min(p, points[v]);
            return p;
        };
        std::sort(o.holes.begin(), o.holes.end(), [&](const Contour* a, const Contour* b) { return leftmost(a) < leftmost(b); });
        Ring ring(points, *o.contour);
        for (const Contour* hole : o.holes)
            if (!ring.add_hole(*hole)) return std::nullopt;
        if (!ring.clip(triangles)) return std::nullopt;
    }
    return triangles;
}

}  // namespace whittle
