// booleans_cgal.cpp — the one translation unit of CGAL's corefinement; what that declines goes to nef_booleans.h.
//
// CGAL's own checks stay on here whatever the build: where one of them fails, a fault is told instead of a crash.
// Source: Loriot, Rouxel-Labbé, Tournois, Yaz, Polygon Mesh Processing (CGAL 5.5 manual).
#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <exception>

#include "modeler/mesh/cgal/booleans_module.h"
#include "modeler/mesh/cgal/nef_booleans.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;
namespace pmp = CGAL::Polygon_mesh_processing;

constexpr const char* kLeaf = "f:leaf";

Surface::Property_map<Face, std::uint32_t> leaves_of(Surface& s) { return s.add_property_map<Face, std::uint32_t>(kLeaf, 0).first; }
std::uint32_t leaf_of(const Surface& s, Face f) { return s.property_map<Face, std::uint32_t>(kLeaf).first[f]; }

// Faces keep their leaf through cuts and copies.
struct LeafVisitor : pmp::Corefinement::Default_visitor<Surface> {
    std::uint32_t leaf = 0;
    void before_subface_creations(Face f, const Surface& s) { leaf = leaf_of(s, f); }
    void after_subface_created(Face f, Surface& s) { leaves_of(s)[f] = leaf; }
    void after_face_copy(Face from, const Surface& source, Face to, Surface& target) { leaves_of(target)[to] = leaf_of(source, from); }
};

bool surface_of(const Mesh& mesh, Surface& s) {
    auto leaves = leaves_of(s);
    for (const Vec3& p : mesh.points) s.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        using Vertex = Surface::Vertex_index;
        const Face f = s.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
        if (f == Surface::null_face()) return false;
        leaves[f] = mesh.leaf[i];
    }
    return CGAL::is_closed(s);
}

bool combined(SetOp op, Surface& a, Surface& b, Surface& out) {
    leaves_of(out);
    const auto how = CGAL::parameters::visitor(LeafVisitor{}).throw_on_self_intersection(true);
    const auto other = CGAL::parameters::throw_on_self_intersection(true);
    if (op == SetOp::kUnion) return pmp::corefine_and_compute_union(a, b, out, how, other);
    if (op == SetOp::kIntersection) return pmp::corefine_and_compute_intersection(a, b, out, how, other);
    return pmp::corefine_and_compute_difference(a, b, out, how, other);
}

void mesh_of(Surface& s, Mesh& out) {
    s.collect_garbage();
    for (const auto v : s.vertices()) {
        const auto& p = s.point(v);
        out.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    for (const Face f : s.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : CGAL::vertices_around_face(s.halfedge(f), s))
            if (k < 3) t[k++] = static_cast<std::uint32_t>(v);
        out.triangles.push_back(t);
        out.leaf.push_back(leaf_of(s, f));
    }
}

bool carried_out(const std::vector<Mesh>& operands, const std::vector<BooleanStep>& steps, Mesh& out, std::string& fault) {
    std::vector<Surface> stack;
    for (const BooleanStep& step : steps) {
        if (step.operand != BooleanStep::kOperation) {
            if (!surface_of(operands[step.operand], stack.emplace_back())) {
                fault = "a solid is not a closed manifold";
                return false;
            }
            continue;
        }
        Surface result, b = std::move(stack.back());
        stack.pop_back();
        // Solids that touch along an edge or in a point have no manifold to show.
        if (!combined(step.op, stack.back(), b, result)) return nef_booleans(operands, steps, out, fault);
        stack.back() = std::move(result);
    }
    mesh_of(stack.back(), out);
    return true;
}

void stay_silent(const char*, const char*, const char*, int, const char*) {}

}  // namespace
}  // namespace whittle

extern "C" __attribute__((visibility("default"))) bool whittle_cgal_booleans_1(const std::vector<whittle::Mesh>& operands,
                                                                               const std::vector<whittle::BooleanStep>& steps, whittle::Mesh& out,
                                                                               std::string& fault) {
    try {
        CGAL::set_error_handler(whittle::stay_silent);
        CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
        return whittle::carried_out(operands, steps, out, fault);
    } catch (const std::exception& e) {
        fault = e.what();
        return false;
    }
}
