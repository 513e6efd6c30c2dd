// simplify.cpp — SolidBuilder::combine: what can be dropped from a set operation with certainty, by identity and by outward rounded boxes.

#include <algorithm>
#include <cassert>
#include <cmath>

#include "csg/solid/directed.h"
#include "csg/solid/hash.h"
#include "csg/solid/placement.h"
#include "csg/solid/solid.h"

namespace whittle {
namespace {

// A shared union longer than this stays a node of its own: copying it into each of its users would cost more than a level of the tree.
constexpr std::size_t kLongestSpliced = 64;
// Up to here equal operands are found by comparing all pairs.
constexpr std::size_t kFewOperands = 8;

bool in_place(const Use& use) { return use.label == kNoLabel && use.motion == 0 && use.placement.is_identity(); }

// Could the insides of both boxes meet? A shared face is no inside; of 2D boxes only x and y count.
bool insides_meet(const Bounds& a, const Bounds& b, bool flat) {
    if (a.empty() || b.empty()) return false;
    for (int i = 0; i < (flat ? 2 : 3); ++i)
        if (!(std::max(a.lo[i], b.lo[i]) < std::min(a.hi[i], b.hi[i]))) return false;
    return true;
}

bool contains(const Bounds& outer, const Bounds& inner) {
    for (int i = 0; i < 3; ++i)
        if (!(outer.lo[i] <= inner.lo[i] && inner.hi[i] <= outer.hi[i])) return false;
    return !inner.empty();
}
bool contains_inside(const Bounds& outer, const Bounds& inner) {
    for (int i = 0; i < 3; ++i)
        if (!(outer.lo[i] < inner.lo[i] && inner.hi[i] < outer.hi[i])) return false;
    return !inner.empty();
}

// The box that a use of shape::Box fills in the frame above, rounded inwards; empty for anything else and for turned boxes.
Bounds filled_box(const Node& node, const Use& use) {
    const auto* s = std::get_if<Shape>(&node);
    const auto* box = s ? std::get_if<shape::Box>(s) : nullptr;
    const Placement& a = use.placement;
    const Placement unmoved = Placement::translation({a.offset(0), a.offset(1), a.offset(2)});
    if (!box || use.motion != 0 || !(a == unmoved)) return {};
    Bounds b;
    for (int i = 0; i < 3; ++i) {
        b.lo[i] = add_up(box->lo[i], a.offset(i));
        b.hi[i] = add_down(box->hi[i], a.offset(i));
    }
    return b;
}

// Do the operands from `first` on certainly name no matter? Only shapes are looked at; what lies deeper may name one.
bool paints_nothing(const Solid& solid, const std::vector<Use>& operands, std::size_t first) {
    return std::all_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                       [&](const Use& u) { return std::holds_alternative<Shape>(solid.node(u.node)) && solid.label(u.label).material == Material{}; });
}

// Does the node certainly hold no label that names a matter?
bool is_bare(const Solid& solid, const Use& use) {
    const auto* c = std::get_if<Combination>(&solid.node(use.node));
    return !c || paints_nothing(solid, c->operands, 0);
}

double volume(const Bounds& b) { return b.empty() ? 0 : (b.hi.x - b.lo.x) * (b.hi.y - b.lo.y) * (b.hi.z - b.lo.z); }

std::uint64_t erase_marked(std::vector<Use>& operands, const std::vector<bool>& marked) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < operands.size(); ++i)
        if (!marked[i]) operands[kept++] = operands[i];
    const std::size_t dropped = operands.size() - kept;
    operands.resize(kept);
    return dropped;
}

}  // namespace

NodeId SolidBuilder::combine(SetOp op, std::vector<Use> operands) {
    if (subtracts_itself(op, operands)) return kEmptyNode;  // before flattening: (A-B)-(A-B) is A-B-(A-B) after it
    flatten(op, operands);
    if (drop_empty(op, operands) || subtracts_itself(op, operands)) return kEmptyNode;
    if (passes_.equal) drop_equal(op, operands);
    if (passes_.disjoint && drop_disjoint(op, operands)) return kEmptyNode;
    if (passes_.buried && drop_buried(op, operands)) return kEmptyNode;
    if (operands.empty()) return kEmptyNode;
    if (operands.size() == 1) {
        if (in_place(operands[0])) return operands[0].node;
        op = SetOp::kUnion;
    }
    Bounds box = bounds(operands[0]);
    bool plain = true;
    for (const Use& use : operands) {
        const Label& l = solid_.labels_[use.label];
        plain = plain && plain_[use.node] && !is_clear(l.material) && l.part.empty();
        if (op == SetOp::kUnion) box = around(box, bounds(use));
        if (op == SetOp::kIntersection) box = common(box, bounds(use));
    }
    const bool flat = solid_.flat_[operands[0].node];
    Combination combination{op, std::move(operands)};
    combination.operands.shrink_to_fit();
    const std::uint64_t hash = hash_of(combination);
    return intern(std::move(combination), hash, box, flat, plain);
}

// A use of a union of one use, as one use, where the placements multiply exactly and at most one motion is left.
std::optional<Use> SolidBuilder::folded(const Use& outer) const {
    const auto* c = std::get_if<Combination>(&solid_.nodes_[outer.node]);
    if (!c || c->op != SetOp::kUnion || c->operands.size() != 1) return std::nullopt;
    const Use& inner = c->operands[0];
    if (outer.label != kNoLabel && inner.label != kNoLabel) return std::nullopt;
    if (outer.motion != 0 && (inner.motion != 0 || !inner.placement.is_identity())) return std::nullopt;
    const auto product = exact_product(outer.placement, inner.placement);
    if (!product) return std::nullopt;
    return Use{inner.node, outer.label != kNoLabel ? outer.label : inner.label, outer.motion != 0 ? outer.motion : inner.motion, *product};
}

// (A|B)|C, (A&B)&C, (A-B)-C and A-(B|C) as one list each.
void SolidBuilder::flatten(SetOp op, std::vector<Use>& operands) {
    std::vector<Use> spliced;
    bool changed = false;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        Use& use = operands[i];
        use.placement = without_negative_zero(use.placement);
        while (const auto shorter = folded(use)) use = *shorter;
        const SetOp same = op == SetOp::kDifference && i > 0 ? SetOp::kUnion : op;
        const auto* c = in_place(use) ? std::get_if<Combination>(&solid_.nodes_[use.node]) : nullptr;
        // (A-B)-C as A-B-C forgets which cut is the outer one, which tells what a face of both shows.
        const bool silent = op != SetOp::kDifference || i > 0 || (c && (paints_nothing(so_far(), c->operands, 1) || paints_nothing(so_far(), operands, 1)));
        const bool splice = c && c->op == same && c->operands.size() <= kLongestSpliced && !c->operands.empty() && silent;
        if (splice && !changed) {
            spliced.assign(operands.begin(), operands.begin() + static_cast<std::ptrdiff_t>(i));
            changed = true;
        }
        if (splice) spliced.insert(spliced.end(), c->operands.begin(), c->operands.end());
        else if (changed) spliced.push_back(use);
    }
    if (changed) operands = std::move(spliced);
}

// True: the whole is empty.
bool SolidBuilder::drop_empty(SetOp op, std::vector<Use>& operands) const {
    const auto is_empty = [](const Use& use) { return use.node == kEmptyNode; };
    if (operands.empty()) return true;
    if (op == SetOp::kIntersection && std::any_of(operands.begin(), operands.end(), is_empty)) return true;
    if (op == SetOp::kDifference && is_empty(operands[0])) return true;
    operands.erase(std::remove_if(operands.begin(), operands.end(), is_empty), operands.end());
    return operands.empty();
}

bool SolidBuilder::same_set(const Use& a, const Use& b) const {
    return solid_.geometry_[a.node] == solid_.geometry_[b.node] && a.motion == b.motion && a.placement == b.placement;
}

// Of two uses of which one lies in the other: can the dropped one's matter nowhere show?
bool SolidBuilder::may_absorb(const Use& kept, const Use& dropped) const {
    const Label &a = solid_.labels_[kept.label], &b = solid_.labels_[dropped.label];
    if (kept.node == dropped.node && a.material == b.material && a.part == b.part) return true;
    return a.part == b.part && plain_[kept.node] && plain_[dropped.node] && !is_clear(a.material) && !is_clear(b.material);
}

bool SolidBuilder::subtracts_itself(SetOp op, const std::vector<Use>& operands) {
    if (op != SetOp::kDifference || operands.empty() || !passes_.equal) return false;
    if (std::none_of(operands.begin() + 1, operands.end(), [&](const Use& use) { return same_set(operands[0], use); })) return false;
    skipped_.equal += operands.size();
    return true;
}

void SolidBuilder::drop_equal(SetOp op, std::vector<Use>& operands) {
    const bool subtracting = op == SetOp::kDifference;
    // A cutter may colour what it cuts: equal cutters are one only with equal matter.
    const auto redundant = [&](std::size_t kept, std::size_t i) {
        const Use &a = operands[kept], &b = operands[i];
        if (!same_set(a, b) || !may_absorb(a, b)) return false;
        const Material &kept_matter = solid_.labels_[a.label].material, &matter = solid_.labels_[b.label].material;
        if (a.node == b.node && kept_matter == matter) return true;
        // As a part of a cutter the one dropped may be the one that names what the cut shows.
        return !subtracting && (kept_matter.names_surface() || (!matter.names_surface() && is_bare(solid_, b)));
    };
    const std::size_t first = subtracting ? 1 : 0;
    std::vector<bool> marked(operands.size(), false);
    IdTable seen;
    if (operands.size() > kFewOperands) seen.reserve(operands.size());
    for (std::size_t i = first; i < operands.size(); ++i) {
        if (operands.size() <= kFewOperands) {
            for (std::size_t j = first; j < i && !marked[i]; ++j) marked[i] = !marked[j] && redundant(j, i);
            continue;
        }
        Use key = operands[i];
        key.node = solid_.geometry_[key.node];
        key.label = kNoLabel;
        const std::uint64_t hash = hash_of(key);
        marked[i] = seen.find(hash, [&](std::uint32_t j) { return redundant(j, i); }) != IdTable::kNone;
        if (!marked[i]) seen.insert(hash, static_cast<std::uint32_t>(i));
    }
    skipped_.equal += erase_marked(operands, marked);
}

bool SolidBuilder::drop_disjoint(SetOp op, std::vector<Use>& operands) {
    if (op == SetOp::kUnion || operands.size() < 2) return false;
    const bool flat = solid_.flat_[operands[0].node];
    Bounds rest = bounds(operands[0]);
    std::vector<bool> marked(operands.size(), false);
    for (std::size_t i = 1; i < operands.size(); ++i) {
        const Bounds box = bounds(operands[i]);
        marked[i] = !insides_meet(rest, box, flat);
        if (op == SetOp::kDifference) continue;
        if (marked[i]) {
            skipped_.disjoint += operands.size();
            return true;
        }
        rest = common(rest, box);
    }
    skipped_.disjoint += erase_marked(operands, marked);
    return false;
}

bool SolidBuilder::drop_buried(SetOp op, std::vector<Use>& operands) {
    if (operands.size() < 2) return false;
    std::vector<bool> marked(operands.size(), false);
    const auto filled = [&](std::size_t i) { return filled_box(solid_.nodes_[operands[i].node], operands[i]); };
    // What comes first owns the matter where both are; the later one may take its place only with the same.
    const auto absorbs = [&](std::size_t kept, std::size_t dropped) {
        const Use &a = operands[kept], &b = operands[dropped];
        const bool same_matter = solid_.labels_[a.label].material == solid_.labels_[b.label].material && is_bare(solid_, a) && is_bare(solid_, b);
        return (kept < dropped || same_matter) && may_absorb(a, b);
    };
    if (op == SetOp::kDifference) {
        const Bounds minuend = bounds(operands[0]);
        for (std::size_t i = 1; i < operands.size(); ++i)
            if (contains(filled(i), minuend)) {
                skipped_.buried += operands.size();
                return true;
            }
    } else if (op == SetOp::kUnion) {
        std::size_t largest = 0;
        for (std::size_t i = 1; i < operands.size(); ++i)
            if (volume(filled(i)) > volume(filled(largest))) largest = i;
        const Bounds around_others = filled(largest);
        if (around_others.empty()) return false;
        for (std::size_t i = 0; i < operands.size(); ++i)
            marked[i] = i != largest && contains_inside(around_others, bounds(operands[i])) && absorbs(largest, i);
    } else if (operands.size() <= kFewOperands) {
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const Bounds box = filled(i);
            for (std::size_t j = 0; j < operands.size() && !box.empty() && !marked[i]; ++j)
                marked[i] = j != i && !marked[j] && contains_inside(box, bounds(operands[j])) && absorbs(j, i);
        }
    }
    skipped_.buried += erase_marked(operands, marked);
    return false;
}

}  // namespace whittle
