// patches.h — the operands' facets as convex flat pieces: what is tested against each other.
//
// A facet (the triangles of one tag) that is convex is one piece, whatever its triangles; any other is a piece per triangle. Only a facet's border
// matters to the arrangement: the diagonals within do not.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "modeler/arrange/box_tree.h"
#include "modeler/arrange/exact_points.h"

namespace whittle {

// What an operand is made of. It decides no set, only what faces show.
struct OperandMatter {
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;
    std::uint32_t subtractions = 0;  // differences as whose cutter it stands, or within
    std::int64_t cut_order = 0;      // of two cutters in one place that name their surfaces the lesser shows
    bool shows_filled = false;       // subtracts and names no surface: its faces show the matter that remains
    bool hides_cutters = false;      // adds, and has such faces of its own
    std::uint32_t fills = kNone;     // the matter of what it adds, equal for equal ones; kNone: it subtracts, or has several
    double priority = 0;             // of overlapping matters the highest fills, of equal ones the first
};

// One operand: a mesh moved by `offset`. `number` orders operands where several have a facet in one place: the least that adds wins.
struct Operand {
    const GridMesh* mesh = nullptr;
    GridPoint offset{};
    FacetTag tag_base = 0;
    std::uint32_t number = 0;
    bool may_cross_itself = false;
    OperandMatter matter{};
};

struct Facet {
    std::uint32_t operand = 0;
    FacetTag tag = 0;                                       // tag_base included
    std::uint32_t first_patch = 0, patch_count = 0;
    std::uint32_t first_border = 0, border_count = 0;       // directed edges, the facet on their left
    std::uint32_t first_triangle = 0, triangle_count = 0;   // as the operand has them
};

struct Patch {
    std::uint32_t facet = 0;
    std::uint32_t first_corner = 0, corner_count = 0;  // counter-clockwise about the plane's normal
    ExactPlane plane;
};

struct Patches {
    PointTable points;
    std::vector<Facet> facets;
    std::vector<Patch> patches;
    std::vector<PointId> corners;
    std::vector<std::array<PointId, 2>> borders;
    std::vector<std::array<PointId, 3>> triangles;
    std::vector<DoubleBox> boxes;        // of patches
    std::vector<std::uint32_t> owner;    // of patches: the operand, kMixed where it may cross itself

    std::span<const PointId> corners_of(const Patch& p) const { return {corners.data() + p.first_corner, p.corner_count}; }
    std::span<const std::array<PointId, 2>> borders_of(const Facet& f) const { return {borders.data() + f.first_border, f.border_count}; }
};

Patches patches_of(std::span<const Operand> operands);

}  // namespace whittle
