// placed_facets.h — the facets of all leaves that have such, in the root frame: how far is the nearest one?
//
// Flat faces stay flat under every placement, so their distances are exact however a leaf is stretched; and only those beside a point are looked at.
#pragma once

#include <optional>

#include "modeler/arrange/box_tree.h"
#include "modeler/check/leaf_distance.h"

namespace whittle {

class PlacedFacets {
public:
    void add(const FacetList& list, const Placement& placement, SourcePlace place);
    void finish();  // after the last add, before the first question

    struct Nearest {
        double distance = kInfiniteDistance;
        SourcePlace place;
    };
    // Of the facets within `reach`; infinite where there is none.
    Nearest within(Vec3 p, double reach) const;
    Nearest nearest(Vec3 p) const;
    bool empty() const { return facets_.empty(); }

private:
    struct Facet {
        std::size_t first = 0, last = 0;  // of corners_
        std::size_t place = 0;
    };
    std::vector<Facet> facets_;
    std::vector<Vec3> corners_;
    std::vector<SourcePlace> places_;
    std::optional<BoxTree> tree_;
    DoubleBox box_;
};

}  // namespace whittle
