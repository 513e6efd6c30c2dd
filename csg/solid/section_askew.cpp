#include "csg/solid/section_askew.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/convex_parts.h"
#include "csg/solid/facets.h"
#include "csg/solid/profile_line.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// The corners of a convex polygon where `value`, which is linear, is not negative.
template <class Value>
std::vector<Vec2> clipped(const std::vector<Vec2>& corners, Value value) {
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double from = value(a), to = value(b);
        if (from >= 0) kept.push_back(a);
        if ((from < 0) != (to < 0) && from != 0 && to != 0) kept.push_back(a + (b - a) * (from / (from - to)));
    }
    return kept;
}

// A prism that stands askew: its profile, seen along its axis from the plane, as far as the plane is between its ends. Nothing where it all but lies in the plane.
std::optional<Use> section_of_prism(SolidBuilder& builder, const Prism& prism, const Placement& at) {
    // A flatter one is a million times as long as its profile is wide: corners found on it would have lost six of their digits.
    constexpr double kLeastRise = 1e-6;
    const double a = at.linear(2, 0), b = at.linear(2, 1), up = at.linear(2, 2), off = at.offset(2);
    if (!(std::fabs(up) > kLeastRise * std::hypot(a, b))) return std::nullopt;
    const auto height = [&](const Vec2& p) { return -(a * p.x + b * p.y + off) / up; };
    const Bounds box = builder.bounds(prism.profile);
    const Vec3 room = 0.0625 * (box.hi - box.lo), lo = box.lo - room, hi = box.hi + room;
    const std::vector<Vec2> whole{{lo.x, lo.y}, {hi.x, lo.y}, {hi.x, hi.y}, {lo.x, hi.y}};
    std::vector<Vec2> between = clipped(whole, [&](const Vec2& p) { return height(p) - prism.z0; });
    if (between.size() >= 3) between = clipped(between, [&](const Vec2& p) { return prism.z1 - height(p); });
    if (between.size() < 3) return use_of(kEmptyNode);
    Use part = prism.profile;
    if (between != whole) part = use_of(builder.combine(SetOp::kIntersection, {part, polygon_of(builder, {between})}));
    Placement seen;
    for (int i = 0; i < 2; ++i) {
        const double along = at.linear(i, 2) / up;
        seen.m[static_cast<std::size_t>(4 * i)] = at.linear(i, 0) - along * a;
        seen.m[static_cast<std::size_t>(4 * i + 1)] = at.linear(i, 1) - along * b;
        seen.m[static_cast<std::size_t>(4 * i + 2)] = 0;
        seen.m[static_cast<std::size_t>(4 * i + 3)] = at.offset(i) - along * off;
    }
    return builder.placed(seen, part);
}

// A prism whose axis is parallel to the plane: over each interval of a line across its profile a parallelogram.
std::optional<Use> section_of_lying(SolidBuilder& builder, const Prism& prism, const Placement& at) {
    const Vec2 rise(at.linear(2, 0), at.linear(2, 1));
    const double steep = glm::length(rise);
    const ProfileLine line{-at.offset(2) / (steep * steep) * rise, Vec2(-rise.y, rise.x) / steep, rise};
    return made_of_intervals(builder, prism.profile, line, [&](const LineIntervals& in) {
        Contours strips;
        for (const auto& [from, to] : in) {
            const Vec2 a = line.o + from * line.d, b = line.o + to * line.d;
            std::vector<Vec2> corners;
            for (const Vec3& p : {Vec3(a, prism.z0), Vec3(b, prism.z0), Vec3(b, prism.z1), Vec3(a, prism.z1)}) corners.push_back(Vec2(apply_to_point(at, p)));
            strips.push_back(std::move(corners));
        }
        return std::optional(polygon_of(builder, std::move(strips)));
    });
}

// An ellipsoid however it is placed: a circle of the unit ball, whose plane's normal is what z is there.
std::optional<Use> section_of_ball(SolidBuilder& builder, const shape::Ellipsoid& s, const Placement& at) {
    const auto row = [&](int i) { return Vec3(at.linear(i, 0) * s.radii.x, at.linear(i, 1) * s.radii.y, at.linear(i, 2) * s.radii.z); };
    const Vec3 rise = row(2);
    const double d = -at.offset(2) / glm::length(rise);
    if (!(std::fabs(d) < 1)) return use_of(kEmptyNode);
    const Vec3 normal = glm::normalize(rise), size = glm::abs(normal);
    const Vec3 aside = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0) : size.y <= size.z ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const double r = std::sqrt((1 - d) * (1 + d));
    const Vec3 u = r * glm::normalize(glm::cross(normal, aside)), v = glm::cross(normal, u);
    const Vec3 x = row(0), y = row(1);
    const Placement seen{{glm::dot(x, u), glm::dot(x, v), 0, at.offset(0) + d * glm::dot(x, normal), glm::dot(y, u), glm::dot(y, v), 0, at.offset(1) + d * glm::dot(y, normal), 0, 0, 1, 0}};
    return builder.placed(seen, use_of(builder.shape(shape::Disc{1})));
}

// The plane z = 0 seen from a shape's own coordinates: the point X, Y of the plane is o + X u + Y v.
struct PlaneSeen {
    Vec3 o, u, v;
};

PlaneSeen plane_seen(const Placement& at) {
    glm::dmat3 m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m[j][i] = at.linear(i, j);
    const glm::dmat3 back = glm::inverse(m);
    return {back * -Vec3(at.offset(0), at.offset(1), at.offset(2)), back[0], back[1]};
}

// A cone that the plane cuts across all its lines: an ellipse, as far as it is between the ends. Else nothing: there is no 2D shape of a hyperbola.
std::optional<Use> section_of_cone(SolidBuilder& builder, const shape::Frustum& s, const Placement& at) {
    const PlaneSeen plane = plane_seen(at);
    const double k = (s.r1 - s.r0) / (s.z1 - s.z0), apex = s.z0 - s.r0 / k;
    // x^2 + y^2 - k^2 (z - apex)^2 as a form of X, Y, 1.
    const Vec3 o(plane.o.x, plane.o.y, plane.o.z - apex);
    const auto form = [&](const Vec3& p, const Vec3& q) { return p.x * q.x + p.y * q.y - k * k * p.z * q.z; };
    const double a = form(plane.u, plane.u), b = form(plane.u, plane.v), c = form(plane.v, plane.v), d = form(plane.u, o), e = form(plane.v, o), f = form(o, o);
    const double det = a * c - b * b;
    constexpr double kRound = 1e-6;  // of the axes' ratio, squared: flatter ones are all but parabolas, and have lost half of their digits
    if (!(a > 0) || !(c > 0) || !(det > kRound * a * c)) return std::nullopt;
    const Vec2 centre((b * e - c * d) / det, (b * d - a * e) / det);
    const double size = -(f + d * centre.x + e * centre.y);
    if (!(size > 0)) return use_of(kEmptyNode);
    // a X^2 + 2 b X Y + c Y^2 = size about the centre: the unit circle's image under the inverse of a triangular root.
    const double r = std::sqrt(size), l = std::sqrt(a), m = b / l, n = std::sqrt(det / a);
    const Use ellipse = use_of(builder.shape(shape::Disc{1}), {{r / l, -r * m / (l * n), 0, centre.x, 0, r / n, 0, centre.y, 0, 0, 1, 0}});
    const Vec2 half = 1.0625 * r * Vec2(std::sqrt(c / det), std::sqrt(a / det));
    const auto height = [&](const Vec2& p) { return plane.o.z + p.x * plane.u.z + p.y * plane.v.z; };
    const std::vector<Vec2> whole{centre - half, {centre.x + half.x, centre.y - half.y}, centre + half, {centre.x - half.x, centre.y + half.y}};
    std::vector<Vec2> between = clipped(whole, [&](const Vec2& p) { return height(p) - s.z0; });
    if (between.size() >= 3) between = clipped(between, [&](const Vec2& p) { return s.z1 - height(p); });
    if (between.size() < 3) return use_of(kEmptyNode);
    if (between == whole) return ellipse;
    return use_of(builder.combine(SetOp::kIntersection, {ellipse, polygon_of(builder, {between})}));
}

// Is the shape's own axis in the plane?
bool has_axis_in_plane(const Placement& at) { return at.linear(2, 2) == 0 && at.offset(2) == 0; }

// From the axis on along +x of the result, the half of the plane that stands over (x, y) of the shape's coordinates; y is the axis.
Placement half_plane(const Placement& at, const Vec2& over) {
    Placement seen;
    for (int i = 0; i < 2; ++i) {
        seen.m[static_cast<std::size_t>(4 * i)] = at.linear(i, 0) * over.x + at.linear(i, 1) * over.y;
        seen.m[static_cast<std::size_t>(4 * i + 1)] = at.linear(i, 2);
        seen.m[static_cast<std::size_t>(4 * i + 2)] = 0;
        seen.m[static_cast<std::size_t>(4 * i + 3)] = at.offset(i);
    }
    return seen;
}

// What is turned about an axis in the plane: the profile on the sides that it is turned to. Where it begins or ends in the plane, what is just above counts.
std::optional<Use> section_along_axis(SolidBuilder& builder, const Use& profile, double start_deg, double angle_deg, const Placement& at) {
    const Vec2 rise(at.linear(2, 0), at.linear(2, 1));
    std::vector<Use> sides;
    for (const double sign : {1.0, -1.0}) {
        const Vec2 over = sign / glm::length(rise) * Vec2(-rise.y, rise.x);
        // Turning on counter-clockwise goes along (-y, x) of the side: up or down.
        const bool on_is_up = glm::dot(Vec2(-over.y, over.x), rise) > 0;
        constexpr double kSame = 1e-9;
        double turn = std::fmod(std::atan2(over.y, over.x) * 180 / 3.14159265358979323846 - start_deg, 360);
        if (turn < -kSame) turn += 360;
        if (turn > 360 - kSame) turn -= 360;
        const bool begins = std::fabs(turn) < kSame, ends = std::fabs(turn - angle_deg) < kSame;
        const bool within = angle_deg >= 360 || (begins ? on_is_up : ends ? !on_is_up : turn < angle_deg);
        if (within) sides.push_back(builder.placed(half_plane(at, over), profile));
    }
    if (sides.empty()) return use_of(kEmptyNode);
    return sides.size() == 1 ? sides[0] : use_of(builder.combine(SetOp::kUnion, std::move(sides)));
}

}  // namespace

Use polygon_of(SolidBuilder& builder, Contours contours) {
    if (contours.empty()) return use_of(kEmptyNode);
    return use_of(builder.shape(shape::Polygon{std::make_shared<const Contours>(std::move(contours))}));
}

std::optional<Use> rings(SolidBuilder& builder, const std::vector<std::pair<double, double>>& radii) {
    std::vector<Use> all;
    for (const auto& [inner, outer] : radii) {
        if (!(outer > 0)) continue;
        const Use whole = use_of(builder.shape(shape::Disc{outer}));
        all.push_back(inner > 0 ? use_of(builder.combine(SetOp::kDifference, {whole, use_of(builder.shape(shape::Disc{inner}))})) : whole);
    }
    if (all.empty()) return use_of(kEmptyNode);
    return all.size() == 1 ? all[0] : use_of(builder.combine(SetOp::kUnion, std::move(all)));
}

std::optional<Use> section_of_askew(SolidBuilder& builder, NodeId id, const Shape& s, const Placement& at) {
    if (const auto* ball = std::get_if<shape::Ellipsoid>(&s)) return section_of_ball(builder, *ball, at);
    const auto* cone = std::get_if<shape::Frustum>(&s);
    if (cone && cone->r0 != cone->r1) return section_of_cone(builder, *cone, at);
    const auto* ring = std::get_if<shape::Torus>(&s);
    if (ring && has_axis_in_plane(at)) return section_along_axis(builder, use_of(builder.shape(shape::Disc{ring->minor}), Placement::translation({ring->major, 0, 0})), 0, 360, at);
    const auto* turned = std::get_if<shape::Revolution>(&s);
    if (turned && turned->fragments == 0 && has_axis_in_plane(at)) return section_along_axis(builder, use_of(turned->profile), turned->start_deg, turned->angle_deg, at);
    const auto prism = prism_of(builder, use_of(id));
    if (!prism) return std::nullopt;
    return at.linear(2, 2) == 0 ? section_of_lying(builder, *prism, at) : section_of_prism(builder, *prism, at);
}

}  // namespace whittle
