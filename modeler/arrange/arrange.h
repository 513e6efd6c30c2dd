// arrange.h — a set expression over closed meshes, carried out in one go and exactly.
//
// All operands are cut along each other at once; nothing is ever combined with a result that has been rounded or has grown, so every number has a
// size known beforehand, and solids that touch in a point or an edge are as good as any. Only the finished surface is rounded to double.
//
// Rejected: pairwise corefinement (CGAL 5.5): it refuses what touches in an edge, crashes where a surface touches itself, and took 2 to 20 times as
// long; hierarchical combination with intermediate results in exact rationals: their size has no bound.
#pragma once

#include <functional>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "modeler/arrange/expression.h"
#include "modeler/arrange/patches.h"

namespace whittle {

struct ArrangeStats {
    std::uint64_t buried = 0;       // facets that were left alone
    std::uint64_t pairs = 0;        // of flat pieces that were tested
    std::uint64_t small_faces = 0;  // after cutting
    std::uint64_t removed = 0;      // vertices taken out of flat facets and straight edges
    double seconds_cut = 0, seconds_classify = 0, seconds_join = 0;

    ArrangeStats& operator+=(const ArrangeStats& o) {
        buried += o.buried, pairs += o.pairs, small_faces += o.small_faces, removed += o.removed;
        seconds_cut += o.seconds_cut, seconds_classify += o.seconds_classify, seconds_join += o.seconds_join;
        return *this;
    }
};

// Closed and oriented. Coordinates in grid units, each the exact one rounded to double.
struct ArrangedMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<FacetTag> tags;   // Operand::tag_base included
    std::vector<std::uint32_t> filled;  // where asked for: of a triangle that shows the matter which remains (OperandMatter) that matter, else kNone
    bool on_grid = true;          // nothing was rounded
};

struct ArrangeOptions {
    bool join = true;                       // join flat pieces of one facet and straight pieces of one edge
    std::function<bool()> cancelled = [] { return false; };
    bool matters = false;                   // tell whose facet shows and what matter remains as rays do: several are to be seen
    bool bury = true;                       // leave out facets within operands that settle the result there; off for comparison
};

// Requires: every |placed coordinate| <= kLargestPlacedCoordinate; operand i of the expression is operands[i].
// Laws: the result does not depend on how the expression is written where the sets are equal, but for tags and the choice of diagonals.
// Errors: kScene where an operand is not closed; kInterrupted.
Result<ArrangedMesh> arrange(std::span<const Operand> operands, Expression& expression, const ArrangeOptions& options, ArrangeStats& stats);

// A piece of a closed surface that crosses itself in facets that are not `sound` (by tag): what of it bounds the places with a winding number other than zero. The
// piece's border, whose facets are sound, stays corner for corner.
// Errors: kScene where a part of the piece has nothing sound; kInterrupted.
Result<ArrangedMesh> arrange_piece(const GridMesh& piece, const std::vector<bool>& sound, const std::function<bool()>& cancelled);

}  // namespace whittle
