#include "csg/solid/convex_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace whittle {
namespace {

constexpr int kMostSteps = 200;       // about 20 are usual
constexpr double kRoundings = 24 * 0x1p-53;  // of a coordinate about the middle, across or along the line
constexpr int kStepsToFaces = 2;             // then a flat face is more likely than a curved place
constexpr std::size_t kAround = 8;           // directions about a normal
constexpr double kLeastTilt = 0x1p-20;       // between them and it
constexpr double kPi = 3.14159265358979323846;
constexpr int kMostTries = 12;               // of Newton's method: 4 are usual
constexpr double kLeastBend = 0x1p-30;       // of the body's size: what bends more is an edge
constexpr double kHalfRoot3 = 0.86602540378443865;
constexpr double kLeastShare = 0x1p-33;      // of the others: a coefficient below it is rounding

// About the body's middle, across the line (x, y) and along it (z).
using Place = Vec3;

class Search {
public:
    Search(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room) : body_(body), length_(glm::length(d)) {
        z_ = d / length_;
        const Vec3 helper = std::fabs(z_.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        x_ = glm::normalize(glm::cross(helper, z_));
        y_ = glm::cross(z_, x_);
        const Vec3 from = o - body.middle;
        q_ = {glm::dot(from, x_), glm::dot(from, y_), glm::dot(from, z_)};
        const double far = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
        error_ = kRoundings * (body.size + glm::length(body.middle) + far + glm::length(from)) + room;
    }

    std::optional<ConvexSpan::Border> way_out() {
        if (surround() != ConvexSpan::Kind::kMet) return std::nullopt;
        return border(-1);
    }

    ConvexSpan run() {
        ConvexSpan span;
        span.kind = surround();
        if (span.kind != ConvexSpan::Kind::kMet) return span;
        span.in = border(1);
        span.out = border(-1);
        return span;
    }

private:
    Vec3 across(const Vec3& n) const { return n.x * x_ + n.y * y_ + n.z * z_; }
    Place place(const Vec3& p) const {
        const Vec3 from = p - body_.middle;
        return {glm::dot(from, x_), glm::dot(from, y_), glm::dot(from, z_)};
    }
    Place farthest(const Vec3& n) const { return place(farthest_point(body_.parts, across(n))); }

    static double cross(const Vec3& a, const Vec3& b) { return a.x * b.y - a.y * b.x; }
    static double flat_dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y; }

    // Two support points of a flat set about the origin such that the triangle of them and the origin holds q, deeper than `depth` from their line.
    template <typename Farthest>
    ConvexSpan::Kind surround(const Place& q, const Farthest& reached, Place& a, Place& b, double depth = 0) const {
        Vec3 way(q.x, q.y, 0);
        if (!(glm::length(way) > error_)) way = {1, 0, 0};
        way /= glm::length(way);
        a = reached(way);
        if (flat_dot(way, q) > flat_dot(way, a) + 4 * error_) return ConvexSpan::Kind::kMissed;
        b = reached(cross(way, a) > 0 ? Vec3(way.y, -way.x, 0) : Vec3(-way.y, way.x, 0));
        for (int step = 0; step < kMostSteps; ++step) {
            Vec3 n(b.y - a.y, a.x - b.x, 0);
            const double length = glm::length(n);
            if (!(length > 0)) return ConvexSpan::Kind::kUnclear;
            n *= (flat_dot(n, way) < 0 ? -1 : 1) / length;  // a and b may lie so far round that the middle is beyond their line
            if (flat_dot(n, q - a) <= -depth) return ConvexSpan::Kind::kMet;
            const Place w = reached(n);
            if (flat_dot(n, q - w) > 4 * error_) return ConvexSpan::Kind::kMissed;
            if (flat_dot(n, w - a) <= 4 * error_) return ConvexSpan::Kind::kUnclear;
            ((cross(way, w) > 0) == (cross(way, a) > 0) ? a : b) = w;
        }
        return ConvexSpan::Kind::kUnclear;
    }

    ConvexSpan::Kind surround() {
        return surround(q_, [&](const Vec3& n) { return farthest(n); }, start_[1], start_[2]);
    }

    // Is the line within the body's outline, seen along it, for certain? Along a ridge it is not: there its borders may be known, but not that it has any.
    bool is_inside() const {
        Place a, b;
        return surround(q_, [&](const Vec3& n) { return farthest(n); }, a, b, 8 * error_) == ConvexSpan::Kind::kMet;
    }

    // Of the flat faces that look to the side the one whose plane is met last: three places of it around the line, where there are such.
    std::optional<std::array<Place, 3>> in_face(double side) const {
        const Vec3 o = body_.middle + q_.x * x_ + q_.y * y_;
        const FlatFace* last = nullptr;
        double most = -HUGE_VAL;
        for (const FlatFace& face : body_.faces) {
            const double along = side * glm::dot(face.n, z_), height = (face.d - glm::dot(face.n, o)) / along;
            if (along < 0 && height > most) most = height, last = &face;
        }
        if (!last) return std::nullopt;
        const Vec3 helper = std::fabs(last->n.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        const Vec3 e = glm::normalize(glm::cross(helper, last->n)), f = glm::cross(last->n, e), middle = last->middle;
        const Vec3 from = o + (most * side) * z_ - middle;
        const auto reached = [&](const Vec3& n) {
            const Vec3 p = farthest_point(body_.parts, body_.size, *last, n.x * e + n.y * f) - middle;
            return Place(glm::dot(p, e), glm::dot(p, f), 0);
        };
        const Place q(glm::dot(from, e), glm::dot(from, f), 0);
        // First from both sides: of a disc the place that lies behind q is a corner, and q on an edge.
        Place a = reached({q.x - q.y, q.y + q.x, 0}), b = reached({q.x + q.y, q.y - q.x, 0});
        if (!(cross(q, a) > 0 && cross(q, b) < 0 && cross(a - q, b - q) < 0) && surround(q, reached, a, b) != ConvexSpan::Kind::kMet) return std::nullopt;
        std::array<Place, 3> corners{place(middle), place(middle + a.x * e + a.y * f), place(middle + b.x * e + b.y * f)};
        for (Place& c : corners) c.z *= side;
        return corners;
    }

    // A triangle in the coordinates (x, y, side z), from an end of its shortest edge: longer ones would round what the others are apart.
    struct Triangle {
        std::array<Place, 3> corner;
        Vec3 e, f;
        double area = 0;

        explicit Triangle(const std::array<Place, 3>& c) : corner(c) {
            const auto length = [&](std::size_t i, std::size_t j) { return flat_dot(corner[i] - corner[j], corner[i] - corner[j]); };
            if (length(1, 2) < std::min(length(0, 1), length(2, 0))) std::swap(corner[0], corner[1]);
            e = corner[1] - corner[0];
            f = corner[2] - corner[0];
            area = cross(e, f);
        }
        std::array<double, 3> shares(const Place& p) const {
            const Vec3 r = p - corner[0];
            double b = cross(r, f) / area, c = cross(e, r) / area;
            // Once more for what they miss: in a long thin triangle quotients of rounded areas are another point's, far along it.
            const Vec3 missed = r - b * e - c * f;
            b += cross(missed, f) / area, c += cross(e, missed) / area;
            return {1 - b - c, b, c};
        }
        Vec2 slope() const { return {(e.z * f.y - f.z * e.y) / area, (e.x * f.z - f.x * e.z) / area}; }
        double height(const std::array<double, 3>& share) const { return corner[0].z + share[1] * e.z + share[2] * f.z; }
        // Of q to the nearest edge.
        double depth(const std::array<double, 3>& share) const {
            double least = HUGE_VAL;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 edge = corner[(i + 2) % 3] - corner[(i + 1) % 3];
                least = std::min(least, share[i] * std::fabs(area) / std::sqrt(flat_dot(edge, edge)));
            }
            return least;
        }
    };

    // What is known of one border, in the heights of its side (1: where the line enters; -1: where it leaves, as it enters in the mirror).
    struct Heights {
        double side, low = -HUGE_VAL, high = HUGE_VAL, steepness = 1, steepness_low = 1;
        Vec3 normal{0};
        bool within = false;  // q is inside the last triangle for certain
    };

    // The parts that were farthest at the last three tries, each once, the last first.
    struct Recent {
        std::array<const ConvexPart*, 3> all{};
        void met(const ConvexPart* p) { all = {p, all[0], all[1]}; }
        std::array<const ConvexPart*, 3> distinct() const {
            std::array<const ConvexPart*, 3> out{all[0]};
            std::size_t count = 1;
            for (const ConvexPart* p : {all[1], all[2]})
                if (p && std::find(out.begin(), out.begin() + count, p) == out.begin() + count) out[count++] = p;
            return out;
        }
    };

    // The body's farthest point along (slope, -1), by whose plane the floor rises.
    Place raised(const Vec2& slope, Heights& at, Recent& recent) const {
        const Vec3 n(slope.x, slope.y, -1), way = across({n.x, n.y, n.z * at.side});
        const ConvexPart& part = farthest_part(body_.parts, way);
        recent.met(&part);
        Place w = place(farthest_point(part, way));
        w.z *= at.side;
        at.steepness = glm::length(n);
        const double floor = w.z + slope.x * (q_.x - w.x) + slope.y * (q_.y - w.y);
        if (floor > at.low) at.low = floor, at.steepness_low = at.steepness, at.normal = way / at.steepness;
        return w;
    }
    bool is_closed(const Heights& at) const { return at.high - at.low <= error_ * at.steepness; }

    ConvexSpan::Border border(double side) const {
        Heights at{side};
        Recent recent;
        std::array<Place, 3> corners = start_;
        for (Place& c : corners) c.z *= side;
        for (int step = 0; step < kMostSteps; ++step) {
            if (step == kStepsToFaces)
                if (const auto face = in_face(side)) corners = *face;
            const Triangle triangle(corners);
            const Vec2 slope = triangle.slope();
            if (!std::isfinite(slope.x + slope.y)) break;
            const auto share = triangle.shares(q_);
            at.high = triangle.height(share);
            const Place w = raised(slope, at, recent);
            at.within = triangle.depth(share) > 8 * error_;
            if (is_closed(at) && at.within) break;
            if (touches(recent.distinct(), slope, at)) break;
            const std::size_t leaves = is_closed(at) ? corners.size() : leaving(triangle, share, w);
            if (leaves == corners.size()) {
                const double depth = triangle.depth(share);
                at.within = at.within || (rises_little({slope.x, slope.y, -1}, side, 8 * error_ + std::max(0.0, -depth), at.steepness, at.high) && is_inside());
                break;
            }
            corners = triangle.corner;
            corners[leaves] = w;
        }
        ConvexSpan::Border out;
        out.normal = at.normal;
        out.t = (side * at.low - q_.z) / length_;
        out.error = (std::max(0.0, at.high - at.low) + 5 * error_ * std::max(at.steepness, at.steepness_low) +
                     4 * kRoundings * (std::fabs(at.low) + std::fabs(q_.z))) / length_;
        out.certain = at.within && std::isfinite(out.error);
        return out;
    }

    // One part that is touched, seen along the line: its point there, how far it reaches, how its point moves with the slope.
    struct Touched { Place p; double reach = 0, xx = 0, xy = 0, yy = 0; };

    Touched touched(const ConvexPart& part, const Vec2& slope, double side) const {
        const Vec3 way = across({slope.x, slope.y, -side});
        Touched out;
        Vec3 p = part.centre;
        for (const BallImage& image : part.images) {
            const Vec3 c = components(image, way), a = components(image, x_), b = components(image, y_);
            const double length = glm::length(c), inverse = 1 / length;
            const Vec3 unit = length > 0 ? c * inverse : Vec3(0);
            p += unit.x * image.u + unit.y * image.v + unit.z * image.w;
            const double ac = glm::dot(a, unit), bc = glm::dot(b, unit);
            out.xx += (glm::dot(a, a) - ac * ac) * inverse;
            out.xy += (glm::dot(a, b) - ac * bc) * inverse;
            out.yy += (glm::dot(b, b) - bc * bc) * inverse;
        }
        out.p = place(p);
        out.p.z *= side;
        out.reach = slope.x * out.p.x + slope.y * out.p.y - out.p.z;
        return out;
    }

    // Where one part, or two, would be touched: the slope of the plane, and how it is turned to move the place by a little.
    struct Touch {
        Vec2 slope{0};
        std::array<Vec2, 3> turn{};
        std::array<const ConvexPart*, 3> part{};
    };

    // By Newton's method: the part's own farthest point comes to lie on the line.
    std::optional<Touch> touch_of(const ConvexPart& part, Vec2 slope, double side) const {
        double last = HUGE_VAL;
        for (int step = 0; step < kMostTries; ++step) {
            const Touched t = touched(part, slope, side);
            const double det = t.xx * t.yy - t.xy * t.xy, trace = t.xx + t.yy, bend = det / trace;
            if (!(bend > kLeastBend * body_.size)) return std::nullopt;
            const Vec2 miss(q_.x - t.p.x, q_.y - t.p.y);
            const auto turn = [&](const Vec2& v) { return Vec2(t.yy * v.x - t.xy * v.y, t.xx * v.y - t.xy * v.x) / det; };
            const double away = glm::length(miss), room = std::sqrt(error_ * bend);
            if (away <= room / 8) {
                const double r = room * 0.5;
                return Touch{slope, {turn({r, 0}), turn({-r / 2, r * kHalfRoot3}), turn({-r / 2, -r * kHalfRoot3})}, {&part, &part, &part}};
            }
            if (!(away < last)) return std::nullopt;
            last = away;
            slope += turn(miss);
        }
        return std::nullopt;
    }

    // The same of two: a plane that touches both, the line between the two places meets the line that is asked.
    std::optional<Touch> touch_of(const ConvexPart& a, const ConvexPart& b, Vec2 slope, double side) const {
        double share = 0.5;
        for (int step = 0; step < kMostTries; ++step) {
            const Touched s = touched(a, slope, side), t = touched(b, slope, side);
            const double rest = 1 - share, xx = share * s.xx + rest * t.xx, xy = share * s.xy + rest * t.xy, yy = share * s.yy + rest * t.yy;
            const Vec2 rule(s.p.x - t.p.x, s.p.y - t.p.y), over(-rule.y, rule.x), miss(q_.x - share * s.p.x - rest * t.p.x, q_.y - share * s.p.y - rest * t.p.y);
            const double width = glm::length(rule), behind = t.reach - s.reach;
            const double bend = (xx * over.x * over.x + 2 * xy * over.x * over.y + yy * over.y * over.y) / (width * width);
            if (!(width > kLeastBend * body_.size && bend > kLeastBend * body_.size)) return std::nullopt;
            const double room = std::sqrt(error_ * bend), side_miss = glm::dot(miss, over) / width;
            if (std::fabs(side_miss) <= room / 8 && std::fabs(behind) <= error_ / 4 && share > 0 && share < 1) {
                const double bend_s = s.xx * over.x * over.x + 2 * s.xy * over.x * over.y + s.yy * over.y * over.y;
                const double bend_t = t.xx * over.x * over.x + 2 * t.xy * over.x * over.y + t.yy * over.y * over.y;
                const bool first = share * bend_s > rest * bend_t;
                const Vec2 turn = over * (room / (2 * width * bend));
                return Touch{slope, {turn, -turn, Vec2(0)}, first ? std::array{&a, &a, &b} : std::array{&b, &b, &a}};
            }
            // Along the rule the slope is what makes both reach as far, across it what moves the place; then the share.
            const double along = behind / (width * width);
            const Vec2 fixed = along * rule;
            const double bent = (xx * fixed.x + xy * fixed.y) * over.x + (xy * fixed.x + yy * fixed.y) * over.y;
            const Vec2 change = fixed + over * ((glm::dot(miss, over) - bent) / (bend * width * width));
            const Vec2 moved(xx * change.x + xy * change.y, xy * change.x + yy * change.y);
            share += glm::dot(miss - moved, rule) / (width * width);
            if (!(share > -1 && share < 2)) return std::nullopt;
            slope += change;
        }
        return std::nullopt;
    }

    // Of three: the plane that touches them all.
    std::optional<Touch> touch_of(const std::array<const ConvexPart*, 3>& parts, Vec2 slope, double side) const {
        for (int step = 0; step < kMostTries; ++step) {
            const Touched s = touched(*parts[0], slope, side), t = touched(*parts[1], slope, side), u = touched(*parts[2], slope, side);
            const Vec2 e(t.p.x - s.p.x, t.p.y - s.p.y), f(u.p.x - s.p.x, u.p.y - s.p.y);
            const double area = e.x * f.y - e.y * f.x, a = s.reach - t.reach, b = s.reach - u.reach;
            if (!(std::fabs(area) > kLeastBend * body_.size * body_.size)) return std::nullopt;
            if (std::max(std::fabs(a), std::fabs(b)) <= error_ / 4) return Touch{slope, {}, parts};
            slope += Vec2(a * f.y - b * e.y, b * e.x - a * f.x) / area;
        }
        return std::nullopt;
    }

    // Does a plane that touches these parts, found from this slope on, close the heights, with a small triangle of the body around the line?
    bool touches(const std::array<const ConvexPart*, 3>& parts, const Vec2& slope, Heights& at) const {
        const auto touch = parts[2]   ? touch_of(parts, slope, at.side)
                           : parts[1] ? touch_of(*parts[0], *parts[1], slope, at.side)
                                      : touch_of(*parts[0], slope, at.side);
        if (!touch) return false;
        Recent unused;
        Heights now = at;
        raised(touch->slope, now, unused);
        std::array<Place, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 turned = touch->slope + touch->turn[i];
            corners[i] = place(farthest_point(*touch->part[i], across({turned.x, turned.y, -at.side})));
            corners[i].z *= at.side;
        }
        const Triangle triangle(corners);
        const auto share = triangle.shares(q_);
        now.high = triangle.height(share);
        now.within = triangle.depth(share) > 8 * error_;
        if (!now.within || !is_closed(now)) return false;
        at = now;
        return true;
    }

    // Where q lies on the triangle's rim, or as near beyond it as `room`, the exact one may be outside; then the body, which is convex, reaches over it from a point of
    // the triangle within `room` towards one of a wider triangle around q. `high` becomes what that is at most. False: none of those tried is wide enough.
    bool rises_little(const Vec3& n, double side, double room, double steepness, double& high) const {
        if (!(room <= 64 * error_)) return false;
        double least = HUGE_VAL;
        for (double tilt = 1; tilt > kLeastTilt; tilt /= 8) {
            std::array<Place, kAround> around;
            for (std::size_t k = 0; k < kAround; ++k) {
                const double turn = static_cast<double>(k) * (2 * kPi / kAround);
                around[k] = farthest({n.x + tilt * steepness * std::cos(turn), n.y + tilt * steepness * std::sin(turn), n.z * side});
                around[k].z *= side;
            }
            for (std::size_t i = 0; i < kAround; ++i)
                for (std::size_t j = i + 1; j < kAround; ++j)
                    for (std::size_t k = j + 1; k < kAround; ++k) {
                        const Triangle wide({around[i], around[j], around[k]});
                        const double depth = wide.depth(wide.shares(q_));
                        if (!(depth > 16 * room)) continue;
                        least = std::min(least, 2 * room / depth * std::max({0.0, around[i].z - high, around[j].z - high, around[k].z - high}));
                    }
        }
        if (!(least < HUGE_VAL)) return false;
        high += least + 2 * room * steepness;
        return true;
    }

    // The corner that w takes the place of, such that the triangle still holds q; 3: rounding leaves none.
    static std::size_t leaving(const Triangle& triangle, const std::array<double, 3>& share, const Place& w) {
        const auto own = triangle.shares(w);
        std::size_t leaves = 3;
        double least = HUGE_VAL, most = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!(own[i] > kLeastShare)) continue;
            const double ratio = std::max(0.0, share[i]) / own[i];
            if (ratio < least || (ratio == least && own[i] > most)) least = ratio, most = own[i], leaves = i;
        }
        return leaves;
    }

    const ConvexHullBody& body_;
    double length_, error_ = 0;
    Vec3 x_, y_, z_, q_;
    std::array<Place, 3> start_{Place(0), Place(0), Place(0)};
};

}  // namespace

std::optional<ConvexSpan::Border> way_out(const ConvexHullBody& body, const Vec3& o, const Vec3& d) { return Search(body, o, d, 0).way_out(); }

ConvexSpan span_on_line(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room) { return Search(body, o, d, room).run(); }

}  // namespace whittle
