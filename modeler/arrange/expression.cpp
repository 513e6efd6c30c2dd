#include "modeler/arrange/expression.h"

namespace whittle {

Expression::Id Expression::operand() {
    const auto id = static_cast<Id>(nodes_.size());
    nodes_.emplace_back();
    operands_.push_back(id);
    return id;
}

Expression::Id Expression::combine(SetOp op, const std::vector<Id>& children) {
    const auto id = static_cast<Id>(nodes_.size());
    Node node;
    node.op = op;
    node.children = static_cast<std::uint32_t>(children.size());
    nodes_.push_back(node);
    for (std::size_t i = 0; i < children.size(); ++i) {
        nodes_[children[i]].parent = id;
        nodes_[children[i]].first = op == SetOp::kDifference && i == 0;
    }
    return id;
}

void Expression::set(std::uint32_t operand, bool inside) {
    Id at = operands_[operand];
    bool value = inside;
    while (nodes_[at].value != value) {
        nodes_[at].value = value;
        const Node& child = nodes_[at];
        if (child.parent == kNone) return;
        Node& parent = nodes_[child.parent];
        if (child.first) {
            parent.minuend = value;
        } else {
            parent.on += value ? 1U : ~0U;
        }
        value = parent.op == SetOp::kUnion ? parent.on > 0 : parent.op == SetOp::kIntersection ? parent.on == parent.children : parent.minuend && parent.on == 0;
        at = child.parent;
    }
}

bool Expression::is_held_by(std::uint32_t operand) const {
    for (Id at = operands_[operand]; nodes_[at].value; at = nodes_[at].parent) {
        if (nodes_[at].parent == kNone) return true;
        if (nodes_[nodes_[at].parent].op == SetOp::kDifference && !nodes_[at].first) return false;
    }
    return false;
}

void Expression::values_around(std::uint32_t operand, std::vector<bool>& out) const {
    out.clear();
    for (Id at = operands_[operand]; at != kNone; at = nodes_[at].parent) out.push_back(nodes_[at].value);
}

bool Expression::is_settled_within(std::uint32_t operand) const {
    Id at = operands_[operand];
    bool value = true;
    while (nodes_[at].parent != kNone) {
        const SetOp op = nodes_[nodes_[at].parent].op;
        // Only true settles a union and, as a cutter, a difference; only false an intersection and, as what is cut, a difference.
        const bool needs = op == SetOp::kUnion || (op == SetOp::kDifference && !nodes_[at].first);
        if (value != needs) return false;
        value = op == SetOp::kUnion;
        at = nodes_[at].parent;
    }
    return at == root_;
}

}  // namespace whittle
