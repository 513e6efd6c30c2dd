#include "csg/solid/facet_operations.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/solid/convex_hull.h"
#include "csg/solid/ear_clipping.h"
#include "csg/solid/polyhedron.h"
#include "csg/solid/predicates.h"
#include "csg/solid/profile.h"

namespace whittle {
namespace {

// Rounding of a volume, against the volume: a dent that is smaller shows nowhere.
constexpr double kConvexShare = 0x1p-36;

using Corners = std::vector<Vec3>;

bool is_convex_solid(const FacetList& list, const FacetList& hull) {
    const double own = signed_volume(list), whole = signed_volume(hull);
    return whole - own <= kConvexShare * whole;
}

Corners corners_of(const FacetList& list, const std::vector<std::uint32_t>& facet) {
    Corners out;
    for (const std::uint32_t i : facet) out.push_back(list.points[i]);
    return out;
}

// Points of which each stands for one connected piece of the list.
std::vector<Vec3> point_of_each_piece(const FacetList& list) {
    std::vector<std::uint32_t> group(list.points.size());
    for (std::uint32_t i = 0; i < group.size(); ++i) group[i] = i;
    const auto find = [&](std::uint32_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    for (const auto& f : list.facets)
        for (const std::uint32_t i : f) group[find(i)] = find(f[0]);
    std::vector<Vec3> out;
    std::vector<bool> used(group.size(), false);
    for (const auto& f : list.facets)
        if (const std::uint32_t root = find(f[0]); !used[root]) {
            used[root] = true;
            out.push_back(list.points[root]);
        }
    return out;
}

void add_sum(std::vector<FacetList>& out, const Corners& a, const Corners& b) {
    if (auto hull = convex_hull_of(sums_of(a, b))) out.push_back(std::move(*hull));
}

// The sums of one convex set of corners with a solid that is not convex.
void add_sums(std::vector<FacetList>& out, const Corners& convex, const FacetList& other) {
    for (const auto& facet : other.facets) add_sum(out, convex, corners_of(other, facet));
    out.push_back(placed_facets(other, Placement::translation(convex.front())));
}

std::vector<std::vector<Vec2>> triangles_of(const Contours& contours) {
    std::vector<Vec2> points;
    std::vector<std::vector<std::uint32_t>> rings;
    for (const auto& c : contours) {
        auto& ring = rings.emplace_back();
        for (const Vec2& p : c) {
            ring.push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back(p);
        }
    }
    const auto triangles = ear_clipped(points, rings);
    std::vector<std::vector<Vec2>> out;
    if (triangles)
        for (const auto& t : *triangles) out.push_back({points[t[0]], points[t[1]], points[t[2]]});
    return out;
}

// Convex pieces of a flat set.
std::vector<std::vector<Vec2>> convex_pieces(const Contours& contours) {
    if (contours.size() == 1) {
        auto hull = convex_hull_of(contours[0]);
        if (hull.size() == contours[0].size()) return {std::move(hull)};
    }
    return triangles_of(contours);
}

// Where the edge from a to b meets z = 0; the same bits from either end.
Vec2 crossing(Vec3 a, Vec3 b) {
    if (a.z > b.z) std::swap(a, b);
    const double t = -a.z / (b.z - a.z);
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

}  // namespace

FacetList placed_facets(const FacetList& list, const Placement& placement) {
    FacetList out = list;
    for (Vec3& p : out.points) p = apply_to_point(placement, p);
    if (determinant(placement) < 0)
        for (auto& facet : out.facets) std::reverse(facet.begin(), facet.end());
    return out;
}

std::optional<std::vector<FacetList>> minkowski_parts(const FacetList& a, const FacetList& b, std::size_t most) {
    const auto hull_a = convex_hull_of(a.points), hull_b = convex_hull_of(b.points);
    if (!hull_a || !hull_b) return std::nullopt;
    const bool convex_a = is_convex_solid(a, *hull_a), convex_b = is_convex_solid(b, *hull_b);
    std::vector<FacetList> out;
    if (convex_a && convex_b) {
        add_sum(out, hull_a->points, hull_b->points);
        return out;
    }
    const std::size_t parts = (convex_a ? 1 : a.facets.size()) * (convex_b ? 1 : b.facets.size() + 1);
    if (parts > most) return std::nullopt;
    if (convex_a || convex_b) {
        add_sums(out, convex_a ? hull_a->points : hull_b->points, convex_a ? b : a);
        return out;
    }
    for (const Vec3& p : point_of_each_piece(b)) out.push_back(placed_facets(a, Placement::translation(p)));
    for (const auto& facet : a.facets) add_sums(out, corners_of(a, facet), b);
    return out;
}

std::optional<Contours> flat_minkowski(const Contours& a, const Contours& b, std::size_t most) {
    const auto left = convex_pieces(a), right = convex_pieces(b);
    if (left.size() * right.size() > most) return std::nullopt;
    std::vector<std::vector<Vec2>> sums;
    for (const auto& p : left)
        for (const auto& q : right) {
            std::vector<Vec2> corners;
            for (const Vec2& x : p)
                for (const Vec2& y : q) corners.push_back(x + y);
            if (auto hull = convex_hull_of(std::move(corners)); hull.size() >= 3) sums.push_back(std::move(hull));
        }
    return united_rings(sums);
}

Contours shadow_of(const FacetList& list) {
    std::vector<std::vector<Vec2>> rings;
    for (const auto& facet : list.facets)
        for (const auto& t : triangulated(list, facet)) {
            const Vec2 a(list.points[t[0]]), b(list.points[t[1]]), c(list.points[t[2]]);
            if (turn_of(a, b, c) > 0) rings.push_back({a, b, c});
        }
    return united_rings(rings);
}

// Each facet gives the sides in which it leaves the half-space z <= 0: end to end they run round the section, its inside on the left.
Contours section_of(const FacetList& list) {
    std::vector<std::vector<Vec2>> rings;
    std::multimap<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, std::uint32_t>> next;
    for (const auto& facet : list.facets)
        for (const auto& t : triangulated(list, facet)) {
            std::pair<std::uint32_t, std::uint32_t> up{}, down{};
            int crossings = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t p = t[i], q = t[(i + 1) % 3];
                const bool from = list.points[p].z > 0, to = list.points[q].z > 0;
                if (from == to) continue;
                (to ? up : down) = {std::min(p, q), std::max(p, q)};
                ++crossings;
            }
            if (crossings == 2) next.emplace(down, up);
        }
    while (!next.empty()) {
        auto at = next.begin();
        const auto first = at->first;
        std::vector<Vec2> ring;
        while (at != next.end()) {
            ring.push_back(crossing(list.points[at->first.first], list.points[at->first.second]));
            const auto to = at->second;
            next.erase(at);
            at = to == first ? next.end() : next.find(to);
        }
        if (ring.size() >= 3) rings.push_back(std::move(ring));
    }
    return united_rings(rings);
}

}  // namespace whittle
