// canonicalise_offset.cpp — offset of 2D sets: true arcs as discs and strips, OpenSCAD's facets by Clipper where the author asked for them.
//
// Growing by r is the union of the set, a strip along each side and a disc at each convex corner; shrinking takes the strips and the discs at the
// reflex corners away. Both are set operations on shapes the solid has, so nothing is approximated. Growing distributes over unions; arcs have parts of rings
// for strips (csg/solid/grown_arcs.h).

#include <algorithm>
#include <cmath>

#include "csg/eval/canonicaliser.h"
#include "csg/solid/grown_arcs.h"
#include "csg/solid/predicates.h"
#include "csg/solid/profile.h"

namespace whittle {
namespace {

bool has_straight_sides(const Solid& solid, NodeId id) {
    if (const auto* s = std::get_if<Shape>(&solid.node(id))) return !is_curved_2d(*s);
    const auto& operands = std::get<Combination>(solid.node(id)).operands;
    return std::all_of(operands.begin(), operands.end(), [&](const Use& use) { return has_straight_sides(solid, use.node); });
}

// Of a circle where curves were meant and only chords can be grown: within 2^-14 of its radius.
constexpr int kSmoothFacets = 288;

bool is_translation(const Placement& a) { return a == Placement::translation({a.offset(0), a.offset(1), 0}); }

Contours outline(const SolidBuilder& builder, NodeId node) {
    const Bounds box = builder.bounds(node);
    return contours_of(builder.so_far(), node, kProfileTolerance * glm::length(box.hi - box.lo));
}

}  // namespace

// The set of `flat`, whose sides are straight, grown by delta.
Use Canonicaliser::grown_outline(const Use& flat, double delta) {
    std::vector<Use> pieces{flat};
    const NodeId disc = builder_.shape(shape::Disc{std::fabs(delta)});
    for (const auto& ring : outline(builder_, node_of(flat)))
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
            const Vec2 out = delta / glm::length(b - a) * Vec2(b.y - a.y, a.x - b.x);
            Use strip;
            strip.node = builder_.shape(shape::Polygon{std::make_shared<const Contours>(Contours{{a, b, b + out, a + out}})});
            pieces.push_back(strip);
            if (turn_of(a, b, c) != (delta > 0 ? 1 : -1)) continue;
            Use corner;
            corner.node = disc;
            corner.placement = Placement::translation({b.x, b.y, 0});
            pieces.push_back(corner);
        }
    Use whole;
    whole.node = builder_.combine(delta > 0 ? SetOp::kUnion : SetOp::kDifference, std::move(pieces));
    return whole;
}

// Nothing where the result is no set of discs and straight sides.
std::optional<Use> Canonicaliser::grown(const Use& flat, double delta) {
    if (flat.node == kEmptyNode) return flat;
    const Node node = builder_.node(flat.node);
    const auto* s = std::get_if<Shape>(&node);
    const auto* disc = s ? std::get_if<shape::Disc>(s) : nullptr;
    if (disc && is_translation(flat.placement)) {
        Use use = flat;
        use.node = disc->r + delta > 0 ? builder_.shape(shape::Disc{disc->r + delta}) : kEmptyNode;
        return use.node == kEmptyNode ? Use{} : use;
    }
    if (has_straight_sides(builder_.so_far(), flat.node)) return grown_outline(flat, delta);
    const auto* c = std::get_if<Combination>(&node);
    if (!c || c->op != SetOp::kUnion || delta < 0 || !is_translation(flat.placement)) return grown_by_arcs(builder_, flat, delta);
    std::vector<Use> parts;
    for (const Use& use : c->operands) {
        const auto part = grown(use, delta);
        if (!part) return grown_by_arcs(builder_, flat, delta);
        parts.push_back(*part);
    }
    Use whole = flat;
    whole.node = builder_.combine(SetOp::kUnion, std::move(parts));
    return whole;
}

// The outline, its curves as chords, grown as OpenSCAD grows it.
Use Canonicaliser::offset_by_chords(const Use& flat, double delta, Join join, int fragments) {
    if (!has_straight_sides(builder_.so_far(), flat.node)) fallbacks_.emplace("offset", 0).first->second++;
    Use use;
    Contours contours = offset_contours(outline(builder_, node_of(flat)), delta, join, fragments);
    if (!contours.empty()) use.node = builder_.shape(shape::Polygon{std::make_shared<const Contours>(std::move(contours))});
    return use;
}

Made Canonicaliser::offset(SceneNodeId id, const scene::Offset& what) {
    const SceneNode& node = scene_.nodes[id];
    const Use flat = profile(id);
    if (flat.node == kEmptyNode) return {};
    if (!std::isfinite(what.delta)) return left_out(node.place, "offset() needs a finite distance, left out");
    Made made{flat, Dimension::kFlat};
    const int n = what.round ? facets_of_circle(node, std::fabs(what.delta)) : 0;
    if (what.delta == 0) return made;
    const auto* shape = std::get_if<Shape>(&builder_.node(flat.node));
    const bool is_disc = shape && std::holds_alternative<shape::Disc>(*shape);  // has no corners: any join is round
    if (n == 0 && (what.round || is_disc)) {
        const auto whole = grown(flat, what.delta);
        made.use = whole ? *whole : offset_by_chords(flat, what.delta, Join::kRound, kSmoothFacets);
    } else {
        const Join join = what.round ? Join::kRound : what.chamfer ? Join::kSquare : Join::kMiter;
        made.use = offset_by_chords(flat, what.delta, join, n);
    }
    if (made.use.node == kEmptyNode) return {};
    if (profile_depth_ == 0) made.use = builder_.labelled({{}, node.place, {}}, made.use);
    return made;
}

}  // namespace whittle
