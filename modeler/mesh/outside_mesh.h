// outside_mesh.h — what a scene asks a mesh for where no exact form exists (csg/solid/outside.h).
#pragma once

#include <memory>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/outside.h"
#include "csg/solid/solid.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// The mesh of the use as facets, in the frame above it. kScene for what is 2D or unbounded.
Result<std::shared_ptr<const FacetList>> facets_by_mesh(const Solid& solid, const Use& use, const MeshOptions& options = {});

// The outline of the part of the use in the plane z = 0; chords are the shorter the flatter the mesh meets the plane, at most some sixteenths of what the options ask.
Result<SectionOutline> section_by_mesh(const Solid& solid, const Use& use, const MeshOptions& options = {});

// The solid under planes of 45 degrees over each side of the floor (outer rings counter-clockwise, holes clockwise, none crossing).
Result<std::shared_ptr<const FacetList>> roof_by_skeleton(const std::vector<std::vector<Vec2>>& floor);

}  // namespace whittle
