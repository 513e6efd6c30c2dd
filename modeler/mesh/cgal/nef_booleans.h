// nef_booleans.h — set operations by CGAL's Nef polyhedra, for what corefinement declines: solids that touch along an edge or in a point.
#pragma once

#include <string>
#include <vector>

#include "modeler/mesh/cgal/booleans_module.h"

namespace whittle {

// The whole expression, regularised; `leaf` of a triangle is that of an operand's facet in whose plane it lies. Its edges may have 2k facets. Operands are as
// those of whittle_cgal_booleans_1(), `steps` well formed. False and what is wrong where an operand is no closed manifold. May throw CGAL's faults.
bool nef_booleans(const std::vector<Mesh>& operands, const std::vector<BooleanStep>& steps, Mesh& out, std::string& fault);

}  // namespace whittle
