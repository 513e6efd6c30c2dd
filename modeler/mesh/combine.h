// combine.h — carries a plan out: which parts really meet, and exact booleans on those.
#pragma once

#include "modeler/mesh/plan.h"

namespace whittle {

// One mesh of a result that may be several: either a leaf on the grid, or an exact mesh.
struct Part {
    PlanId leaf = 0;
    ExactRef exact;  // null: `leaf` is meant
    GridPoint offset{};
    FacetTag tag_base = 0;
    GridBox box;  // around it, in place
};

// Disjoint sets, boundaries included; their union is the result.
using Parts = std::vector<Part>;

struct CombineOptions {
    int threads = 0;
    bool decimate = true;
};

// The result of one plan node. Its bytes do not depend on the number of threads.
Result<Parts> combine_plan(const Plan& plan, PlanId root, const CombineOptions& options, MeshControl& control, MeshStats& stats);

}  // namespace whittle
