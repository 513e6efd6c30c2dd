// drawn_set.cpp — drawings as 2D sets. A contour with curves is the polygon of its chords, united with the segments (between a curve and its chord) that bulge
// out of it and less those that bulge into it; curves are halved until no segment reaches another side, so that this is the set itself. Arcs are those of
// discs, quadratic Bezier curves those of parabolas; cubic ones become several quadratic ones.
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "csg/base/degrees.h"
#include "csg/eval/imports.h"
#include "csg/solid/facets.h"
#include "csg/solid/parabola.h"
#include "csg/solid/predicates.h"
#include "csg/solid/profile.h"

namespace whittle {
namespace {

// How far the quadratic curves that stand for a cubic one are from it, of the drawing's size.
constexpr double kCubicTolerance = kProfileTolerance / 8;
// What overlaps by no more of its size, by rounding, only touches.
constexpr double kTouching = 0x1p-40;
// Halvings of a curve at most: pieces of a 64th of it.
constexpr int kMostHalvings = 6;
// Centres and radii of arcs of one circle differ by the rounding of their ends.
constexpr double kSameCircle = 0x1p-40;
// An angle that went through a tangent and back must not count one facet more.
constexpr double kCountSlack = 0x1p-32;

// A side with both ends: straight, an arc where bulge is not 0, or a quadratic Bezier curve with that control point.
struct Side {
    Vec2 a, b;
    double bulge = 0;
    std::optional<Vec2> control;
    bool is_straight() const { return bulge == 0 && !control; }
};
using Sides = std::vector<Side>;
using Quad = std::array<Vec2, 4>;

Vec2 right_of(Vec2 v) { return {v.y, -v.x}; }
double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

double radius_of(const Side& s) { return glm::length(s.b - s.a) * (1 + s.bulge * s.bulge) / (4 * std::fabs(s.bulge)); }
// From an arc's chord to its middle: an arc that turns left bulges to the right.
Vec2 rise_of(const Side& s) { return right_of(s.b - s.a) * (s.bulge / 2); }
Vec2 middle_of(const Side& s) { return (s.a + s.b) / 2.0 + rise_of(s); }
Vec2 centre_of(const Side& s) { return (s.a + s.b) / 2.0 - right_of(s.b - s.a) * ((1 - s.bulge * s.bulge) / (4 * s.bulge)); }
shape::ParabolicSegment parabola_of(const Side& s) { return {s.a, *s.control, s.b}; }
// Does the side bulge to the right of its chord?
bool is_right(const Side& s) { return s.control ? cross(s.b - s.a, *s.control - s.a) < 0 : s.bulge > 0; }

std::pair<Side, Side> halves_of(const Side& s) {
    if (s.control) {
        const auto [first, second] = parabola_halves(parabola_of(s));
        return {{first.a, first.b, 0, first.c}, {second.a, second.b, 0, second.c}};
    }
    const double half = s.bulge / (1 + std::sqrt(1 + s.bulge * s.bulge));  // tan of half the angle
    const Vec2 m = middle_of(s);
    return {{s.a, m, half, {}}, {m, s.b, half, {}}};
}

// Convex, around a side and its chord: of a Bezier curve up to its tangent along the chord.
Quad box_of(const Side& s) {
    if (s.control) return {s.a, s.b, (*s.control + s.b) / 2.0, (s.a + *s.control) / 2.0};
    return {s.a, s.b, s.b + rise_of(s), s.a + rise_of(s)};
}

Vec2 bezier_point(const Vec2& start, const DrawnSide& side, double t) {
    std::array<Vec2, 4> p{start, side.p[0], side.p[1], side.p[2]};
    for (int n = side.degree; n > 0; --n)
        for (int i = 0; i < n; ++i) p[static_cast<std::size_t>(i)] = glm::mix(p[static_cast<std::size_t>(i)], p[static_cast<std::size_t>(i + 1)], t);
    return p[0];
}

class Drawer {
public:
    Drawer(SolidBuilder& builder, const Drawing& drawing, const FacetsOfCircle& facets) : builder_(builder), drawing_(drawing), facets_(facets) {
        Vec2 lo(HUGE_VAL), hi(-HUGE_VAL);
        for (const auto& figure : drawing.figures)
            for (const auto& contour : figure.contours)
                for (const auto& side : contour.sides) lo = glm::min(lo, side.end()), hi = glm::max(hi, side.end());
        size_ = drawing.figures.empty() ? 0 : glm::length(hi - lo);
    }

    Use set() {
        std::vector<Use> figures;
        for (const auto& figure : drawing_.figures)
            if (const Use use = figure_set(figure); use.node != kEmptyNode) figures.push_back(use);
        return of(SetOp::kUnion, std::move(figures));
    }

private:
    Use of(SetOp op, std::vector<Use> operands) {
        if (operands.size() == 1) return operands[0];
        Use use;
        use.node = builder_.combine(op, std::move(operands));
        return use;
    }
    Use of(Shape shape, const Placement& placement = {}) {
        Use use;
        use.node = builder_.shape(std::move(shape));
        use.placement = placement;
        return use;
    }

    Sides sides_of(const DrawnContour& contour) const {
        Sides out;
        Vec2 at = contour.start;
        const auto line_to = [&](Vec2 to) {
            if (to != at) out.push_back({at, to, 0, {}});
            at = to;
        };
        for (std::size_t i = 0; i < contour.sides.size(); ++i) {
            const DrawnSide& side = contour.sides[i];
            const Side arc{at, side.end(), side.bulge, {}};
            if (side.degree > 1) {
                const int asked = facets_(size_);
                const Vec2 start = at;
                const int n = std::max(2, asked / 8 + 1);
                for (int k = 1; asked > 0 && k <= n; ++k) line_to(k == n ? side.end() : bezier_point(start, side, 1.0 * k / n));
                if (asked == 0) add_bezier(out, start, side);
                at = side.end();
            } else if (side.bulge == 0 || arc.a == arc.b) {
                line_to(side.end());
            } else if (const int n = facets_(radius_of(arc)); n > 0) {
                // Arcs that go on along the same circle are one.
                double turn_deg = angle_deg(arc);
                for (Vec2 from = arc.b; i + 1 < contour.sides.size(); ++i, from = contour.sides[i].end()) {
                    const Side next{from, contour.sides[i + 1].end(), contour.sides[i + 1].bulge, {}};
                    if (contour.sides[i + 1].degree > 1 || !same_circle(arc, next)) break;
                    turn_deg += angle_deg(next);
                }
                add_chords(arc, turn_deg, contour.sides[i].end(), n, line_to);
            } else {
                add_arc(out, arc);
                at = side.end();
            }
        }
        line_to(contour.start);
        return out.size() == 2 ? with_area(out) : out;
    }

    // The chords of two curves enclose nothing: which side of them is within shows once they are halved.
    static Sides with_area(const Sides& lens) {
        Sides out;
        for (const Side& side : lens) {
            if (side.bulge == 0 && !side.control) {
                out.push_back(side);
                continue;
            }
            const auto [first, second] = halves_of(side);
            out.insert(out.end(), {first, second});
        }
        return out;
    }

    // Halved until a piece turns by 90 degrees at most.
    static void add_arc(Sides& out, const Side& arc) {
        if (std::fabs(arc.bulge) <= std::sqrt(2.0) - 1 + 0x1p-40) {
            out.push_back(arc);
            return;
        }
        const auto [first, second] = halves_of(arc);
        add_arc(out, first);
        add_arc(out, second);
    }
    void add_bezier(Sides& out, Vec2 start, const DrawnSide& side) const {
        const auto add = [&out](const shape::ParabolicSegment& s) {
            const bool is_straight = turn_of(s.a, s.c, s.b) == 0;
            if (s.a != s.b) out.push_back({s.a, s.b, 0, is_straight ? std::nullopt : std::optional(s.c)});
        };
        if (side.degree == 2) return add({start, side.p[0], side.p[1]});
        for (const auto& part : parabolas_of_cubic({start, side.p[0], side.p[1], side.p[2]}, size_ * kCubicTolerance)) add(part);
    }
    static double angle_deg(const Side& arc) { return 4 * std::atan(arc.bulge) / kRadiansPerDegree; }
    static bool same_circle(const Side& a, const Side& b) {
        if (a.bulge == 0 || b.bulge == 0 || (a.bulge > 0) != (b.bulge > 0) || b.a == b.b) return false;
        return glm::length(centre_of(a) - centre_of(b)) + std::fabs(radius_of(a) - radius_of(b)) <= kSameCircle * (glm::length(centre_of(a)) + radius_of(a));
    }
    // From arc.a by `turn_deg` around the arc's centre to `end`.
    template <class LineTo>
    static void add_chords(const Side& arc, double turn_deg, Vec2 end, int around, LineTo line_to) {
        const int n = std::max(1, static_cast<int>(std::ceil(around * std::fabs(turn_deg) / 360 - kCountSlack)));
        const Vec2 c = centre_of(arc), from = arc.a - c;
        for (int i = 1; i < n; ++i) {
            const double turn = turn_deg * i / n;
            line_to(c + Vec2(from.x * cosd(turn) - from.y * sind(turn), from.x * sind(turn) + from.y * cosd(turn)));
        }
        line_to(end);
    }

    // A contour of arcs about one centre, all turning one way: the disc it is.
    std::optional<std::pair<Vec2, double>> circle_of(const DrawnContour& contour) const {
        if (contour.sides.size() < 2) return std::nullopt;
        Vec2 at = contour.start, centre(0);
        double turned = 0, radius = 0;
        for (std::size_t i = 0; i < contour.sides.size(); ++i) {
            const DrawnSide& side = contour.sides[i];
            const Side arc{at, side.end(), side.bulge, {}};
            if (side.degree > 1 || side.bulge == 0 || arc.a == arc.b) return std::nullopt;
            if (i == 0) centre = centre_of(arc), radius = radius_of(arc);
            if (glm::length(centre_of(arc) - centre) + std::fabs(radius_of(arc) - radius) > kSameCircle * (glm::length(centre) + radius)) return std::nullopt;
            turned += 4 * std::atan(side.bulge);
            at = side.end();
        }
        constexpr double kTurn = 6.283185307179586;
        if (at != contour.start || std::fabs(std::fabs(turned) - kTurn) > 0x1p-40) return std::nullopt;
        return std::pair(centre, radius);
    }

    Use figure_set(const DrawnFigure& figure) {
        std::vector<Sides> contours;
        std::vector<Use> discs;
        for (const auto& contour : figure.contours) {
            const auto circle = circle_of(contour);
            if (circle && facets_(circle->second) == 0 && figure.contours.size() == 1)
                return of(shape::Disc{circle->second}, Placement::translation({circle->first.x, circle->first.y, 0}));
            Sides sides = sides_of(contour);
            if (sides.size() >= 2) contours.push_back(std::move(sides));
        }
        if (contours.empty()) return {};
        if (figure.contours.size() == 2 && contours.size() == 2)
            if (const auto ring = ring_of(figure)) return *ring;
        part(contours);
        return set_of(contours);
    }

    // Two full circles, one in the other.
    std::optional<Use> ring_of(const DrawnFigure& figure) {
        auto a = circle_of(figure.contours[0]), b = circle_of(figure.contours[1]);
        if (!a || !b || facets_(a->second) > 0 || facets_(b->second) > 0) return std::nullopt;
        if (a->second < b->second) std::swap(a, b);
        if (!(glm::length(a->first - b->first) + b->second < a->second)) return std::nullopt;
        const auto disc = [&](const auto& circle) { return of(shape::Disc{circle.second}, Placement::translation({circle.first.x, circle.first.y, 0})); };
        return of(SetOp::kDifference, {disc(*a), disc(*b)});
    }

    // Do two convex boxes not meet, but for touching? By the directions across the sides of both.
    static bool apart(const Quad& p, const Quad& q, Vec2 direction) {
        double p_lo = HUGE_VAL, p_hi = -HUGE_VAL, q_lo = HUGE_VAL, q_hi = -HUGE_VAL;
        for (std::size_t i = 0; i < 4; ++i) {
            const double x = glm::dot(p[i], direction), y = glm::dot(q[i], direction);
            p_lo = std::min(p_lo, x), p_hi = std::max(p_hi, x), q_lo = std::min(q_lo, y), q_hi = std::max(q_hi, y);
        }
        const double room = kTouching * std::max(p_hi - p_lo, q_hi - q_lo);
        return p_hi <= q_lo + room || q_hi <= p_lo + room;
    }
    static bool may_meet(const Side& s, const Side& t) {
        const auto p = box_of(s), q = box_of(t);
        for (const Quad* box : {&p, &q})
            for (std::size_t i = 0; i < 4; ++i) {
                const Vec2 along = (*box)[(i + 1) % 4] - (*box)[i];
                if (along != Vec2(0) && apart(p, q, right_of(along))) return false;
            }
        return true;
    }

    // Halves every curve whose segment may reach another side.
    static void part(std::vector<Sides>& contours) {
        for (int round = 0; round < kMostHalvings; ++round) {
            const auto reaching = reaching_curves(contours);
            bool parted = false;
            for (std::size_t c = 0; c < contours.size(); ++c) {
                const Sides now = std::exchange(contours[c], {});
                for (std::size_t i = 0; i < now.size(); ++i) {
                    if (!reaching[c][i]) {
                        contours[c].push_back(now[i]);
                        continue;
                    }
                    const auto [first, second] = halves_of(now[i]);
                    contours[c].push_back(first);
                    contours[c].push_back(second);
                    parted = true;
                }
            }
            if (!parted) return;
        }
    }

    // Sides sorted by where they begin in x: each is held against those that begin before it ends.
    static std::vector<std::vector<bool>> reaching_curves(const std::vector<Sides>& contours) {
        struct Boxed { Vec2 lo, hi; std::size_t contour, side; };
        std::vector<Boxed> boxed;
        std::vector<std::vector<bool>> reaching;
        for (std::size_t c = 0; c < contours.size(); ++c) {
            reaching.emplace_back(contours[c].size(), false);
            for (std::size_t i = 0; i < contours[c].size(); ++i) {
                const auto box = box_of(contours[c][i]);
                boxed.push_back({glm::min(glm::min(box[0], box[1]), glm::min(box[2], box[3])), glm::max(glm::max(box[0], box[1]), glm::max(box[2], box[3])), c, i});
            }
        }
        std::sort(boxed.begin(), boxed.end(), [](const Boxed& a, const Boxed& b) { return std::tie(a.lo.x, a.contour, a.side) < std::tie(b.lo.x, b.contour, b.side); });
        for (std::size_t i = 0; i < boxed.size(); ++i)
            for (std::size_t k = i + 1; k < boxed.size() && boxed[k].lo.x <= boxed[i].hi.x; ++k) {
                const Boxed &a = boxed[i], &b = boxed[k];
                if (a.lo.y > b.hi.y || b.lo.y > a.hi.y) continue;
                const Side &s = contours[a.contour][a.side], &t = contours[b.contour][b.side];
                if ((s.is_straight() && t.is_straight()) || !may_meet(s, t)) continue;
                if (!s.is_straight()) reaching[a.contour][a.side] = true;
                if (!t.is_straight()) reaching[b.contour][b.side] = true;
            }
        return reaching;
    }
    // Is a point just right of the chord's middle inside the polygon of all chords?
    static bool inside_right_of(const std::vector<Sides>& contours, const Side& s) {
        const Vec2 m = (s.a + s.b) / 2.0, out = right_of(s.b - s.a);
        bool inside = false;
        for (const Sides& sides : contours)
            for (const Side& t : sides) {
                if (&t == &s) continue;
                // Crossed by the half-line from m along `out`?
                const double ha = cross(out, t.a - m), hb = cross(out, t.b - m);
                if ((ha < 0) == (hb < 0)) continue;
                const double at = glm::dot(t.a - m, out) + (glm::dot(t.b - m, out) - glm::dot(t.a - m, out)) * (ha / (ha - hb));
                inside ^= at > 0;
            }
        return inside;
    }

    Use set_of(const std::vector<Sides>& contours) {
        auto polygon = std::make_shared<Contours>();
        std::vector<Use> more{{}}, less{{}};
        for (const Sides& sides : contours) {
            if (sides.size() >= 3) {
                auto& points = polygon->emplace_back();
                for (const Side& s : sides) points.push_back(s.a);
            }
            for (const Side& s : sides) {
                if (s.is_straight()) continue;
                (inside_right_of(contours, s) == is_right(s) ? less : more).push_back(segment(s));
            }
        }
        if (!polygon->empty()) more[0] = of(shape::Polygon{std::move(polygon)});
        else more.erase(more.begin());
        less[0] = of(SetOp::kUnion, std::move(more));
        return less.size() == 1 ? less[0] : of(SetOp::kDifference, std::move(less));
    }

    // Between the chord and the curve; an arc's strip is twice as high, so that only the chord and the arc bound it.
    Use segment(const Side& side) {
        if (side.control) return of(parabola_of(side));
        const Side s = side.bulge > 0 ? side : Side{side.b, side.a, -side.bulge, {}};
        const Vec2 rise = 2.0 * rise_of(s), c = centre_of(s);
        const Use strip = of(shape::Polygon{std::make_shared<const Contours>(Contours{{s.a, s.a + rise, s.b + rise, s.b}})});
        return of(SetOp::kIntersection, {of(shape::Disc{radius_of(s)}, Placement::translation({c.x, c.y, 0})), strip});
    }

    SolidBuilder& builder_;
    const Drawing& drawing_;
    const FacetsOfCircle& facets_;
    double size_ = 0;
};

}  // namespace

Use drawn_set(SolidBuilder& builder, const Drawing& drawing, const FacetsOfCircle& facets) { return Drawer(builder, drawing, facets).set(); }

}  // namespace whittle
