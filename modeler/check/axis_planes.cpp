// axis_planes.cpp — gathers the planes of every node in its own frame, once a node, and maps them by the placements of its uses.
#include "modeler/check/axis_planes.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

using Planes = std::optional<AxisPlanes>;

Planes box_planes(Vec3 lo, Vec3 hi) { return AxisPlanes{{{lo.x, hi.x}, {lo.y, hi.y}, {lo.z, hi.z}}}; }

// Planes of the contour's edges; nothing where one is tilted.
Planes contour_planes(const std::vector<std::vector<Vec2>>& contours) {
    AxisPlanes planes;
    for (const std::vector<Vec2>& contour : contours)
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Vec2 a = contour[i], b = contour[(i + 1) % contour.size()];
            if (a.x != b.x && a.y != b.y) return {};
            planes[0].push_back(a.x);
            planes[1].push_back(a.y);
        }
    return planes;
}

Planes facet_planes(const FacetList& mesh) {
    AxisPlanes planes;
    for (const std::vector<std::uint32_t>& facet : mesh.facets) {
        bool flat = false;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = mesh.points[facet[0]][axis];
            if (!std::all_of(facet.begin(), facet.end(), [&](std::uint32_t v) { return mesh.points[v][axis] == at; })) continue;
            planes[static_cast<std::size_t>(axis)].push_back(at);
            flat = true;
        }
        if (!flat) return {};
    }
    return planes;
}

class Gatherer {
public:
    Gatherer(const Solid& solid, std::size_t limit) : solid_(solid), limit_(limit), known_(solid.node_count()), seen_(solid.node_count(), false) {}

    Planes of_use(const Use& use) {
        if (use.motion != 0) return {};
        const Planes& inner = of_node(use.node);
        return inner ? placed(*inner, use.placement) : Planes{};
    }

private:
    const Planes& of_node(NodeId id) {
        if (!seen_[id]) {
            seen_[id] = true;
            Planes planes = std::visit([&](const auto& node) { return of(node); }, solid_.node(id));
            if (planes && !tidy(*planes)) planes.reset();
            known_[id] = std::move(planes);
        }
        return known_[id];
    }

    Planes of(const Combination& combination) {
        AxisPlanes all;
        for (const Use& use : combination.operands) {
            const Planes part = of_use(use);
            if (!part) return {};
            for (std::size_t axis = 0; axis < 3; ++axis) all[axis].insert(all[axis].end(), (*part)[axis].begin(), (*part)[axis].end());
        }
        return all;
    }
    Planes of(const Shape& shape) {
        return std::visit([&](const auto& s) { return planes_of(s); }, shape);
    }
    Planes planes_of(const shape::Box& box) { return box_planes(box.lo, box.hi); }
    Planes planes_of(const shape::Rectangle& r) { return AxisPlanes{{{r.lo.x, r.hi.x}, {r.lo.y, r.hi.y}, {}}}; }
    Planes planes_of(const shape::Polygon& polygon) { return polygon.section == kEmptyNode ? contour_planes(*polygon.contours) : Planes{}; }
    Planes planes_of(const shape::Polyhedron& polyhedron) { return facet_planes(*polyhedron.mesh); }
    Planes planes_of(const shape::HalfSpace& half) {
        AxisPlanes planes;
        int axes = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (half.n[axis] == 0) continue;
            ++axes;
            planes[static_cast<std::size_t>(axis)].push_back(half.d / half.n[axis]);
        }
        return axes == 1 ? Planes(planes) : Planes{};
    }
    Planes planes_of(const shape::Extrusion& extrusion) {
        if (extrusion.twist_deg != 0 || extrusion.scale_top != Vec2(1)) return {};
        Planes planes = of_node(extrusion.profile);
        if (planes) (*planes)[2] = {extrusion.z0, extrusion.z1};
        return planes;
    }
    template <class Curved>
    Planes planes_of(const Curved&) { return {}; }

    // Each row of the placement must read one coordinate.
    static Planes placed(const AxisPlanes& inner, const Placement& placement) {
        AxisPlanes outer;
        for (int row = 0; row < 3; ++row) {
            int from = -1;
            for (int column = 0; column < 3; ++column) {
                if (placement.linear(row, column) == 0) continue;
                if (from >= 0) return {};
                from = column;
            }
            if (from < 0) return {};
            for (const double x : inner[static_cast<std::size_t>(from)])
                outer[static_cast<std::size_t>(row)].push_back(placement.linear(row, from) * x + placement.offset(row));
        }
        return outer;
    }

    bool tidy(AxisPlanes& planes) const {
        for (std::vector<double>& list : planes) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
            if (list.size() > limit_) return false;
        }
        return true;
    }

    const Solid& solid_;
    std::size_t limit_;
    std::vector<Planes> known_;
    std::vector<bool> seen_;
};

void merge_near(std::vector<double>& sorted) {
    if (sorted.empty()) return;
    const double gap = kPlaneMerge * (sorted.back() - sorted.front());
    sorted.erase(std::unique(sorted.begin(), sorted.end(), [gap](double a, double b) { return b - a <= gap; }), sorted.end());
}

}  // namespace

std::optional<AxisPlanes> axis_planes(const Solid& solid, std::size_t limit) {
    Planes planes = Gatherer(solid, limit).of_use(solid.root());
    if (!planes) return planes;
    for (std::vector<double>& list : *planes) {
        std::sort(list.begin(), list.end());
        merge_near(list);
        if (list.size() > limit) return {};
    }
    return planes;
}

}  // namespace whittle
