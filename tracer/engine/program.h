// program.h — what the engine runs: leaves and groups in flat arrays, a bounding volume hierarchy under every wide group. Immutable.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/engine/bvh.h"
#include "tracer/engine/engine.h"
#include "tracer/engine/facet_tree.h"
#include "tracer/engine/formula.h"
#include "tracer/engine/identity.h"
#include "tracer/engine/wide.h"

namespace whittle {

// A class's side: inside where f <= 0, or f >= 0 where inverted.
struct HalfSpace {
    std::uint32_t packed = 0;
    ClassId id() const { return packed >> 1; }
    bool inverted() const { return (packed & 1) != 0; }
};

// A leaf of the formula. kCell: half_spaces[first, first+count), planes first. kPrism, kMesh: data index in `first`.
struct Leaf {
    static constexpr std::uint32_t kNoFacets = 0xFFFFFFFF, kNoSlabs = 0xFFFFFFFF;
    FormulaKind kind = FormulaKind::kCell;
    bool negated = false;
    bool fills = true;  // its use is not subtracted
    bool exact = true;  // its ends are certified
    std::uint32_t first = 0, count = 0;
    std::uint32_t use = 0;
    std::uint32_t facets = kNoFacets;  // cells of many planes: their tree
    std::uint32_t slabs = kNoSlabs;    // in `cell_slabs`
};

// The first half-spaces of a cell where they are pairs of axis planes of the root frame: what a ray needs of them, in one place. Infinite across other axes.
struct CellSlabs {
    std::array<std::array<double, 2>, 3> at;  // by axis: least, greatest
    std::array<std::array<ClassId, 2>, 3> id{};
    std::uint32_t planes = 0;
};

// A leaf or a group.
struct Ref {
    std::uint32_t packed = 0;
    bool is_leaf() const { return (packed >> 31) != 0; }
    std::uint32_t index() const { return packed & 0x7FFFFFFF; }
    static Ref leaf(std::uint32_t i) { return {i | 0x80000000}; }
    static Ref group(std::uint32_t i) { return {i}; }
};

// AND or OR of refs. `plain` ones are asked always; those in the hierarchy have the group's neutral value outside their boxes.
struct Group {
    bool is_and = false;
    bool outside_value = false;
    bool bounded = false;
    bool holds = false;  // some leaf below is not subtracted
    // In a cell of the octree: the least use, of those that are not subtracted, of what was folded away as always true there; not known if unclear.
    static constexpr std::uint32_t kNoUse = 0xFFFFFFFF;
    bool hold_unclear = false;
    bool always = false;  // an OR that is true throughout its cell; its children only tell who holds a place
    std::uint32_t hold = kNoUse;
    Bounds box;
    std::uint32_t first_plain = 0, plain_count = 0;
    std::uint32_t first_item = 0, item_count = 0;  // into `refs`, in the hierarchy's order
    std::uint32_t wide = 0;                        // root node in Program::wide, if item_count > 0
};

// How far from its box, in parts of its greatest side, a facet's crossing may lie where its class is another's plane: further away its own plane says
// where (parity.cpp). The snap moves planes by less than a thousand-millionth of that; no round figure, so that no tidy scene stands on the edge.
inline constexpr double kFacetReach = 0.000297;

struct PrismLeaf {
    FrameId frame = 0;
    std::uint8_t axis = 2;
    std::vector<Vec2> points;
    std::vector<std::uint32_t> next;  // the vertex that ends the edge from this one
    std::vector<ClassId> edges;       // class of that edge; kNoClass where it has no length
    std::vector<ClassId> own;         // a class of the edge's own plane (identity.h); empty where all are those of `edges`
};

struct ParityMesh {
    FrameId frame = 0;
    std::shared_ptr<const TriangleList> mesh;
    std::shared_ptr<const Hierarchy> hierarchy;
    std::vector<ClassId> facets;
    std::vector<ClassId> own;  // as of a prism's edges
};

// The use that a border on a class shows, as far as the class alone tells: always `use`; or, where only cutters that name no surface have it, the least
// use that holds the place; or it depends on which leaves meet there.
struct ClassLabel {
    enum class Kind : std::uint8_t { kUse, kHeld, kDepends };
    Kind kind = Kind::kDepends;
    bool exact = true;       // all leaves that have it are
    bool of_facets = false;  // some mesh or prism has it
    std::uint32_t use = 0;
};

// A leaf that is one ball of the root frame, where it is met: beside its like, in the hierarchy's order.
struct ItemBall {
    double x = 0, y = 0, z = 0, r = 0;  // r is 0 where the leaf is anything else
    ClassId id = 0;
};

// A node of the octree over the program's bounds (space.h): its eight children stand at `first`; or its formula, in the cell a little grown.
struct SpaceNode {
    enum class Kind : std::uint8_t { kOutside, kInside, kBorder, kDivided };
    Kind kind = Kind::kOutside;
    std::uint32_t first = 0;
    Ref formula;
    Ref labels;  // the same with all that may hold a place; equal to `formula` where that tells it
};

class Program {
public:
    std::array<bool, kEnginePasses> passes{};
    bool makes(EnginePass pass) const { return passes[static_cast<std::size_t>(pass)]; }

    std::vector<Frame> frames;
    std::vector<MotionGroup> motions;
    std::vector<Support> classes;
    std::vector<HalfSpace> half_spaces;
    std::vector<CellSlabs> cell_slabs;
    std::vector<Leaf> leaves;
    std::vector<FloatBox> leaf_boxes;      // around each leaf that is not negated, around what it takes away where it is; may be infinite
    std::vector<Bounds> leaf_bounds;       // the same in double: whoever aims by them aims alike wherever the solid stands. Empty where no matter names how it reflects
    std::vector<ClassLabel> class_labels;  // by class
    bool some_depend = false;              // some class's label is kDepends
    bool some_uncertified = false;         // some leaf is not exact
    bool some_doubtful = false;            // or some class has no polynomial
    bool mostly_turned = false;            // more than half of the leaves have turned sides, which packets do not know: rays do better alone
    bool met_whole = false;                // so few leaves that rays which do not go together meet most of them
    bool bodies_show = false;              // no cutter names its surface, and matter is by the author's order: the first body at a border shows there
    std::vector<Group> groups;
    std::vector<Ref> refs;
    std::vector<ItemBall> balls;  // one a ref; empty where none is a ball
    // Null where the ref is anything else.
    const ItemBall* ball(std::uint32_t ref) const { return !balls.empty() && balls[ref].r > 0 ? &balls[ref] : nullptr; }
    std::vector<WideNode> wide;   // hierarchies of items, which are numbers of refs
    std::vector<SpaceNode> space;  // root first; empty where cells do not pay
    std::vector<FacetTree> facet_trees;
    std::vector<FacetChunk> facet_chunks;
    std::vector<PrismLeaf> prisms;
    std::vector<ParityMesh> meshes;
    std::vector<LeafUse> uses;
    std::vector<std::uint32_t> matter_order;  // by use: of two that hold a place the one of lower order fills it (priority, then the author's order)
    bool matter_by_author = true;             // no use comes before an earlier one
    bool one_matter = true;                   // all uses that are not subtracted are of one material
    Ref root;
    bool flat = false;              // the root is a group of leaves only; where it is an AND,
    std::uint32_t flat_matter = Group::kNoUse;  // this use's matter fills all of it
    bool empty = true;       // nothing inside anywhere
    bool everything = false;
    Bounds bounds;
    BuildReport report;
};

std::array<bool, kEnginePasses> passes_made(const std::vector<std::string>& disabled);

}  // namespace whittle
