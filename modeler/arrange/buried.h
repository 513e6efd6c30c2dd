// buried.h — facets that lie within an operand which alone decides the result there: they are neither cut nor told inside from outside.
//
// Where an operand settles the expression (any of a union; a cutter of what is cut) nothing within it can be surface. What stays cuts space no finer
// than the result needs: a facet that stays is cut wherever it leaves such an operand, because the facets there stay too or lie within the next one.
// So a face is buried as a whole or not at all, faces that are not meet only such in their edges, and windings may be carried along them; inside the
// operands named here they may not, for walls are missing there.
#pragma once

#include <span>
#include <vector>

#include "modeler/arrange/expression.h"
#include "modeler/arrange/patches.h"

namespace whittle {

struct Buried {
    std::vector<bool> facets;    // of Patches::facets
    std::vector<bool> operands;  // those that settle the expression; none where no facet is buried
    std::size_t count = 0;       // of facets
};

Buried nothing_buried(const Patches& patches, std::span<const Operand> operands);
// Every facet named is strictly within an operand that settles; not every such facet is named. Names none where an operand is not closed.
Buried buried_facets(const Patches& patches, std::span<const Operand> operands, const Expression& expression);

}  // namespace whittle
