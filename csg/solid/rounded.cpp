#include "csg/solid/rounded.h"

#include <cmath>
#include <map>
#include <set>

#include "csg/solid/polyhedron.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// Sine of the angle between facets that are one face but for the rounding of their corners.
constexpr double kFlat = 0x1p-24;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Vec3 area_of(const FacetList& list, const std::vector<std::uint32_t>& f) {
    Vec3 out(0);
    for (std::size_t i = 1; i + 1 < f.size(); ++i) out += glm::cross(list.points[f[i]] - list.points[f[0]], list.points[f[i + 1]] - list.points[f[0]]);
    return out;
}

class Rounding {
public:
    Rounding(const FacetList& list, double r) : list_(list), r_(r) {
        for (std::size_t i = 0; i < list.facets.size(); ++i) {
            areas_.push_back(area_of(list, list.facets[i]));
            face_.push_back(i);
            const auto& f = list.facets[i];
            for (std::size_t k = 0; k < f.size(); ++k) edges_[{f[k], f[(k + 1) % f.size()]}].push_back(i);
        }
        for (const auto& [edge, facets] : edges_) visit(edge, facets);
    }

    std::size_t features() const { return list_.facets.size() + ridges_.size() + corners_.size(); }

    std::vector<Use> parts(SolidBuilder& builder) {
        std::vector<Use> out{use_of(builder.shape(shape::Polyhedron{std::make_shared<const FacetList>(list_)}))};
        std::map<std::size_t, std::vector<std::size_t>> faces;
        for (std::size_t i = 0; i < list_.facets.size(); ++i)
            if (glm::length(areas_[i]) > 0) faces[root(i)].push_back(i);
        for (const auto& [_, facets] : faces) out.push_back(use_of(builder.shape(shape::Polyhedron{std::make_shared<const FacetList>(slab(facets))})));
        for (const auto& [a, b] : ridges_) out.push_back(use_of(builder.shape(shape::Capsule{list_.points[a], list_.points[b], r_})));
        const NodeId ball = builder.shape(shape::Ellipsoid{Vec3(r_)});
        for (const std::uint32_t i : corners_) out.push_back(use_of(ball, Placement::translation(list_.points[i])));
        return out;
    }

private:
    const FacetList& list_;
    double r_;
    std::vector<Vec3> areas_;         // twice the facets' areas, along their normals
    std::vector<std::size_t> face_;   // facets joined along flat edges
    std::map<Edge, std::vector<std::size_t>> edges_;
    std::set<Edge> ridges_;
    std::set<std::uint32_t> corners_;  // ends of ridges

    std::size_t root(std::size_t i) {
        while (face_[i] != i) i = face_[i] = face_[face_[i]];
        return i;
    }

    void visit(const Edge& edge, const std::vector<std::size_t>& facets) {
        if (edge.first > edge.second) return;
        const auto others = edges_.find({edge.second, edge.first});
        const bool plain = facets.size() == 1 && others != edges_.end() && others->second.size() == 1;
        if (plain) {
            const Vec3 &n = areas_[facets[0]], &m = areas_[others->second[0]];
            const double scale = glm::length(n) * glm::length(m), length = glm::distance(list_.points[edge.first], list_.points[edge.second]);
            // Sine of the turn about the edge: positive where it sticks out.
            const double turn = glm::dot(glm::cross(n, m), list_.points[edge.second] - list_.points[edge.first]) / length;
            if (!(scale > 0) || (std::fabs(turn) <= kFlat * scale && glm::dot(n, m) > 0)) {
                face_[root(facets[0])] = root(others->second[0]);
                return;
            }
            if (turn < 0) return;
        }
        ridges_.insert(edge);
        corners_.insert(edge.first);
        corners_.insert(edge.second);
    }

    // A face moved by r along its normal to both sides.
    FacetList slab(const std::vector<std::size_t>& facets) const {
        FacetList out;
        Vec3 normal(0);
        for (const std::size_t i : facets) normal += areas_[i];
        normal *= r_ / glm::length(normal);
        std::map<std::uint32_t, std::uint32_t> below;  // the same corner above is the next
        const auto corner = [&](std::uint32_t i) {
            const auto [at, is_new] = below.try_emplace(i, static_cast<std::uint32_t>(out.points.size()));
            if (is_new) {
                out.points.push_back(list_.points[i] - normal);
                out.points.push_back(list_.points[i] + normal);
            }
            return at->second;
        };
        std::set<Edge> border;
        for (const std::size_t i : facets) {
            const auto& f = list_.facets[i];
            std::vector<std::uint32_t> top, bottom;
            for (std::size_t k = 0; k < f.size(); ++k) {
                top.push_back(corner(f[k]) + 1);
                bottom.insert(bottom.begin(), corner(f[k]));
                if (const Edge back{f[(k + 1) % f.size()], f[k]}; border.erase(back) == 0) border.insert({f[k], f[(k + 1) % f.size()]});
            }
            out.facets.push_back(std::move(top));
            out.facets.push_back(std::move(bottom));
        }
        for (const auto& [a, b] : border) out.facets.push_back({corner(a), corner(b), corner(b) + 1, corner(a) + 1});
        return with_flat_facets(out);
    }
};

}  // namespace

std::optional<Use> rounded_by_ball(SolidBuilder& builder, const FacetList& list, const Vec3& centre, double r, std::size_t most) {
    const FacetList tidy = welded(list);
    if (tidy.facets.empty() || open_edges(tidy) > 0) return std::nullopt;
    Rounding rounding(tidy, r);
    if (rounding.features() > most) return std::nullopt;
    Use sum = use_of(builder.combine(SetOp::kUnion, rounding.parts(builder)));
    sum.placement = Placement::translation(centre);
    return sum;
}

}  // namespace whittle
