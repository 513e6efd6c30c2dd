#include "modeler/arrange/patches.h"

#include <map>

namespace whittle {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// What does not depend on the place: one facet of a mesh.
struct FlatFacet {
    FacetTag tag = 0;
    std::vector<Corners> triangles;
    std::vector<std::array<std::uint32_t, 2>> borders;
    std::vector<std::uint32_t> polygon;  // empty: not convex, or with holes
};
struct FlatMesh {
    std::vector<FlatFacet> facets;
    bool has_flat_triangles = false;
};

ExactPlane plane_of(const GridMesh& mesh, const Corners& t) { return plane_through(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]); }

// Directed edges that no triangle of the facet runs back along.
std::vector<std::array<std::uint32_t, 2>> borders_of(const std::vector<Corners>& triangles) {
    std::vector<std::array<std::uint32_t, 3>> edges;  // smaller, larger, direction
    for (const Corners& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1U : 0U});
        }
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<std::uint32_t, 2>> out;
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        int balance = 0;
        for (j = i; j < edges.size() && edges[j][0] == edges[i][0] && edges[j][1] == edges[i][1]; ++j) balance += edges[j][2] != 0 ? 1 : -1;
        for (; balance > 0; --balance) out.push_back({edges[i][0], edges[i][1]});
        for (; balance < 0; ++balance) out.push_back({edges[i][1], edges[i][0]});
    }
    return out;
}

// The border as one loop where it turns left all the way round; else nothing.
std::vector<std::uint32_t> convex_loop(const GridMesh& mesh, const FlatFacet& facet) {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [a, b] : facet.borders)
        if (!next.emplace(a, b).second) return {};
    std::vector<std::uint32_t> loop{facet.borders.front()[0]};
    for (std::uint32_t at = next[loop.front()]; at != loop.front() && loop.size() <= facet.borders.size(); at = next[at]) loop.push_back(at);
    if (loop.size() != facet.borders.size() || facet.triangles.size() + 2 != loop.size()) return {};
    const ExactPlane plane = plane_of(mesh, facet.triangles.front());
    const int axis = plane.largest_axis(), sign = plane.nd[static_cast<std::size_t>(axis)] > 0 ? 1 : -1;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto corner = [&](std::size_t k) -> const GridPoint& { return mesh.points[loop[(i + k) % loop.size()]]; };
        if (turn_of(corner(0), corner(1), corner(2), axis) * sign < 0) return {};
    }
    return loop;
}

FlatMesh flat_mesh(const GridMesh& mesh) {
    FlatMesh out;
    std::map<FacetTag, std::size_t> by_tag;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!plane_of(mesh, mesh.triangles[i]).valid()) {
            out.has_flat_triangles = true;
            continue;
        }
        const auto [at, fresh] = by_tag.try_emplace(mesh.tags[i], out.facets.size());
        if (fresh) out.facets.emplace_back().tag = mesh.tags[i];
        out.facets[at->second].triangles.push_back(mesh.triangles[i]);
    }
    for (FlatFacet& f : out.facets) {
        f.borders = borders_of(f.triangles);
        if (f.triangles.size() == 1) {
            f.polygon.assign(f.triangles[0].begin(), f.triangles[0].end());
        } else if (!f.borders.empty()) {
            f.polygon = convex_loop(mesh, f);
        }
    }
    return out;
}

class Collector {
public:
    explicit Collector(Patches& out) : out_(out) {}

    void add(const Operand& operand, std::uint32_t index, const FlatMesh& flat) {
        ids_.clear();
        for (const GridPoint& p : operand.mesh->points)
            ids_.push_back(out_.points.add({p[0] + operand.offset[0], p[1] + operand.offset[1], p[2] + operand.offset[2]}));
        const bool against_all = operand.may_cross_itself || flat.has_flat_triangles;
        for (const FlatFacet& f : flat.facets) add(f, operand, index, against_all ? BoxTree::kMixed : index);
    }

private:
    void add(const FlatFacet& flat, const Operand& operand, std::uint32_t index, std::uint32_t owner) {
        Facet facet;
        facet.operand = index;
        facet.tag = flat.tag + operand.tag_base;
        const auto count = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
        facet.first_patch = count(out_.patches);
        facet.first_border = count(out_.borders);
        facet.first_triangle = count(out_.triangles);
        facet.border_count = count(flat.borders);
        facet.triangle_count = count(flat.triangles);
        const auto number = count(out_.facets);
        if (!flat.polygon.empty()) {
            add_patch(flat.polygon, plane_of_points(flat.triangles.front()), number, owner);
        } else {
            for (const Corners& t : flat.triangles) add_patch({t.begin(), t.end()}, plane_of_points(t), number, owner);
        }
        facet.patch_count = count(out_.patches) - facet.first_patch;
        for (const auto& [a, b] : flat.borders) out_.borders.push_back({ids_[a], ids_[b]});
        for (const Corners& t : flat.triangles) out_.triangles.push_back({ids_[t[0]], ids_[t[1]], ids_[t[2]]});
        out_.facets.push_back(facet);
    }

    ExactPlane plane_of_points(const Corners& t) const {
        return plane_through(out_.points.grid(ids_[t[0]]), out_.points.grid(ids_[t[1]]), out_.points.grid(ids_[t[2]]));
    }

    void add_patch(const std::vector<std::uint32_t>& corners, const ExactPlane& plane, std::uint32_t facet, std::uint32_t owner) {
        Patch patch;
        patch.facet = facet;
        patch.first_corner = static_cast<std::uint32_t>(out_.corners.size());
        patch.corner_count = static_cast<std::uint32_t>(corners.size());
        patch.plane = plane;
        DoubleBox box = DoubleBox::at(out_.points.near(ids_[corners[0]]));
        for (const std::uint32_t c : corners) {
            out_.corners.push_back(ids_[c]);
            box.include(out_.points.near(ids_[c]));
        }
        out_.patches.push_back(patch);
        out_.boxes.push_back(box);
        out_.owner.push_back(owner);
    }

    Patches& out_;
    std::vector<PointId> ids_;
};

}  // namespace

Patches patches_of(std::span<const Operand> operands) {
    Patches out;
    Collector collector(out);
    std::map<const GridMesh*, std::uint32_t> uses_left;
    for (const Operand& o : operands) ++uses_left[o.mesh];
    std::map<const GridMesh*, FlatMesh> flat;
    for (std::uint32_t i = 0; i < operands.size(); ++i) {
        const auto [at, fresh] = flat.try_emplace(operands[i].mesh);
        if (fresh) at->second = flat_mesh(*operands[i].mesh);
        collector.add(operands[i], i, at->second);
        if (--uses_left[operands[i].mesh] == 0) flat.erase(at);
    }
    return out;
}

}  // namespace whittle
