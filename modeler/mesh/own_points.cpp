// own_points.cpp — see file_text.h.
// Source: Guéziec, Taubin, Lazarus, Horn, Converting Sets of Polygons to Manifold Surfaces by Cutting and Stitching (1998).
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "modeler/mesh/file_text.h"

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
        std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle; });
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

}  // namespace whittle
