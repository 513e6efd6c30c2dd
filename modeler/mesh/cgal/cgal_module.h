// cgal_module.h — the two halves of the module's kernel: booleans_cgal.cpp and queries_cgal.cpp. Nothing outside the module includes this.
#pragma once

#include "modeler/mesh/exact_kernel.h"

namespace whittle {

class CgalBooleans : public ExactKernel {
public:
    Result<ExactRef> load(const GridMesh& mesh) const final;
    Result<ExactRef> combine(SetOp op, std::span<const PlacedExact> a, std::span<const PlacedExact> b, KernelWatch& watch) const final;
    RoundedMesh rounded(const ExactMesh& mesh) const final;
};

}  // namespace whittle
