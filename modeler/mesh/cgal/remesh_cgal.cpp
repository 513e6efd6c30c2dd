// remesh_cgal.cpp — the one translation unit of CGAL's remeshing.
//
// Source: Botsch, Kobbelt, A Remeshing Approach to Multiresolution Modeling (2004).
#include "modeler/mesh/cgal/cgal_surface.h"

#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include "modeler/mesh/cgal/remesh_module.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge = Surface::Edge_index;
namespace pmp = CGAL::Polygon_mesh_processing;

using Halfedge = Surface::Halfedge_index;

constexpr unsigned kIterations = 3;

// From a new point on an edge to the corner opposite: what was one face has its leaf on both sides.
void cut_face(Surface& s, LeafMap<Surface>& leaves, Halfedge to_point, Halfedge to_corner) {
    const auto leaf = leaves[s.face(to_point)];
    const Halfedge cut = CGAL::Euler::split_face(to_point, to_corner, s);
    leaves[s.face(cut)] = leaves[s.face(s.opposite(cut))] = leaf;
}

// Into equal parts no longer than `edge_mm`. CGAL's own splitting forgets whose the new faces are.
void divide(Surface& s, LeafMap<Surface>& leaves, Surface::Property_map<Edge, bool>& kept, Edge edge, double edge_mm) {
    const Halfedge h = s.halfedge(edge);
    const auto from = s.point(s.source(h)), to = s.point(s.target(h));
    const int parts = static_cast<int>(std::ceil(std::sqrt(CGAL::squared_distance(from, to)) / edge_mm));
    for (int i = 1; i < parts; ++i) {
        const Halfedge before = CGAL::Euler::split_edge(h, s);  // to the new point, from where h goes on
        s.point(s.target(before)) = from + (to - from) * (static_cast<double>(i) / parts);
        kept[s.edge(before)] = true;
        cut_face(s, leaves, before, s.next(h));
        cut_face(s, leaves, s.opposite(h), s.next(s.opposite(before)));
    }
}

bool remeshed(const Mesh& in, double edge_mm, double sharp_deg, Mesh& out, std::string& fault) {
    Surface s;
    if (!surface_of(in, s)) return fault = "the mesh is not a manifold", false;
    auto leaves = leaves_of(s);
    auto kept = s.add_property_map<Edge, bool>("e:kept", false).first;
    pmp::detect_sharp_edges(s, sharp_deg, kept);
    std::vector<Edge> borders;
    for (const Edge e : s.edges()) {
        const auto h = s.halfedge(e);
        if (leaves[s.face(h)] != leaves[s.face(s.opposite(h))]) kept[e] = true;
        if (kept[e]) borders.push_back(e);
    }
    for (const Edge e : borders) divide(s, leaves, kept, e, edge_mm);
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
