// canonicalise_sum.cpp — minkowski(): the true body where both operands are convex, else a union of sums.
//
// In this order: sums distribute over unions; a ball rounds the faces, edges and corners of a solid of facets; operands are covered by convex pieces, of which each two
// have a true or a flat-sided sum; what has facets only adds each of them to the other operand.

#include <algorithm>
#include <cmath>

#include "csg/eval/canonicaliser.h"
#include "csg/solid/convex_body.h"
#include "csg/solid/convex_cover.h"
#include "csg/solid/convex_hull.h"
#include "csg/solid/convex_parts.h"
#include "csg/solid/exact_hull.h"
#include "csg/solid/facet_operations.h"
#include "csg/solid/rounded.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// Pieces of a sum beyond which it would take hours to combine them.
constexpr std::size_t kMostPieces = 20000;
// Pieces of one operand, and of both together with finer chords: more are made again with coarser ones.
constexpr std::size_t kMostOfOne = 2000, kManyPieces = 100;
// Of a sum's size: chord errors of operands that are cut.
constexpr double kFine = 0x1p-11, kCoarse = 0x1p-10;
// Parts of a convex body beyond which each ray would take longer than through flat facets, and of one to add to a facet.
constexpr std::size_t kMostParts = 2000, kFewParts = 64, kFewPartsOfOne = 16;
// Corners of what adds to something else.
constexpr std::size_t kMostCorners = 4000;

double size_of(const Bounds& box) { return glm::length(box.hi - box.lo); }

std::optional<Ball> ball_of(const SolidBuilder& builder, const Use& use) {
    const auto balls = balls_of(builder.so_far(), use);
    return balls && balls->size() == 1 && (*balls)[0].r > 0 ? std::optional((*balls)[0]) : std::nullopt;
}

// One convex shape, so that its hull is itself.
bool is_flat_convex(const Solid& solid, NodeId id) {
    if (const auto* c = std::get_if<Combination>(&solid.node(id))) return c->operands.size() == 1 && is_flat_convex(solid, c->operands[0].node);
    const auto& shape = std::get<Shape>(solid.node(id));
    const auto* polygon = std::get_if<shape::Polygon>(&shape);
    if (polygon) return polygon->contours->size() == 1 && convex_hull_of(polygon->contours->front()).size() == polygon->contours->front().size();
    return std::holds_alternative<shape::Disc>(shape) || std::holds_alternative<shape::Rectangle>(shape);
}

}  // namespace

bool Canonicaliser::is_convex(const Use& use) {
    if (use.motion != 0) return false;
    if (convex_.count(use.node) != 0) return true;
    if (const auto* c = std::get_if<Combination>(&builder_.node(use.node)); c && c->operands.size() == 1) {
        const Use inner = c->operands[0];
        return is_convex(inner);
    }
    return is_known_convex(builder_, use);
}

std::optional<Use> Canonicaliser::convex_sum(const Use& a, const Use& b) {
    if (!is_convex(a) || !is_convex(b)) return std::nullopt;
    const auto p = convex_parts_of(builder_.so_far(), a), q = convex_parts_of(builder_.so_far(), b);
    if (!p || !q || p->size() * q->size() > kMostParts) return std::nullopt;
    Use sum = use_of(builder_.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(without_hidden_parts(sums_of(*p, *q)))}));
    convex_.insert(sum.node);
    return sum;
}

// The operands of a union, in the frame above it; nothing for what is one piece.
std::optional<std::vector<Use>> Canonicaliser::parts_of_union(const Use& use) {
    const auto* c = std::get_if<Combination>(&builder_.node(use.node));
    if (!c || c->op != SetOp::kUnion || use.motion != 0) return std::nullopt;
    std::vector<Use> parts = c->operands;
    for (Use& part : parts) {
        part = builder_.placed(use.placement, part);
        part.label = kNoLabel;
    }
    return parts;
}

Result<Use> Canonicaliser::sum_of_each(const std::vector<Use>& parts, const Use& other) {
    std::vector<Use> sums;
    for (const Use& part : parts) {
        auto sum = sum_of(part, other);
        if (!sum) return sum;
        sums.push_back(*sum);
    }
    return use_of(builder_.combine(SetOp::kUnion, std::move(sums)));
}

// By a ball: a ring has a thicker tube, what has facets is rounded.
std::optional<Use> Canonicaliser::rounded(const Use& a, const Use& b) {
    const auto ball = ball_of(builder_, b);
    if (!ball) return std::nullopt;
    const Shape* shape = std::get_if<Shape>(&builder_.node(a.node));
    if (const auto* ring = shape && a.motion == 0 ? std::get_if<shape::Torus>(shape) : nullptr) {
        const auto scale = similarity_of(a.placement, false);
        if (!scale) return std::nullopt;
        return builder_.placed(Placement::translation(ball->c), use_of(builder_.shape(shape::Torus{ring->major, ring->minor + ball->r / *scale}), a.placement));
    }
    const auto facets = facets_of_use("minkowski", a);
    return facets ? rounded_by_ball(builder_, **facets, ball->c, ball->r, kMostPieces) : std::nullopt;
}

// Of two convex pieces. A true body is for pieces that are true themselves: rays meet flat facets many times as fast.
std::optional<Use> Canonicaliser::body_of(const Use& a, const Use& b, double tolerance, Pieces pieces) {
    const auto p = convex_parts_of(builder_.so_far(), a), q = convex_parts_of(builder_.so_far(), b);
    if (!p || !q) return std::nullopt;
    if (p->size() * q->size() <= kFewParts) {
        if (const auto exact = exact_minkowski(builder_, a, b)) return exact;
        if (pieces == Pieces::kTrue) return use_of(builder_.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(without_hidden_parts(sums_of(*p, *q)))}));
    }
    const auto left = corners_within(*p, tolerance, kMostCorners), right = corners_within(*q, tolerance, kMostCorners);
    if (!left || !right) return std::nullopt;
    auto hull = sum_of_hulls(*left, *right);
    if (!hull) return std::nullopt;
    return use_of(builder_.shape(shape::Polyhedron{std::make_shared<const FacetList>(std::move(*hull))}));
}

std::optional<Use> Canonicaliser::sum_of_covers(const Use& a, const Use& b) {
    const double size = size_of(builder_.bounds(a)) + size_of(builder_.bounds(b));
    for (const double share : {kFine, kCoarse}) {
        const CoverOptions options{share * size, kMostOfOne, [this](const Use& use) { return is_convex(use); }};
        const auto left = convex_cover(builder_, a, options), right = left ? convex_cover(builder_, b, options) : std::nullopt;
        if (!right || left->pieces.size() * right->pieces.size() > (share == kCoarse ? kMostPieces : kManyPieces)) continue;
        const bool chords = left->chords || right->chords;
        std::vector<Use> sums;
        for (const Use& p : left->pieces)
            for (const Use& q : right->pieces) {
                const auto body = body_of(p, q, options.tolerance, chords ? Pieces::kChords : Pieces::kTrue);
                if (!body) return std::nullopt;
                sums.push_back(*body);
            }
        if (chords) fallbacks_.emplace("minkowski", 0).first->second++;
        return use_of(builder_.combine(SetOp::kUnion, std::move(sums)));
    }
    return std::nullopt;
}

// A point of the convex one, which bends, moves the other; each facet of that adds the convex one.
std::optional<Use> Canonicaliser::sum_of_facets(const Use& convex, const Use& other) {
    const auto parts = convex_parts_of(builder_.so_far(), convex);
    if (!parts || std::all_of(parts->begin(), parts->end(), [](const ConvexPart& part) { return part.images.empty(); })) return std::nullopt;
    const auto list = facets_of_use("minkowski", other);
    if (!list || (*list)->facets.size() > kMostPieces) return std::nullopt;
    const bool few = (*list)->facets.size() <= kManyPieces && parts->size() <= kFewPartsOfOne;
    const double size = size_of(builder_.bounds(convex)) + size_of(builder_.bounds(other));
    const auto points = corners_within(*parts, kCoarse * size, kMostCorners);
    if (!points) return std::nullopt;
    std::vector<Use> sums{use_of(builder_.shape(shape::Polyhedron{*list}), Placement::translation(middle_of(*parts)))};
    for (const auto& facet : (*list)->facets) {
        ConvexParts corners;
        std::vector<Vec3> places;
        for (const std::uint32_t i : facet) {
            corners.push_back({(*list)->points[i], {}});
            places.push_back((*list)->points[i]);
        }
        if (few) sums.push_back(use_of(builder_.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(without_hidden_parts(sums_of(corners, *parts)))})));
        else if (auto hull = sum_of_hulls(places, *points)) sums.push_back(use_of(builder_.shape(shape::Polyhedron{std::make_shared<const FacetList>(std::move(*hull))})));
    }
    return use_of(builder_.combine(SetOp::kUnion, std::move(sums)));
}

Result<Use> Canonicaliser::sum_of_lists(const Use& a, const Use& b) {
    const auto left = facets_of_use("minkowski", a), right = facets_of_use("minkowski", b);
    if (!left) return tl::unexpected(left.error());
    if (!right) return tl::unexpected(right.error());
    auto parts = minkowski_parts(**left, **right, kMostPieces);
    if (!parts) return fail(Fault::kScene, "an operand is flat, or the sum would have too many parts");
    std::vector<Use> uses;
    for (FacetList& part : *parts) uses.push_back(use_of(builder_.shape(shape::Polyhedron{std::make_shared<const FacetList>(std::move(part))})));
    return use_of(builder_.combine(SetOp::kUnion, std::move(uses)));
}

Result<Use> Canonicaliser::flat_sum(const Use& a, const Use& b) {
    auto sum = flat_minkowski(outline_of(a), outline_of(b), kMostPieces);
    if (!sum) return fail(Fault::kScene, "too many parts");
    if (sum->empty()) return Use{};
    if (!has_corners_only(a.node) || !has_corners_only(b.node)) {
        const bool convex = is_flat_convex(builder_.so_far(), a.node) && is_flat_convex(builder_.so_far(), b.node);
        const auto p = parts_of_all({a}), q = parts_of_all({b});
        if (const auto body = convex && p && q ? flat_body(sums_of(*p, *q), *sum) : std::nullopt) return *body;
        fallbacks_.emplace("minkowski", 0).first->second++;
    }
    return use_of(builder_.shape(shape::Polygon{std::make_shared<const Contours>(std::move(*sum))}));
}

Result<Use> Canonicaliser::sum_of(const Use& a, const Use& b) {
    if (const auto exact = exact_minkowski(builder_, a, b)) {
        if (!builder_.is_2d(a.node)) convex_.insert(exact->node);
        return *exact;
    }
    if (builder_.is_2d(a.node)) return flat_sum(a, b);
    const std::pair operands{node_of(a), node_of(b)};
    if (const auto known = sums_.find(operands); known != sums_.end()) return known->second;
    auto sum = sum_without_form(a, b);
    if (sum) sums_.emplace(operands, *sum);
    return sum;
}

Result<Use> Canonicaliser::sum_without_form(const Use& a, const Use& b) {
    if (const auto convex = convex_sum(a, b)) return *convex;
    const auto left = is_convex(a) ? std::nullopt : parts_of_union(a), right = is_convex(b) ? std::nullopt : parts_of_union(b);
    if ((left ? left->size() : 1) * (right ? right->size() : 1) > kMostPieces) return fail(Fault::kScene, "the sum would have too many parts");
    if (left) return sum_of_each(*left, b);
    if (right) return sum_of_each(*right, a);
    for (const auto& [ball, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
        if (const auto sum = rounded(*other, *ball)) return *sum;
    if (const auto sum = sum_of_covers(a, b)) return *sum;
    for (const auto& [convex, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
        if (is_convex(*convex))
            if (const auto sum = sum_of_facets(*convex, *other)) return *sum;
    return sum_of_lists(a, b);
}

Made Canonicaliser::summed(SceneNodeId id) {
    const SceneNode& node = scene_.nodes[id];
    const Operands operands = bare_operands(id);
    if (operands.uses.empty()) return {};
    Use sum = operands.uses[0];
    for (std::size_t i = 1; i < operands.uses.size(); ++i) {
        const auto next = sum_of(sum, operands.uses[i]);
        if (!next) return left_out(node.place, "minkowski() cannot be made, left out", next.error().message);
        sum = *next;
    }
    return owned(node, sum);
}

}  // namespace whittle
