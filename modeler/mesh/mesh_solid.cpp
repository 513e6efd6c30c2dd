// mesh_solid.cpp — solid → plan of distinct leaves and operations → combined parts → one mesh in double.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <unordered_map>

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

// What the leaves are made of; equal materials have one number, that of the first.
std::vector<OperandMatter> matters_of(const std::vector<MeshLeaf>& leaves) {
    std::vector<OperandMatter> out;
    std::unordered_multimap<double, std::uint32_t> known;  // by a sum that equal ones share
    for (std::uint32_t i = 0; i < leaves.size(); ++i) {
        const Material& m = leaves[i].material;
        const bool shows_filled = leaves[i].subtracts() && !leaves[i].filled && !m.names_surface();
        out.push_back({leaves[i].subtractions, leaves[i].cut_order, shows_filled, false, OperandMatter::kNone, m.priority.value_or(0)});
        if (leaves[i].subtracts()) continue;
        const Vec4 color = m.color.value_or(Vec4(-1));
        const double sum = color.x + 256 * color.y + 65536 * color.z + color.w / 256;
        const auto [from, to] = known.equal_range(sum);
        const auto found = std::find_if(from, to, [&](const auto& k) { return leaves[k.second].material == m; });
        out.back().fills = found == to ? i : found->second;
        if (found == to) known.emplace(sum, i);
    }
    return out;
}

// Are there several things to be seen?
bool are_told(const std::vector<MeshLeaf>& leaves) {
    const Material* first = nullptr;
    for (const MeshLeaf& l : leaves) {
        if (l.subtracts() && !l.shown().names_surface()) continue;
        if (first && !(*first == l.shown())) return true;
        first = &l.shown();
    }
    return false;
}

// A cutter's leaf as it is where that matter remains, added to the leaves when it is first met.
class FilledLeaves {
public:
    explicit FilledLeaves(std::vector<MeshLeaf>& leaves) : leaves_(leaves) {}
    std::uint32_t of(std::uint32_t leaf, std::uint32_t filled) {
        if (filled == OperandMatter::kNone || !leaves_[leaf].subtracts() || leaves_[leaf].shown().names_surface()) return leaf;
        const auto [at, fresh] = known_.try_emplace({leaf, filled}, static_cast<std::uint32_t>(leaves_.size()));
        if (fresh) {
            MeshLeaf shown = leaves_[leaf];
            shown.filled = leaves_[filled].material;
            leaves_.push_back(std::move(shown));
        }
        return at->second;
    }

private:
    std::vector<MeshLeaf>& leaves_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
};

// Parts in double, one after the other; tags become leaf uses.
Mesh gathered(const Planner& planner, const Instance& root, const Parts& parts, Corners corners, FilledLeaves& leaves) {
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
            const bool told = part.made && !part.made->filled.empty();
            mesh.leaf.push_back(leaves.of(root.leaves[static_cast<std::size_t>(at)], told ? part.made->filled[i] : OperandMatter::kNone));
        }
    }
    return mesh;
}

// The mesh in double, with the corners as made where nothing crosses then.
void settle(const Planner& planner, const Instance& root, const Parts& parts, MeshControl& control, MeshResult& result) {
    FilledLeaves leaves(result.leaves);
    result.mesh = gathered(planner, root, parts, Corners::kAsMade, leaves);
    weld(result.mesh);
    remove_flat_triangles(result.mesh);
    std::uint64_t crossings = count_crossings(result.mesh.points, result.mesh.triangles);
    if (crossings > 0) {
        Settled settled = settled_in_double(gathered(planner, root, parts, Corners::kOnGrid, leaves), control);
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

    CombineOptions combining{how.options.threads, how.options.decimate, how.maker, matters_of(result.leaves)};
    combining.tell_matters = are_told(result.leaves);
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
