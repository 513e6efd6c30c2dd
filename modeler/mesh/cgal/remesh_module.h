// remesh_module.h — CGAL's isotropic remeshing. The number in a name changes with its parameters.
#pragma once

#include <string>

#include "modeler/mesh/mesh.h"

// Triangles of about `edge_mm` a side over the same surface; edges that turn by more than `sharp_deg` and borders between leaves stay where they are, cut
// to length. `in` is closed and oriented, no edge has more than two faces. False and what is wrong where CGAL gives up.
extern "C" bool whittle_cgal_remesh_1(const whittle::Mesh& in, double edge_mm, double sharp_deg, whittle::Mesh& out, std::string& fault);
