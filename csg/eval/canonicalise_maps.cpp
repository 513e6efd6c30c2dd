// canonicalise_maps.cpp — linear_extrude and rotate_extrude: maps of a 2D set that commute with set operations, so the set stays as it is.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/canonicaliser.h"
#include "csg/solid/divided_sides.h"
#include "csg/solid/facets.h"
#include "csg/solid/placement.h"
#include "csg/solid/profile.h"
#include "csg/solid/support.h"

namespace whittle {
namespace {

// A placement that keeps the plane z = 0 moves an upright extrusion just as it moves the profile.
const Shape* single_shape(const SolidBuilder& builder, NodeId id) { return std::get_if<Shape>(&builder.node(id)); }

// The upright extrusion of a rectangle or disc as the shape it is.
Shape upright(const SolidBuilder& builder, const shape::Extrusion& e) {
    const Shape* profile = single_shape(builder, e.profile);
    if (const auto* r = profile ? std::get_if<shape::Rectangle>(profile) : nullptr) return shape::Box{{r->lo.x, r->lo.y, e.z0}, {r->hi.x, r->hi.y, e.z1}};
    if (const auto* d = profile ? std::get_if<shape::Disc>(profile) : nullptr) return shape::Frustum{e.z0, e.z1, d->r, d->r};
    return e;
}

bool has_curves(const SolidBuilder& builder, NodeId id) {
    if (const auto* c = std::get_if<Combination>(&builder.node(id)))
        return std::any_of(c->operands.begin(), c->operands.end(), [&](const Use& use) { return has_curves(builder, use.node); });
    return is_curved_2d(std::get<Shape>(builder.node(id)));
}

// The extrusion of a placed 2D set that shrinks or grows evenly on its way up, `e.profile` left open. Set operations commute with it, and a disc becomes a cone,
// which leans where the disc is off the axis: k(z) (A q + b) is the upright cone of k q, turned by A and sheared along b.
Use tapered(SolidBuilder& builder, const shape::Extrusion& e, const Use& flat, const Placement& outer, const Label& label) {
    const Placement placement = outer * flat.placement;
    Use made;
    if (const auto* c = std::get_if<Combination>(&builder.node(flat.node))) {
        const Combination combination = *c;
        std::vector<Use> operands;
        for (const Use& operand : combination.operands) operands.push_back(tapered(builder, e, operand, placement, label));
        made.node = builder.combine(combination.op, std::move(operands));
        return made;
    }
    if (const auto* disc = std::get_if<shape::Disc>(&std::get<Shape>(builder.node(flat.node)))) {
        const double top = e.scale_top.x, lean = (top - 1) / (e.z1 - e.z0);
        made.node = builder.shape(shape::Frustum{e.z0, e.z1, disc->r, disc->r * top});
        made.placement = placement;
        for (int i = 0; i < 2; ++i) {
            made.placement.m[static_cast<std::size_t>(4 * i + 2)] = lean * placement.offset(i);
            made.placement.m[static_cast<std::size_t>(4 * i + 3)] = placement.offset(i) * (1 - lean * e.z0);
        }
    } else if (const auto* segment = std::get_if<shape::ParabolicSegment>(&std::get<Shape>(builder.node(flat.node)))) {
        const auto at = [&](Vec2 p) { return Vec2(apply_to_point(placement, {p.x, p.y, 0})); };
        shape::Extrusion part = e;
        part.profile = builder.shape(shape::ParabolicSegment{at(segment->a), at(segment->c), at(segment->b)});
        made.node = builder.shape(part);
    } else {
        shape::Extrusion part = e;
        Use profile;
        profile.node = flat.node;
        profile.placement = placement;
        part.profile = builder.combine(SetOp::kUnion, {profile});
        made.node = builder.shape(part);
    }
    made.label = builder.label(label);
    return made;
}

bool is_translation_in_plane(const Placement& a) { return a == Placement::translation({a.offset(0), a.offset(1), 0}); }

// The angle as the language reads it: outside (-360, 360] and what is no number mean a full turn.
double turn_of(double angle_deg) { return angle_deg > -360 && angle_deg <= 360 ? angle_deg : 360; }

}  // namespace

// The union of the 2D children, without labels.
Use Canonicaliser::profile(SceneNodeId id) {
    const std::size_t ghosts_before = ghosts_.size();
    ++profile_depth_;
    Operands operands;
    operands.dimension = Dimension::kFlat;
    collect_union(id, operands);
    --profile_depth_;
    ghosts_.resize(ghosts_before);
    if (operands.uses.size() == 1) return operands.uses[0];
    Use use;
    use.node = builder_.combine(SetOp::kUnion, std::move(operands.uses));
    return use;
}

Made Canonicaliser::extruded(SceneNodeId id, const scene::LinearExtrude& what) {
    Made made = extruded_upright(id, what);
    if (what.lean != Vec2(0)) made.use = builder_.placed({{1, 0, what.lean.x, 0, 0, 1, what.lean.y, 0, 0, 0, 1, 0}}, made.use);
    return made;
}

Made Canonicaliser::extruded_upright(SceneNodeId id, const scene::LinearExtrude& what) {
    const SceneNode& node = scene_.nodes[id];
    Use flat = profile(id);
    if (flat.node == kEmptyNode || !is_positive(node, "linear_extrude", "height", what.height)) return {};
    if (!std::isfinite(what.twist_deg) || !std::isfinite(what.scale.x) || !std::isfinite(what.scale.y))
        return left_out(node.place, "linear_extrude() has a twist or scale that is not finite, left out");
    shape::Extrusion e{};
    e.z0 = what.center ? -what.height / 2 : 0;
    e.z1 = what.center ? what.height / 2 : what.height;
    e.twist_deg = what.twist_deg;
    e.scale_top = {std::max(0.0, what.scale.x), std::max(0.0, what.scale.y)};
    if (e.twist_deg == 0 && e.scale_top == Vec2(1)) {
        e.profile = flat.node;
        return leaf(node, upright(builder_, e), flat.placement);
    }
    e.profile = node_of(flat);
    e.slices = slices_of(node, what, e);
    if (what.segments > 0 && e.slices > 0) e.profile = divided(e, what.segments);
    if (e.twist_deg == 0 && e.scale_top.x == e.scale_top.y && has_curves(builder_, e.profile)) {
        Use made = tapered(builder_, e, flat, {}, {{}, node.place, {}});
        if (made.node == kEmptyNode) return {};
        return {made, Dimension::kSolid};
    }
    return leaf(node, e);
}

// A uniform scale without twist is the same surface in any number of slices.
int Canonicaliser::slices_of(const SceneNode& node, const scene::LinearExtrude& what, const shape::Extrusion& e) {
    if (e.twist_deg == 0 && e.scale_top.x == e.scale_top.y) return 0;
    if (what.slices && *what.slices > 0) return *what.slices;
    const double radius = glm::length(glm::max(glm::abs(builder_.bounds(e.profile).lo), glm::abs(builder_.bounds(e.profile).hi)));
    if (facets_of_circle(node, radius) == 0) return 0;
    const auto contours = contours_of(builder_.so_far(), e.profile, radius * kProfileTolerance);
    return extrusion_slices(contours, what.height, e.twist_deg, e.scale_top, resolution(node));
}

// The profile with more corners along its sides.
NodeId Canonicaliser::divided(const shape::Extrusion& e, int segments) {
    const Bounds box = builder_.bounds(e.profile);
    const auto contours = contours_of(builder_.so_far(), e.profile, std::max(glm::length(box.lo), glm::length(box.hi)) * kProfileTolerance);
    return builder_.shape(shape::Polygon{std::make_shared<const Contours>(with_divided_sides(contours, segments, {e.twist_deg, e.scale_top, e.slices}))});
}

// The part of a profile on one side of the axis as a radius >= 0; empty, with a message, where it lies on both.
Use Canonicaliser::right_of_axis(const SceneNode& node, Use flat, bool& mirrored) {
    mirrored = false;
    Bounds box = builder_.bounds(flat);
    if (box.lo.x >= 0) return flat;
    if (box.hi.x > 0) {
        const double room = kProfileTolerance * std::max(-box.lo.x, box.hi.x);
        double least = 0, most = 0;
        for (const auto& contour : contours_of(builder_.so_far(), node_of(flat), room))
            for (const Vec2& p : contour) {
                least = std::min(least, p.x);
                most = std::max(most, p.x);
            }
        if (least < -room && most > room) {
            diagnostics_.add(Severity::kError, node.place,
                             fmt::format("all points for rotate_extrude() must have the same X coordinate sign (range is {:.2f} -> {:.2f})", least, most));
            something_left_out_ = true;
            return {};
        }
        mirrored = most <= room;
        Use half;  // what rounding left beyond the axis is cut off
        half.node = builder_.shape(mirrored ? shape::Rectangle{{box.lo.x, box.lo.y}, {0, box.hi.y}} : shape::Rectangle{{0, box.lo.y}, {box.hi.x, box.hi.y}});
        Use cut;
        cut.node = builder_.combine(SetOp::kIntersection, {flat, half});
        flat = cut;
    } else {
        mirrored = true;
    }
    if (mirrored) flat = builder_.placed({{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}, flat);
    return flat;
}

// The largest radius of a profile. Only OpenSCAD's rule for $fa and $fs needs more than an upper bound.
double Canonicaliser::radius_of(const SceneNode& node, const Use& flat) {
    const double bound = builder_.bounds(flat).hi.x;
    if (node.facets.fn > 0 || options_.curves != Curves::kFaceted) return bound;
    double radius = 0;
    for (const auto& contour : contours_of(builder_.so_far(), node_of(flat), bound * kProfileTolerance))
        for (const Vec2& p : contour) radius = std::max(radius, p.x);
    return radius;
}

Made Canonicaliser::revolved(SceneNodeId id, const scene::RotateExtrude& what) {
    const SceneNode& node = scene_.nodes[id];
    Use flat = profile(id);
    const double turn = turn_of(what.angle_deg);
    if (flat.node == kEmptyNode || turn == 0) return {};
    bool mirrored = false;
    flat = right_of_axis(node, flat, mirrored);
    if (flat.node == kEmptyNode) return {};
    const bool full = turn == 360;
    const int around = facets_of_circle(node, radius_of(node, flat));
    shape::Revolution r{};
    r.angle_deg = std::fabs(turn);
    r.fragments = around == 0 ? 0 : full ? around : std::max(1, static_cast<int>(around * std::fabs(turn) / 360));
    if (!full || around > 0) r.start_deg = (std::isfinite(what.start_deg) ? what.start_deg : 0) + (mirrored ? 180 : 0) + std::min(turn, 0.0);
    r.start_deg -= 360 * std::floor(r.start_deg / 360);
    // A turned disc beside the axis is a torus.
    const Shape* single = single_shape(builder_, flat.node);
    const auto* disc = single ? std::get_if<shape::Disc>(single) : nullptr;
    if (disc && full && around == 0 && is_translation_in_plane(flat.placement) && flat.placement.offset(0) >= disc->r)
        return leaf(node, shape::Torus{flat.placement.offset(0), disc->r}, Placement::translation({0, 0, flat.placement.offset(1)}));
    r.profile = node_of(flat);
    return leaf(node, r);
}

// The smallest box: by directions where the set knows how far it reaches, else by its corners.
std::optional<Bounds> Canonicaliser::box_of(const Use& use) {
    if (auto box = tight_bounds(builder_.so_far(), use)) return box;
    Bounds box;
    const auto add = [&box](Vec3 p) {
        box = box.empty() ? Bounds{p, p} : Bounds{glm::min(box.lo, p), glm::max(box.hi, p)};
    };
    if (builder_.is_2d(use.node)) {
        for (const auto& ring : outline_of(use))
            for (const Vec2& p : ring) add({p.x, p.y, 0});
    } else if (const auto facets = facets_of_use("resize", use)) {
        for (const Vec3& p : (*facets)->points) add(p);
    }
    if (box.empty()) return std::nullopt;
    return box;
}

Made Canonicaliser::resized(SceneNodeId id, const scene::Resize& what) {
    const SceneNode& node = scene_.nodes[id];
    const std::size_t ghosts_before = ghosts_.size();
    Made made = united(id);
    if (made.dimension == Dimension::kNone) return {};
    const auto box = box_of(made.use);
    if (!box) return left_out(node.place, "resize() of what has no box, left out");
    Vec3 factor(1);
    double largest = 1, largest_size = 0;
    for (int i = 0; i < (made.dimension == Dimension::kFlat ? 2 : 3); ++i) {
        if (!(what.size[i] > 0) || !std::isfinite(what.size[i])) continue;
        factor[i] = what.size[i] / (box->hi[i] - box->lo[i]);
        if (what.size[i] > largest_size) {
            largest_size = what.size[i];
            largest = factor[i];
        }
    }
    for (int i = 0; i < 3; ++i)
        if (what.automatic[static_cast<std::size_t>(i)] && what.size[i] == 0 && (i < 2 || made.dimension == Dimension::kSolid)) factor[i] = largest;
    const Placement scale{{factor.x, 0, 0, 0, 0, factor.y, 0, 0, 0, 0, factor.z, 0}};
    for (int i = 0; i < 3; ++i)
        if (!(factor[i] > 0 && std::isfinite(factor[i]))) return left_out(node.place, "resize() beyond all numbers, left out");
    place_ghosts(ghosts_before, scale);
    made.use = builder_.placed(scale, made.use);
    return made;
}

}  // namespace whittle
