// facet_operations.h — hull, Minkowski sum, shadow and section of closed lists of facets: what operations without an exact form are made by, once their
// operands have become facets.
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/facets.h"
#include "csg/solid/solid.h"

namespace whittle {

// The list after the placement; facets are turned round where it mirrors.
FacetList placed_facets(const FacetList& list, const Placement& placement);

// Polyhedra whose union is the Minkowski sum of the two: one where both are convex. Else the sum of a and a connected b is a, moved by a point of b,
// and the sums of each facet of a with b; with b in turn cut likewise. Nothing where more than `most` parts would be needed.
std::optional<std::vector<FacetList>> minkowski_parts(const FacetList& a, const FacetList& b, std::size_t most);

// The same in the plane, as one set. Contours as contours_of makes them.
std::optional<Contours> flat_minkowski(const Contours& a, const Contours& b, std::size_t most);

// What the facets cover seen along z.
Contours shadow_of(const FacetList& list);

// The section of the solid with z = 0; where a facet lies in that plane, what is just above it.
Contours section_of(const FacetList& list);

}  // namespace whittle
