// lower_stretched.cpp — a polygon that shrinks or grows on its way up: each side sweeps a plane, or, where the two scales differ, a hyperbolic paraboloid.
//
// At height z the profile is scaled by kx and ky, linear in z and positive between the ends. The side from p along d, its inside on the left, is then
// d.y x ky - d.x y kx <= (d.y p.x - d.x p.y) kx ky, of degree two. A profile that is not convex is cut into triangles: the cuts are such sides too, shared by
// the two cells that meet there, so that no border is left.
#include <algorithm>

#include "csg/solid/convex_rings.h"
#include "csg/solid/predicates.h"
#include "csg/solid/profile.h"
#include "tracer/engine/formula_builder.h"

namespace whittle {

namespace {

// Of the size: sides carry roundings of 2^-52 of it, which grow where they meet by the inverse of the angle there.
constexpr double kBeyondCorners = 0x1p-38;

struct Scales {
    double x0, x1, y0, y1;  // kx = x0 + x1 z, ky likewise
};

Scales scales_of(const shape::Extrusion& e) {
    const double height = e.z1 - e.z0, x1 = (e.scale_top.x - 1) / height, y1 = (e.scale_top.y - 1) / height;
    return {1 - x1 * e.z0, x1, 1 - y1 * e.z0, y1};
}

std::array<double, 10> swept_side(Vec2 p, Vec2 q, const Scales& k) {
    const Vec2 d = q - p;
    const double c = d.x * p.y - d.y * p.x;
    return {0, 0, c * k.x1 * k.y1, 0, d.y * k.y1, -d.x * k.x1, d.y * k.y0, -d.x * k.x0, c * (k.x0 * k.y1 + k.x1 * k.y0), c * k.x0 * k.y0};
}

}  // namespace

bool FormulaBuilder::has_straight_sides(NodeId profile) const {
    const Node& n = solid_.node(profile);
    if (const auto* c = std::get_if<Combination>(&n))
        return std::all_of(c->operands.begin(), c->operands.end(), [&](const Use& u) { return has_straight_sides(u.node); });
    return !is_curved_2d(std::get<Shape>(n));
}

HalfSpaceRef FormulaBuilder::stretched_side(Placer& placer, const shape::Extrusion& e, Vec2 p, Vec2 q) {
    // Written from the lesser end, so that the two sides of a cut are one support.
    const bool turned = q.x != p.x ? q.x < p.x : q.y < p.y;
    if (turned) std::swap(p, q);
    const bool is_plane = p.x == q.x || p.y == q.y || e.scale_top.x == e.scale_top.y;
    HalfSpaceRef side = is_plane ? placer.side(Vec3(p, e.z0), Vec3(q, e.z0), Vec3(q * e.scale_top, e.z1)) : placer.quadric(swept_side(p, q, scales_of(e)));
    side.inverted = side.inverted != turned;
    return side;
}

void FormulaBuilder::note_rounding(double length, const Placement& placement) {
    const double longest = std::max(glm::length(Vec3(placement.m[0], placement.m[4], placement.m[8])), glm::length(Vec3(placement.m[1], placement.m[5], placement.m[9])));
    out_.largest_displacement = std::max(out_.largest_displacement, 2 * longest * std::abs(length));
}

std::vector<std::vector<Vec2>> FormulaBuilder::profile_rings(NodeId profile, const Placement& placement) {
    const Bounds& flat = solid_.bounds(profile);
    RoundedContours made = rounded_contours_of(solid_, profile, kProfileTolerance * glm::length(flat.hi - flat.lo));
    note_rounding(made.rounding, placement);
    return std::move(made.contours);
}

FormulaId FormulaBuilder::stretched(NodeId id, const shape::Extrusion& e, const Site& site) {
    const auto parts = convex_rings(profile_rings(e.profile, site.chain.whole()));
    if (!parts) return faceted(id, site);
    std::vector<FormulaId> cells;
    for (const auto& part : *parts) {
        Bounds box;
        for (const Vec2& p : part)
            for (const Vec3& corner : {Vec3(p, e.z0), Vec3(p * e.scale_top, e.z1)}) box = box.empty() ? Bounds{corner, corner} : Bounds{glm::min(box.lo, corner), glm::max(box.hi, corner)};
        Placer placer(out_, site.chain, site.motion, box, Absorb::kExact);
        std::vector<HalfSpaceRef> sides{placer.axis_plane(2, e.z0, false), placer.axis_plane(2, e.z1, true)};
        for (std::size_t i = 0; i < part.size(); ++i) sides.push_back(stretched_side(placer, e, part[i], part[(i + 1) % part.size()]));
        // Where one scale nearly ends in 0 all sides run into one line, beyond whose ends rounding would leave films without end.
        if (e.scale_top.x != e.scale_top.y)
            for (int axis = 0; axis < 2; ++axis) sides.insert(sides.end(), {placer.axis_plane(axis, box.lo[axis], false), placer.axis_plane(axis, box.hi[axis], true)});
        Bounds around = placer.root_box();
        if (around.empty()) continue;  // no part of it is in the section that it stands in
        const Vec3 size = around.hi - around.lo;
        const double room = kBeyondCorners * std::max({size.x, size.y, size.z});
        around.lo -= room;
        around.hi += room;
        cells.push_back(cell(std::move(sides), around, site));
    }
    return any_of(std::move(cells), site);
}

}  // namespace whittle
