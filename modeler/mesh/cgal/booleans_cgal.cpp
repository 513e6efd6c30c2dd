// booleans_cgal.cpp — the one translation unit of CGAL's corefinement; what that declines goes to nef_booleans.h.
//
// Source: Loriot, Rouxel-Labbé, Tournois, Yaz, Polygon Mesh Processing (CGAL 5.5 manual).
#include "modeler/mesh/cgal/cgal_surface.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include "modeler/mesh/cgal/booleans_module.h"
#include "modeler/mesh/cgal/nef_booleans.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;
namespace pmp = CGAL::Polygon_mesh_processing;

auto known_leaves(const Surface& s) { return s.property_map<Face, std::uint32_t>(kLeafOfFace).first; }

// Faces keep their leaf through cuts and copies.
struct LeafVisitor : pmp::Corefinement::Default_visitor<Surface> {
    std::uint32_t leaf = 0;
    void before_subface_creations(Face f, const Surface& s) { leaf = known_leaves(s)[f]; }
    void after_subface_created(Face f, Surface& s) { leaves_of(s)[f] = leaf; }
    void after_face_copy(Face from, const Surface& source, Face to, Surface& target) { leaves_of(target)[to] = known_leaves(source)[from]; }
};

bool combined(SetOp op, Surface& a, Surface& b, Surface& out) {
    leaves_of(out);
    const auto how = CGAL::parameters::visitor(LeafVisitor{}).throw_on_self_intersection(true);
    const auto other = CGAL::parameters::throw_on_self_intersection(true);
    if (op == SetOp::kUnion) return pmp::corefine_and_compute_union(a, b, out, how, other);
    if (op == SetOp::kIntersection) return pmp::corefine_and_compute_intersection(a, b, out, how, other);
    return pmp::corefine_and_compute_difference(a, b, out, how, other);
}

bool carried_out(const std::vector<Mesh>& operands, const std::vector<BooleanStep>& steps, Mesh& out, std::string& fault) {
    std::vector<Surface> stack;
    for (const BooleanStep& step : steps) {
        if (step.operand != BooleanStep::kOperation) {
            if (Surface& s = stack.emplace_back(); !surface_of(operands[step.operand], s) || !CGAL::is_closed(s)) {
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

}  // namespace
}  // namespace whittle

extern "C" __attribute__((visibility("default"))) bool whittle_cgal_booleans_1(const std::vector<whittle::Mesh>& operands,
                                                                               const std::vector<whittle::BooleanStep>& steps, whittle::Mesh& out,
                                                                               std::string& fault) {
    return whittle::guarded(fault, [&] { return whittle::carried_out(operands, steps, out, fault); });
}
