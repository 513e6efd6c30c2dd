// expression.h — a set expression over operands whose value is kept while operands are switched on and off.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

class Expression {
public:
    using Id = std::uint32_t;

    Id operand();                   // numbered in order: see operand_of
    Id combine(SetOp op, const std::vector<Id>& children);  // kDifference: the first less all others
    void finish(Id root) { root_ = root; }

    std::size_t operand_count() const { return operands_.size(); }
    void set(std::uint32_t operand, bool inside);
    bool value() const { return nodes_[root_].value; }
    // Is the operand on, and with it every part of the expression around it, so that its matter is part of the result?
    bool is_held_by(std::uint32_t operand) const;
    // The values of the operand and of what it is part of, up to the root.
    void values_around(std::uint32_t operand, std::vector<bool>& out) const;
    // Does the value no longer depend on the other operands where this one is on?
    bool is_settled_within(std::uint32_t operand) const;

private:
    static constexpr Id kNone = 0xFFFFFFFF;
    struct Node {
        SetOp op = SetOp::kUnion;
        Id parent = kNone;
        bool first = false;            // the first child of a difference
        bool value = false;
        std::uint32_t children = 0, on = 0;  // of a difference: its cutters
        bool minuend = false;
    };
    std::vector<Node> nodes_;
    std::vector<Id> operands_;
    Id root_ = 0;
};

}  // namespace whittle
