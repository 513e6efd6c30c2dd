// pov_shapes.h — one shape as a POV-Ray object without its closing brace, so that placement and texture can follow. Internal to pov.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/solid/solid.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// All but extrusions, revolutions, faceted shapes and 2D ones.
// Nothing for those.
std::optional<std::string> pov_shape(const Shape& shape);

// A 2D shape raised from z0 to z1, or turned about z (x -> radius, y -> z; the shape lies at x >= 0).
std::optional<std::string> pov_raised(const Shape& flat, double z0, double z1);
std::optional<std::string> pov_turned(const Shape& flat, const Placement& in_plane);

// Closed triangles; open brace.
std::string pov_mesh(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

// " matrix<...>", or nothing for the identity.
std::string pov_matrix(const Placement& placement);

}  // namespace whittle
