// booleans_module.h — CGAL's booleans of meshes: a second opinion on modeler/arrange, which shares no code with it. The number in a name changes with its
// parameters, so that a module of another version is not called but refused.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/solid.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// An expression in postfix order: an operand is pushed, an operation takes two and pushes one.
struct BooleanStep {
    static constexpr std::uint32_t kOperation = 0xFFFFFFFF;
    std::uint32_t operand = kOperation;
    SetOp op = SetOp::kUnion;
};

}  // namespace whittle

// Corefinement over exact constructions, Nef polyhedra where it declines; `leaf` of a face is that of the face it was cut from. Operands are closed and
// oriented, no edge has more than two facets. False and what is wrong where an operand is no closed manifold or crosses itself.
extern "C" bool whittle_cgal_booleans_1(const std::vector<whittle::Mesh>& operands, const std::vector<whittle::BooleanStep>& steps, whittle::Mesh& out,
                                        std::string& fault);
