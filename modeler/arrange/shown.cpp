#include "modeler/arrange/shown.h"

#include <map>
#include <tuple>

namespace whittle {

bool shows_before(const Operand& a, const Operand& b) {
    const auto rank = [](const Operand& o) {
        const OperandMatter& m = o.matter;
        return std::tuple(m.subtractions, m.shows_filled, m.subtractions > 0 ? m.cut_order : std::int64_t{0}, o.number);
    };
    return rank(a) < rank(b);
}

std::uint32_t ShownFacets::among(const Cover& cover, const std::vector<std::uint32_t>& on) {
    struct Change {
        int winding = 0;
        std::uint32_t facet = 0;
        std::vector<bool> before;
    };
    std::map<std::uint32_t, Change> changes;
    for (const CoverEntry& e : cover) {
        Change& change = changes[patches_.facets[e.facet].operand];
        change.winding += e.sign;
        change.facet = e.facet;
    }
    const auto changes_value = [](const Change& change) { return change.winding != 0; };
    for (const std::uint32_t operand : on) expression_.set(operand, true);
    for (auto& [operand, change] : changes) expression_.values_around(operand, change.before);
    for (const auto& [operand, change] : changes)
        if (changes_value(change)) expression_.set(operand, !change.before.front());
    const Operand* first = nullptr;
    std::uint32_t shown = cover.front().facet;
    for (const auto& [operand, change] : changes) {
        if (!changes_value(change) || (first && !shows_before(operands_[operand], *first))) continue;
        std::vector<bool> after;
        expression_.values_around(operand, after);
        after.flip();
        if (after != change.before) continue;
        first = &operands_[operand];
        shown = change.facet;
    }
    for (const auto& [operand, change] : changes) expression_.set(operand, false);
    for (const std::uint32_t operand : on) expression_.set(operand, false);
    return shown;
}

}  // namespace whittle
