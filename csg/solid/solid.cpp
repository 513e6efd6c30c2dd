#include "csg/solid/solid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "csg/solid/hash.h"
#include "csg/solid/placement.h"
#include "csg/solid/shape_bounds.h"

namespace whittle {
namespace {

bool is_flat_shape(const Shape& s) {
    return std::holds_alternative<shape::Disc>(s) || std::holds_alternative<shape::Rectangle>(s) || std::holds_alternative<shape::Polygon>(s) ||
           std::holds_alternative<shape::ParabolicSegment>(s);
}

// The node that the shape is made of, if it is made of one.
NodeId* made_of(Shape& s) {
    if (auto* e = std::get_if<shape::Extrusion>(&s)) return &e->profile;
    if (auto* r = std::get_if<shape::Revolution>(&s)) return &r->profile;
    if (auto* p = std::get_if<shape::Polygon>(&s); p && p->section != kEmptyNode) return &p->section;
    return nullptr;
}

// Which nodes the root reaches; children have smaller ids, so one pass downwards is enough.
std::vector<bool> reached_from(NodeId root, std::vector<Node>& nodes) {
    std::vector<bool> reached(nodes.size(), false);
    reached[kEmptyNode] = reached[root] = true;
    for (std::size_t id = nodes.size(); id-- > 0;) {
        if (!reached[id]) continue;
        if (const auto* c = std::get_if<Combination>(&nodes[id])) {
            for (const Use& use : c->operands) reached[use.node] = true;
        } else if (const NodeId* part = made_of(std::get<Shape>(nodes[id]))) {
            reached[*part] = true;
        }
    }
    return reached;
}

void renumber(Node& node, const std::vector<NodeId>& new_id) {
    if (auto* c = std::get_if<Combination>(&node)) {
        for (Use& use : c->operands) use.node = new_id[use.node];
    } else if (NodeId* part = made_of(std::get<Shape>(node))) {
        *part = new_id[*part];
    }
}

}  // namespace

void IdTable::put(Slot slot) {
    std::size_t i = slot.hash & (slots_.size() - 1);
    while (slots_[i].id != kNone) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = slot;
}

void IdTable::reserve(std::size_t entries) {
    std::size_t size = std::max<std::size_t>(slots_.size(), 16);
    while (size * 2 < entries * 3) size *= 2;
    if (size == slots_.size()) return;
    std::vector<Slot> old(size, Slot{0, kNone});
    old.swap(slots_);
    for (const Slot& slot : old)
        if (slot.id != kNone) put(slot);
}

void IdTable::insert(std::uint64_t hash, std::uint32_t id) {
    reserve(++used_);
    put({hash, id});
}

Bounds use_bounds(const Bounds& node_box, const Use& use, const Motion& motion) {
    return placed_bounds(use.motion == 0 ? node_box : moved_bounds(node_box, motion), use.placement);
}

Bounds Solid::root_bounds() const { return use_bounds(bounds_[root_.node], root_, motions_[root_.motion]); }

SolidBuilder::SolidBuilder(SolidPasses passes) : passes_(passes) {
    solid_.labels_.emplace_back();
    solid_.motions_.emplace_back();
    labels_by_hash_.insert(hash_of(Label{}), kNoLabel);
    intern(Combination{}, hash_of(Combination{}), {}, false, true);
}

NodeId SolidBuilder::shape(Shape s) {
    s = without_negative_zero(std::move(s));
    const NodeId* part = made_of(s);
    const Bounds box = shape_bounds(s, part ? solid_.bounds_[*part] : Bounds{});
    if (box.empty()) return kEmptyNode;
    const bool flat = is_flat_shape(s), plain = !part || plain_[*part];
    const std::uint64_t hash = hash_of(s);
    return intern(std::move(s), hash, box, flat, plain);
}

NodeId SolidBuilder::intern(Node node, std::uint64_t hash, const Bounds& box, bool flat, bool plain) {
    const NodeId known = nodes_by_hash_.find(hash, [&](NodeId id) { return solid_.nodes_[id] == node; });
    if (known != IdTable::kNone) return known;
    const auto id = static_cast<NodeId>(solid_.nodes_.size());
    solid_.nodes_.push_back(std::move(node));
    solid_.bounds_.push_back(box);
    solid_.flat_.push_back(flat);
    plain_.push_back(plain);
    nodes_by_hash_.insert(hash, id);
    solid_.geometry_.push_back(geometry_of(id));
    return id;
}

// The first combination of the same operands, labels aside. Shapes are their own geometry: a profile's labels are part of the profile.
NodeId SolidBuilder::geometry_of(NodeId id) {
    const auto* c = std::get_if<Combination>(&solid_.nodes_[id]);
    if (!c) return id;
    std::uint64_t hash = static_cast<std::uint64_t>(c->op) + 1;
    for (Use use : c->operands) {
        use.node = solid_.geometry_[use.node];
        use.label = kNoLabel;
        hash = (hash ^ hash_of(use)) * 0x9E3779B97F4A7C15u + (hash >> 29);
    }
    const NodeId first = geometry_by_hash_.find(hash, [&](NodeId other) {
        const auto& o = std::get<Combination>(solid_.nodes_[other]);
        return o.op == c->op && std::equal(o.operands.begin(), o.operands.end(), c->operands.begin(), c->operands.end(),
                                           [&](const Use& a, const Use& b) { return same_set(a, b); });
    });
    if (first != IdTable::kNone) return first;
    geometry_by_hash_.insert(hash, id);
    return id;
}

LabelId SolidBuilder::label(Label label) {
    const std::uint64_t hash = hash_of(label);
    const LabelId known = labels_by_hash_.find(hash, [&](LabelId id) { return solid_.labels_[id] == label; });
    if (known != IdTable::kNone) return known;
    const auto id = static_cast<LabelId>(solid_.labels_.size());
    solid_.labels_.push_back(std::move(label));
    labels_by_hash_.insert(hash, id);
    return id;
}

MotionId SolidBuilder::motion(Motion motion) {
    motion = {without_negative_zero(motion.start), without_negative_zero(motion.end)};
    if (motion == Motion{}) return 0;
    const std::uint64_t hash = hash_of(motion);
    const MotionId known = motions_by_hash_.find(hash, [&](MotionId id) { return solid_.motions_[id] == motion; });
    if (known != IdTable::kNone) return known;
    const auto id = static_cast<MotionId>(solid_.motions_.size());
    solid_.motions_.push_back(motion);
    motions_by_hash_.insert(hash, id);
    return id;
}

Use SolidBuilder::placed(const Placement& outer, Use use) {
    if (use.node == kEmptyNode) return {};
    if (const auto product = exact_product(without_negative_zero(outer), use.placement)) {
        use.placement = *product;
        return use;
    }
    Use wrapped;
    wrapped.node = combine(SetOp::kUnion, {use});
    wrapped.placement = without_negative_zero(outer);
    return wrapped;
}

Use SolidBuilder::labelled(const Label& outer, Use use) {
    if (use.node == kEmptyNode) return {};
    const Label inner = solid_.labels_[use.label];
    use.label = label({nested(outer.material, inner.material), inner.place.line != 0 ? inner.place : outer.place,
                       outer.part.empty() ? inner.part : outer.part});
    return use;
}

Solid SolidBuilder::finish(Use root) {
    const std::vector<bool> reached = reached_from(root.node, solid_.nodes_);
    std::vector<NodeId> new_id(reached.size(), kEmptyNode), first_of(reached.size(), IdTable::kNone);
    NodeId next = 0;
    for (NodeId id = 0; id < reached.size(); ++id) {
        if (!reached[id]) continue;
        new_id[id] = next;
        renumber(solid_.nodes_[id], new_id);
        NodeId& first = first_of[solid_.geometry_[id]];
        if (first == IdTable::kNone) first = next;
        solid_.geometry_[next] = first;
        if (id != next) solid_.nodes_[next] = std::move(solid_.nodes_[id]);
        solid_.bounds_[next] = solid_.bounds_[id];
        solid_.flat_[next] = solid_.flat_[id];
        ++next;
    }
    solid_.nodes_.resize(next);
    solid_.bounds_.resize(next);
    solid_.flat_.resize(next);
    solid_.geometry_.resize(next);
    root.node = new_id[root.node];
    solid_.root_ = root;
    return std::move(solid_);
}

}  // namespace whittle
