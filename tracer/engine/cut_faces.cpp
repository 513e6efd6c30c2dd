#include "tracer/engine/cut_faces.h"

#include "tracer/engine/program.h"

namespace whittle {

std::vector<bool> classes_of_cutters(const Program& program) {
    std::vector<bool> cuts(program.classes.size(), false), bounds(program.classes.size(), false);
    for (const Leaf& leaf : program.leaves) {
        std::vector<bool>& seen = program.uses[leaf.use].subtractions % 2 == 1 ? cuts : bounds;
        const auto see = [&](const std::vector<ClassId>& classes) {
            for (const ClassId id : classes)
                if (id != kNoClass) seen[id] = true;
        };
        const auto see_facets = [&](const auto& data, const std::vector<ClassId>& classes) { see(classes), see(data.own); };
        if (leaf.kind == FormulaKind::kCell)
            for (std::uint32_t k = 0; k < leaf.count; ++k) seen[program.half_spaces[leaf.first + k].id()] = true;
        if (leaf.kind == FormulaKind::kPrism) see_facets(program.prisms[leaf.first], program.prisms[leaf.first].edges);
        if (leaf.kind == FormulaKind::kMesh) see_facets(program.meshes[leaf.first], program.meshes[leaf.first].facets);
    }
    for (std::size_t i = 0; i < cuts.size(); ++i) cuts[i] = cuts[i] && !bounds[i];
    return cuts;
}

}  // namespace whittle
