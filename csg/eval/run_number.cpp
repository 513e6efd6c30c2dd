// Terms that are numbers as a rule: arithmetic, comparisons, elements and functions of a number hand doubles on in registers; what turns out to be something else
// takes the general way of values.
#include "csg/eval/builtin.h"
#include "csg/eval/machine.h"
#include "csg/eval/value_ops.h"

namespace whittle {

using namespace code;

namespace {

bool compare(Op op, double a, double b) {
    switch (op) {
        case Op::kLess: return a < b;
        case Op::kLessEqual: return a <= b;
        case Op::kGreater: return a > b;
        case Op::kGreaterEqual: return a >= b;
        case Op::kEqual: return a == b;
        default: return a != b;
    }
}

ast::Op general(Op op) {
    switch (op) {
        case Op::kAdd: return ast::Op::kAdd;
        case Op::kSubtract: return ast::Op::kSubtract;
        case Op::kMultiply: return ast::Op::kMultiply;
        case Op::kDivide: return ast::Op::kDivide;
        case Op::kModulo: return ast::Op::kModulo;
        case Op::kLess: return ast::Op::kLess;
        case Op::kLessEqual: return ast::Op::kLessEqual;
        case Op::kGreater: return ast::Op::kGreater;
        case Op::kGreaterEqual: return ast::Op::kGreaterEqual;
        case Op::kEqual: return ast::Op::kEqual;
        default: return ast::Op::kNotEqual;
    }
}

}  // namespace

// OpenSCAD evaluates the right operand first, which shows in the order of messages.
std::optional<bool> Machine::compared(const Term& term, TermId id, Activation* frame, Value& other) {
    const Number right = read(term.b, frame, other);
    if (!right.is) {
        Value hold;
        other = eval_binary(general(term.op), operand(term.a, frame, hold), other, id);
        return std::nullopt;
    }
    const Number left = read(term.a, frame, other);
    if (left.is) return compare(term.op, left.value, right.value);
    other = eval_binary(general(term.op), other, Value(right.value), id);
    return std::nullopt;
}

bool Machine::truth(TermId id, Activation* frame) {
    const Term& term = terms_[id];
    switch (term.op) {
        case Op::kLess: case Op::kLessEqual: case Op::kGreater: case Op::kGreaterEqual: case Op::kEqual: case Op::kNotEqual: {
            Value other;
            const std::optional<bool> yes = compared(term, id, frame, other);
            return yes ? *yes : other.truth();
        }
        case Op::kOr: return truth(term.a, frame) || truth(term.b, frame);
        case Op::kAnd: return truth(term.a, frame) && truth(term.b, frame);
        default: {
            Value hold;
            return operand(id, frame, hold).truth();
        }
    }
}

// The terms that are numbers as a rule; others take eval.
Machine::Number Machine::number(TermId id, Activation* frame, Value& other) {
    for (;;) {
        const Term& term = terms_[id];
        switch (term.op) {
            case Op::kConstant: return number_of(constants_[term.a], other);
            case Op::kSlot: return number_of(frame->slots()[term.a], other);
            case Op::kOuter: return number_of(up(frame, term.a)->slots()[term.b], other);
            case Op::kAdd: case Op::kSubtract: case Op::kMultiply: case Op::kDivide: case Op::kModulo: return number_of_operation(term, id, frame, other);
            case Op::kTernary: id = truth(term.a, frame) ? term.b : term.c; continue;
            case Op::kIndex: case Op::kElement: {
                Value hold;
                const Value* found = element(term, frame, hold, other);
                return found ? number_of(*found, other) : Number{0, false};
            }
            case Op::kNumberFunction: return number_of_function(term, id, frame, other);
            case Op::kLet:
                bind_all(term.b, term.c, frame);
                id = term.a;
                continue;
            case Op::kCall: return call_function(program_.calls[term.a], frame, id, other);
            default:
                other = eval(id, frame);
                if (other.is_number()) return {other.number(), true};
                return {0, false};
        }
    }
}

Machine::Number Machine::number_of_operation(const Term& term, TermId id, Activation* frame, Value& other) {
    const Number right = read(term.b, frame, other);
    if (!right.is) {
        Value hold;
        other = eval_binary(general(term.op), operand(term.a, frame, hold), other, id);
        return {other.is_number() ? other.number() : 0, other.is_number()};
    }
    const Number left = read(term.a, frame, other);
    if (!left.is) {
        other = eval_binary(general(term.op), other, Value(right.value), id);
        return {other.is_number() ? other.number() : 0, other.is_number()};
    }
    switch (term.op) {
        case Op::kAdd: return {left.value + right.value, true};
        case Op::kSubtract: return {left.value - right.value, true};
        case Op::kMultiply: return {left.value * right.value, true};
        case Op::kDivide: return {left.value / right.value, true};
        default: return {remainder_of(left.value, right.value), true};
    }
}

Machine::Number Machine::number_of_function(const Term& term, TermId id, Activation* frame, Value& other) {
    const BuiltinFunction& function = builtin_functions()[term.a];
    try {
        const Number x = read(program_.lists[term.b], frame, other);
        if (x.is) return {function.of_number(*this, x.value), true};
        Value argument = std::move(other);
        other = call_builtin(term.a, {&argument, 1}, program_.places[id]);
        return {other.is_number() ? other.number() : 0, other.is_number()};
    } catch (StopRun& stop) {
        trace(stop, function.name, program_.places[id]);
        throw;
    }
}

// The element that list[index] or list.x names, where it lies in a vector that something else or `hold` keeps; else nothing, and its value is `other`.
const Value* Machine::element(const Term& term, Activation* frame, Value& hold, Value& other) {
    const Value& whole = operand(term.a, frame, hold);
    if (term.op == Op::kElement) {
        if (whole.is_vector() && term.b < whole.size()) return &whole[term.b];
        other = whole.is_record() ? member_of(whole, std::string_view(&"xyz"[term.b], 1)) : Value();
        return nullptr;
    }
    const Number index = read(term.b, frame, other);
    if (index.is && whole.is_vector() && index.value >= 0 && index.value < whole.size()) return &whole[static_cast<std::size_t>(index.value)];
    if (index.is) other = Value(index.value);
    if (whole.is_record()) other = other.is_string() ? member_of(whole, other.string()) : Value();
    else other = element_at(heap_, whole, other);
    return nullptr;
}

}  // namespace whittle
