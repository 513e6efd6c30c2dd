// solids.h — short names for making the solids of the reference's tests.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "csg/solid/solid.h"
#include "tests/reference/reference.h"

namespace whittle::reference {

inline Placement rows(std::array<double, 12> m) { return Placement{m}; }

inline Solid single(Shape shape, const Placement& placement = {}) {
    SolidBuilder b;
    Use use;
    use.node = b.shape(std::move(shape));
    use.placement = placement;
    return b.finish(use);
}

inline Use use_of(NodeId node, const Placement& placement = {}) {
    Use use;
    use.node = node;
    use.placement = placement;
    return use;
}

// The t of the borders: the double in the interval where there is one, else the one below in magnitude.
inline std::vector<double> ts(const Borders& b) {
    std::vector<double> r;
    for (const Border& border : b.borders) {
        const double below = border.lo.to_double(), above = std::nextafter(below, HUGE_VAL);
        r.push_back(Dyadic(above) <= border.hi ? above : below);
    }
    return r;
}

inline bool same_borders(const Borders& a, const Borders& b) {
    if (a.starts_inside != b.starts_inside || a.borders.size() != b.borders.size()) return false;
    for (std::size_t i = 0; i < a.borders.size(); ++i) {
        const Border &p = a.borders[i], &q = b.borders[i];
        if (p.entering != q.entering || q.hi < p.lo || p.hi < q.lo) return false;
    }
    return true;
}

// Closed mesh of a box, facets counter-clockwise from outside.
inline std::shared_ptr<const FacetList> box_mesh(const Vec3& lo, const Vec3& hi) {
    auto m = std::make_shared<FacetList>();
    for (int i = 0; i < 8; ++i) m->points.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
    m->facets = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return m;
}

}  // namespace whittle::reference
