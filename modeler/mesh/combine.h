// combine.h — carries a plan out: which leaves can meet, and one exact arrangement for each group of those.
#pragma once

#include <span>

#include "modeler/arrange/arrange.h"
#include "modeler/mesh/cgal/booleans_module.h"
#include "modeler/mesh/plan.h"
#include "modeler/mesh/reference_mesh.h"

namespace whittle {

// One mesh of a result that may be several: either a leaf on the grid, or a mesh that was made.
struct Part {
    PlanId leaf = 0;
    std::optional<ArrangedMesh> made;  // nothing: `leaf` is meant
    GridPoint offset{};
    FacetTag tag_base = 0;             // of a leaf; in what was made it is included
};

// Disjoint sets, boundaries included; their union is the result.
using Parts = std::vector<Part>;

struct CombineOptions {
    int threads = 0;
    bool decimate = true;
    BooleanMaker booleans = BooleanMaker::kArrangement;
    std::vector<OperandMatter> matters{};  // by the author's number of a leaf
    bool tell_matters = false;             // say which of them remains at the faces of cutters that show it
};

// The result of one plan node. `uses[i]` is the author's number of the plan's leaf i: where two leaves have a facet in one place the lower one keeps
// it. Bytes do not depend on the number of threads.
Result<Parts> combine_plan(const Plan& plan, PlanId root, std::span<const std::uint32_t> uses, const CombineOptions& options, MeshControl& control,
                           MeshStats& stats);

}  // namespace whittle
