// outside_mesh.h — what a scene asks a mesh for where no exact form exists (csg/solid/outside.h): hull and minkowski by way of meshes.
#pragma once

#include <memory>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// The convex hull of the operands' meshes. kScene for operands that are 2D, unbounded, or all in one plane.
Result<std::shared_ptr<const FacetList>> hull_of(const Solid& solid, const std::vector<Use>& operands, const MeshOptions& options = {});

// The Minkowski sum of the operands' meshes. kScene where one of them is not convex.
Result<std::shared_ptr<const FacetList>> minkowski_of(const Solid& solid, const std::vector<Use>& operands, const MeshOptions& options = {});

}  // namespace whittle
