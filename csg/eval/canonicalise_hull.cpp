// canonicalise_hull.cpp — hull, projection, fill, roof: exact where there is a form for it (csg/solid), else by facets of the operands.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/canonicaliser.h"
#include "csg/solid/convex_hull.h"
#include "csg/solid/convex_parts.h"
#include "csg/solid/exact_hull.h"
#include "csg/solid/facet_operations.h"
#include "csg/solid/profile.h"
#include "csg/solid/roof.h"
#include "csg/solid/section.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// Parts of a convex body beyond which each ray would take longer than through a mesh.
constexpr std::size_t kMostParts = 2000;
// Chord error of a curved floor under a roof, of its size: that of meshes, since every chord costs the roof a wedge on every ray. A crescent's roof has
// 3e-3 too little volume with it; 1e-4 makes that 5e-4 and 1.6 times the time, 1e-5 makes it less than can be measured and 3.7 times.
constexpr double kRoofTolerance = 1e-3;

double size_of(const Bounds& box) { return glm::length(box.hi - box.lo); }
double size_of_parts(const ConvexParts& parts) { return whittle::size_of(parts, middle_of(parts)); }

// Outlines without their holes.
Contours outlines_of(const Contours& contours) {
    Contours out;
    for (const auto& ring : contours)
        if (ring_area(ring) > 0) out.push_back(ring);
    return out;
}

}  // namespace

// What an operation made of operands whose labels it swallows: its own place is what it is called by.
Made Canonicaliser::owned(const SceneNode& node, Use use) {
    if (use.node == kEmptyNode) return {};
    Made made{use, builder_.is_2d(use.node) ? Dimension::kFlat : Dimension::kSolid};
    made.use.node = node_of(use);
    made.use.placement = {};
    made.use.label = kNoLabel;
    if (profile_depth_ == 0) made.use = builder_.labelled({{}, node.place, {}}, made.use);
    return made;
}

Made Canonicaliser::owned_polygon(const SceneNode& node, Contours contours) {
    if (contours.empty()) return {};
    Use use;
    use.node = builder_.shape(shape::Polygon{std::make_shared<const Contours>(std::move(contours))});
    return owned(node, use);
}

// Operands that are something, without labels.
Canonicaliser::Operands Canonicaliser::bare_operands(SceneNodeId id) {
    ++profile_depth_;
    Operands operands = collect_each(id);
    --profile_depth_;
    operands.uses.erase(std::remove_if(operands.uses.begin(), operands.uses.end(), [](const Use& use) { return use.node == kEmptyNode; }), operands.uses.end());
    return operands;
}

Contours Canonicaliser::outline_of(const Use& flat) {
    const NodeId node = node_of(flat);
    const double size = size_of(builder_.bounds(node));
    return contours_of(builder_.so_far(), node, kProfileTolerance * size);
}

// The facets of a solid: its own where it has such, else a mesh of it, which is counted.
Result<std::shared_ptr<const FacetList>> Canonicaliser::facets_of_use(const char* module, const Use& use) {
    if (std::holds_alternative<Shape>(builder_.node(use.node)) && use.motion == 0) {
        const auto& shape = std::get<Shape>(builder_.node(use.node));
        const auto* e = std::get_if<shape::Extrusion>(&shape);
        const bool smooth = (e && e->slices == 0 && (e->twist_deg != 0 || !has_corners_only(e->profile))) || std::holds_alternative<shape::Revolution>(shape);
        if (!smooth)
            if (auto own = facets_of(builder_.so_far(), use.node)) return std::make_shared<const FacetList>(placed_facets(*own, use.placement));
    }
    const NodeId node = node_of(use);
    if (const auto known = meshes_.find(node); known != meshes_.end()) return known->second;
    if (!outside_) return fail(Fault::kScene, "no meshes here");
    Use whole;
    whole.node = node;
    auto mesh = outside_->mesh(builder_.so_far(), whole);
    if (!mesh) return mesh;
    meshes_.emplace(node, *mesh);
    fallbacks_.emplace(module, 0).first->second++;
    return mesh;
}

bool Canonicaliser::has_corners_only(NodeId id) const {
    if (const auto* s = std::get_if<Shape>(&builder_.node(id))) return !is_curved_2d(*s);
    const auto& operands = std::get<Combination>(builder_.node(id)).operands;
    return std::all_of(operands.begin(), operands.end(), [&](const Use& use) { return has_corners_only(use.node); });
}

// Said once: what no exact form was found for.
void Canonicaliser::note_fallbacks() {
    for (const auto& [module, count] : fallbacks_)
        diagnostics_.add(Severity::kNote, {}, fmt::format("{}() has no exact form here: {} {} went through chords or a mesh within the tolerance", module, count, count == 1 ? "operand" : "operands"));
}

Made Canonicaliser::hulled(SceneNodeId id) {
    const SceneNode& node = scene_.nodes[id];
    const Operands operands = bare_operands(id);
    if (operands.uses.empty()) return {};
    const HullResult exact = exact_hull(builder_, operands.uses);
    if (exact.flat) return {};  // as in OpenSCAD: fewer than four points that span space have no hull
    if (const auto hull = exact.use ? exact.use : convex_hull(operands.uses)) {
        Made made = owned(node, *hull);
        convex_.insert(made.use.node);
        return made;
    }
    if (operands.dimension == Dimension::kFlat) {
        std::vector<Vec2> points;
        for (const Use& use : operands.uses)
            for (const auto& ring : outline_of(use)) points.insert(points.end(), ring.begin(), ring.end());
        auto ring = convex_hull_of(std::move(points));
        if (ring.size() < 3) return {};
        if (std::all_of(operands.uses.begin(), operands.uses.end(), [&](const Use& use) { return has_corners_only(use.node); })) return owned_polygon(node, {std::move(ring)});
        if (const auto body = flat_body(parts_of_all(operands.uses), {ring})) return owned(node, *body);
        fallbacks_.emplace("hull", 0).first->second++;
        return owned_polygon(node, {std::move(ring)});
    }
    std::vector<Vec3> points;
    for (const Use& use : operands.uses) {
        const auto facets = facets_of_use("hull", use);
        if (!facets) return left_out(node.place, "hull() cannot be made, left out", facets.error().message);
        points.insert(points.end(), (*facets)->points.begin(), (*facets)->points.end());
    }
    auto hull = convex_hull_of(std::move(points));
    if (!hull) return {};
    return leaf(node, shape::Polyhedron{std::make_shared<const FacetList>(std::move(*hull))});
}

std::optional<ConvexParts> Canonicaliser::parts_of_all(const std::vector<Use>& uses) const {
    ConvexParts parts;
    for (const Use& use : uses) {
        const auto own = convex_parts_of(builder_.so_far(), use);
        if (!own) return std::nullopt;
        parts.insert(parts.end(), own->begin(), own->end());
    }
    return parts;
}

// In the plane the convex body of the parts is the section of the one that has them at two heights.
std::optional<Use> Canonicaliser::flat_body(const std::optional<ConvexParts>& parts, Contours chords) {
    constexpr std::size_t kMostFlatParts = 200;
    if (!parts || parts->size() > kMostFlatParts) return std::nullopt;
    const double size = size_of_parts(*parts);
    ConvexParts both;
    for (const double height : {-size, size})
        for (ConvexPart part : *parts) {
            part.centre.z = height;
            both.push_back(std::move(part));
        }
    const NodeId body = builder_.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(without_hidden_parts(std::move(both)))});
    return use_of(builder_.shape(shape::Polygon{std::make_shared<const Contours>(std::move(chords)), body, 4 * kProfileTolerance * size}));
}

// The hull of bodies that are known by how far they reach.
std::optional<Use> Canonicaliser::convex_hull(const std::vector<Use>& operands) {
    if (builder_.is_2d(operands[0].node)) return std::nullopt;
    auto all = parts_of_all(operands);
    if (!all) return std::nullopt;
    const ConvexParts parts = without_hidden_parts(std::move(*all));
    if (parts.size() > kMostParts) return std::nullopt;
    return use_of(builder_.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(std::move(parts))}));
}

Made Canonicaliser::projected(SceneNodeId id, const scene::Projection& what) {
    const SceneNode& node = scene_.nodes[id];
    ++profile_depth_;
    Operands operands;
    operands.dimension = Dimension::kSolid;
    collect_union(id, operands);
    --profile_depth_;
    if (operands.uses.empty()) return {};
    Use solid = operands.uses[0];
    if (operands.uses.size() > 1) {
        solid = Use{};
        solid.node = builder_.combine(SetOp::kUnion, std::move(operands.uses));
    }
    if (solid.node == kEmptyNode) return {};
    // A section that stands below a polygon is exact where it is traced.
    const auto outline = [this](const Use& use) -> std::optional<SectionOutline> {
        auto made = outside_ ? outside_->section(builder_.so_far(), use) : fail(Fault::kScene, "no meshes here");
        return made ? std::optional(std::move(*made)) : std::nullopt;
    };
    const auto exact = what.cut ? exact_section(builder_, solid, outline) : exact_shadow(builder_, solid);
    if (exact) return owned(node, *exact);
    const auto facets = facets_of_use("projection", solid);
    if (!facets) return left_out(node.place, "projection() cannot be made, left out", facets.error().message);
    return owned_polygon(node, what.cut ? section_of(**facets) : shadow_of(**facets));
}

// The holes are what lies between the outlines with and without them; true arcs outside stay.
Made Canonicaliser::filled(SceneNodeId id) {
    const SceneNode& node = scene_.nodes[id];
    const Use flat = profile(id);
    if (flat.node == kEmptyNode) return {};
    const Contours contours = outline_of(flat);
    const Contours outer = outlines_of(contours);
    if (outer.size() == contours.size()) return owned(node, flat);
    if (has_corners_only(flat.node)) return owned_polygon(node, united_rings(outer));
    Contours holes;
    for (const auto& ring : contours)
        if (ring_area(ring) <= 0) holes.emplace_back(ring.rbegin(), ring.rend());
    const double room = 2 * kProfileTolerance * size_of(builder_.bounds(node_of(flat)));
    Use plug;
    plug.node = builder_.shape(shape::Polygon{std::make_shared<const Contours>(offset_contours(united_rings(holes), room, Join::kMiter, 0))});
    Use whole;
    whole.node = builder_.combine(SetOp::kUnion, {flat, plug});
    return owned(node, whole);
}

Made Canonicaliser::roofed(SceneNodeId id, const scene::Roof& what) {
    const SceneNode& node = scene_.nodes[id];
    const Use flat = profile(id);
    if (flat.node == kEmptyNode) return {};
    const auto* shape = std::get_if<Shape>(&builder_.node(flat.node));
    if (const auto* disc = shape ? std::get_if<shape::Disc>(shape) : nullptr; disc && similarity_of(flat.placement, true)) {
        const double r = disc->r * *similarity_of(flat.placement, true);
        return leaf(node, shape::Frustum{0, r, r, 0}, Placement::translation({flat.placement.offset(0), flat.placement.offset(1), 0}));
    }
    const bool curved = !has_corners_only(flat.node);
    if (curved) fallbacks_.emplace("roof", 0).first->second++;
    const Contours floor = curved ? contours_of(builder_.so_far(), node_of(flat), kRoofTolerance * size_of(builder_.bounds(flat))) : outline_of(flat);
    if (floor.empty()) return {};
    if (what.method == "straight" && !is_one_convex_ring(floor)) {
        if (!outside_) return left_out(node.place, "roof() needs meshes, left out");
        const auto roof = outside_->straight_roof(floor);
        if (!roof) return left_out(node.place, "roof() cannot be made, left out", roof.error().message);
        if (!curved) fallbacks_.emplace("roof", 0).first->second++;
        return leaf(node, shape::Polyhedron{*roof});
    }
    return owned(node, roof_of(builder_, floor));
}

}  // namespace whittle
