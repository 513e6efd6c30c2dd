// queries_module.h — what the module whittle_cgal answers about meshes. The number in a name changes with its parameters, so that a module of another
// version is not called but refused.
#pragma once

#include <string>
#include <vector>

#include "csg/base/vec.h"
#include "modeler/mesh/mesh.h"

// Pairs of triangles that cross or overlap; false and what is wrong where CGAL gives up.
extern "C" bool whittle_cgal_crossings_2(const std::vector<whittle::Vec3>& points, const std::vector<whittle::Triangle>& triangles, std::uint64_t& count,
                                         std::string& fault);
