// tile.h — the part of a program that a tile of rays can meet: the formula folded to what lies within the tile's bounds. What the tile misses has its value
// outside its box and folds away. Private to the engine.
#pragma once

#include <array>
#include <vector>

#include "tracer/engine/coarse_view.h"
#include "tracer/engine/tile_bounds.h"
#include "tracer/engine/wide.h"

namespace whittle {

inline constexpr int kTileRays = 256;

// Work done on tiles since it was last taken.
struct TileWork {
    std::uint64_t tests = 0;     // cells met, times lanes
    std::uint64_t folded = 0;    // leaves of trees
    std::uint64_t pruned = 0;    // subtrees that the tile misses
    std::uint64_t beyond = 0;    // subtrees behind the window
    std::uint64_t hidden = 0;    // parts behind what all rays, or a packet's, have met
    std::uint64_t masked = 0;    // packets that cannot meet a part
    std::uint64_t constant = 0;  // leaves of which a cell of the octree knows
};

// Requires: finite bounds of the program.
TileScope tile_scope(const TileExtremes& extremes, const Bounds& bounds);

// A node of the folded formula: `outside` wherever t is not in [near, far].
struct TileNode {
    enum class Kind : std::uint8_t { kLeaf, kAnd, kOr };
    Kind kind = Kind::kLeaf;
    bool negated = false;  // leaves
    bool outside = false;
    bool cells = false;    // every child is a leaf
    bool hold_unclear = false;
    bool always = false;  // true whatever its children are
    std::uint32_t hold = Group::kNoUse;  // Group::hold
    bool holds = false;    // some leaf in it is not subtracted
    std::uint32_t leaf = 0;                          // of the program
    std::uint32_t slot = 0;                          // leaves: their number in this tree
    std::uint32_t first = 0, count = 0;              // into TileTree::children
    double near = 0, far = 0;
};

// A child as its parent sees it: side by side, so that those out of range cost little.
struct TileChild {
    double near = 0, far = 0;
    std::uint32_t node = 0;
    bool outside = false, holds = false, leaf = false;
};

// The folded formula. Children that are not neutral outside stand first; those that are, by rising `near`.
struct TileTree {
    static constexpr std::uint32_t kFalse = 0xFFFFFFFF, kTrue = 0xFFFFFFFE;
    std::vector<TileNode> nodes;
    std::vector<TileChild> children;
    std::uint32_t root = kFalse;
    std::uint32_t leaf_count = 0;
    std::vector<TileCell> cells;         // by slot
    std::vector<TileSurface> surfaces;
    std::vector<CoarseSurface> coarse;
    double room = 0;                     // events further apart than this are in this order
    std::uint32_t holders = 0;           // leaves of the tree that are not subtracted,
    std::uint32_t holder_use = 0;        // and the use of the last
    bool holder_lost = false;            // what holds a place may have been folded away
    double window = HUGE_VAL;            // what begins behind it is left out:
    bool clipped = false;                // something was
    bool whole = false;                  // folded to the scope, not to some of its rays: it holds for the next ones too
    TileWork work;

    // Cells folded for an older scope are forgotten.
    void begin(const Program& program, const TileScope& scope);
    const TileScope& scope() const { return scope_; }
    // Requires: begin(). `shared`: `bounds` are of some rays of the scope only; cells are folded to the scope, once.
    void build(const Program& program, const TileBounds& bounds, Ref ref, bool shared);
    // Folds nothing away that may hold a place. For PacketWalker::holder() alone.
    void build_labels(const Program& program, const TileBounds& bounds, Ref ref);

    // The cell of a leaf of the tree, folded by now; `room` may have grown.
    const TileCell& cell(const Program& program, const TileNode& leaf) {
        TileCell& c = cells[leaf.slot];
        if (!c.folded) fold(program, leaf.leaf, c);
        return c;
    }

    // A leaf of the tree and the node it is a child of; only where some class's label depends on which leaves meet.
    struct Placed {
        std::uint32_t leaf = 0, parent = 0;
    };
    const std::vector<Placed>& placed() const { return placed_; }

private:
    void place_leaves();
    bool beyond(double near);
    bool meets(const TileBounds& bounds, const std::array<double, 3>& lo, const std::array<double, 3>& hi, double& near, double& far);
    std::uint32_t add(const Program& program, const TileBounds& bounds, Ref ref);
    std::uint32_t add_leaf(const Program& program, const TileBounds& bounds, std::uint32_t leaf);
    std::uint32_t add_group(const Program& program, const TileBounds& bounds, const Group& g);
    void fold(const Program& program, std::uint32_t leaf, TileCell& cell);
    TileCell cell_of(const Program& program, std::uint32_t leaf, bool& met, double& near, double& far);

    // A cell folded once for the rays of a scope.
    struct Folded {
        std::uint32_t stamp = 0;
        TileCell cell;
        double near = 0, far = 0;
        bool met = false;
    };
    std::vector<std::uint32_t> pending_;
    std::vector<WideChild> waiting_;  // boxes that add_group() has yet to look into
    std::vector<Placed> placed_;
    std::vector<Folded> folded_;  // by leaf
    std::uint32_t stamp_ = 0;
    TileScope scope_;
    double error_ = 0;
    bool shared_ = false, labels_ = false;
};

// Fills what packets need of a finished program: class_labels and Group::holds.
void describe_for_packets(Program& program);

}  // namespace whittle
