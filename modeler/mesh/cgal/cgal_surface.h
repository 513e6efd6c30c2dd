// cgal_surface.h — what the parts that use CGAL's Surface_mesh share: a mesh copied in and out with its leaves, and the entry that lets no exception out.
//
// Include it before any header of CGAL: their own checks stay on whatever the build, so that a fault is told instead of crashing.
#pragma once

#undef NDEBUG
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>

#include <exception>
#include <string>

#include "modeler/mesh/mesh.h"

namespace whittle {

template <class Surface>
using LeafMap = typename Surface::template Property_map<typename Surface::Face_index, std::uint32_t>;

constexpr const char* kLeafOfFace = "f:leaf";

// The leaf of every face, 0 where none was set.
template <class Surface>
LeafMap<Surface> leaves_of(Surface& s) {
    return s.template add_property_map<typename Surface::Face_index, std::uint32_t>(kLeafOfFace, 0).first;
}

// False where a facet does not fit on the others: no oriented manifold.
template <class Surface>
bool surface_of(const Mesh& mesh, Surface& s) {
    using Vertex = typename Surface::Vertex_index;
    auto leaves = leaves_of(s);
    for (const Vec3& p : mesh.points) s.add_vertex(typename Surface::Point(p.x, p.y, p.z));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const auto f = s.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
        if (f == Surface::null_face()) return false;
        leaves[f] = mesh.leaf[i];
    }
    return true;
}

// Coordinates rounded to double.
template <class Surface>
void mesh_of(Surface& s, Mesh& out) {
    s.collect_garbage();
    const auto leaves = leaves_of(s);
    for (const auto v : s.vertices()) {
        const auto& p = s.point(v);
        out.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    for (const auto f : s.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : CGAL::vertices_around_face(s.halfedge(f), s))
            if (k < 3) t[k++] = static_cast<std::uint32_t>(v);
        out.triangles.push_back(t);
        out.leaf.push_back(leaves[f]);
    }
}

// What `work` answers; false, and what is wrong, where CGAL throws. CGAL neither prints nor aborts meanwhile.
template <class Work>
bool guarded(std::string& fault, const Work& work) {
    try {
        CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
        CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
        return work();
    } catch (const std::exception& e) {
        fault = e.what();
        return false;
    }
}

}  // namespace whittle
