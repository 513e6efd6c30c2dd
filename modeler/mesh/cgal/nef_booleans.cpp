// Source: Hachenberger, Kettner, Mehlhorn, Boolean operations on 3D selective Nef complexes (2007); CGAL 5.5 manual. Nef polyhedra hold every set of points that
// half-spaces make, so nothing is declined; the price is time and memory.
#include "modeler/mesh/cgal/nef_booleans.h"

#include "modeler/mesh/cgal/cgal_surface.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <array>
#include <map>

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Point>;

Point exact(const Vec3& p) { return {p.x, p.y, p.z}; }

bool nef_of(const Mesh& mesh, Nef& nef) {
    Surface s;
    if (!surface_of(mesh, s) || !CGAL::is_closed(s)) return false;
    nef = Nef(s);
    return true;
}

Nef combined(SetOp op, const Nef& a, const Nef& b) {
    if (op == SetOp::kUnion) return (a + b).regularization();
    if (op == SetOp::kIntersection) return (a * b).regularization();
    return (a - b).regularization();
}

// A plane whichever way it looks: its coefficients over the first that is not 0.
using PlaneKey = std::array<Number, 4>;
PlaneKey key_of(const Kernel::Plane_3& p) {
    const PlaneKey c{p.a(), p.b(), p.c(), p.d()};
    const Number first = c[0] != 0 ? c[0] : c[1] != 0 ? c[1] : c[2];
    return {c[0] / first, c[1] / first, c[2] / first, c[3] / first};
}

// Nef polyhedra forget whose a facet was: the planes remember.
class LeafFinder {
public:
    explicit LeafFinder(const std::vector<Mesh>& operands) {
        for (const Mesh& mesh : operands)
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
                const Triangle& t = mesh.triangles[i];
                const Kernel::Triangle_3 facet(exact(mesh.points[t[0]]), exact(mesh.points[t[1]]), exact(mesh.points[t[2]]));
                if (!facet.is_degenerate()) facets_[key_of(facet.supporting_plane())].push_back({facet, mesh.leaf[i]});
            }
    }

    std::uint32_t leaf_of(const Kernel::Triangle_3& part) const {
        const auto found = facets_.find(key_of(part.supporting_plane()));
        if (found == facets_.end()) return 0;
        const Point middle = CGAL::centroid(part);
        for (const Facet& f : found->second)
            if (f.triangle.has_on(middle)) return f.leaf;
        return found->second.front().leaf;
    }

private:
    struct Facet {
        Kernel::Triangle_3 triangle;
        std::uint32_t leaf;
    };
    std::map<PlaneKey, std::vector<Facet>> facets_;
};

void mesh_of(const Nef& nef, const LeafFinder& leaves, Mesh& out) {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    CGAL::convert_nef_polyhedron_to_polygon_soup(nef, points, polygons, true);
    for (const Point& p : points) out.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    for (const auto& p : polygons) {
        const Kernel::Triangle_3 part(points[p[0]], points[p[1]], points[p[2]]);
        out.triangles.push_back({static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]), static_cast<std::uint32_t>(p[2])});
        out.leaf.push_back(leaves.leaf_of(part));
    }
}

}  // namespace

bool nef_booleans(const std::vector<Mesh>& operands, const std::vector<BooleanStep>& steps, Mesh& out, std::string& fault) {
    std::vector<Nef> stack;
    for (const BooleanStep& step : steps) {
        if (step.operand != BooleanStep::kOperation) {
            if (nef_of(operands[step.operand], stack.emplace_back())) continue;
            fault = "a solid is not a closed manifold";
            return false;
        }
        const Nef b = std::move(stack.back());
        stack.pop_back();
        stack.back() = combined(step.op, stack.back(), b);
    }
    mesh_of(stack.back(), LeafFinder(operands), out);
    return true;
}

}  // namespace whittle
