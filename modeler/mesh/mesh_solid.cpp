// mesh_solid.cpp — solid → plan of distinct leaves and operations → combined parts → one mesh in double.
#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "modeler/arrange/crossings.h"
#include "modeler/mesh/combine.h"
#include "modeler/mesh/own_points.h"
#include "modeler/mesh/planner.h"
#include "modeler/mesh/settle.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// First tag of each use in a plan, in the plan's order.
void append_tag_starts(const Plan& plan, PlanId id, FacetTag base, std::vector<FacetTag>& starts) {
    const PlanNode& n = plan.node(id);
    if (!n.op) {
        if (n.starts.empty()) starts.push_back(base);
        for (const FacetTag start : n.starts) starts.push_back(base + start);
        return;
    }
    append_tag_starts(plan, n.a.plan, base, starts);
    append_tag_starts(plan, n.b.plan, base + plan.node(n.a.plan).tag_count, starts);
}

// What a leaf's own corners become: the doubles they were made with, or the grid points they stand on.
enum class Corners { kAsMade, kOnGrid };

// A point in millimetres.
Vec3 in_mm(const Vec3& p, const GridPoint& by, const Planner& planner, Corners corners) {
    const Vec3 whole{std::nearbyint(p.x), std::nearbyint(p.y), std::nearbyint(p.z)};
    if (whole == p && corners == Corners::kAsMade)
        if (const Vec3* was = planner.known().find(sum({std::llround(p.x), std::llround(p.y), std::llround(p.z)}, by))) return *was;
    return apply_to_point(planner.frame(), (p + Vec3{by[0], by[1], by[2]}) / planner.grid().per_mm);
}

// The box of a use at time 0.
Bounds bounds_at_start(const Solid& solid, const Use& use) {
    const Bounds& own = solid.bounds(use.node);
    return placed_bounds(use.motion == 0 ? own : placed_bounds(own, solid.motion(use.motion).start), use.placement);
}

// Parts in double, one after the other; tags become leaf uses.
Mesh gathered(const Planner& planner, const Instance& root, const Parts& parts, Corners corners) {
    const Plan& plan = planner.plan();
    std::vector<FacetTag> starts;
    append_tag_starts(plan, root.ref.plan, 0, starts);
    Mesh mesh;
    for (const Part& part : parts) {
        const GridPoint by = sum(part.offset, root.ref.offset);
        const GridMesh& leaf = plan.node(part.leaf).leaf;
        const auto& triangles = part.made ? part.made->triangles : leaf.triangles;
        const auto& tags = part.made ? part.made->tags : leaf.tags;
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        if (part.made) {
            for (const Vec3& p : part.made->points) mesh.points.push_back(in_mm(p, by, planner, corners));
        } else {
            for (const GridPoint& p : leaf.points) mesh.points.push_back(in_mm(Vec3{p[0], p[1], p[2]}, by, planner, corners));
        }
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Triangle& t = triangles[i];
            mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            const FacetTag tag = tags[i] + part.tag_base;
            const auto at = std::upper_bound(starts.begin(), starts.end(), tag) - starts.begin() - 1;
            mesh.leaf.push_back(root.leaves[static_cast<std::size_t>(at)]);
        }
    }
    return mesh;
}

// The mesh in double, with the corners as made where nothing crosses then.
void settle(const Planner& planner, const Instance& root, const Parts& parts, MeshControl& control, MeshResult& result) {
    result.mesh = gathered(planner, root, parts, Corners::kAsMade);
    weld(result.mesh);
    remove_flat_triangles(result.mesh);
    std::uint64_t crossings = count_crossings(result.mesh.points, result.mesh.triangles);
    if (crossings > 0) {
        Settled settled = settled_in_double(gathered(planner, root, parts, Corners::kOnGrid), control);
        if (settled.crossings < crossings) {
            crossings = settled.crossings;
            result.mesh = std::move(settled.mesh);
        }
    }
    if (crossings > 0) result.warnings.push_back(fmt::format("{} pairs of facets cross after rounding to double", crossings));
    result.report = report_mesh(result.mesh);
    if (result.report.shared_edges > 0 && divide_knots(result.mesh) > 0) result.report = report_mesh(result.mesh);
    result.report.self_intersections = crossings;
}

}  // namespace

double chord_tolerance(const MeshOptions& options, double radius, double diagonal) {
    return options.tolerance_mm ? *options.tolerance_mm : std::min(1e-3 * radius, 1e-3 * diagonal);
}

namespace {

struct How {
    BooleanMaker maker;
    const MeshOptions& options;
    MeshControl& control;
};

Result<MeshResult> mesh_by_rule(const How& how, const Solid& solid, const Use& root, const Bounds& room, const CurveRule& rule) {
    MeshResult result;
    auto start = Clock::now();
    const NodeMesher apart = [&](NodeId node, const CurveRule& its) {
        Use alone;
        alone.node = node;
        return mesh_by_rule(how, solid, alone, bounds_at_start(solid, alone), its);
    };
    Planner planner(solid, root, rule, apart, how.control, room, result);
    auto instance = planner.build(root, Path{});
    if (!instance) return tl::unexpected(instance.error());
    result.stats.seconds_tessellate = seconds_since(start);
    result.stats.reused += planner.plan().reused();
    result.stats.skipped_boxes += planner.plan().skipped();
    if (!*instance) return result;

    const CombineOptions combining{how.options.threads, how.options.decimate, how.maker};
    result.stats.loaded_cgal = how.maker == BooleanMaker::kCgal;
    const auto parts = combine_plan(planner.plan(), (*instance)->ref.plan, (*instance)->leaves, combining, how.control, result.stats);
    if (!parts) return tl::unexpected(parts.error());
    start = Clock::now();
    settle(planner, **instance, *parts, how.control, result);
    result.stats.seconds_round = seconds_since(start);
    return result;
}

Result<MeshResult> mesh_use_by(BooleanMaker maker, const Solid& solid, const Use& root, const MeshOptions& options, MeshControl& control) {
    if (root.node == kEmptyNode) return MeshResult{};
    if (solid.is_2d(root.node)) return fail(Fault::kScene, "Current top level object is not a 3D object.");
    const Bounds room = bounds_at_start(solid, root);
    if (room.empty()) return MeshResult{};
    if (!finite(room)) return fail(Fault::kScene, "the solid is unbounded: no operation bounds a halfspace or quadric");
    constexpr double kLargestMm = 1e100;  // squares of lengths stay finite
    if (const double far = std::max(largest_coordinate(room), farthest_leaf(solid, root, Placement{})); far > kLargestMm)
        return fail(Fault::kScene, fmt::format("the solid reaches {:g} mm far, beyond the {:g} that can be meshed", far, kLargestMm));
    CurveRule rule;
    rule.angle_deg = options.angle_deg;
    rule.largest = options.tolerance_mm.value_or(1e-3 * glm::length(room.hi - room.lo));
    if (options.tolerance_mm) rule.share_of_radius = 0;
    return mesh_by_rule({maker, options, control}, solid, root, room, rule);
}

}  // namespace

Result<MeshResult> mesh_use(const Solid& solid, const Use& root, const MeshOptions& options, MeshControl& control) {
    return mesh_use_by(BooleanMaker::kArrangement, solid, root, options, control);
}

Result<MeshResult> mesh_solid(const Solid& solid, const MeshOptions& options, MeshControl& control) {
    return mesh_use(solid, solid.root(), options, control);
}

Result<MeshResult> mesh_solid_by(BooleanMaker maker, const Solid& solid, const MeshOptions& options, MeshControl& control) {
    return mesh_use_by(maker, solid, solid.root(), options, control);
}

}  // namespace whittle
