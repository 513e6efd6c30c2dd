// lower_turned.cpp — profiles that turn, or shrink unevenly, on their way up: each side sweeps a true helical or ruled surface.
//
// At each height the section is the turned and scaled profile, so the formula of the profile holds with each side's swept surface in its place. The way up is cut
// into pieces of at most 45 degrees between planes, which makes boxes tight and crossings few. A polygon that is not convex is cut into triangles; the cuts
// are swept sides too, shared by the two cells that meet there, so that no border is left.
#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/convex_rings.h"
#include "csg/solid/predicates.h"
#include "tracer/engine/formula_builder.h"

namespace whittle {

namespace {

constexpr double kMostDegrees = 45;        // of a piece
constexpr double kMostPieces = 1 << 14;
constexpr double kOutward = 1 + 0x1p-30;   // of boxes and reaches: far over what rounds them

Placement without_offset(Placement p) {
    for (const std::size_t i : {3u, 7u, 11u}) p.m[i] = 0;
    return p;
}

void include(Bounds& box, const Vec3& p) { box = box.empty() ? Bounds{p, p} : Bounds{glm::min(box.lo, p), glm::max(box.hi, p)}; }

// The farthest that a scale, linear over the piece, is from 0 and the nearest.
Vec2 scales_at(const Twist& w, double z) {
    const double share = (z - w.z0) / (w.z1 - w.z0);
    return {1 + (w.scale_x - 1) * share, 1 + (w.scale_y - 1) * share};
}

// Of a placement that does nothing but scale by a power of two; 1 of any other. Such a scale is taken into the numbers, which it does not round: bounds then
// are those of the solid without it, to the bit.
double exact_scale(const Placement& p) {
    const double k = p.linear(0, 0);
    int exponent = 0;
    Placement scale;
    for (const std::size_t i : {0u, 5u, 10u}) scale.m[i] = k;
    return std::frexp(k, &exponent) == 0.5 && p == scale ? k : 1;
}

Twist scaled(Twist w, double k) {
    for (double* x : {&w.z0, &w.z1, &w.from, &w.to, &w.reach}) *x *= k;
    return w;
}

// Around the paths of the points over the piece: an arc is within its chord's box grown by its rise, and scales are largest and least at the ends.
Bounds swept_box(const Twist& w, const std::vector<Vec2>& points) {
    const double first = w.degrees * (w.from - w.z0) / (w.z1 - w.z0), last = w.degrees * (w.to - w.z0) / (w.z1 - w.z0);
    const double half = (last - first) * 0.5, rise = std::abs(half) < 90 ? 1 - cosd(half) : 2;
    const Vec2 low = scales_at(w, w.from), high = scales_at(w, w.to);
    Bounds box;
    for (const Vec2& p : points) {
        const double r = glm::length(p) * rise;
        Vec2 lo(HUGE_VAL), hi(-HUGE_VAL);
        for (const double a : {first, last}) {
            const Vec2 q(cosd(a) * p.x + sind(a) * p.y, cosd(a) * p.y - sind(a) * p.x);
            lo = glm::min(lo, q - r);
            hi = glm::max(hi, q + r);
        }
        for (const Vec2& k : {low, high})
            for (const Vec2& q : {lo * k, hi * k}) {
                include(box, Vec3(q, w.from));
                include(box, Vec3(q, w.to));
            }
    }
    const Vec3 size = box.hi - box.lo;
    const double room = (kOutward - 1) * (w.reach + std::max({size.x, size.y, size.z}));
    box.lo -= room;
    box.hi += room;
    return box;
}

}  // namespace

FormulaId FormulaBuilder::turned(NodeId id, const shape::Extrusion& e, const Site& site) {
    const Bounds &flat = solid_.bounds(e.profile), &whole = solid_.bounds(id);
    const Vec2 far = glm::max(glm::abs(Vec2(flat.lo)), glm::abs(Vec2(flat.hi)));
    Twist twist{e.z0, e.z1, e.twist_deg, e.scale_top.x, e.scale_top.y, e.z0, e.z1, 0};
    twist.reach = glm::length(far) * std::max({1.0, e.scale_top.x, e.scale_top.y}) * kOutward;
    const double scale = site.chain.section() ? 1 : exact_scale(site.chain.whole());
    const int pieces = static_cast<int>(std::clamp(std::ceil(std::abs(e.twist_deg) / kMostDegrees), 1.0, kMostPieces));
    std::vector<FormulaId> parts;
    for (int i = 0; i < pieces; ++i) {
        const auto height = [&](int k) { return k == 0 ? e.z0 : k == pieces ? e.z1 : e.z0 + (e.z1 - e.z0) * k / pieces; };
        twist.from = height(i);
        twist.to = height(i + 1);
        if (!(twist.from < twist.to)) return faceted(id, site);
        Turning turning{scale == 1 ? site.chain : Chain(), scaled(twist, scale), false};
        Placer p(out_, site.chain, site.motion, {Vec3(whole.lo.x, whole.lo.y, twist.from), Vec3(whole.hi.x, whole.hi.y, twist.to)}, Absorb::kAny);
        std::vector<HalfSpaceRef> sides{p.axis_plane(2, twist.from, false), p.axis_plane(2, twist.to, true)};
        const FormulaId ends = cell(std::move(sides), p.root_box(), site);
        Site within = site;
        within.chain = Chain().then({{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0}});
        within.turning = &turning;
        parts.push_back(all_of({ends, node(e.profile, within)}, site));
        if (turning.failed) return faceted(id, site);
    }
    return any_of(std::move(parts), site);
}

// Where a scale ends in 0, or all but, sides go on beyond the line or point that they run into, mirrored, and the plane that ends them is rounded in another frame:
// what would be left between is a film, and may be far longer than the solid. Two planes through that line, which lean so little that the solid stays below them,
// leave nothing beyond.
void add_roof(const Twist& w, Placer& p, std::vector<HalfSpaceRef>& sides) {
    constexpr double kNear = 0x1p-20;
    const double scale = std::min(w.scale_x, w.scale_y);
    if (!(scale < kNear) || w.to != w.z1) return;
    const double height = w.z1 - w.z0, apex = scale == 0 ? w.z1 : std::max(w.z1, std::nextafter(w.z0 + height / (1 - scale), w.z0));
    for (const double lean : {-height / (8 * w.reach), height / (8 * w.reach)}) sides.push_back(p.plane(w.scale_x <= w.scale_y ? Vec3(lean, 0, 1) : Vec3(0, lean, 1), apex));
}

FormulaId FormulaBuilder::turned_cell(const std::vector<Vec2>& around, const Site& site, const std::function<std::vector<HalfSpaceRef>(Placer&)>& sides) {
    const Twist& twist = site.turning->twist;
    Placer p(out_, site.turning->chain, site.motion, swept_box(twist, around), Absorb::kNothing, &twist);
    std::vector<HalfSpaceRef> all = sides(p);
    add_roof(twist, p, all);
    return cell(std::move(all), p.root_box(), site);
}

FormulaId FormulaBuilder::turned_ring(const std::vector<Vec2>& ring, const Site& site) {
    return turned_cell(ring, site, [&](Placer& p) {
        std::vector<HalfSpaceRef> sides;
        for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back(p.turned_side(ring[i], ring[(i + 1) % ring.size()]));
        return sides;
    });
}

// The point of the profile where the extrusion sees it, rounded once.
Vec2 FormulaBuilder::turned_image(Vec2 p, const Site& site) {
    const Placement map = site.chain.whole();
    Vec2 r;
    for (int i = 0; i < 2; ++i) {
        const Wide x = Wide(map.linear(i, 0)) * p.x + Wide(map.linear(i, 1)) * p.y + map.offset(i);
        r[i] = to_double(x);
        note_rounding(to_double(x - r[i]), site.turning->chain.whole());
    }
    return r;
}

FormulaId FormulaBuilder::turned_shape(NodeId id, const Shape& shape, const Site& site) {
    const auto at = [&](Vec2 p) { return turned_image(p, site); };
    if (const auto* disc = std::get_if<shape::Disc>(&shape)) {
        Site about_centre = site;
        about_centre.chain = Chain().then(without_offset(site.chain.whole()));
        const Vec2 centre = at(Vec2(0)), u = turned_image({disc->r, 0}, about_centre), v = turned_image({0, disc->r}, about_centre);
        return turned_cell({centre - u - v, centre + u - v, centre + u + v, centre - u + v}, site,
                           [&](Placer& p) { return std::vector<HalfSpaceRef>{p.turned_ellipse(centre, u, v)}; });
    }
    if (const auto* arc = std::get_if<shape::ParabolicSegment>(&shape)) {
        const Vec2 a = at(arc->a), c = at(arc->c), b = at(arc->b);
        const int turn = turn_of(a, c, b);
        if (turn == 0) return constant(site.negated);
        return turned_cell({a, c, b}, site, [&](Placer& p) {
            return std::vector<HalfSpaceRef>{turn < 0 ? p.turned_side(a, b) : p.turned_side(b, a), p.turned_parabola(a, c, b)};
        });
    }
    return turned_polygons(id, site);
}

FormulaId FormulaBuilder::turned_polygons(NodeId id, const Site& site) {
    const Placement map = site.chain.whole();
    std::vector<std::vector<Vec2>> rings = profile_rings(id, site.turning->chain.whole() * map);
    const bool mirrored = map.linear(0, 0) * map.linear(1, 1) - map.linear(0, 1) * map.linear(1, 0) < 0;
    for (auto& ring : rings) {
        for (Vec2& p : ring) p = turned_image(p, site);
        if (mirrored) std::reverse(ring.begin(), ring.end());
    }
    if (rings.empty()) return constant(site.negated);
    const auto parts = convex_rings(std::move(rings));
    if (!parts) {
        site.turning->failed = true;
        return constant(site.negated);
    }
    std::vector<FormulaId> cells;
    for (const auto& ring : *parts) cells.push_back(turned_ring(ring, site));
    return any_of(std::move(cells), site);
}

}  // namespace whittle
