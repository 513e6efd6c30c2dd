#include "csg/solid/roof.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/polyhedron.h"
#include "csg/solid/predicates.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// Over the strip left of the side from a to b: what is higher than the distance from the side, up to `high`.
Use wedge(SolidBuilder& builder, Vec2 a, Vec2 b, double high) {
    const Vec2 along = b - a, left = Vec2(-along.y, along.x) / glm::length(along) * high;
    FacetList list;
    for (const Vec2 p : {a, b}) {
        list.points.emplace_back(p, 0);
        list.points.emplace_back(p, high);
        list.points.emplace_back(p + left, high);
    }
    list.facets = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
    return use_of(builder.shape(shape::Polyhedron{std::make_shared<const FacetList>(with_flat_facets(list))}));
}

}  // namespace

double ring_area(const std::vector<Vec2>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

bool is_one_convex_ring(const Contours& contours) {
    if (contours.size() != 1) return false;
    const auto& ring = contours[0];
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn_of(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0) return false;
    return true;
}

Use roof_of(SolidBuilder& builder, const Contours& floor) {
    Vec2 lo(HUGE_VAL), hi(-HUGE_VAL);
    for (const auto& ring : floor)
        for (const Vec2& p : ring) lo = glm::min(lo, p), hi = glm::max(hi, p);
    const double high = std::min(hi.x - lo.x, hi.y - lo.y);  // no inner point is that far from the border
    shape::Extrusion prism{};
    prism.profile = builder.shape(shape::Polygon{std::make_shared<const Contours>(floor)});
    prism.z1 = high;
    prism.scale_top = Vec2(1);
    std::vector<Use> operands{use_of(builder.shape(prism))};
    const NodeId cone = builder.shape(shape::Frustum{0, high, 0, high});
    for (const auto& ring : floor)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
            if (a == b) continue;
            operands.push_back(wedge(builder, a, b, high));
            if (turn_of(a, b, c) < 0) operands.push_back(use_of(cone, Placement::translation({b.x, b.y, 0})));
        }
    return use_of(builder.combine(SetOp::kDifference, std::move(operands)));
}

}  // namespace whittle
