// random_shape.cpp — see random_shape.h.
#include "tests/support/random_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/base/degrees.h"

namespace whittle::support {

namespace {

std::vector<Vec3> box_points(const Vec3& lo, const Vec3& hi) {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
    points.push_back((lo + hi) * 0.5);
    points.push_back({hi.x, lo.y + (hi.y - lo.y) * 0.25, hi.z});
    points.push_back({lo.x + (hi.x - lo.x) * 0.25, lo.y + (hi.y - lo.y) * 0.5, hi.z});
    return points;
}

std::vector<Vec3> round_points(const Vec3& r) {
    return {{0, 0, 0}, {r.x, 0, 0}, {-r.x, 0, 0}, {0, r.y, 0}, {0, 0, r.z}, {r.x, 0, r.z}, {0.6 * r.x, 0.8 * r.y, 0}};
}

Sketch box(Dice& dice) {
    Vec3 lo, hi;
    for (int i = 0; i < 3; ++i) {
        const double a = dice.length();
        lo[i] = dice.one_in(2) ? -a : 0;
        hi[i] = dice.one_in(3) ? a : dice.length();
    }
    return {shape::Box{lo, hi}, box_points(lo, hi)};
}

Sketch ellipsoid(Dice& dice) {
    const double r = dice.length();
    const Vec3 radii = dice.one_in(2) ? Vec3(r) : Vec3(r, dice.length(), dice.length());
    return {shape::Ellipsoid{radii}, round_points(radii)};
}

Sketch frustum(Dice& dice) {
    const double r = dice.length(), h = dice.length(), z0 = dice.one_in(2) ? 0 : -dice.length();
    const double r0 = dice.one_in(6) ? 0 : r, r1 = r0 == 0 || dice.one_in(2) ? r : dice.one_in(2) ? 0 : dice.length();
    std::vector<Vec3> points = round_points({r0, r0, z0});
    for (const Vec3& p : round_points({r1, r1, h})) points.push_back({p.x, p.y, h});
    return {shape::Frustum{z0, h, r0, r1}, points};
}

Sketch torus(Dice& dice) {
    const double major = dice.length(), minor = dice.one_in(4) ? dice.length() : std::min(dice.length(), major);
    return {shape::Torus{major, minor},
            {{0, 0, 0}, {major + minor, 0, 0}, {major - minor, 0, 0}, {major, 0, minor}, {0, major, 0}, {0, major + minor, 0}, {0.6 * major, 0.8 * major, minor}}};
}

Sketch half_space(Dice& dice) {
    Vec3 n = dice.one_in(2) ? Vec3(0) : dice.vector();
    if (n == Vec3(0)) n[dice.integer(0, 2)] = dice.pick<double>({1, -1});
    const double d = dice.offset();
    return {shape::HalfSpace{n, d}, {n * (d / dot(n, n)), {n.z, n.x, n.y}}, false};
}

Sketch quadric(Dice& dice) {
    const double r = dice.length();
    switch (dice.integer(0, 4)) {
        case 0: return {shape::Quadric{{1, 1, 0, 0, 0, 0, 0, 0, -1, 0}}, {{0, 0, 0}, {1, 0, 1}}, false};       // paraboloid
        case 1: return {shape::Quadric{{1, 1, -1, 0, 0, 0, 0, 0, 0, -r}}, {{0, 0, 0}, {r, 0, 0}, {r, 1, 1}}, false};  // hyperboloids
        case 2: return {shape::Quadric{{1, -1, 0, 0, 0, 0, 0, 0, -1, 0}}, {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}}, false};  // saddle
        case 3: return {shape::Quadric{{1, 0, 0, 0, 0, 0, 0, 0, 0, -r * r}}, {{r, 0, 0}, {-r, 0, 1}}, false};      // a slab
        default: {
            shape::Quadric q{};
            for (double& c : q.c) c = dice.offset();
            if (q.c == std::array<double, 10>{}) q.c[9] = -1;
            return {q, {{0, 0, 0}, {1, 1, 1}}, false};
        }
    }
}

Sketch capsule(Dice& dice) {
    Vec3 p = dice.vector(), q = dice.one_in(2) ? p + Vec3(0, 0, dice.length()) : dice.vector();
    if (p == q) q.z = p.z + 1;
    const double r = dice.length() * 0.5;
    return {shape::Capsule{p, q, r}, {p, q, p + Vec3(r, 0, 0), q + Vec3(0, r, 0), (p + q) * 0.5 + Vec3(r, 0, 0)}};
}

Sketch round_box(Dice& dice) {
    const Vec3 hi{dice.length(), dice.length(), dice.length()};
    const double r = std::min({hi.x, hi.y, hi.z}) * dice.pick<double>({0.25, 0.5, 0.125});
    std::vector<Vec3> points = box_points(Vec3(r), hi - r);
    for (const Vec3& p : box_points(Vec3(0), hi)) points.push_back(p);
    return {shape::RoundBox{Vec3(0), hi, r}, points};
}

Sketch polyhedron(Dice& dice) {
    auto m = std::make_shared<FacetList>();
    const double a = dice.length(), b = dice.length(), c = dice.length();
    switch (dice.integer(0, 3)) {
        case 0:
            m->points = box_points({0, 0, 0}, {a, b, c});
            m->points.resize(8);
            m->facets = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
            break;
        case 1:
            m->points = {{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}};
            m->facets = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
            break;
        case 2:
            m->points = {{a, 0, 0}, {-a, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}};
            m->facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
            break;
        default:  // an L, not convex
            for (const double z : {0.0, c})
                for (const Vec2& p : {Vec2{0, 0}, {2 * a, 0}, {2 * a, b}, {a, b}, {a, 2 * b}, {0, 2 * b}}) m->points.push_back({p.x, p.y, z});
            m->facets = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
            for (std::uint32_t i = 0; i < 6; ++i) m->facets.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
    }
    std::vector<Vec3> points = m->points;
    points.push_back((points[0] + points[1]) * 0.5);
    return {shape::Polyhedron{std::move(m)}, points};
}

// Corners of a ring of n, at most eight of them.
void add_ring(double r, int n, double z, std::vector<Vec3>& points) {
    for (int i = 0; i < n && i < 8; ++i) points.push_back({r * cosd(360.0 * i / n), r * sind(360.0 * i / n), z});
}

// Like OpenSCAD's with $fn.
Sketch faceted(Dice& dice) {
    const int n = dice.pick({3, 4, 5, 6, 8, 12});
    const double a = dice.length(), b = dice.length(), h = dice.length();
    std::vector<Vec3> points{{0, 0, 0}};
    if (dice.one_in(2)) {
        const double from = dice.one_in(2) ? 0 : -h, top = dice.pick<double>({a, b, 0});
        add_ring(a, n, from, points);
        add_ring(top, n, from + h, points);
        points.push_back((points[1] + points[2]) * 0.5);
        return {shape::FacetedFrustum{from, from + h, a, top, n}, points};
    }
    const int rings = (n + 1) / 2;
    for (int i = 0; i < rings && i < 3; ++i) {
        const double deg = 180 * (i + 0.5) / rings;
        add_ring(a * sind(deg), n, a * cosd(deg), points);
    }
    return {shape::FacetedBall{a, n}, points};
}

Sketch extrusion(SolidBuilder& builder, Dice& dice, bool planes) {
    const NodeId profile = random_profile(builder, dice, planes, false);
    const double h = dice.length();
    Vec2 scale{1, 1};
    if (dice.one_in(3)) scale = Vec2(dice.pick<double>({0, 0.5, 2, 0.75}));
    else if (dice.one_in(6)) scale = {0.5, dice.pick<double>({1, 2, 0})};
    const Bounds b = builder.bounds(profile);
    return {shape::Extrusion{profile, 0, h, 0, scale, 0}, box_points({b.lo.x, b.lo.y, 0}, {b.hi.x, b.hi.y, h})};
}

Sketch twist(SolidBuilder& builder, Dice& dice) {
    const NodeId profile = random_profile(builder, dice, true, false);
    const double h = dice.length();
    const Bounds b = builder.bounds(profile);
    return {shape::Extrusion{profile, 0, h, dice.pick<double>({30, 90, -45}), {1, 1}, dice.integer(2, 4)}, box_points({b.lo.x, b.lo.y, 0}, {b.hi.x, b.hi.y, h})};
}

Sketch revolution(SolidBuilder& builder, Dice& dice) {
    const NodeId profile = random_profile(builder, dice, dice.one_in(2), !dice.one_in(4));
    const double start = dice.pick<double>({0, 0, 90, 30, -45}), angle = dice.one_in(2) ? 360 : dice.pick<double>({90, 180, 270, 45, 200});
    const Bounds b = builder.bounds(profile);
    std::vector<Vec3> points = round_points({b.hi.x, b.hi.x, b.hi.y});
    points.push_back({b.hi.x, 0, b.lo.y});
    points.push_back({0, 0, b.lo.y});
    return {shape::Revolution{profile, start, angle, 0}, points};
}

// Where the section's plane is z = 0: turned by a grid's or any angles, perhaps sheared, mirrored or scaled, and moved along z so that the plane is likely to meet it.
Placement askew(Dice& dice) {
    const auto turn = [](int axis, double deg) {
        const std::size_t i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
        Placement p;
        p.m[4 * i + i] = p.m[4 * j + j] = cosd(deg);
        p.m[4 * i + j] = -sind(deg);
        p.m[4 * j + i] = sind(deg);
        return p;
    };
    Placement p = turn(0, dice.pick<double>({90, 90, 30, 45, 60, 120})) * turn(2, dice.pick<double>({0, 0, 90, 20, 45}));
    if (dice.one_in(3)) p = turn(1, dice.pick<double>({90, 15, 45})) * p;
    if (dice.one_in(4)) p = p * Placement{{1, 0.5, 0, 0, 0, -1, 0, 0, 0, 0, 2, 0}};
    p.m[11] = dice.one_in(3) ? 0 : 0.5 * dice.offset();
    if (dice.one_in(2)) p.m[3] = dice.offset();
    return p;
}

// What a projection sweeps along z again; its polygon is read by nothing but what turns or shrinks it.
Sketch section(SolidBuilder& builder, Dice& dice) {
    Use inner;
    switch (dice.integer(0, 5)) {
        case 0: inner.node = builder.shape(frustum(dice).shape); break;
        case 1: inner.node = builder.shape(revolution(builder, dice).shape); break;
        case 2: inner.node = builder.shape(capsule(dice).shape); break;
        case 3: inner.node = builder.shape(round_box(dice).shape); break;
        case 4: inner.node = builder.shape(ellipsoid(dice).shape); break;
        default: inner.node = builder.shape(torus(dice).shape);
    }
    inner.placement = askew(dice);
    const Bounds b = builder.bounds(inner);
    auto contours = std::make_shared<const std::vector<std::vector<Vec2>>>(std::vector<std::vector<Vec2>>{{{b.lo.x, b.lo.y}, {b.hi.x, b.lo.y}, {b.hi.x, b.hi.y}}});
    const NodeId profile = builder.shape(shape::Polygon{std::move(contours), builder.combine(SetOp::kUnion, {inner})});
    const double h = dice.length();
    return {shape::Extrusion{profile, 0, h, 0, Vec2(1), 0}, box_points({b.lo.x, b.lo.y, 0}, {b.hi.x, b.hi.y, h})};
}

}  // namespace

void Dice::pool(bool coarse) {
    pool_.clear();
    for (int i = integer(2, 5); i > 0; --i) pool_.push_back(integer(1, 8) * 0.25);
    if (coarse) return;
    for (int i = integer(1, 3); i > 0; --i) pool_.push_back(one_in(2) ? integer(1, 20) * 0.1 : real(0.05, 2));
}

NodeId random_profile(SolidBuilder& builder, Dice& dice, bool planes, bool right) {
    const auto one = [&] {
        const int kind = planes ? dice.integer(1, 2) : dice.integer(0, 2);
        const double a = dice.length(), b = dice.length();
        Use use;
        if (kind == 0) use.node = builder.shape(shape::Disc{a});
        if (kind == 1) use.node = builder.shape(shape::Rectangle{{dice.one_in(2) || right ? 0 : -a, dice.one_in(2) ? 0 : -b}, {a, b}});
        if (kind == 2) {
            std::vector<std::vector<Vec2>> contours{dice.one_in(2) ? std::vector<Vec2>{{0, 0}, {a, 0}, {0, b}}
                                                                   : std::vector<Vec2>{{0, 0}, {2 * a, 0}, {2 * a, b}, {a, b}, {a, 2 * b}, {0, 2 * b}}};
            if (dice.one_in(3)) contours.push_back({{a * 0.25, b * 0.25}, {a * 0.25, b * 0.5}, {a * 0.5, b * 0.25}});
            use.node = builder.shape(shape::Polygon{std::make_shared<const std::vector<std::vector<Vec2>>>(std::move(contours))});
            if (!planes && !right && a == b) use.node = builder.shape(shape::ParabolicSegment{{0, 0}, {a, 2 * a}, {2 * a, 0}});
        }
        if (right) use.placement = Placement::translation({kind == 0 ? a + (dice.one_in(2) ? 0 : b) : dice.one_in(2) ? 0 : b, dice.offset(), 0});
        else if (!dice.one_in(3)) use.placement = Placement::translation({dice.offset(), dice.offset(), 0});
        if (!right && dice.one_in(6)) use.placement = {{0, -1, 0, dice.offset(), 1, 0, 0, 0, 0, 0, 1, 0}};
        return use;
    };
    std::vector<Use> uses{one()};
    const int more = dice.one_in(2) ? 0 : dice.integer(1, 2);
    for (int i = 0; i < more; ++i) uses.push_back(one());
    return builder.combine(dice.pick({SetOp::kUnion, SetOp::kUnion, SetOp::kDifference, SetOp::kIntersection}), uses);
}

const char* name_of(ShapeKind kind) {
    constexpr std::array<const char*, kShapeKinds> names{"box", "polyhedron", "ellipsoid", "frustum", "torus", "capsule", "round box", "quadric", "half-space", "extrusion", "revolution", "faceted", "twist", "convex body", "section"};
    return names[static_cast<std::size_t>(kind)];
}

Sketch random_shape_of(ShapeKind kind, SolidBuilder& builder, Dice& dice) {
    switch (kind) {
        case ShapeKind::kBox: return box(dice);
        case ShapeKind::kPolyhedron: return polyhedron(dice);
        case ShapeKind::kEllipsoid: return ellipsoid(dice);
        case ShapeKind::kFrustum: return frustum(dice);
        case ShapeKind::kTorus: return torus(dice);
        case ShapeKind::kCapsule: return capsule(dice);
        case ShapeKind::kRoundBox: return round_box(dice);
        case ShapeKind::kQuadric: return quadric(dice);
        case ShapeKind::kHalfSpace: return half_space(dice);
        case ShapeKind::kExtrusion: return extrusion(builder, dice, false);
        case ShapeKind::kFaceted: return faceted(dice);
        case ShapeKind::kTwist: return twist(builder, dice);
        case ShapeKind::kConvex: return random_convex(dice);
        case ShapeKind::kSection: return section(builder, dice);
        default: return revolution(builder, dice);
    }
}

Sketch random_shape(SolidBuilder& builder, Dice& dice, Repertoire repertoire) {
    if (repertoire == Repertoire::kPlanes) {
        const int kind = dice.integer(0, 10);
        if (kind == 10) return faceted(dice);
        return kind < 5 ? box(dice) : kind < 7 ? polyhedron(dice) : kind < 9 ? extrusion(builder, dice, true) : half_space(dice);
    }
    const int kind = dice.integer(repertoire == Repertoire::kRound ? 4 : 0, 21);
    if (kind == 21) return section(builder, dice);
    if (kind < 3) return box(dice);
    if (kind < 4) return polyhedron(dice);
    if (kind < 7) return ellipsoid(dice);
    if (kind < 11) return frustum(dice);
    if (kind < 13) return torus(dice);
    if (kind < 14) return capsule(dice);
    if (kind < 15) return round_box(dice);
    if (kind < 16) return quadric(dice);
    if (kind < 17) return half_space(dice);
    if (kind < 18) return extrusion(builder, dice, false);
    if (kind == 20) return faceted(dice);
    return revolution(builder, dice);
}

}  // namespace whittle::support
