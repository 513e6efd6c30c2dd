#include "csg/solid/convex_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace whittle {
namespace {

constexpr int kMostSteps = 200;       // about 20 are usual
constexpr double kRoundings = 24 * 0x1p-53;  // of a coordinate about the middle, across or along the line
constexpr double kLeastShare = 0x1p-33;      // of the others: a coefficient below it is rounding
constexpr std::size_t kAround = 8;           // directions about a normal
constexpr double kLeastTilt = 0x1p-20;       // between them and it
constexpr double kPi = 3.14159265358979323846;

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

    ConvexSpan run() {
        ConvexSpan span;
        span.kind = surround();
        if (span.kind != ConvexSpan::Kind::kMet) return span;
        span.in = border(1);
        span.out = border(-1);
        return span;
    }

private:
    Place farthest(const Vec3& n) const {
        const Vec3 p = farthest_point(body_.parts, n.x * x_ + n.y * y_ + n.z * z_) - body_.middle;
        return {glm::dot(p, x_), glm::dot(p, y_), glm::dot(p, z_)};
    }

    static double cross(const Vec3& a, const Vec3& b) { return a.x * b.y - a.y * b.x; }
    static double flat_dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y; }

    // Two support points such that the triangle of them and the middle holds q.
    ConvexSpan::Kind surround() {
        Vec3 way(q_.x, q_.y, 0);
        if (!(glm::length(way) > error_)) way = {1, 0, 0};
        way /= glm::length(way);
        Place a = farthest(way);
        if (flat_dot(way, q_) > flat_dot(way, a) + 4 * error_) return ConvexSpan::Kind::kMissed;
        Place b = farthest(cross(way, a) > 0 ? Vec3(way.y, -way.x, 0) : Vec3(-way.y, way.x, 0));
        for (int step = 0; step < kMostSteps; ++step) {
            Vec3 n(b.y - a.y, a.x - b.x, 0);
            const double length = glm::length(n);
            if (!(length > 0)) return ConvexSpan::Kind::kUnclear;
            n *= (flat_dot(n, way) < 0 ? -1 : 1) / length;  // a and b may lie so far round that the middle is beyond their line
            if (flat_dot(n, q_ - a) <= 0) {
                start_ = {Place(0), a, b};
                return ConvexSpan::Kind::kMet;
            }
            const Place w = farthest(n);
            if (flat_dot(n, q_ - w) > 4 * error_) return ConvexSpan::Kind::kMissed;
            if (flat_dot(n, w - a) <= 4 * error_) return ConvexSpan::Kind::kUnclear;
            ((cross(way, w) > 0) == (cross(way, a) > 0) ? a : b) = w;
        }
        return ConvexSpan::Kind::kUnclear;
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

    // side 1: where the line enters; -1: where it leaves, as it enters in the mirror.
    ConvexSpan::Border border(double side) const {
        ConvexSpan::Border out;
        std::array<Place, 3> corners = start_;
        for (Place& c : corners) c.z *= side;
        double low = -HUGE_VAL, high = HUGE_VAL, steepness = 1, steepness_low = 1;
        for (int step = 0; step < kMostSteps; ++step) {
            const Triangle triangle(corners);
            const Vec2 slope = triangle.slope();
            if (!std::isfinite(slope.x + slope.y)) break;
            const auto share = triangle.shares(q_);
            high = triangle.corner[0].z + share[1] * triangle.e.z + share[2] * triangle.f.z;
            const Vec3 n(slope.x, slope.y, -1);
            Place w = farthest({n.x, n.y, n.z * side});
            w.z *= side;
            steepness = glm::length(n);
            const double floor = w.z + slope.x * (q_.x - w.x) + slope.y * (q_.y - w.y);
            if (floor > low) {
                low = floor;
                steepness_low = steepness;
                out.normal = (n.x * x_ + n.y * y_ + (n.z * side) * z_) / steepness;
            }
            const std::size_t leaves = high - low <= error_ * steepness ? corners.size() : leaving(triangle, share, w);
            if (leaves == corners.size()) {
                const double depth = triangle.depth(share);
                out.certain = depth > 8 * error_ || rises_little(n, side, 8 * error_ + std::max(0.0, -depth), steepness, high);
                break;
            }
            corners = triangle.corner;
            corners[leaves] = w;
        }
        out.t = (side * low - q_.z) / length_;
        out.error = (std::max(0.0, high - low) + 5 * error_ * std::max(steepness, steepness_low) + 4 * kRoundings * (std::fabs(low) + std::fabs(q_.z))) / length_;
        out.certain = out.certain && std::isfinite(out.error);
        return out;
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
    std::array<Place, 3> start_;
};

}  // namespace

ConvexSpan span_on_line(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room) { return Search(body, o, d, room).run(); }

}  // namespace whittle
