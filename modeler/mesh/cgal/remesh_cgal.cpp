// remesh_cgal.cpp — the one translation unit of CGAL's remeshing.
//
// Source: Botsch, Kobbelt, A Remeshing Approach to Multiresolution Modeling (2004).
#include "modeler/mesh/cgal/cgal_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include "modeler/mesh/cgal/remesh_module.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge = Surface::Edge_index;
namespace pmp = CGAL::Polygon_mesh_processing;

constexpr unsigned kIterations = 3;

bool remeshed(const Mesh& in, double edge_mm, double sharp_deg, Mesh& out, std::string& fault) {
    Surface s;
    if (!surface_of(in, s)) return fault = "the mesh is not a manifold", false;
    const auto leaves = leaves_of(s);
    auto kept = s.add_property_map<Edge, bool>("e:kept", false).first;
    pmp::detect_sharp_edges(s, sharp_deg, kept);
    std::vector<Edge> borders;
    for (const Edge e : s.edges()) {
        const auto h = s.halfedge(e);
        if (leaves[s.face(h)] != leaves[s.face(s.opposite(h))]) kept[e] = true;
        if (kept[e]) borders.push_back(e);
    }
    pmp::split_long_edges(borders, edge_mm, s, CGAL::parameters::edge_is_constrained_map(kept));
    pmp::isotropic_remeshing(s.faces(), edge_mm, s,
                             CGAL::parameters::number_of_iterations(kIterations).protect_constraints(true).edge_is_constrained_map(kept).face_patch_map(leaves));
    mesh_of(s, out);
    return true;
}

}  // namespace
}  // namespace whittle

extern "C" __attribute__((visibility("default"))) bool whittle_cgal_remesh_1(const whittle::Mesh& in, double edge_mm, double sharp_deg, whittle::Mesh& out,
                                                                             std::string& fault) {
    return whittle::guarded(fault, [&] { return whittle::remeshed(in, edge_mm, sharp_deg, out, fault); });
}
