#include "csg/solid/grown_arcs.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/flat_outline.h"
#include "csg/solid/profile.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

constexpr std::size_t kMostSides = 4000;
// Of two sides' directions where they meet, the sine of the angle between: less is no corner but two sides that go on into each other.
constexpr double kSmooth = 0x1p-24;

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

struct PlacedSide {
    Vec2 start;
    const OutlineSide& side;

    Vec2 point(double t) const { return side.centre + side.u * std::cos(t) + side.v * std::sin(t); }
    // Along the side, the set on the left.
    Vec2 direction(bool at_end) const {
        if (!side.curved) return glm::normalize(side.end - start);
        const double t = at_end ? side.to : side.from;
        const Vec2 along = side.v * std::cos(t) - side.u * std::sin(t);
        return glm::normalize(side.to < side.from ? -along : along);
    }
};

class Pieces {
public:
    Pieces(SolidBuilder& builder, double delta) : builder_(builder), reach_(std::fabs(delta)), grows_(delta > 0) {}

    void add(const Outline& outline) {
        std::vector<PlacedSide> sides;
        Vec2 at = outline.start;
        for (const OutlineSide& side : outline.sides) {
            sides.push_back({at, side});
            at = side.end;
        }
        for (std::size_t i = 0; i < sides.size(); ++i) {
            sides[i].side.curved ? add_arc(sides[i]) : add_strip(sides[i].start, sides[i].side.end);
            const bool is_circle = sides.size() == 1;
            if (!is_circle) add_corner(sides[i], sides[(i + 1) % sides.size()]);
        }
    }

    std::vector<Use> uses;

private:
    Use polygon(std::vector<Vec2> corners) {
        return use_of(builder_.shape(shape::Polygon{std::make_shared<const Contours>(Contours{std::move(corners)})}));
    }
    Use disc(Vec2 centre, double r) { return use_of(builder_.shape(shape::Disc{r}), Placement::translation({centre.x, centre.y, 0})); }

    void add_strip(Vec2 a, Vec2 b) {
        const Vec2 out = reach_ / glm::length(b - a) * Vec2(b.y - a.y, a.x - b.x);
        uses.push_back(polygon({a - out, b - out, b + out, a + out}));
    }

    void add_arc(const PlacedSide& arc) {
        const OutlineSide& s = arc.side;
        const double r = glm::length(s.u);
        Use band = disc(s.centre, r + reach_);
        if (r > reach_) band = use_of(builder_.combine(SetOp::kDifference, {band, disc(s.centre, r - reach_)}));
        if (std::fabs(s.turn()) < 2 * M_PI) band = use_of(builder_.combine(SetOp::kIntersection, {band, wedge(arc, 3 * (r + reach_))}));
        uses.push_back(band);
    }

    // From the centre of the arc over all of it, farther out than its band.
    Use wedge(const PlacedSide& arc, double far) {
        constexpr double kStep = M_PI / 3;
        const OutlineSide& s = arc.side;
        const auto out = [&](Vec2 p) { return s.centre + far * glm::normalize(p - s.centre); };
        const int steps = std::max(1, static_cast<int>(std::ceil(std::fabs(s.turn()) / kStep)));
        std::vector<Vec2> corners{s.centre, out(arc.start)};
        for (int i = 1; i < steps; ++i) corners.push_back(out(arc.point(s.from + (s.to - s.from) * i / steps)));
        corners.push_back(out(s.end));
        return polygon(std::move(corners));
    }

    void add_corner(const PlacedSide& before, const PlacedSide& after) {
        const Vec2 in = before.direction(true), on = after.direction(false);
        const double turn = grows_ ? cross(in, on) : -cross(in, on);
        if (turn > kSmooth || (glm::dot(in, on) < 0 && turn > -kSmooth)) uses.push_back(disc(before.side.end, reach_));
    }

    SolidBuilder& builder_;
    const double reach_;
    const bool grows_;
};

// Of a section the sides are chords, though it is not what they say.
bool holds_section(const Solid& solid, NodeId id) {
    if (const auto* c = std::get_if<Combination>(&solid.node(id)))
        return std::any_of(c->operands.begin(), c->operands.end(), [&](const Use& use) { return holds_section(solid, use.node); });
    const auto* polygon = std::get_if<shape::Polygon>(&std::get<Shape>(solid.node(id)));
    return polygon && polygon->section != kEmptyNode;
}

// Was no side lost? The area against that of the outline in chords.
bool is_whole(const SolidBuilder& builder, const Use& flat, const std::vector<Outline>& outlines) {
    const Bounds box = builder.bounds(flat.node);
    const double tolerance = kProfileTolerance * glm::length(box.hi - box.lo);
    double twice = 0, length = 0;
    for (const auto& ring : contours_of(builder.so_far(), flat.node, tolerance))
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            twice += cross(a, b);
            length += glm::length(b - a);
        }
    const Placement& p = flat.placement;
    const double scale = std::fabs(p.linear(0, 0) * p.linear(1, 1) - p.linear(0, 1) * p.linear(1, 0));
    return std::fabs(area_of(outlines) - scale * twice / 2) <= 2 * scale * tolerance * length;
}

}  // namespace

std::optional<Use> grown_by_arcs(SolidBuilder& builder, const Use& flat, double delta) {
    if (holds_section(builder.so_far(), flat.node)) return std::nullopt;
    const std::vector<Outline> outlines = outlines_of(builder.so_far(), flat);
    std::size_t count = 0;
    for (const Outline& o : outlines) {
        count += o.sides.size();
        if (!std::all_of(o.sides.begin(), o.sides.end(), [](const OutlineSide& s) { return !s.quadratic && (!s.curved || s.round()); })) return std::nullopt;
    }
    if (count == 0 || count > kMostSides || !is_whole(builder, flat, outlines)) return std::nullopt;
    Pieces pieces(builder, delta);
    pieces.uses.push_back(flat);
    for (const Outline& o : outlines) pieces.add(o);
    const Use whole = use_of(builder.combine(delta > 0 ? SetOp::kUnion : SetOp::kDifference, std::move(pieces.uses)));
    return delta > 0 || !outlines_of(builder.so_far(), whole).empty() ? whole : use_of(kEmptyNode);
}

}  // namespace whittle
