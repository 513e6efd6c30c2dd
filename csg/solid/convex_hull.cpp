#include "csg/solid/convex_hull.h"

#include <algorithm>
#include <array>
#include <map>

#include "csg/solid/predicates.h"

namespace whittle {
namespace {

bool before(Vec3 a, Vec3 b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }
bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

class Quickhull {
public:
    explicit Quickhull(const std::vector<Vec3>& points) : points_(points) {}

    std::optional<FacetList> run() {
        if (!start()) return std::nullopt;
        for (std::size_t f = 0; f < facets_.size(); ++f)
            while (facets_[f].alive && !facets_[f].above.empty()) grow(f);
        return listed();
    }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;
    // `next[i]` is the facet across the side from corner i to corner i + 1; `above`: points seen by this facet first.
    struct Facet {
        std::array<std::uint32_t, 3> corner;
        std::array<std::uint32_t, 3> next{kNone, kNone, kNone};
        std::vector<std::uint32_t> above{};
        bool alive = true;
    };
    struct Side { std::uint32_t from, to, behind; };  // of the horizon; `behind` stays

    int side(const Facet& f, std::uint32_t p) const { return side_of(points_[f.corner[0]], points_[f.corner[1]], points_[f.corner[2]], points_[p]); }

    // Four points that span space, the first ones far apart.
    bool start() {
        const auto n = static_cast<std::uint32_t>(points_.size());
        if (n < 4) return false;
        std::array<std::uint32_t, 4> t{0, n - 1, 0, 0};  // sorted: the extreme ones
        const Vec3 a = points_[t[0]], b = points_[t[1]];
        double most = -1;
        for (std::uint32_t i = 0; i < n; ++i)
            if (const Vec3 c = glm::cross(b - a, points_[i] - a); glm::dot(c, c) > most && !are_collinear(a, b, points_[i])) most = glm::dot(c, c), t[2] = i;
        if (most < 0) return false;
        const Vec3 normal = glm::cross(b - a, points_[t[2]] - a);
        most = -1;
        for (std::uint32_t i = 0; i < n; ++i)
            if (const double h = std::abs(glm::dot(normal, points_[i] - a)); h > most && side_of(a, b, points_[t[2]], points_[i]) != 0) most = h, t[3] = i;
        if (most < 0) return false;
        if (side_of(a, b, points_[t[2]], points_[t[3]]) > 0) std::swap(t[1], t[2]);
        facets_ = {{{t[0], t[1], t[2]}}, {{t[0], t[3], t[1]}}, {{t[1], t[3], t[2]}}, {{t[2], t[3], t[0]}}};
        facets_[0].next = {1, 2, 3};
        facets_[1].next = {3, 2, 0};
        facets_[2].next = {1, 3, 0};
        facets_[3].next = {2, 1, 0};
        for (std::uint32_t p = 0; p < n; ++p) give(p, 0, 4);
        return true;
    }

    // Hands a point to the first facet that sees it.
    void give(std::uint32_t p, std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f)
            if (facets_[f].alive && side(facets_[f], p) > 0) {
                facets_[f].above.push_back(p);
                return;
            }
    }

    std::uint32_t farthest(const Facet& f) const {
        const Vec3 a = points_[f.corner[0]], normal = glm::cross(points_[f.corner[1]] - a, points_[f.corner[2]] - a);
        std::uint32_t best = f.above[0];
        double most = -1;
        for (const std::uint32_t p : f.above)
            if (const double h = glm::dot(normal, points_[p] - a); h > most) most = h, best = p;
        return best;
    }

    // Joins the farthest point that the facet sees: what it sees goes, its horizon becomes a fan.
    void grow(std::size_t f) {
        const std::uint32_t eye = farthest(facets_[f]);
        std::vector<std::uint32_t> seen, orphans;
        std::vector<Side> horizon;
        see(static_cast<std::uint32_t>(f), eye, seen, horizon);
        for (const std::uint32_t s : seen) {
            orphans.insert(orphans.end(), facets_[s].above.begin(), facets_[s].above.end());
            facets_[s].above.clear();
        }
        const std::size_t first = facets_.size();
        std::map<std::uint32_t, std::uint32_t> starting;  // corner → facet of the fan whose horizon side starts there
        for (const Side& s : horizon) {
            const auto id = static_cast<std::uint32_t>(facets_.size());
            facets_.push_back({{s.from, s.to, eye}, {s.behind, kNone, kNone}, {}, true});
            starting[s.from] = id;
            Facet& behind = facets_[s.behind];
            for (std::size_t i = 0; i < 3; ++i)
                if (behind.corner[i] == s.to && behind.corner[(i + 1) % 3] == s.from) behind.next[i] = id;
        }
        for (std::size_t i = first; i < facets_.size(); ++i) {
            const std::uint32_t after = starting.at(facets_[i].corner[1]);
            facets_[i].next[1] = after;
            facets_[after].next[2] = static_cast<std::uint32_t>(i);
        }
        std::sort(orphans.begin(), orphans.end());
        for (const std::uint32_t p : orphans)
            if (p != eye) give(p, first, facets_.size());
    }

    void see(std::uint32_t from, std::uint32_t eye, std::vector<std::uint32_t>& seen, std::vector<Side>& horizon) {
        facets_[from].alive = false;
        seen.push_back(from);
        for (std::size_t at = 0; at < seen.size(); ++at)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t next = facets_[seen[at]].next[i];
                if (!facets_[next].alive) continue;
                if (side(facets_[next], eye) <= 0) continue;
                facets_[next].alive = false;
                seen.push_back(next);
            }
        for (const std::uint32_t s : seen)
            for (std::size_t i = 0; i < 3; ++i)
                if (const std::uint32_t next = facets_[s].next[i]; facets_[next].alive)
                    horizon.push_back({facets_[s].corner[i], facets_[s].corner[(i + 1) % 3], next});
    }

    FacetList listed() const {
        FacetList out;
        std::vector<std::uint32_t> number(points_.size(), kNone);
        for (const Facet& f : facets_) {
            if (!f.alive) continue;
            auto& facet = out.facets.emplace_back();
            for (const std::uint32_t c : f.corner) {
                if (number[c] == kNone) {
                    number[c] = static_cast<std::uint32_t>(out.points.size());
                    out.points.push_back(points_[c]);
                }
                facet.push_back(number[c]);
            }
        }
        return out;
    }

    const std::vector<Vec3>& points_;
    std::vector<Facet> facets_;
};

}  // namespace

std::optional<FacetList> convex_hull_of(std::vector<Vec3> points) {
    std::sort(points.begin(), points.end(), [](Vec3 a, Vec3 b) { return before(a, b); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return Quickhull(points).run();
}

std::vector<Vec2> convex_hull_of(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return before(a, b); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Vec2> out;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = out.size();
        for (const Vec2& p : points) {
            while (out.size() >= first + 2 && turn_of(out[out.size() - 2], out.back(), p) <= 0) out.pop_back();
            out.push_back(p);
        }
        out.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return out;
}

std::vector<Vec3> sums_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    std::vector<Vec3> out;
    out.reserve(a.size() * b.size());
    for (const Vec3& p : a)
        for (const Vec3& q : b) out.push_back(p + q);
    return out;
}

}  // namespace whittle
