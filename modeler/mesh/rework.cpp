#include "modeler/mesh/rework.h"

#include <fmt/format.h>

#include "csg/base/module_file.h"
#include "modeler/arrange/crossings.h"
#include "modeler/mesh/cgal/remesh_module.h"
#include "modeler/mesh/deviation.h"
#include "modeler/mesh/mesh_queries.h"
#include "modeler/mesh/openmesh/simplify_module.h"
#include "modeler/mesh/own_points.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

// Facets of a curve turn by less, edges of a part by more.
constexpr double kSharpDeg = 30;
// Halvings of what the decimation is asked for until its result keeps the promise.
constexpr int kTries = 6;
constexpr double kMostTriangles = 2e7;

bool alike(const MeshLeaf& a, const MeshLeaf& b) { return a.part == b.part && a.shown() == b.shown(); }

// For every triangle the first leaf of its colour and part.
std::vector<std::uint32_t> groups_of(const MeshResult& in) {
    std::vector<std::uint32_t> of_leaf;
    for (std::uint32_t i = 0; i < in.leaves.size(); ++i) {
        std::uint32_t first = 0;
        while (!alike(in.leaves[first], in.leaves[i])) ++first;
        of_leaf.push_back(first);
    }
    std::vector<std::uint32_t> out;
    for (const std::uint32_t leaf : in.mesh.leaf) out.push_back(of_leaf[leaf]);
    return out;
}

// Welded, without what is flat; nothing where it is not as valid as a mesh has to be.
std::optional<MeshReport> settled(Mesh& mesh) {
    weld(mesh);
    remove_flat_triangles(mesh);
    MeshReport report = report_mesh(mesh);
    if (mesh.triangles.empty() || !report.valid()) return std::nullopt;
    report.self_intersections = count_crossings(mesh.points, mesh.triangles);
    if (*report.self_intersections > 0) return std::nullopt;
    return report;
}

Reworked with_mesh(const MeshResult& in, Mesh mesh, const MeshReport& report, double deviation) {
    Reworked out{in, deviation, true};
    out.result.mesh = std::move(mesh);
    out.result.report = report;
    out.result.tolerance_mm += deviation;
    return out;
}

// The least of a few distances that holds for every point of both.
Result<Reworked> as_near_as_it_is(const MeshResult& in, Mesh mesh, const MeshReport& report, double edge_mm) {
    constexpr double kFirst = 0x1p-10;
    for (double most = kFirst * edge_mm; most <= edge_mm; most *= 4)
        if (const auto deviation = hausdorff_within(in.mesh, mesh, most)) return with_mesh(in, std::move(mesh), report, *deviation);
    return fail(Fault::kScene, "triangles of that size would stray from the surface by more than their sides");
}

}  // namespace

Result<Reworked> simplified(const MeshResult& in, double most_mm, MeshControl& control) {
    const auto entry = module_entry("whittle_openmesh.so", "whittle_openmesh_simplify_2", "the part that simplifies meshes");
    if (!entry) return tl::unexpected(entry.error());
    const Mesh apart = with_own_points(in.mesh);
    const auto groups = groups_of(in);
    // Between the middles that are tested a facet may stray a little farther.
    constexpr double kMargin = 0.75;
    const Nearness surface(in.mesh);
    double asked = most_mm;
    for (int i = 0; i < kTries; ++i, asked /= 2) {
        if (control.cancelled()) return fail(Fault::kInterrupted, "interrupted");
        Mesh mesh;
        std::string fault;
        const std::function<bool(const Vec3&)> is_near = [&](const Vec3& p) { return surface.within(p, kMargin * asked); };
        if (!reinterpret_cast<decltype(&whittle_openmesh_simplify_2)>(*entry)(apart, groups, asked, is_near, mesh, fault)) return fail(Fault::kScene, "OpenMesh: " + fault);
        const auto report = settled(mesh);
        if (!report) continue;
        if (const auto deviation = hausdorff_within(in.mesh, mesh, most_mm)) return with_mesh(in, std::move(mesh), *report, *deviation);
    }
    return Reworked{in, 0, false};
}

Result<Reworked> remeshed(const MeshResult& in, double edge_mm, MeshControl& control) {
    // An equilateral triangle of that side.
    if (mass_properties(in.mesh).area / (0.433 * edge_mm * edge_mm) > kMostTriangles)
        return fail(Fault::kWorld, fmt::format("--remesh={}: more than {:g} triangles of that size", edge_mm, kMostTriangles));
    const auto entry = module_entry("whittle_cgal.so", "whittle_cgal_remesh_1", "the part that remeshes");
    if (!entry) return tl::unexpected(entry.error());
    // Where two curves of one circle meet, slivers lie between their chords that remeshing turns over: then without them.
    for (const double slivers : {0.0, 1.0 / 64, 1.0 / 16}) {
        MeshResult from = in;
        if (slivers > 0) {
            auto slim = simplified(in, slivers * edge_mm, control);
            if (!slim) return slim;
            if (!slim->changed) continue;
            from = std::move(slim->result);
        }
        Mesh mesh, apart = with_own_points(from.mesh);
        apart.leaf = groups_of(from);
        std::string fault;
        if (!reinterpret_cast<decltype(&whittle_cgal_remesh_1)>(*entry)(apart, edge_mm, kSharpDeg, mesh, fault)) return fail(Fault::kScene, "CGAL: " + fault);
        if (control.cancelled()) return fail(Fault::kInterrupted, "interrupted");
        if (const auto report = settled(mesh)) return as_near_as_it_is(in, std::move(mesh), *report, edge_mm);
    }
    return fail(Fault::kScene, "triangles of that size would cross each other");
}

}  // namespace whittle
