#include "modeler/mesh/outside_mesh.h"

#include <algorithm>
#include <cmath>

#include "csg/base/module_file.h"
#include "csg/solid/ear_clipping.h"
#include "csg/solid/facet_operations.h"
#include "csg/solid/polyhedron.h"
#include "modeler/mesh/cgal/roof_module.h"

namespace whittle {

namespace {

FacetList facets_of(const Mesh& mesh) {
    FacetList list;
    list.points = mesh.points;
    for (const Triangle& t : mesh.triangles) list.facets.push_back({t[0], t[1], t[2]});
    return list;
}

// What is at most 1 off a facet is at most so much off it along the plane z = 0; the most over the facets that cross it.
double most_along_plane(const Mesh& mesh) {
    double most = 1;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        if ((a.z > 0) == (b.z > 0) && (b.z > 0) == (c.z > 0)) continue;
        const Vec3 n = glm::cross(b - a, c - a);
        const double flat = std::hypot(n.x, n.y);
        if (flat > 0) most = std::max(most, glm::length(n) / flat);
    }
    return most;
}

}  // namespace

Result<std::shared_ptr<const FacetList>> facets_by_mesh(const Solid& solid, const Use& use, const MeshOptions& options) {
    MeshControl control;
    const auto made = mesh_use(solid, use, options, control);
    if (!made) return tl::unexpected(made.error());
    return std::make_shared<const FacetList>(facets_of(made->mesh));
}

Result<SectionOutline> section_by_mesh(const Solid& solid, const Use& use, const MeshOptions& options) {
    constexpr double kFinest = 1.0 / 16;
    MeshControl control;
    auto made = mesh_use(solid, use, options, control);
    if (!made) return tl::unexpected(made.error());
    if (const double steep = most_along_plane(made->mesh); steep > 1 && made->tolerance_mm > 0) {
        MeshOptions finer = options;
        finer.tolerance_mm = made->tolerance_mm * std::max(1 / steep, kFinest);
        made = mesh_use(solid, use, finer, control);
        if (!made) return tl::unexpected(made.error());
    }
    return SectionOutline{section_of(facets_of(made->mesh)), made->tolerance_mm * most_along_plane(made->mesh)};
}

Result<std::shared_ptr<const FacetList>> roof_by_skeleton(const std::vector<std::vector<Vec2>>& floor) {
    const auto entry = module_entry("whittle_cgal.so", "whittle_cgal_roof", "the part that makes roofs");
    if (!entry) return tl::unexpected(entry.error());
    FacetList list;
    std::string fault;
    if (!reinterpret_cast<decltype(&whittle_cgal_roof)>(*entry)(floor, list, fault)) return fail(Fault::kScene, fault);
    // The floor itself, seen from below.
    std::vector<Vec2> points;
    std::vector<std::vector<std::uint32_t>> rings;
    for (const auto& ring : floor) {
        auto& indices = rings.emplace_back();
        for (const Vec2& p : ring) {
            indices.push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back(p);
        }
    }
    const auto triangles = ear_clipped(points, rings);
    if (!triangles) return fail(Fault::kScene, "the floor of a roof crosses itself");
    const auto first = static_cast<std::uint32_t>(list.points.size());
    for (const Vec2& p : points) list.points.emplace_back(p, 0);
    for (const auto& t : *triangles) list.facets.push_back({first + t[0], first + t[2], first + t[1]});
    list = with_flat_facets(welded(list));
    if (open_edges(list) > 0) return fail(Fault::kScene, "the roof does not close");
    return std::make_shared<const FacetList>(std::move(list));
}

}  // namespace whittle
