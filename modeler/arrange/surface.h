// surface.h — the faces between inside and outside as a mesh with no more triangles than its facets need.
#pragma once

#include "modeler/arrange/arrange.h"
#include "modeler/arrange/cells.h"

namespace whittle {

ArrangedMesh surface_of(Patches& patches, std::span<const Operand> operands, const SmallFaces& small, const std::vector<FaceSides>& sides,
                        const ArrangeOptions& options, ArrangeStats& stats);

}  // namespace whittle
