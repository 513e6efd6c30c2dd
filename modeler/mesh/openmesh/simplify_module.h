// simplify_module.h — OpenMesh's decimation. The number in a name changes with its parameters.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "modeler/mesh/mesh.h"

// Fewer triangles: edges collapse, those of least quadric error first, while points that have gone stay within about `distance_mm` of the triangles, and the
// middles of new triangles and of their sides where `is_near` says (what is true of the result is measured by who asks). A border
// between two groups gives up corners likewise; where borders meet, corners stay. `in` is closed and oriented, no edge has more than two faces.
extern "C" bool whittle_openmesh_simplify_2(const whittle::Mesh& in, const std::vector<std::uint32_t>& groups, double distance_mm,
                                            const std::function<bool(const whittle::Vec3&)>& is_near, whittle::Mesh& out, std::string& fault);
