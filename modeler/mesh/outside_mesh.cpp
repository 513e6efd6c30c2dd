#include "modeler/mesh/outside_mesh.h"

#include "csg/base/module_file.h"
#include "csg/solid/ear_clipping.h"
#include "csg/solid/polyhedron.h"
#include "modeler/mesh/cgal/roof_module.h"

namespace whittle {

Result<std::shared_ptr<const FacetList>> facets_by_mesh(const Solid& solid, const Use& use, const MeshOptions& options) {
    MeshControl control;
    const auto made = mesh_use(solid, use, options, control);
    if (!made) return tl::unexpected(made.error());
    auto list = std::make_shared<FacetList>();
    list->points = made->mesh.points;
    for (const Triangle& t : made->mesh.triangles) list->facets.push_back({t[0], t[1], t[2]});
    return list;
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
