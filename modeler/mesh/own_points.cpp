// Source: Guéziec, Taubin, Lazarus, Horn, Converting Sets of Polygons to Manifold Surfaces by Cutting and Stitching (1998).
#include "modeler/mesh/own_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "modeler/arrange/edge_order.h"

namespace whittle {
namespace {

struct Side { std::uint64_t edge; std::uint32_t triangle; std::uint8_t corner; bool up; };  // up: from the lower point to the higher

class Corners {
public:
    explicit Corners(const Mesh& mesh) : mesh_(mesh), parent_(mesh.triangles.size() * 3) { std::iota(parent_.begin(), parent_.end(), 0U); }

    void join_fans() {
        std::vector<Side> sides;
        sides.reserve(parent_.size());
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
            for (std::uint8_t k = 0; k < 3; ++k) {
                const std::uint64_t a = mesh_.triangles[i][k], b = mesh_.triangles[i][(k + 1U) % 3];
                sides.push_back({std::min(a, b) << 32 | std::max(a, b), i, k, a < b});
            }
        sort_edges(sides, mesh_.points.size(), [](const Side& s) { return s.edge >> 32; },
                   [](const Side& a, const Side& b) { return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle; });
        for (std::size_t i = 0, j; i < sides.size(); i = j) {
            for (j = i; j < sides.size() && sides[j].edge == sides[i].edge;) ++j;
            if (j - i == 2) join(sides[i], sides[i + 1]);
            else pair_up({sides.begin() + static_cast<std::ptrdiff_t>(i), sides.begin() + static_cast<std::ptrdiff_t>(j)});
        }
    }

    std::uint32_t fan_of(std::uint32_t corner) {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }

private:
    void unite(std::uint32_t a, std::uint32_t b) {
        a = fan_of(a), b = fan_of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    // The corners of two triangles at both ends of their common edge.
    void join(const Side& a, const Side& b) {
        const std::uint32_t a0 = a.triangle * 3 + a.corner, a1 = a.triangle * 3 + (a.corner + 1U) % 3;
        const std::uint32_t b0 = b.triangle * 3 + b.corner, b1 = b.triangle * 3 + (b.corner + 1U) % 3;
        const bool opposite = a.up != b.up;
        unite(a0, opposite ? b1 : b0);
        unite(a1, opposite ? b0 : b1);
    }

    // Around the edge, from a triangle that runs up it the inside lies clockwise: the next that runs down that way bounds it.
    void pair_up(std::vector<Side> sides) {
        const std::uint64_t edge = sides.front().edge;
        const Vec3 a = mesh_.points[edge >> 32], axis = mesh_.points[edge & 0xFFFFFFFF] - a;
        const Vec3 u = std::fabs(axis.x) <= std::fabs(axis.y) && std::fabs(axis.x) <= std::fabs(axis.z) ? glm::cross(axis, Vec3(1, 0, 0))
                       : std::fabs(axis.y) <= std::fabs(axis.z)                                        ? glm::cross(axis, Vec3(0, 1, 0))
                                                                                                       : glm::cross(axis, Vec3(0, 0, 1));
        const Vec3 v = glm::cross(glm::normalize(axis), u);
        std::vector<std::pair<double, Side>> around;
        for (const Side& s : sides) {
            const Vec3 w = mesh_.points[mesh_.triangles[s.triangle][(s.corner + 2U) % 3]] - a;
            around.emplace_back(-std::atan2(glm::dot(w, v), glm::dot(w, u)), s);  // clockwise
        }
        std::stable_sort(around.begin(), around.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
        std::vector<bool> used(around.size());
        // Nearest pairs first; of a closed surface all find one.
        for (std::size_t left = around.size(); left > 1; left -= 2)
            for (std::size_t i = 0; i < around.size(); ++i) {
                if (used[i] || !around[i].second.up) continue;
                std::size_t k = (i + 1) % around.size();
                while (used[k]) k = (k + 1) % around.size();
                if (k == i || around[k].second.up) continue;
                join(around[i].second, around[k].second);
                used[i] = used[k] = true;
                break;
            }
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> parent_;
};

}  // namespace

Mesh with_own_points(const Mesh& mesh) {
    Corners corners(mesh);
    corners.join_fans();
    Mesh out;
    out.leaf = mesh.leaf;
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    std::vector<std::uint32_t> number(mesh.triangles.size() * 3, kNone);
    // Points keep their order; a second fan of a point gets a number behind it.
    out.points = mesh.points;
    std::vector<std::uint32_t> first_fan(mesh.points.size(), kNone);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle t{};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t fan = corners.fan_of(i * 3 + k), point = mesh.triangles[i][k];
            if (number[fan] == kNone) {
                if (first_fan[point] == kNone) {
                    first_fan[point] = fan;
                    number[fan] = point;
                } else {
                    number[fan] = static_cast<std::uint32_t>(out.points.size());
                    out.points.push_back(mesh.points[point]);
                }
            }
            t[k] = number[fan];
        }
        out.triangles.push_back(t);
    }
    return out;
}

namespace {

std::uint64_t edge_of(std::uint32_t a, std::uint32_t b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

// Edges of `mesh` that more than two triangles share though parts that touch have points of their own.
std::vector<std::uint64_t> knots_of(const Mesh& mesh) {
    const Mesh own = with_own_points(mesh);
    std::vector<std::pair<std::uint64_t, std::uint64_t>> sides;  // by its own edge, the edge in `mesh`
    sides.reserve(mesh.triangles.size() * 3);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle &t = own.triangles[i], &was = mesh.triangles[i];
            sides.emplace_back(edge_of(t[k], t[(k + 1) % 3]), edge_of(was[k], was[(k + 1) % 3]));
        }
    std::sort(sides.begin(), sides.end());
    std::vector<std::uint64_t> knots;
    for (std::size_t i = 2; i < sides.size(); ++i)
        if (sides[i].first == sides[i - 2].first) knots.push_back(sides[i].second);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

}  // namespace

std::size_t divide_knots(Mesh& mesh) {
    std::map<std::uint64_t, std::uint32_t> middles;
    for (const std::uint64_t edge : knots_of(mesh)) {
        const Vec3 a = mesh.points[edge >> 32], b = mesh.points[edge & 0xFFFFFFFF], middle = 0.5 * (a + b);
        if (middle == a || middle == b) continue;
        middles.emplace(edge, static_cast<std::uint32_t>(mesh.points.size()));
        mesh.points.push_back(middle);
    }
    if (middles.empty()) return 0;
    // A triangle is cut from the middle of a side to the corner opposite; what is cut off comes behind all others and is looked at in turn.
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            Triangle& t = mesh.triangles[i];
            const auto found = middles.find(edge_of(t[k], t[(k + 1) % 3]));
            if (found == middles.end()) continue;
            Triangle rest = t;
            rest[k] = found->second;
            t[(k + 1) % 3] = found->second;
            mesh.triangles.push_back(rest);
            if (!mesh.leaf.empty()) mesh.leaf.push_back(mesh.leaf[i]);
        }
    return middles.size();
}

}  // namespace whittle
