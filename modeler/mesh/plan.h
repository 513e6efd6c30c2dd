// plan.h — what has to be meshed and combined: every distinct part once.
//
// Nodes are hash-consed on grid coordinates, modulo translation: two leaves are one when their snapped points differ by one grid vector, two
// combinations when their operands are the same plans at the same distances. So a part that is used at a thousand places is combined once, however the scene came to repeat it.
// Source: Goto, hash-consing (1974).
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "modeler/mesh/grid.h"

namespace whittle {

using PlanId = std::uint32_t;

struct PlanRef {
    PlanId plan = 0;
    GridPoint offset{};
    bool operator==(const PlanRef&) const = default;
};

// A leaf holds its mesh; a combination two operands, offsets from the place of the first.
struct PlanNode {
    std::optional<SetOp> op;
    PlanRef a, b;
    GridMesh leaf;
    std::vector<FacetTag> starts;  // of a leaf that holds several uses: the first tag of each
    bool may_cross_itself = false;
    GridBox box;              // around the result, from the node's own place
    FacetTag tag_count = 0;   // of a leaf, or of both operands: b's tags follow a's
    std::uint32_t users = 0;  // combinations that name this node
};

// A placed plan and the leaf uses in it, in the plan's own order.
struct Instance {
    PlanRef ref;
    std::vector<std::uint32_t> leaves;
};

class Plan {
public:
    const PlanNode& node(PlanId id) const { return nodes_[id]; }
    std::size_t size() const { return nodes_.size(); }
    GridBox box(const PlanRef& ref) const;
    std::uint64_t reused() const { return reused_; }
    std::uint64_t skipped() const { return skipped_; }

    Instance leaf(SnappedLeaf&& leaf, std::vector<std::uint32_t> uses);
    // Nothing where the result is empty. Operands that cannot matter, by equality or by their boxes, do not reach a node.
    std::optional<Instance> unite(std::vector<Instance> operands);
    std::optional<Instance> intersect(std::vector<Instance> operands);
    std::optional<Instance> subtract(Instance from, std::vector<Instance> cutters);

private:
    Instance binary(SetOp op, Instance&& a, Instance&& b);
    Instance united(std::vector<Instance>& operands, std::size_t first, std::size_t last);
    PlanId interned(PlanNode&& node, std::uint64_t hash);

    std::vector<PlanNode> nodes_;
    std::unordered_multimap<std::uint64_t, PlanId> by_hash_;
    std::uint64_t reused_ = 0, skipped_ = 0;
};

bool boxes_touch(const GridBox& a, const GridBox& b);    // as closed sets
bool boxes_overlap(const GridBox& a, const GridBox& b);  // in more than a face
GridBox box_around(const GridBox& a, const GridBox& b);
GridBox moved(const GridBox& box, const GridPoint& by);
GridPoint sum(const GridPoint& a, const GridPoint& b);
GridPoint difference(const GridPoint& a, const GridPoint& b);

}  // namespace whittle
