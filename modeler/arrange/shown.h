// shown.h — whose facet shows where several lie in one place, and what matter remains there: the rule by which rays show colours (docs/numerics.md, labels).
#pragma once

#include "modeler/arrange/expression.h"
#include "modeler/arrange/small_faces.h"

namespace whittle {

// The lesser shows: fewer subtractions; of solids the first; of cutters the outermost difference's that names its surface, else any.
bool shows_before(const Operand& a, const Operand& b);

class ShownFacets {
public:
    ShownFacets(const Patches& patches, std::span<const Operand> operands, const Expression& expression)
        : patches_(patches), operands_(operands), expression_(expression) {}

    // The facet of the cover that shows, given the operands that are on at one of its sides: of those for whose sake the value changes, from the operand to
    // the root of the expression.
    std::uint32_t among(const Cover& cover, const std::vector<std::uint32_t>& on);

private:
    const Patches& patches_;
    std::span<const Operand> operands_;
    Expression expression_;  // all operands off between calls
};

}  // namespace whittle
