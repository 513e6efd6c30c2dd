// test_against_cgal.cpp — the exported booleans against CGAL's: corefinement of the operands' own meshes over exact constructions.
//
// Our arrangement and CGAL share no code, so what both say of volume and area is worth more than what either says of itself.
#include <random>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include "tests/modeler/mesh/solids.h"

using namespace whittle;
using namespace whittle::test;
using Catch::Matchers::WithinRel;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

// A coarse one is enough: facets are compared with facets.
MeshOptions coarse() {
    MeshOptions options;
    options.tolerance_mm = 0.05;
    return options;
}

Surface surface_of(const Mesh& mesh) {
    Surface s;
    for (const Vec3& p : mesh.points) s.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
    for (const auto& t : mesh.triangles) {
        using Vertex = Surface::Vertex_index;
        REQUIRE(s.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) != Surface::null_face());
    }
    return s;
}

struct Random {
    std::mt19937_64 engine;
    double between(double a, double b) { return a + (b - a) * (static_cast<double>(engine() >> 11) * 0x1p-53); }
};

NodeId random_part(SolidBuilder& b, Random& random) {
    switch (random.engine() % 4) {
        case 0: return b.shape(shape::Box{Vec3(-random.between(2, 6), -random.between(2, 6), -random.between(2, 6)), Vec3(random.between(2, 6))});
        case 1: return b.shape(shape::Ellipsoid{Vec3(random.between(3, 7))});
        case 2: return b.shape(shape::Frustum{-random.between(2, 8), random.between(2, 8), random.between(2, 5), random.between(1, 5)});
        default: return b.shape(shape::Ellipsoid{Vec3(random.between(3, 7), random.between(3, 7), random.between(3, 7))});
    }
}

// A turn about a random axis through quarter-free angles, and a move.
Placement random_placement(Random& random) {
    const double a = random.between(0, 6.28), c = random.between(0, 6.28);
    const double ca = std::cos(a), sa = std::sin(a), cc = std::cos(c), sc = std::sin(c);
    return {{cc, -sc * ca, sc * sa, random.between(-4, 4), sc, cc * ca, -cc * sa, random.between(-4, 4), 0, sa, ca, random.between(-4, 4)}};
}

Surface combined_by_cgal(SetOp op, Surface a, Surface b) {
    Surface out;
    bool made = false;
    if (op == SetOp::kUnion) made = pmp::corefine_and_compute_union(a, b, out);
    if (op == SetOp::kIntersection) made = pmp::corefine_and_compute_intersection(a, b, out);
    if (op == SetOp::kDifference) made = pmp::corefine_and_compute_difference(a, b, out);
    REQUIRE(made);
    return out;
}

// Rounding to the grid moves corners by 1e-8 of the size or less, whatever is combined with what.
void compare(SetOp op, const Placement& turn, const NodeId first, const NodeId second, SolidBuilder b) {
    const Use moved = placed(second, turn);
    const NodeId whole = b.combine(op, {at(first), moved});
    const Solid solid = b.finish(at(whole));
    const auto mesh = [&](const Use& use) {
        MeshControl control;
        auto made = mesh_use(solid, use, coarse(), control);
        REQUIRE(made);
        return std::move(made->mesh);
    };
    const Mesh ours = mesh(at(whole));
    const Surface theirs = combined_by_cgal(op, surface_of(mesh(at(first))), surface_of(mesh(moved)));
    const auto facts = mass_properties(ours);
    const double volume = CGAL::to_double(pmp::volume(theirs)), area = CGAL::to_double(pmp::area(theirs));
    INFO("volume " << facts.volume << " " << volume << " area " << facts.area << " " << area);
    CHECK(std::abs(facts.volume - volume) <= 1e-6 * (1 + volume));
    CHECK(std::abs(facts.area - area) <= 1e-5 * (1 + area));
}

}  // namespace

TEST_CASE("unions, intersections and differences have the volume and area that CGAL gives them") {
    Random random{std::mt19937_64(20261122)};
    for (int i = 0; i < 12; ++i)
        for (const SetOp op : {SetOp::kUnion, SetOp::kIntersection, SetOp::kDifference}) {
            SolidBuilder b;
            const NodeId first = random_part(b, random), second = random_part(b, random);
            const Placement turn = random_placement(random);
            INFO("pair " << i << ", operation " << static_cast<int>(op));
            compare(op, turn, first, second, std::move(b));
        }
}

TEST_CASE("flush faces are what CGAL makes of them") {
    for (const SetOp op : {SetOp::kUnion, SetOp::kIntersection, SetOp::kDifference}) {
        SolidBuilder b;
        const NodeId plate = b.shape(shape::Box{Vec3(0), {30, 20, 5}}), drill = b.shape(shape::Frustum{0, 5, 3, 3});
        compare(op, Placement::translation({10, 10, 0}), plate, drill, std::move(b));
        SolidBuilder d;
        const NodeId cube = d.shape(shape::Box{Vec3(0), Vec3(10)});
        compare(op, Placement::translation({5, 5, 0}), cube, cube, std::move(d));
    }
}
