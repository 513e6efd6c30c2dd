// remesh_cgal.cpp — the one translation unit of CGAL's remeshing.
//
// Source: Botsch, Kobbelt, A Remeshing Approach to Multiresolution Modeling (2004).
#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <exception>

#include "modeler/mesh/cgal/remesh_module.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;
using Edge = Surface::Edge_index;
namespace pmp = CGAL::Polygon_mesh_processing;

constexpr unsigned kIterations = 3;

bool remeshed(const Mesh& in, double edge_mm, double sharp_deg, Mesh& out, std::string& fault) {
    Surface s;
    auto leaves = s.add_property_map<Face, std::uint32_t>("f:leaf", 0).first;
    for (const Vec3& p : in.points) s.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
    for (std::size_t i = 0; i < in.triangles.size(); ++i) {
        using Vertex = Surface::Vertex_index;
        const Triangle& t = in.triangles[i];
        const Face f = s.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
        if (f == Surface::null_face()) return fault = "the mesh is not a manifold", false;
        leaves[f] = in.leaf[i];
    }
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
    s.collect_garbage();
    for (const auto v : s.vertices()) out.points.emplace_back(s.point(v).x(), s.point(v).y(), s.point(v).z());
    for (const Face f : s.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : CGAL::vertices_around_face(s.halfedge(f), s))
            if (k < 3) t[k++] = static_cast<std::uint32_t>(v);
        out.triangles.push_back(t);
        out.leaf.push_back(leaves[f]);
    }
    return true;
}

void stay_silent(const char*, const char*, const char*, int, const char*) {}

}  // namespace
}  // namespace whittle

extern "C" __attribute__((visibility("default"))) bool whittle_cgal_remesh_1(const whittle::Mesh& in, double edge_mm, double sharp_deg, whittle::Mesh& out,
                                                                             std::string& fault) {
    try {
        CGAL::set_error_handler(whittle::stay_silent);
        CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
        return whittle::remeshed(in, edge_mm, sharp_deg, out, fault);
    } catch (const std::exception& e) {
        fault = e.what();
        return false;
    }
}
