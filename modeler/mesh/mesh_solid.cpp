// mesh_solid.cpp — solid → plan of distinct leaves and operations → combined parts → one mesh in double.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "modeler/arrange/crossings.h"
#include "modeler/mesh/combine.h"
#include "modeler/mesh/grid_frame.h"
#include "modeler/mesh/mesh.h"
#include "modeler/mesh/settle.h"
#include "modeler/mesh/tessellate.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool finite(const Bounds& b) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(b.lo[i]) || !std::isfinite(b.hi[i])) return false;
    return true;
}
double largest_coordinate(const Bounds& b) {
    const Vec3 m = glm::max(glm::abs(b.lo), glm::abs(b.hi));
    return std::max({m.x, m.y, m.z});
}

// The most by which the map lengthens a vector: the root of the largest eigenvalue of its Gram matrix, by Cardano's trigonometric form.
double largest_stretch(const Placement& p) {
    double g[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            g[i][j] = 0;
            for (int k = 0; k < 3; ++k) g[i][j] += p.linear(k, i) * p.linear(k, j);
        }
    const double off = g[0][1] * g[0][1] + g[0][2] * g[0][2] + g[1][2] * g[1][2];
    const double mean = (g[0][0] + g[1][1] + g[2][2]) / 3;
    if (off == 0) return std::sqrt(std::max({g[0][0], g[1][1], g[2][2]}));
    double spread = 2 * off;
    for (int i = 0; i < 3; ++i) spread += (g[i][i] - mean) * (g[i][i] - mean), g[i][i] -= mean;
    const double s = std::sqrt(spread / 6);
    const double det = g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) - g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
                       g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
    const double angle = std::acos(std::clamp(det / (2 * s * s * s), -1.0, 1.0)) / 3;
    return std::sqrt(std::max(0.0, mean + 2 * s * std::cos(angle)));
}

// The box around `box` after the inverse of `p`; nothing where p flattens space.
std::optional<Bounds> pulled_back(const Bounds& box, const Placement& p) {
    const glm::dmat3 linear(p.m[0], p.m[4], p.m[8], p.m[1], p.m[5], p.m[9], p.m[2], p.m[6], p.m[10]);
    if (glm::determinant(linear) == 0) return std::nullopt;
    const glm::dmat3 inverse = glm::inverse(linear);
    const Vec3 offset{p.m[3], p.m[7], p.m[11]};
    Bounds out;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 q = inverse * (Vec3{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z} - offset);
        out.lo = corner == 0 ? q : glm::min(out.lo, q);
        out.hi = corner == 0 ? q : glm::max(out.hi, q);
    }
    return out;
}

// The largest coordinate of any bounded leaf, in place.
double farthest_leaf(const Solid& solid, const Use& use, const Placement& outer) {
    Placement placement = outer * use.placement;
    if (use.motion != 0) placement = placement * solid.motion(use.motion).start;
    if (const auto* c = std::get_if<Combination>(&solid.node(use.node))) {
        double most = 0;
        for (const Use& operand : c->operands) most = std::max(most, farthest_leaf(solid, operand, placement));
        return most;
    }
    const Bounds& own = solid.bounds(use.node);
    return own.empty() || !finite(own) ? 0 : largest_coordinate(placed_bounds(own, placement));
}

// What a use on the path to a leaf adds.
struct Path {
    Placement placement;
    Material material;
    std::string part;
    SourcePlace place;
    bool subtracts = false;
};

class Planner {
public:
    Planner(const Solid& solid, const Use& root, const MeshOptions& options, MeshControl& control, const Bounds& room, MeshResult& result)
        : solid_(solid), control_(control), room_(room), result_(result), frame_(grid_frame(solid, root)), to_frame_(turned_back(frame_)) {
        const double diagonal = glm::length(room.hi - room.lo);
        rule_.angle_deg = options.angle_deg;
        rule_.largest = options.tolerance_mm.value_or(1e-3 * diagonal);
        if (options.tolerance_mm) rule_.share_of_radius = 0;
        // Unbounded leaves reach past the room, by less than a quarter of its diagonal; others may reach far out of it and be cut.
        // Along turned axes coordinates, and steps seen along the world's, may be longer by the root of three.
        const double longer = frame_.is_identity() ? 1 : std::sqrt(3.0) * (1 + std::numeric_limits<double>::epsilon());
        grid_ = Grid::for_sizes(longer * (largest_coordinate(room) + diagonal / 4), longer * farthest_leaf(solid, root, Placement{}));
        result_.grid_mm = longer / grid_.per_mm;
    }

    const Plan& plan() const { return plan_; }
    const Grid& grid() const { return grid_; }
    const KnownPoints& known() const { return known_; }
    const Placement& frame() const { return frame_; }

    Result<std::optional<Instance>> build(const Use& use, Path path) {
        if (use.node == kEmptyNode) return std::optional<Instance>{};
        if (control_.cancelled()) return fail(Fault::kInterrupted, "interrupted");
        enter(use, path);
        const Node& node = solid_.node(use.node);
        if (std::holds_alternative<Shape>(node)) return leaf(use.node, path);
        return combination(std::get<Combination>(node), path);
    }

private:
    void enter(const Use& use, Path& path) const {
        path.placement = path.placement * use.placement;
        if (use.motion != 0) path.placement = path.placement * solid_.motion(use.motion).start;
        const Label& label = solid_.label(use.label);
        path.material = nested(path.material, label.material);
        if (path.part.empty()) path.part = label.part;
        if (label.place.line != 0) path.place = label.place;
    }

    Result<std::optional<Instance>> combination(const Combination& c, const Path& path) {
        std::vector<Instance> instances;
        bool first_is_empty = false;
        for (std::size_t i = 0; i < c.operands.size(); ++i) {
            Path inner = path;
            if (c.op == SetOp::kDifference && i > 0) inner.subtracts = true;  // c in a - (b - c) too: its matter fills nothing
            auto built = build(c.operands[i], std::move(inner));
            if (!built) return built;
            if (*built) {
                instances.push_back(std::move(**built));
            } else if (c.op == SetOp::kIntersection || (c.op == SetOp::kDifference && i == 0)) {
                first_is_empty = true;
                break;
            }
        }
        if (first_is_empty || instances.empty()) return std::optional<Instance>{};
        if (c.op == SetOp::kUnion) return plan_.unite(std::move(instances));
        if (c.op == SetOp::kIntersection) return plan_.intersect(std::move(instances));
        Instance from = std::move(instances.front());
        instances.erase(instances.begin());
        return plan_.subtract(std::move(from), std::move(instances));
    }

    Result<std::optional<Instance>> leaf(NodeId node, const Path& path) {
        const auto number = static_cast<std::uint32_t>(result_.leaves.size());
        result_.leaves.push_back({path.material, path.place, path.part, path.subtracts});
        const auto tessellation = tessellated(node, path.placement);
        if (!tessellation) return tl::unexpected(placed_error(tessellation.error(), path.place));
        result_.tolerance_mm = std::max(result_.tolerance_mm, (*tessellation)->error);
        const Tessellation& made = **tessellation;
        const auto& shape = std::get<Shape>(solid_.node(node));
        const bool crosses = std::holds_alternative<shape::Polyhedron>(shape) || std::holds_alternative<shape::Extrusion>(shape) ||
                             std::holds_alternative<shape::Revolution>(shape) || std::holds_alternative<shape::Quadric>(shape);
        std::vector<Instance> pieces;
        for (std::size_t i = 0; i <= made.more.size(); ++i) {
            auto piece = piece_of(i == 0 ? made.mesh : made.more[i - 1], path, number, crosses);
            if (!piece) return piece;
            if (*piece) pieces.push_back(std::move(**piece));
        }
        ++result_.stats.leaves;
        if (!made.less) return plan_.unite(std::move(pieces));
        auto around = piece_of(*made.less, path, number, false);
        if (!around || !*around) return around;
        return plan_.subtract(std::move(**around), std::move(pieces));
    }

    Result<std::optional<Instance>> piece_of(const LeafMesh& mesh, const Path& path, std::uint32_t number, bool may_cross_itself) {
        SnappedLeaf snapped = snap_leaf(mesh, path.placement, to_frame_, grid_, known_);
        if (snapped.mesh.triangles.empty()) return std::optional<Instance>{};
        if (const std::uint64_t open = count_open_edges(snapped.mesh.triangles); open > 0)
            return fail(Fault::kScene, placed_text(fmt::format("a solid is not closed: {} edges lack a neighbour", open), path.place));
        // Against a leaf this small the grid is no longer fine: its triangles may have been pressed into each other.
        constexpr std::int64_t kSmallLeaf = std::int64_t{1} << 20;
        snapped.may_cross_itself = may_cross_itself || *std::min_element(snapped.size.begin(), snapped.size.end()) < kSmallLeaf;
        return std::optional<Instance>{plan_.leaf(std::move(snapped), number)};
    }

    // Shapes do not change with translation, so each is cut into triangles once for every linear part; unbounded ones depend on the place.
    Result<std::shared_ptr<const Tessellation>> tessellated(NodeId node, const Placement& placement) {
        const auto& shape = std::get<Shape>(solid_.node(node));
        const bool unbounded = std::holds_alternative<shape::HalfSpace>(shape) || std::holds_alternative<shape::Quadric>(shape);
        std::array<double, 10> key{static_cast<double>(solid_.geometry(node))};
        for (int i = 0; i < 9; ++i) key[static_cast<std::size_t>(i) + 1] = placement.linear(i / 3, i % 3);
        if (!unbounded)
            if (const auto known = tessellations_.find(key); known != tessellations_.end()) return known->second;
        CurveRule rule = rule_;
        rule.scale = largest_stretch(placement);
        const auto room = pulled_back(room_, placement);
        if (!room || !(rule.scale > 0)) return std::make_shared<const Tessellation>();
        auto made = tessellate(solid_, node, rule, *room);
        if (!made) return tl::unexpected(made.error());
        auto shared = std::make_shared<const Tessellation>(std::move(*made));
        if (!unbounded) tessellations_.emplace(key, shared);
        return shared;
    }

    static std::string placed_text(const std::string& text, const SourcePlace& place) {
        return place.line == 0 ? text : fmt::format("{} (line {})", text, place.line);
    }
    static Error placed_error(Error error, const SourcePlace& place) {
        error.message = placed_text(error.message, place);
        return error;
    }

    const Solid& solid_;
    MeshControl& control_;
    Bounds room_;
    MeshResult& result_;
    Placement frame_, to_frame_;
    CurveRule rule_;
    Grid grid_;
    Plan plan_;
    KnownPoints known_;
    std::map<std::array<double, 10>, std::shared_ptr<const Tessellation>> tessellations_;
};

// First tag of each leaf of a plan, in the plan's order, and one past the last.
void append_tag_starts(const Plan& plan, PlanId id, FacetTag base, std::vector<FacetTag>& starts) {
    const PlanNode& n = plan.node(id);
    if (!n.op) {
        starts.push_back(base);
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
    result.report.self_intersections = crossings;
}

}  // namespace

double chord_tolerance(const MeshOptions& options, double radius, double diagonal) {
    return options.tolerance_mm ? *options.tolerance_mm : std::min(1e-3 * radius, 1e-3 * diagonal);
}

namespace {

Result<MeshResult> mesh_use_by(BooleanMaker maker, const Solid& solid, const Use& root, const MeshOptions& options, MeshControl& control) {
    MeshResult result;
    if (root.node == kEmptyNode) return result;
    if (solid.is_2d(root.node)) return fail(Fault::kScene, "Current top level object is not a 3D object.");
    const Bounds room = bounds_at_start(solid, root);
    if (room.empty()) return result;
    if (!finite(room)) return fail(Fault::kScene, "the solid is unbounded: no operation bounds a halfspace or quadric");
    constexpr double kLargestMm = 1e100;  // squares of lengths stay finite
    if (const double far = std::max(largest_coordinate(room), farthest_leaf(solid, root, Placement{})); far > kLargestMm)
        return fail(Fault::kScene, fmt::format("the solid reaches {:g} mm far, beyond the {:g} that can be meshed", far, kLargestMm));

    auto start = Clock::now();
    Planner planner(solid, root, options, control, room, result);
    auto instance = planner.build(root, Path{});
    if (!instance) return tl::unexpected(instance.error());
    result.stats.seconds_tessellate = seconds_since(start);
    result.stats.reused = planner.plan().reused();
    result.stats.skipped_boxes = planner.plan().skipped();
    if (!*instance) return result;

    const CombineOptions how{options.threads, options.decimate, maker};
    result.stats.loaded_cgal = maker == BooleanMaker::kCgal;
    const auto parts = combine_plan(planner.plan(), (*instance)->ref.plan, (*instance)->leaves, how, control, result.stats);
    if (!parts) return tl::unexpected(parts.error());
    start = Clock::now();
    settle(planner, **instance, *parts, control, result);
    result.stats.seconds_round = seconds_since(start);
    return result;
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
