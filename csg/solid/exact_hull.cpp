#include "csg/solid/exact_hull.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/solid/convex_hull.h"
#include "csg/solid/convex_parts.h"
#include "csg/solid/facets.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// Beyond it the triples of balls would take longer than meshes.
constexpr std::size_t kMostBalls = 40;
// A plane that touches four balls is met by three of them, and passes the fourth by the rounding of solving for it.
constexpr double kTangentRounding = 0x1p-40;

bool holds(const Ball& a, const Ball& b) { return glm::distance(a.c, b.c) + b.r <= a.r; }

double size_of(const std::vector<Ball>& balls) {
    double size = 0;
    for (const Ball& b : balls) size = std::max(size, glm::distance(b.c, balls[0].c) + b.r);
    return size;
}

bool touches_all(const std::vector<Ball>& balls, Vec3 n, double h, double size) {
    return std::all_of(balls.begin(), balls.end(), [&](const Ball& b) { return glm::dot(n, b.c) + b.r <= h + kTangentRounding * size; });
}

// The unit normals of planes that touch three balls from one side: n.(cj - ci) = ri - rj.
std::vector<Vec3> common_tangents(const Ball& a, const Ball& b, const Ball& c) {
    const Vec3 u = b.c - a.c, v = c.c - a.c, w = glm::cross(u, v);
    const double ww = glm::dot(w, w), p = a.r - b.r, q = a.r - c.r;
    if (!(ww > 0)) return {};
    const Vec3 base = (p * glm::cross(v, w) + q * glm::cross(w, u)) / ww;  // in the plane of the centres
    const double rest = (1 - glm::dot(base, base)) / ww;
    if (!(rest >= 0)) return {};
    return {base + std::sqrt(rest) * w, base - std::sqrt(rest) * w};
}

std::vector<Ball> without_hidden(const std::vector<Ball>& all) {
    std::vector<Ball> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool hidden = std::any_of(all.begin(), all.end(), [&](const Ball& other) {
            const auto j = static_cast<std::size_t>(&other - all.data());
            return j != i && holds(other, all[i]) && (j < i || !holds(all[i], other));
        });
        if (!hidden) out.push_back(all[i]);
    }
    return out;
}

// Corners that are corners of their own hull.
void keep_extreme_corners(std::vector<Ball>& balls) {
    std::vector<Vec3> corners;
    for (const Ball& b : balls)
        if (b.r == 0) corners.push_back(b.c);
    const auto hull = convex_hull_of(corners);
    if (!hull) return;
    balls.erase(std::remove_if(balls.begin(), balls.end(), [](const Ball& b) { return b.r == 0; }), balls.end());
    for (const Vec3& p : hull->points) balls.push_back({p, 0});
}

// A rotation that takes z to the direction.
Placement upright_to(Vec3 from, Vec3 direction) {
    const Vec3 z = glm::normalize(direction), helper = std::fabs(z.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 x = glm::normalize(glm::cross(helper, z)), y = glm::cross(z, x);
    return {{x.x, y.x, z.x, from.x, x.y, y.y, z.y, from.y, x.z, y.z, z.z, from.z}};
}

// The part of the hull of two balls between the circles in which its cone touches them.
Use touching_cone(SolidBuilder& builder, const Ball& a, const Ball& b) {
    if (a.r == b.r) return use_of(builder.shape(shape::Capsule{a.c, b.c, a.r}));
    const double d = glm::distance(a.c, b.c), s = (a.r - b.r) / d, c = std::sqrt(1 - s * s);
    return use_of(builder.shape(shape::Frustum{s * a.r, d + s * b.r, c * a.r, c * b.r}), upright_to(a.c, b.c - a.c));
}

// Equal balls at the corners of a rectangle or a box along the axes, each once.
std::optional<shape::RoundBox> rounded_box(const std::vector<Ball>& balls) {
    if (balls.size() != 4 && balls.size() != 8) return std::nullopt;
    Vec3 lo = balls[0].c, hi = lo;
    for (const Ball& b : balls) lo = glm::min(lo, b.c), hi = glm::max(hi, b.c);
    std::array<bool, 8> seen{};
    for (const Ball& b : balls) {
        std::size_t corner = 0;
        for (int i = 0; i < 3; ++i) {
            if (b.c[i] != lo[i] && b.c[i] != hi[i]) return std::nullopt;
            if (b.c[i] != lo[i]) corner |= std::size_t{1} << i;
        }
        if (b.r != balls[0].r || seen[corner]) return std::nullopt;
        seen[corner] = true;
    }
    if (((lo.x < hi.x) + (lo.y < hi.y) + (lo.z < hi.z)) != (balls.size() == 8 ? 3 : 2)) return std::nullopt;
    return shape::RoundBox{lo - balls[0].r, hi + balls[0].r, balls[0].r};
}

// Some plane touches both balls and has all others on one side. Where no such plane touches a third ball, it is enough to look at one.
bool is_ridge(const std::vector<Ball>& balls, const Ball& a, const Ball& b, double size) {
    const Vec3 u = b.c - a.c;
    const double d = glm::length(u), s = (a.r - b.r) / d;
    if (!(std::fabs(s) <= 1)) return false;
    const Placement frame = upright_to(a.c, u);
    const Vec3 n = s * (u / d) + std::sqrt(1 - s * s) * Vec3(frame.m[0], frame.m[4], frame.m[8]);
    return touches_all(balls, n, glm::dot(n, a.c) + a.r, size);
}

// What touches the hull of balls: points of its flat faces, and the pairs of balls that a cone joins.
struct HullContacts {
    std::vector<Vec3> touched;
    std::vector<std::array<std::size_t, 2>> ridges;
};

HullContacts contacts_of(const std::vector<Ball>& balls) {
    HullContacts out;
    const double size = size_of(balls);
    std::vector<bool> joined(balls.size() * balls.size(), false);
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = i + 1; j < balls.size(); ++j)
            for (std::size_t k = j + 1; k < balls.size(); ++k)
                for (const Vec3& n : common_tangents(balls[i], balls[j], balls[k])) {
                    if (!touches_all(balls, n, glm::dot(n, balls[i].c) + balls[i].r, size)) continue;
                    joined[i * balls.size() + j] = joined[j * balls.size() + k] = joined[i * balls.size() + k] = true;
                    for (const Ball* b : {&balls[i], &balls[j], &balls[k]}) out.touched.push_back(b->c + b->r * n);
                }
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = i + 1; j < balls.size(); ++j)
            if ((balls[i].r > 0 || balls[j].r > 0) && (joined[i * balls.size() + j] || is_ridge(balls, balls[i], balls[j], size))) out.ridges.push_back({i, j});
    return out;
}

HullResult hull_of_balls(SolidBuilder& builder, std::vector<Ball> balls) {
    const bool curved = std::any_of(balls.begin(), balls.end(), [](const Ball& b) { return b.r > 0; });
    if (!curved) {
        std::vector<Vec3> corners;
        corners.reserve(balls.size());
        for (const Ball& b : balls) corners.push_back(b.c);
        auto hull = convex_hull_of(std::move(corners));
        if (!hull) return {std::nullopt, true};
        return {use_of(builder.shape(shape::Polyhedron{std::make_shared<const FacetList>(std::move(*hull))})), false};
    }
    keep_extreme_corners(balls);
    balls = without_hidden(balls);
    if (balls.size() > kMostBalls) return {};
    if (const auto box = rounded_box(balls)) return {use_of(builder.shape(*box)), false};
    HullContacts contacts = contacts_of(balls);
    std::vector<Use> parts;
    for (const Ball& b : balls) {
        if (b.r > 0) parts.push_back(use_of(builder.shape(shape::Ellipsoid{Vec3(b.r)}), Placement::translation(b.c)));
        else contacts.touched.push_back(b.c);
    }
    for (const auto& [i, j] : contacts.ridges) parts.push_back(touching_cone(builder, balls[i], balls[j]));
    if (auto polytope = convex_hull_of(std::move(contacts.touched))) parts.push_back(use_of(builder.shape(shape::Polyhedron{std::make_shared<const FacetList>(std::move(*polytope))})));
    if (parts.size() == 1) return {parts[0], false};
    return {use_of(builder.combine(SetOp::kUnion, std::move(parts))), false};
}

Use polygon_of(SolidBuilder& builder, std::vector<Vec2> ring) {
    return use_of(builder.shape(shape::Polygon{std::make_shared<const Contours>(Contours{std::move(ring)})}));
}

// Lines that touch two discs from one side: as common_tangents, in the plane.
std::vector<Vec2> common_tangents(const Ball& a, const Ball& b) {
    const Vec2 u{b.c.x - a.c.x, b.c.y - a.c.y};
    const double uu = glm::dot(u, u), p = a.r - b.r;
    if (!(uu > 0) || !(uu - p * p >= 0)) return {};
    const double across = std::sqrt(uu - p * p);
    return {(u * p + Vec2(-u.y, u.x) * across) / uu, (u * p - Vec2(-u.y, u.x) * across) / uu};
}

HullResult hull_of_discs(SolidBuilder& builder, std::vector<Ball> balls) {
    std::vector<Vec2> touched;
    for (const Ball& b : balls)
        if (b.r == 0) touched.emplace_back(b.c.x, b.c.y);
    touched = convex_hull_of(std::move(touched));
    balls.erase(std::remove_if(balls.begin(), balls.end(), [](const Ball& b) { return b.r == 0; }), balls.end());
    if (balls.empty()) {
        if (touched.size() < 3) return {std::nullopt, true};
        return {polygon_of(builder, std::move(touched)), false};
    }
    for (const Vec2& p : touched) balls.push_back({{p.x, p.y, 0}, 0});
    balls = without_hidden(balls);
    if (balls.size() > 16 * kMostBalls) return {};
    const double size = size_of(balls);
    std::vector<Use> parts;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls[i].r > 0) parts.push_back(use_of(builder.shape(shape::Disc{balls[i].r}), Placement::translation(balls[i].c)));
        for (std::size_t j = i + 1; j < balls.size(); ++j)
            for (const Vec2& n : common_tangents(balls[i], balls[j])) {
                if (!touches_all(balls, {n.x, n.y, 0}, n.x * balls[i].c.x + n.y * balls[i].c.y + balls[i].r, size)) continue;
                for (const Ball* b : {&balls[i], &balls[j]}) touched.emplace_back(b->c.x + b->r * n.x, b->c.y + b->r * n.y);
            }
    }
    touched = convex_hull_of(std::move(touched));
    if (touched.size() >= 3) parts.push_back(polygon_of(builder, std::move(touched)));
    if (parts.size() == 1) return {parts[0], false};
    return {use_of(builder.combine(SetOp::kUnion, std::move(parts))), false};
}

std::optional<std::vector<Ball>> all_balls(const SolidBuilder& builder, const std::vector<Use>& operands) {
    std::vector<Ball> out;
    for (const Use& use : operands) {
        const auto own = balls_of(builder.so_far(), use);
        if (!own) return std::nullopt;
        out.insert(out.end(), own->begin(), own->end());
    }
    return out;
}

Use extruded(SolidBuilder& builder, const Use& profile, double z0, double z1) {
    shape::Extrusion e{};
    e.profile = builder.combine(SetOp::kUnion, {profile});
    e.z0 = z0;
    e.z1 = z1;
    e.scale_top = Vec2(1);
    return use_of(builder.shape(e));
}

// Prisms of one height: the hull of their profiles, swept.
std::optional<HullResult> hull_of_prisms(SolidBuilder& builder, const std::vector<Use>& operands) {
    std::vector<Use> profiles;
    double z0 = 0, z1 = 0;
    for (const Use& use : operands) {
        const auto prism = prism_of(builder, use);
        if (!prism || (!profiles.empty() && (prism->z0 != z0 || prism->z1 != z1))) return std::nullopt;
        profiles.push_back(prism->profile);
        z0 = prism->z0;
        z1 = prism->z1;
    }
    const auto flat = exact_hull(builder, profiles);
    if (!flat.use) return std::nullopt;
    return HullResult{extruded(builder, *flat.use, z0, z1), false};
}

// Bodies of revolution about one upright axis by what turns about it: corners and discs of the plane y = 0, on both sides of the axis (x).
struct Meridians {
    std::optional<Vec2> axis;
    std::vector<Ball> parts;
    bool convex = true;

    bool add(const SolidBuilder& builder, const Use& use, const Placement& above) {
        if (use.motion != 0) return false;
        const Placement at = above * use.placement;
        const Node& node = builder.node(use.node);
        if (const auto* c = std::get_if<Combination>(&node)) {
            convex &= c->operands.size() == 1;
            return c->op == SetOp::kUnion && std::all_of(c->operands.begin(), c->operands.end(), [&](const Use& part) { return add(builder, part, at); });
        }
        const auto scale = similarity_of(at, true);
        if (!scale || !keeps_z(at) || (axis && *axis != Vec2(at.offset(0), at.offset(1)))) return false;
        axis = Vec2(at.offset(0), at.offset(1));
        const auto& shape = std::get<Shape>(node);
        const auto z = [&](double own) { return at.linear(2, 2) * own + at.offset(2); };
        const auto add_both = [&](double x, double height, double r) {
            for (const double side : {x, -x}) parts.push_back({{side, z(height), 0}, r});
        };
        if (const auto* cone = std::get_if<shape::Frustum>(&shape)) {
            add_both(cone->r0 * *scale, cone->z0, 0);
            add_both(cone->r1 * *scale, cone->z1, 0);
            return true;
        }
        if (!similarity_of(at, false)) return false;
        if (const auto* ball = std::get_if<shape::Ellipsoid>(&shape); ball && ball->radii == Vec3(ball->radii.x)) {
            parts.push_back({{0, z(0), 0}, ball->radii.x * *scale});
            return true;
        }
        if (const auto* ring = std::get_if<shape::Torus>(&shape)) {
            convex = false;
            add_both(ring->major * *scale, 0, ring->minor * *scale);
            return true;
        }
        return false;
    }
};

// The hull of the parts, turned.
std::optional<Use> turned_hull(SolidBuilder& builder, const Meridians& m) {
    const auto outline = hull_of_discs(builder, m.parts).use;
    if (!outline) return std::nullopt;
    shape::Revolution r{};
    r.angle_deg = 360;
    const auto* shape = std::get_if<Shape>(&builder.node(outline->node));
    if (const auto* polygon = shape ? std::get_if<shape::Polygon>(shape) : nullptr) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        std::vector<Vec2> right;
        for (const Vec2& p : polygon->contours->front()) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
            if (p.x > 0) right.push_back(p);
        }
        // From the axis at the bottom round to the axis at the top: the ring is counter-clockwise, so its right side goes up.
        const auto first = std::min_element(right.begin(), right.end(), [](Vec2 a, Vec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        std::rotate(right.begin(), first, right.end());
        right.insert(right.begin(), {0, low});
        right.push_back({0, high});
        r.profile = polygon_of(builder, std::move(right)).node;
    } else {
        const Bounds box = builder.bounds(*outline);
        const Use half = use_of(builder.shape(shape::Rectangle{{0, box.lo.y}, {box.hi.x, box.hi.y}}));
        r.profile = builder.combine(SetOp::kIntersection, {*outline, half});
    }
    return use_of(builder.shape(r), Placement::translation({m.axis->x, m.axis->y, 0}));
}

// Is the 2D set convex, with corners only? Then these are they.
std::optional<std::vector<Vec2>> convex_corners(const SolidBuilder& builder, const Use& use) {
    if (!std::holds_alternative<Shape>(builder.node(use.node))) return std::nullopt;
    const auto& shape = std::get<Shape>(builder.node(use.node));
    const auto* polygon = std::get_if<shape::Polygon>(&shape);
    if (!polygon && !std::holds_alternative<shape::Rectangle>(shape)) return std::nullopt;
    const auto balls = balls_of(builder.so_far(), use);
    if (!balls) return std::nullopt;
    std::vector<Vec2> corners;
    for (const Ball& b : *balls) corners.emplace_back(b.c.x, b.c.y);
    std::vector<Vec2> hull = convex_hull_of(corners);
    if (hull.size() < 3 || (polygon && (polygon->contours->size() != 1 || hull.size() != polygon->contours->front().size()))) return std::nullopt;
    return hull;
}

std::optional<Use> flat_sum(SolidBuilder& builder, const Use& a, const Use& b) {
    const auto p = convex_corners(builder, a), q = convex_corners(builder, b);
    if (p && q) {
        std::vector<Vec2> sums;
        for (const Vec2& x : *p)
            for (const Vec2& y : *q) sums.push_back(x + y);
        return polygon_of(builder, convex_hull_of(std::move(sums)));
    }
    // With a disc: the hull of the discs at the corners.
    const auto disc_of = [&](const Use& use) -> std::optional<Ball> {
        const auto* shape = std::get_if<Shape>(&builder.node(use.node));
        const auto balls = shape && std::holds_alternative<shape::Disc>(*shape) ? balls_of(builder.so_far(), use) : std::nullopt;
        return balls && balls->size() == 1 ? std::optional((*balls)[0]) : std::nullopt;
    };
    const auto disc = disc_of(b) ? disc_of(b) : disc_of(a), other = disc_of(b) && disc_of(a) ? disc_of(a) : std::nullopt;
    if (!disc) return std::nullopt;
    if (other) return use_of(builder.shape(shape::Disc{disc->r + other->r}), Placement::translation(disc->c + other->c));
    const auto& corners = disc_of(b) ? p : q;
    if (!corners) return std::nullopt;
    std::vector<Ball> grown;
    for (const Vec2& x : *corners) grown.push_back({Vec3(x, 0) + disc->c, disc->r});
    return hull_of_discs(builder, std::move(grown)).use;
}

// Balls of a convex solid whose hull it is; nothing for others.
std::optional<std::vector<Ball>> convex_balls(SolidBuilder& builder, const Use& use) {
    const auto* shape = std::get_if<Shape>(&builder.node(use.node));
    if (!shape || use.motion != 0) return std::nullopt;
    const bool always = std::holds_alternative<shape::Box>(*shape) || std::holds_alternative<shape::Ellipsoid>(*shape) || std::holds_alternative<shape::Capsule>(*shape) ||
                        std::holds_alternative<shape::RoundBox>(*shape) || std::holds_alternative<shape::FacetedBall>(*shape) ||
                        std::holds_alternative<shape::FacetedFrustum>(*shape);
    if (always) return balls_of(builder.so_far(), use);
    if (const auto prism = prism_of(builder, use)) {
        if (!convex_corners(builder, prism->profile)) return std::nullopt;
        return balls_of(builder.so_far(), use);
    }
    if (const auto* p = std::get_if<shape::Polyhedron>(shape)) {
        const auto hull = convex_hull_of(p->mesh->points);
        if (!hull || hull->points.size() != p->mesh->points.size()) return std::nullopt;
        double sizes[2] = {0, 0};
        const FacetList* lists[2] = {&*hull, p->mesh.get()};
        for (int i = 0; i < 2; ++i)
            for (const auto& f : lists[i]->facets)
                for (std::size_t k = 1; k + 1 < f.size(); ++k)
                    sizes[i] += glm::dot(lists[i]->points[f[0]], glm::cross(lists[i]->points[f[k]], lists[i]->points[f[k + 1]]));
        if (std::fabs(sizes[0] - sizes[1]) > kTangentRounding * std::fabs(sizes[0])) return std::nullopt;
        return balls_of(builder.so_far(), use);
    }
    return std::nullopt;
}

std::optional<Use> sum_of_prisms(SolidBuilder& builder, const Use& a, const Use& b) {
    const auto upright = prism_of(builder, a), other = upright ? prism_of(builder, b) : std::nullopt;
    if (!other) return std::nullopt;
    const auto profile = flat_sum(builder, upright->profile, other->profile);
    if (!profile) return std::nullopt;
    return extruded(builder, *profile, upright->z0 + other->z0, upright->z1 + other->z1);
}

// Of convex bodies of revolution: their reach adds up in every direction, so what turns about the axis is the sum of what turned.
std::optional<Use> sum_of_turned(SolidBuilder& builder, const Use& a, const Use& b) {
    Meridians p, q, sum;
    if (!p.add(builder, a, {}) || !q.add(builder, b, {}) || !p.convex || !q.convex) return std::nullopt;
    for (const Ball& x : p.parts)
        for (const Ball& y : q.parts) sum.parts.push_back({x.c + y.c, x.r + y.r});
    sum.axis = *p.axis + *q.axis;
    return turned_hull(builder, sum);
}

}  // namespace

HullResult exact_hull(SolidBuilder& builder, const std::vector<Use>& operands) {
    if (operands.empty()) return {std::nullopt, true};
    const auto balls = all_balls(builder, operands);
    if (builder.is_2d(operands[0].node)) return balls ? hull_of_discs(builder, *balls) : HullResult{};
    if (balls) return hull_of_balls(builder, *balls);
    if (auto prisms = hull_of_prisms(builder, operands)) return *prisms;
    Meridians m;
    if (std::all_of(operands.begin(), operands.end(), [&](const Use& use) { return m.add(builder, use, {}); })) return {turned_hull(builder, m), false};
    return {};
}

bool is_known_convex(SolidBuilder& builder, const Use& use) {
    if (use.motion != 0) return false;
    if (const auto* c = std::get_if<Combination>(&builder.node(use.node))) {
        if (c->operands.size() != 1) return false;
        const Use inner = c->operands[0];
        return is_known_convex(builder, inner);
    }
    const Shape shape = std::get<Shape>(builder.node(use.node));
    if (std::holds_alternative<shape::Frustum>(shape) || std::holds_alternative<shape::ConvexBody>(shape) || std::holds_alternative<shape::Ellipsoid>(shape)) return true;
    if (const auto* e = std::get_if<shape::Extrusion>(&shape); e && e->twist_deg == 0 && e->scale_top == Vec2(1)) {
        const Shape* profile = std::get_if<Shape>(&builder.node(e->profile));
        if (profile && std::holds_alternative<shape::Disc>(*profile)) return true;
    }
    return convex_balls(builder, use_of(use.node)).has_value();
}

std::optional<Use> exact_minkowski(SolidBuilder& builder, const Use& a, const Use& b) {
    if (builder.is_2d(a.node)) return flat_sum(builder, a, b);
    const auto p = convex_balls(builder, a), q = convex_balls(builder, b);
    if (p && q) {
        std::vector<Ball> sums;
        for (const Ball& x : *p)
            for (const Ball& y : *q) sums.push_back({x.c + y.c, x.r + y.r});
        if (const auto hull = hull_of_balls(builder, std::move(sums)); hull.use) return hull.use;
    }
    if (const auto prism = sum_of_prisms(builder, a, b)) return prism;
    return sum_of_turned(builder, a, b);
}

}  // namespace whittle
