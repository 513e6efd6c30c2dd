#include "csg/solid/flat_outline.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/solid/parabola.h"
#include "csg/solid/flat_curves.h"

namespace whittle {
namespace {

using Index = std::uint32_t;
constexpr double kTurn = 6.283185307179586;
// How far beside a piece the set is asked, against the distance at which points are one.
constexpr double kBeside = 32;

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// Points that are nearer than the tolerance are one: the first.
class Points {
public:
    explicit Points(double tolerance) : tolerance_(tolerance), cell_(4 * tolerance) {}
    Index number(Vec2 p) {
        const auto [cx, cy] = cell(p);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto found = cells_.find({cx + dx, cy + dy});
                if (found == cells_.end()) continue;
                for (const Index i : found->second)
                    if (glm::length(points_[i] - p) <= tolerance_) return i;
            }
        points_.push_back(p);
        cells_[{cx, cy}].push_back(static_cast<Index>(points_.size() - 1));
        return static_cast<Index>(points_.size() - 1);
    }
    Vec2 operator[](Index i) const { return points_[i]; }

private:
    std::pair<std::int64_t, std::int64_t> cell(Vec2 p) const { return {static_cast<std::int64_t>(std::floor(p.x / cell_)), static_cast<std::int64_t>(std::floor(p.y / cell_))}; }
    double tolerance_, cell_;
    std::vector<Vec2> points_;
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Index>> cells_;
};

// Part of a curve between two points, with the set on its left.
struct Piece {
    Index from, to, curve;
    double t0, t1;  // t1 < t0: against the curve's direction
};

class Tracer {
public:
    Tracer(const Solid& solid, const Use& use) : set_(solid, use), size_(size_of(set_)), points_(size_ * kOutlineJoin) {}

    std::vector<Outline> run() {
        if (!(size_ > 0)) return {};
        cut();
        for (Index c = 0; c < set_.curves().size(); ++c) keep_borders(c);
        return chained();
    }

private:
    static double size_of(const FlatSet& set) {
        double size = 0;
        for (const FlatCurve& c : set.curves()) size = std::max({size, std::fabs(c.lo.x), std::fabs(c.lo.y), std::fabs(c.hi.x), std::fabs(c.hi.y)});
        return std::isfinite(size) ? size : 0;
    }

    void cut() {
        const auto& curves = set_.curves();
        cuts_.resize(curves.size());
        for (Index i = 0; i < curves.size(); ++i) {
            // Corners first, so that they keep their bits; an ellipse begins and turns back on its axis.
            for (const double t : {0.0, curves[i].curved ? kTurn / 2 : 1.0}) cuts_[i].push_back({t, points_.number(curves[i].curved ? curves[i].at(t) : t == 0 ? curves[i].a : curves[i].b)});
        }
        std::vector<Index> order(curves.size());
        for (Index i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](Index a, Index b) { return curves[a].lo.x != curves[b].lo.x ? curves[a].lo.x < curves[b].lo.x : a < b; });
        const double tolerance = size_ * kOutlineJoin;
        std::vector<Vec2> met;
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t k = i + 1; k < order.size() && curves[order[k]].lo.x <= curves[order[i]].hi.x + tolerance; ++k) {
                met.clear();
                meetings(curves[order[i]], curves[order[k]], tolerance, met);
                for (const Vec2& p : met) {
                    const Index number = points_.number(p);
                    for (const Index c : {order[i], order[k]}) cuts_[c].push_back({curves[c].parameter(points_[number]), number});
                }
            }
    }

    void keep_borders(Index c) {
        const FlatCurve& curve = set_.curves()[c];
        auto cuts = cuts_[c];
        std::sort(cuts.begin(), cuts.end());
        cuts.erase(std::unique(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.second == b.second; }), cuts.end());
        if (curve.curved) {
            if (cuts.size() > 1 && cuts.front().second == cuts.back().second) cuts.pop_back();
            cuts.push_back({cuts.front().first + kTurn, cuts.front().second});
        }
        const double beside = kBeside * size_ * kOutlineJoin;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            Piece piece{cuts[i].second, cuts[i + 1].second, c, cuts[i].first, cuts[i + 1].first};
            const double middle = (piece.t0 + piece.t1) / 2;
            const Vec2 at = curve.at(middle), along = glm::normalize(curve.along(middle)), left{-along.y, along.x};
            const bool in_left = set_.contains(at + left * beside), in_right = set_.contains(at - left * beside);
            if (in_left == in_right || is_known(piece, at)) continue;
            if (in_right) std::swap(piece.from, piece.to), std::swap(piece.t0, piece.t1);
            leaving_[piece.from].push_back(static_cast<Index>(pieces_.size()));
            pieces_.push_back(piece);
        }
    }

    // Sides of several leaves may lie on each other: one is enough.
    bool is_known(const Piece& piece, Vec2 middle) {
        auto& known = middles_[{std::min(piece.from, piece.to), std::max(piece.from, piece.to)}];
        // Middles of the same piece differ by the tolerance of its ends and what bends between them.
        for (const Vec2& p : known)
            if (glm::length(p - middle) <= 4 * size_ * kOutlineJoin) return true;
        known.push_back(middle);
        return false;
    }

    Vec2 direction_at(const Piece& piece, double t) const {
        const Vec2 along = set_.curves()[piece.curve].along(t);
        return piece.t1 < piece.t0 ? -along : along;
    }

    // The piece that goes on where this one ends: the one furthest to the left, so that parts that touch in a point stay apart.
    Index next_of(Index piece, const std::vector<bool>& used) const {
        const Vec2 back = -direction_at(pieces_[piece], pieces_[piece].t1);
        Index best = static_cast<Index>(pieces_.size());
        double least = HUGE_VAL;
        const auto found = leaving_.find(pieces_[piece].to);
        if (found == leaving_.end()) return best;
        for (const Index i : found->second) {
            if (used[i]) continue;
            const Vec2 ahead = direction_at(pieces_[i], pieces_[i].t0);
            double angle = -std::atan2(cross(back, ahead), glm::dot(back, ahead));  // clockwise from where we came
            if (angle <= 0) angle += kTurn;
            if (angle < least) least = angle, best = i;
        }
        return best;
    }

    std::vector<Outline> chained() {
        std::vector<Outline> out;
        std::vector<bool> used(pieces_.size());
        for (Index first = 0; first < pieces_.size(); ++first) {
            if (used[first]) continue;
            std::vector<Index> chain;
            for (Index i = first; i < pieces_.size(); i = next_of(i, used)) {
                used[i] = true;
                chain.push_back(i);
                if (pieces_[i].to == pieces_[first].from) break;
            }
            if (pieces_[chain.back()].to == pieces_[first].from) out.push_back(outline_of(chain));
        }
        std::sort(out.begin(), out.end(), [](const Outline& a, const Outline& b) { return a.start.x != b.start.x ? a.start.x < b.start.x : a.start.y < b.start.y; });
        return out;
    }

    // Do two pieces in a row lie on one line, ellipse or parabola?
    bool same_support(const Piece& p, const Piece& q) const {
        const FlatCurve &a = set_.curves()[p.curve], &b = set_.curves()[q.curve];
        if (a.curved != b.curved || a.quadratic != b.quadratic) return false;
        if (a.quadratic) return a.a == b.a && a.c == b.c && a.b == b.b && (p.t1 > p.t0) == (q.t1 > q.t0);
        if (a.curved) return a.centre == b.centre && a.u == b.u && a.v == b.v && (p.t1 > p.t0) == (q.t1 > q.t0);
        const Vec2 corner = points_[q.from], d = points_[p.from] - corner, e = points_[q.to] - corner;
        return std::fabs(cross(d, e)) <= size_ * kOutlineJoin * glm::length(e - d) && glm::dot(d, e) < 0;
    }

    Outline outline_of(std::vector<Index> chain) const {
        // Begin at a corner, the lowest of the leftmost, so that sides are whole.
        std::size_t begin = 0;
        bool corner = false;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const bool is_corner = !same_support(pieces_[chain[(i + chain.size() - 1) % chain.size()]], pieces_[chain[i]]);
            const Vec2 p = points_[pieces_[chain[i]].from], best = points_[pieces_[chain[begin]].from];
            const bool before = p.x != best.x ? p.x < best.x : p.y < best.y;
            if (is_corner != corner ? is_corner : before) begin = i, corner = is_corner;
        }
        std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(begin), chain.end());
        Outline out;
        out.start = points_[pieces_[chain[0]].from];
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const Piece& p = pieces_[chain[i]];
            const FlatCurve& curve = set_.curves()[p.curve];
            const bool goes_on = i > 0 && same_support(pieces_[chain[i - 1]], p);
            if (goes_on) {
                out.sides.back().end = points_[p.to];
                out.sides.back().to += p.t1 - p.t0;
            } else {
                out.sides.push_back({points_[p.to], curve.curved, curve.centre, curve.u, curve.v, p.t0, p.t1, curve.quadratic, Vec2(0)});
            }
            OutlineSide& side = out.sides.back();
            if (side.quadratic) side.control = curve.control(side.from, side.to);
        }
        return out;
    }

    FlatSet set_;
    double size_;
    Points points_;
    std::vector<std::vector<std::pair<double, Index>>> cuts_;
    std::vector<Piece> pieces_;
    std::map<Index, std::vector<Index>> leaving_;
    std::map<std::pair<Index, Index>, std::vector<Vec2>> middles_;
};

}  // namespace

bool OutlineSide::round() const {
    const double uu = glm::dot(u, u), vv = glm::dot(v, v);
    return curved && std::fabs(uu - vv) <= 0x1p-46 * uu && std::fabs(glm::dot(u, v)) <= 0x1p-46 * uu;
}

double OutlineSide::turn() const { return curved ? (cross(u, v) < 0 ? from - to : to - from) : 0; }

std::vector<Outline> outlines_of(const Solid& solid) { return outlines_of(solid, solid.root()); }

std::vector<Outline> outlines_of(const Solid& solid, const Use& use) {
    if (use.node == kEmptyNode) return {};
    return Tracer(solid, use).run();
}

OutlineBox box_of(const std::vector<Outline>& outlines) {
    OutlineBox box{outlines.front().start, outlines.front().start};
    const auto add = [&](Vec2 p) { box.lo = glm::min(box.lo, p), box.hi = glm::max(box.hi, p); };
    for (const Outline& o : outlines) {
        Vec2 at = o.start;
        for (const OutlineSide& s : o.sides) {
            const Vec2 start = at;
            at = s.end;
            add(s.end);
            for (int axis = 0; s.quadratic && axis < 2; ++axis) {
                const double rise = s.control[axis] - start[axis], fall = s.control[axis] - s.end[axis], t = rise / (rise + fall);
                if (t > 0 && t < 1) add(parabola_point({start, s.control, s.end}, t));
            }
            if (!s.curved) continue;
            // Where the arc runs along an axis.
            for (int axis = 0; axis < 2; ++axis) {
                const double t0 = std::atan2(s.v[axis], s.u[axis]), lo = std::min(s.from, s.to), hi = std::max(s.from, s.to);
                for (double t = t0 + std::ceil((lo - t0) / (kTurn / 2)) * (kTurn / 2); t <= hi; t += kTurn / 2) add(s.centre + s.u * std::cos(t) + s.v * std::sin(t));
            }
        }
    }
    return box;
}

double area_of(const std::vector<Outline>& outlines) {
    double twice = 0;
    for (const Outline& o : outlines) {
        Vec2 at = o.start;
        for (const OutlineSide& s : o.sides) {
            twice += cross(at, s.end);
            // Between chord and arc: |u x v| (angle - sin angle).
            if (s.curved) twice += cross(s.u, s.v) * ((s.to - s.from) - std::sin(s.to - s.from));
            if (s.quadratic) twice += 2 * cross(s.control - at, s.end - at) / 3;
            at = s.end;
        }
    }
    return twice / 2;
}

}  // namespace whittle
