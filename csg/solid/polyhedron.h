// polyhedron.h — from a list of polygons to a closed surface of flat facets.
#pragma once

#include <cstddef>

#include "csg/solid/ear_clipping.h"
#include "csg/solid/solid.h"

namespace whittle {

// Points equal in all coordinates become one, in order of first appearance among the facets; points no facet uses and repeated corners go;
// facets left with fewer than three corners go.
FacetList welded(const FacetList& mesh);

// Edges that are not run along as often in one direction as in the other. 0 means closed and oriented.
std::size_t open_edges(const FacetList& mesh);

// Do all points of the facet lie in one plane, exactly?
bool is_flat(const FacetList& mesh, const std::vector<std::uint32_t>& facet);

// Facets that are not exactly flat are cut into triangles, by clipping ears in the plane the facet is nearest to; flat ones stay.
FacetList with_flat_facets(const FacetList& mesh);

// Triangles of one facet, with its orientation; corners index `mesh`. A polygon that is not simple becomes a fan.
std::vector<IndexTriangle> triangulated(const FacetList& mesh, const std::vector<std::uint32_t>& facet);

// Is the facet convex, seen along its normal?
bool is_convex(const FacetList& mesh, const std::vector<std::uint32_t>& facet);

// Facets that are not convex are cut into triangles: what is left may be fanned from any corner.
FacetList with_convex_facets(const FacetList& mesh);

// Positive where facets are counter-clockwise seen from outside; rounded.
double signed_volume(const FacetList& mesh);

}  // namespace whittle
