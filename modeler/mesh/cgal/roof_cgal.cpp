// roof_cgal.cpp — the one translation unit of CGAL's straight skeletons: roofs of 45 degrees over floors that are not convex.
//
// Source: Aichholzer, Aurenhammer, Alberts, Gärtner, A novel type of skeleton for polygons (1995).
#include <exception>
#include <memory>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include "modeler/mesh/cgal/roof_module.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Region = CGAL::Polygon_with_holes_2<Kernel>;

Polygon polygon_of(const std::vector<Vec2>& ring) {
    Polygon out;
    for (const Vec2& p : ring) out.push_back({p.x, p.y});
    return out;
}

// Each outer ring with the holes in it.
std::vector<Region> regions_of(const std::vector<std::vector<Vec2>>& floor) {
    std::vector<Polygon> outer, holes;
    for (const auto& ring : floor) {
        Polygon polygon = polygon_of(ring);
        (polygon.is_counterclockwise_oriented() ? outer : holes).push_back(std::move(polygon));
    }
    std::vector<Region> out(outer.begin(), outer.end());
    for (const Polygon& hole : holes) {
        Region* smallest = nullptr;
        for (Region& region : out) {
            const bool holds = region.outer_boundary().bounded_side(hole[0]) != CGAL::ON_UNBOUNDED_SIDE;
            if (holds && (!smallest || region.outer_boundary().area() < smallest->outer_boundary().area())) smallest = &region;
        }
        if (smallest) smallest->add_hole(hole);
    }
    return out;
}

bool add_roof(const Region& region, FacetList& out) {
    const auto skeleton = CGAL::create_interior_straight_skeleton_2(region);
    if (!skeleton) return false;
    for (auto face = skeleton->faces_begin(); face != skeleton->faces_end(); ++face) {
        auto& facet = out.facets.emplace_back();
        const auto first = face->halfedge();
        auto at = first;
        do {
            const auto& vertex = *at->vertex();
            facet.push_back(static_cast<std::uint32_t>(out.points.size()));
            out.points.emplace_back(CGAL::to_double(vertex.point().x()), CGAL::to_double(vertex.point().y()), vertex.is_contour() ? 0 : CGAL::to_double(vertex.time()));
            at = at->next();
        } while (at != first);
    }
    return true;
}

}  // namespace
}  // namespace whittle

extern "C" bool whittle_cgal_roof(const std::vector<std::vector<whittle::Vec2>>& floor, whittle::FacetList& out, std::string& fault) {
    try {
        for (const auto& region : whittle::regions_of(floor))
            if (!whittle::add_roof(region, out)) {
                fault = "the straight skeleton of the floor cannot be made";
                return false;
            }
        return true;
    } catch (const std::exception& e) {
        fault = e.what();
        return false;
    }
}
