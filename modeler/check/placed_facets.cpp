#include "modeler/check/placed_facets.h"

#include <algorithm>

#include "modeler/check/nearest_point.h"

namespace whittle {

namespace {

std::array<double, 3> triple(Vec3 p) { return {p.x, p.y, p.z}; }

}  // namespace

void PlacedFacets::add(const FacetList& list, const Placement& placement, SourcePlace place) {
    places_.push_back(place);
    for (const auto& facet : list.facets) {
        const std::size_t first = corners_.size();
        for (const std::uint32_t v : facet) corners_.push_back(apply_to_point(placement, list.points[v]));
        facets_.push_back({first, corners_.size(), places_.size() - 1});
    }
}

void PlacedFacets::finish() {
    std::vector<DoubleBox> boxes;
    for (const Facet& f : facets_) {
        DoubleBox box = DoubleBox::at(triple(corners_[f.first]));
        for (std::size_t i = f.first; i < f.last; ++i) box.include(triple(corners_[i]));
        if (boxes.empty()) box_ = box;
        box_.include(box);
        boxes.push_back(box);
    }
    tree_.emplace(std::move(boxes), std::vector<std::uint32_t>(facets_.size(), BoxTree::kMixed));
}

PlacedFacets::Nearest PlacedFacets::within(Vec3 p, double reach) const {
    Nearest best;
    if (facets_.empty()) return best;
    tree_->touching({triple(p - reach), triple(p + reach)}, [&](std::uint32_t i) {
        const Facet& f = facets_[i];
        const double d = distance_to_polygon(p, {corners_.data() + f.first, f.last - f.first});
        if (d < best.distance) best = {d, places_[f.place]};
    });
    return best;
}

PlacedFacets::Nearest PlacedFacets::nearest(Vec3 p) const {
    if (facets_.empty()) return {};
    double farthest = 0;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        farthest += std::max(std::fabs(p[i] - box_.lo[k]), std::fabs(p[i] - box_.hi[k]));
    }
    // What is found within a box of half width `reach` and nearer than that is the nearest.
    constexpr double kFirstShare = 0x1p-20;
    for (double reach = kFirstShare * farthest; reach < farthest; reach *= 4)
        if (const Nearest found = within(p, reach); found.distance <= reach) return found;
    return within(p, farthest);
}

}  // namespace whittle
