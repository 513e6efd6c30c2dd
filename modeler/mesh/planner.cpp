#include "modeler/mesh/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "modeler/arrange/crossings.h"
#include "modeler/mesh/grid_frame.h"
#include "modeler/mesh/stretch.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

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

std::string placed_text(const std::string& text, const SourcePlace& place) {
    return place.line == 0 ? text : fmt::format("{} (line {})", text, place.line);
}
Error placed_error(Error error, const SourcePlace& place) {
    error.message = placed_text(error.message, place);
    return error;
}

// A scale that equal parts share, though their placements differ by roundings: never less than it is.
double shared_scale(double scale) {
    constexpr double kRoundings = 0x1p-30;
    constexpr int kBits = 20;
    int exponent = 0;
    const double mantissa = std::frexp(scale * (1 + kRoundings), &exponent);
    return std::ldexp(std::ceil(std::ldexp(mantissa, kBits)), exponent - kBits);
}

}  // namespace

bool finite(const Bounds& b) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(b.lo[i]) || !std::isfinite(b.hi[i])) return false;
    return true;
}
double largest_coordinate(const Bounds& b) {
    const Vec3 m = glm::max(glm::abs(b.lo), glm::abs(b.hi));
    return std::max({m.x, m.y, m.z});
}

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

Planner::Planner(const Solid& solid, const Use& root, const CurveRule& rule, NodeMesher mesher, MeshControl& control, const Bounds& room, MeshResult& result)
    : solid_(solid), mesher_(std::move(mesher)), control_(control), room_(room), result_(result), frame_(grid_frame(solid, root)), to_frame_(turned_back(frame_)), rule_(rule) {
    const double diagonal = glm::length(room.hi - room.lo);
    // Unbounded leaves reach past the room, by less than a quarter of its diagonal; others may reach far out of it and be cut.
    // Along turned axes coordinates, and steps seen along the world's, may be longer by the root of three.
    const double longer = frame_.is_identity() ? 1 : std::sqrt(3.0) * (1 + std::numeric_limits<double>::epsilon());
    grid_ = Grid::for_sizes(longer * (largest_coordinate(room) + diagonal / 4), longer * farthest_leaf(solid, root, Placement{}));
    result_.grid_mm = own_grid_mm_ = longer / grid_.per_mm;
}

Result<std::optional<Instance>> Planner::build(const Use& use, Path path) {
    if (use.node == kEmptyNode) return std::optional<Instance>{};
    if (control_.cancelled()) return fail(Fault::kInterrupted, "interrupted");
    enter(use, path);
    const Node& node = solid_.node(use.node);
    if (std::holds_alternative<Shape>(node)) return leaf(use.node, path);
    if (is_turned_part(use, path.placement)) return turned_part(use.node, path);
    return combination(std::get<Combination>(node), path);
}

void Planner::enter(const Use& use, Path& path) const {
    path.placement = path.placement * use.placement;
    if (use.motion != 0) path.placement = path.placement * solid_.motion(use.motion).start;
    const Label& label = solid_.label(use.label);
    path.material = nested(path.material, label.material);
    if (path.part.empty()) path.part = label.part;
    if (label.place.line != 0) path.place = label.place;
}

Result<std::optional<Instance>> Planner::combination(const Combination& c, const Path& path) {
    std::vector<Instance> instances;
    bool first_is_empty = false;
    const std::size_t begin = result_.leaves.size();
    std::size_t middle = begin;
    for (std::size_t i = 0; i < c.operands.size(); ++i) {
        if (i == 1) middle = result_.leaves.size();
        Path inner = path;
        if (c.op == SetOp::kDifference && i > 0) ++inner.subtractions;  // c in a - (b - c) too: its matter fills nothing
        auto built = build(c.operands[i], std::move(inner));
        if (!built) return built;
        if (*built) {
            instances.push_back(std::move(**built));
        } else if (c.op == SetOp::kIntersection || (c.op == SetOp::kDifference && i == 0)) {
            first_is_empty = true;
            break;
        }
    }
    if (c.op == SetOp::kDifference && middle > begin) put_cutters_first(begin, middle);
    if (first_is_empty || instances.empty()) return std::optional<Instance>{};
    if (c.op == SetOp::kUnion) return plan_.unite(std::move(instances));
    if (c.op == SetOp::kIntersection) return plan_.intersect(std::move(instances));
    Instance from = std::move(instances.front());
    instances.erase(instances.begin());
    return plan_.subtract(std::move(from), std::move(instances));
}

// Of the leaves from `begin` those of what is cut change places in the order of cuts with those of its cutters, which begin at `middle`.
void Planner::put_cutters_first(std::size_t begin, std::size_t middle) {
    const std::size_t end = result_.leaves.size();
    for (std::size_t i = begin; i < end; ++i) result_.leaves[i].cut_order += i < middle ? static_cast<std::int64_t>(end - middle) : -static_cast<std::int64_t>(middle - begin);
}

Result<std::optional<Instance>> Planner::leaf(NodeId node, const Path& path) {
    const auto number = static_cast<std::uint32_t>(result_.leaves.size());
    result_.leaves.push_back({path.material, path.place, path.part, path.subtractions, number, {}});
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

Result<std::optional<Instance>> Planner::piece_of(const LeafMesh& mesh, const Path& path, std::uint32_t number, bool may_cross_itself) {
    SnappedLeaf snapped = snap_leaf(mesh, path.placement, to_frame_, grid_, known_);
    if (snapped.mesh.triangles.empty()) return std::optional<Instance>{};
    if (const std::uint64_t open = count_open_edges(snapped.mesh.triangles); open > 0)
        return fail(Fault::kScene, placed_text(fmt::format("a solid is not closed: {} edges lack a neighbour", open), path.place));
    // Against a leaf this small the grid is no longer fine: its triangles may have been pressed into each other.
    constexpr std::int64_t kSmallLeaf = std::int64_t{1} << 20;
    snapped.may_cross_itself = may_cross_itself || *std::min_element(snapped.size.begin(), snapped.size.end()) < kSmallLeaf;
    return std::optional<Instance>{plan_.leaf(std::move(snapped), {number})};
}

// What a shape is cut into depends on how much its placement lengthens alone, so it is cut once for all places that differ in turns; unbounded ones depend on the place.
Result<std::shared_ptr<const Tessellation>> Planner::tessellated(NodeId node, const Placement& placement) {
    const auto& shape = std::get<Shape>(solid_.node(node));
    const bool unbounded = std::holds_alternative<shape::HalfSpace>(shape) || std::holds_alternative<shape::Quadric>(shape);
    CurveRule rule = rule_;
    rule.scale = rule_.scale * largest_stretch(placement);
    if (!keeps_axes(placement)) rule.scale = shared_scale(rule.scale);
    if (!(rule.scale > 0)) return std::make_shared<const Tessellation>();
    const std::pair key{solid_.geometry(node), rule.scale};
    if (!unbounded)
        if (const auto known = tessellations_.find(key); known != tessellations_.end()) return known->second;
    const auto room = pulled_back(room_, placement);
    if (!room) return std::make_shared<const Tessellation>();
    auto made = tessellate(solid_, node, rule, *room);
    if (!made) return tl::unexpected(made.error());
    auto shared = std::make_shared<const Tessellation>(std::move(*made));
    if (!unbounded) tessellations_.emplace(key, shared);
    return shared;
}

bool Planner::is_bounded(NodeId node) {
    const auto [at, fresh] = bounded_.try_emplace(node, true);
    if (!fresh) return at->second;
    bool bounded = true;
    if (const auto* c = std::get_if<Combination>(&solid_.node(node))) {
        for (const Use& operand : c->operands) bounded = bounded && is_bounded(operand.node);
    } else {
        bounded = solid_.bounds(node).empty() || finite(solid_.bounds(node));
    }
    return bounded_[node] = bounded;
}

// `placement` is that of all uses down to this one.
bool Planner::is_turned_part(const Use& use, const Placement& placement) {
    const bool turns = !keeps_axes(use.placement) || (use.motion != 0 && !keeps_axes(solid_.motion(use.motion).start));
    return turns && !keeps_axes(to_frame_ * placement) && determinant(placement) != 0 && is_bounded(use.node) && !solid_.bounds(use.node).empty();
}

Result<std::shared_ptr<const MeshResult>> Planner::meshed_apart(NodeId node, double scale) {
    if (const auto known = apart_.find({node, scale}); known != apart_.end()) {
        ++result_.stats.reused;
        return known->second;
    }
    CurveRule rule = rule_;
    rule.scale = scale;
    auto made = mesher_(node, rule);
    if (!made) return tl::unexpected(made.error());
    result_.stats.booleans += made->stats.booleans;
    result_.stats.fallbacks += made->stats.fallbacks;
    result_.stats.reused += made->stats.reused;
    result_.stats.skipped_boxes += made->stats.skipped_boxes;
    result_.stats.decimated += made->stats.decimated;
    for (const std::string& warning : made->warnings) result_.warnings.push_back(warning);
    auto shared = std::make_shared<const MeshResult>(std::move(*made));
    apart_.emplace(std::pair{node, scale}, shared);
    return shared;
}

Result<std::optional<Instance>> Planner::turned_part(NodeId node, const Path& path) {
    const auto made = meshed_apart(node, shared_scale(rule_.scale * largest_stretch(path.placement)));
    if (!made) return tl::unexpected(made.error());
    const MeshResult& part = **made;
    std::vector<std::uint32_t> uses;
    const auto first = static_cast<std::int64_t>(result_.leaves.size());
    for (const MeshLeaf& l : part.leaves) {
        uses.push_back(static_cast<std::uint32_t>(result_.leaves.size()));
        result_.leaves.push_back({nested(path.material, l.material), l.place.line != 0 ? l.place : path.place, path.part.empty() ? l.part : path.part,
                                  path.subtractions + l.subtractions, first + l.cut_order, {}});
        if (l.filled && path.subtractions == 0) result_.leaves.back().filled = nested(path.material, *l.filled);
    }
    result_.tolerance_mm = std::max(result_.tolerance_mm, part.tolerance_mm);
    // Corners have been rounded in the part's own axes before.
    result_.grid_mm = std::max(result_.grid_mm, own_grid_mm_ + part.grid_mm * largest_stretch(path.placement));
    result_.stats.leaves += part.stats.leaves;
    if (part.mesh.triangles.empty()) return std::optional<Instance>{};
    const LeafMesh mesh{part.mesh.points, part.mesh.triangles, part.mesh.leaf, static_cast<std::uint32_t>(part.leaves.size())};
    SnappedLeaf snapped = snap_leaf(mesh, path.placement, to_frame_, grid_, known_);
    if (snapped.mesh.triangles.empty()) return std::optional<Instance>{};
    std::vector<Vec3> points;
    for (const GridPoint& p : snapped.mesh.points) points.emplace_back(p[0], p[1], p[2]);
    snapped.may_cross_itself = count_crossings(points, snapped.mesh.triangles) > 0;
    return std::optional<Instance>{plan_.leaf(std::move(snapped), std::move(uses))};
}

}  // namespace whittle
