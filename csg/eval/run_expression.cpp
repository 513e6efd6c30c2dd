#include <cmath>

#include "csg/eval/builtin.h"
#include "csg/eval/machine.h"
#include "csg/eval/nearest.h"
#include "csg/eval/value_ops.h"
#include "csg/eval/value_text.h"
#include "csg/lang/print_ast.h"

namespace whittle {

using namespace code;

namespace {

Frame* up(Frame* frame, std::uint32_t levels) {
    for (; levels > 0; --levels) frame = frame->parent;
    return frame;
}

}  // namespace

// The ways that most evaluations take; the rest is in eval_slow, so that this frame stays small.
Value Machine::eval(TermId id, Frame* frame) {
    const Term& node = program_.terms[id];
    const auto arithmetic = [&](auto operation, ast::Op op) {
        const Value left = eval(node.a, frame);
        const Value right = eval(node.b, frame);
        if (left.is_number() && right.is_number()) return Value(operation(left.number(), right.number()));
        return eval_binary(op, left, right, id);
    };
    switch (node.op) {
        case Op::kConstant: return program_.constants[node.a];
        case Op::kSlot: return frame->slots()[node.a];
        case Op::kOuter: return up(frame, node.a)->slots()[node.b];
        case Op::kMaybe: {
            const Value& value = up(frame, node.a)->slots()[node.b];
            return value.is_unset() ? eval(node.c, frame) : value;
        }
        case Op::kTernary: return eval(eval(node.a, frame).truth() ? node.b : node.c, frame);
        case Op::kOr: return Value(eval(node.a, frame).truth() || eval(node.b, frame).truth());
        case Op::kAnd: return Value(eval(node.a, frame).truth() && eval(node.b, frame).truth());
        case Op::kAdd: return arithmetic([](double a, double b) { return a + b; }, ast::Op::kAdd);
        case Op::kSubtract: return arithmetic([](double a, double b) { return a - b; }, ast::Op::kSubtract);
        case Op::kMultiply: return arithmetic([](double a, double b) { return a * b; }, ast::Op::kMultiply);
        case Op::kDivide: return arithmetic([](double a, double b) { return a / b; }, ast::Op::kDivide);
        case Op::kLess: return arithmetic([](double a, double b) { return a < b; }, ast::Op::kLess);
        case Op::kLessEqual: return arithmetic([](double a, double b) { return a <= b; }, ast::Op::kLessEqual);
        case Op::kGreater: return arithmetic([](double a, double b) { return a > b; }, ast::Op::kGreater);
        case Op::kGreaterEqual: return arithmetic([](double a, double b) { return a >= b; }, ast::Op::kGreaterEqual);
        case Op::kEqual: return arithmetic([](double a, double b) { return a == b; }, ast::Op::kEqual);
        case Op::kNotEqual: return arithmetic([](double a, double b) { return a != b; }, ast::Op::kNotEqual);
        case Op::kIndex: {
            const Value list = eval(node.a, frame);
            const Value index = eval(node.b, frame);
            if (list.is_vector() && index.is_number() && index.number() >= 0 && index.number() < list.size()) return list[static_cast<std::size_t>(index.number())];
            return element_at(heap_, list, index);
        }
        case Op::kVector: {
            const std::size_t base = stack_.size();
            for (std::uint32_t i = 0; i < node.b; ++i) stack_.push_back(eval(program_.lists[node.a + i], frame));
            Value made = heap_.vector(stack_.data() + base, node.b);
            stack_.resize(base);
            if (made.vector().nesting > kMaxValueNesting) fail_too_nested(id);
            return made;
        }
        case Op::kLet: {
            const std::size_t before = mark();
            bind_all(node.b, node.c, frame);
            Value result = eval(node.a, frame);
            if (trail_.size() > before) undo(before);
            return result;
        }
        case Op::kCall: return call_function(program_.calls[node.a], frame, program_.places[id]);
        case Op::kTailCall: return call_function(program_.calls[node.a], frame, program_.places[id]);
        default: return eval_slow(node, id, frame);
    }
}

Value Machine::eval_slow(const Term& node, TermId id, Frame* frame) {
    switch (node.op) {
        case Op::kDynamic: return eval_dynamic(node, id);
        case Op::kUnknown:
            if (node.b == 0) warn(program_.places[id], "Ignoring unknown variable '" + names_.text(node.a) + "'", hint_for_variable(program_, names_, node.a));
            return {};
        case Op::kUnary: {
            const Value operand = eval(node.a, frame);
            std::string problem;
            Value result = unary_operation(heap_, static_cast<ast::Op>(node.b), operand, problem);
            if (!problem.empty()) warn(program_.places[id], std::move(problem));
            return result;
        }
        case Op::kBinary: {
            const Value left = eval(node.a, frame);
            const Value right = eval(node.b, frame);
            return eval_binary(static_cast<ast::Op>(node.c), left, right, id);
        }
        case Op::kMember: return eval_member(node, frame);
        case Op::kElements: {
            const std::size_t base = stack_.size();
            for (std::uint32_t i = 0; i < node.b; ++i) push_elements(program_.lists[node.a + i], frame);
            Value made = heap_.vector(stack_.data() + base, stack_.size() - base);
            stack_.resize(base);
            if (made.vector().nesting > kMaxValueNesting) fail_too_nested(id);
            return made;
        }
        case Op::kRange: return eval_range(node, id, frame);
        case Op::kFrame: {
            const FrameRef inner(heap_.frame(program_.frame_sizes[node.b], frame));
            return eval(node.a, inner.get());
        }
        case Op::kAssert:
            run_assert(program_.arguments, node.b, node.c, frame, program_.places[id]);
            return node.a == code::kNone ? Value() : eval(node.a, frame);
        case Op::kEcho:
            run_echo(program_.arguments, node.b, node.c, frame);
            return node.a == code::kNone ? Value() : eval(node.a, frame);
        case Op::kFunction: return heap_.function(node.a, frame);
        case Op::kCallValue: return call_value(id, frame);
        case Op::kBuiltin: {
            std::vector<Value> arguments;
            arguments.reserve(node.c);
            std::vector<std::string_view> names;
            try {
                for (std::uint32_t i = 0; i < node.c; ++i) arguments.push_back(eval(program_.lists[node.b + i], frame));
                return call_builtin(node.a, arguments, names, program_.places[id]);
            } catch (StopRun& stop) {
                trace(stop, builtin_functions()[node.a].name, program_.places[id]);
                throw;
            }
        }
        case Op::kUnknownFunction:
            warn(program_.places[id], "Ignoring unknown function '" + names_.text(node.a) + "'", hint_for_function(program_, names_, node.a));
            return {};
        default: {  // a generator on its own makes a list
            const std::size_t base = stack_.size();
            push_elements(id, frame);
            Value made = heap_.vector(stack_.data() + base, stack_.size() - base);
            stack_.resize(base);
            return made;
        }
    }
}

void Machine::fail_too_nested(TermId id) { fail(program_.places[id], "Lists are nested too deeply"); }

Value Machine::eval_binary(ast::Op op, const Value& left, const Value& right, TermId id) {
    std::string problem;
    Value result = binary_operation(heap_, op, left, right, problem);
    if (!problem.empty()) warn(program_.places[id], std::move(problem));
    return result;
}

Value Machine::eval_dynamic(const Term& node, TermId id) {
    const Value& value = cells_[node.a];
    if (!value.is_unset()) return value;
    if (node.a == kParentModules && !module_names_.empty()) return Value(static_cast<double>(module_names_.size()));
    if (node.c == 0) warn(program_.places[id], "Ignoring unknown variable '" + names_.text(node.b) + "'", hint_for_variable(program_, names_, node.b));
    return {};
}

Value Machine::eval_range(const Term& node, TermId id, Frame* frame) {
    const Value begin = eval(node.a, frame);
    const Value end = eval(node.c, frame);
    if (!begin.is_number() || !end.is_number()) {
        if (node.b != code::kNone) eval(node.b, frame);
        return {};
    }
    const SourcePlace place = program_.places[id];
    if (node.b == code::kNone) {
        if (begin.number() <= end.number() || std::isnan(begin.number()) || std::isnan(end.number())) return heap_.range(begin.number(), 1, end.number());
        say(Severity::kDeprecated, place, "Using ranges of the form [begin:end] with begin value greater than the end value is deprecated",
            "write the step: [begin : -1 : end]");
        return heap_.range(end.number(), 1, begin.number());
    }
    const Value step = eval(node.b, frame);
    if (!step.is_number()) return {};
    // A literal range that can never give anything is a slip.
    const auto literal = [this](TermId part) { return program_.terms[part].op == Op::kConstant; };
    if (literal(node.a) && literal(node.b) && literal(node.c)) {
        if (step.number() > 0 && begin.number() > end.number()) warn(place, "begin is greater than the end, but step is positive");
        if (step.number() < 0 && begin.number() < end.number()) warn(place, "begin is smaller than the end, but step is negative");
    }
    return heap_.range(begin.number(), step.number(), end.number());
}

Value Machine::eval_member(const Term& node, Frame* frame) {
    const Value whole = eval(node.a, frame);
    const std::string& name = names_.text(node.b);
    if (whole.is_vector() && name.size() == 1 && name[0] >= 'x' && name[0] <= 'z') {
        const std::size_t index = static_cast<std::size_t>(name[0] - 'x');
        return index < whole.size() ? whole[index] : Value();
    }
    if (whole.is_range()) {
        if (name == "begin") return Value(whole.range().begin);
        if (name == "step") return Value(whole.range().step);
        if (name == "end") return Value(whole.range().end);
    }
    return {};
}

void Machine::bind(const Bind& bind, Value value, Frame* frame) {
    switch (bind.kind) {
        case BindKind::kSlot: frame->slots()[bind.target] = std::move(value); return;
        case BindKind::kDynamic: set_dynamic(bind.target, std::move(value)); return;
        case BindKind::kDuplicate:
            warn(bind.place, "Ignoring duplicate variable assignment " + names_.text(bind.name) + " = " + text_of(value));
            return;
        case BindKind::kNameless: warn(bind.place, "Assignment without variable name " + text_of(value)); return;
    }
}

void Machine::bind_all(std::uint32_t first, std::uint32_t count, Frame* frame) {
    for (std::uint32_t i = first; i < first + count; ++i) bind(program_.binds[i], eval(program_.binds[i].value, frame), frame);
}

void Machine::run_assert(const std::vector<Argument>& list, std::size_t first, std::size_t count, Frame* frame, SourcePlace place) {
    const Argument* condition = nullptr;
    const Argument* message = nullptr;
    std::size_t position = 0;
    for (std::size_t i = first; i < first + count; ++i) {
        const Argument& a = list[i];
        const std::string& name = names_.text(a.name);
        if (name == "condition" || (name.empty() && position == 0)) condition = &a;
        else if (name == "message" || (name.empty() && position == 1)) message = &a;
        else if (name.empty() && position == 2) warn(place, "Too many unnamed arguments supplied");
        else if (!name.empty()) warn(place, "variable " + name + " not specified as parameter");
        if (name.empty()) ++position;
    }
    if (condition && eval(condition->value, frame).truth()) return;
    std::string text = "Assertion";
    if (condition) {
        text += " '";
        print_expression(text, *condition->tree, condition->text, names_, append_number);
        text += "'";
    }
    text += " failed";
    if (message) text += ": " + text_of(eval(message->value, frame));
    fail(place, std::move(text));
}

void Machine::run_echo(const std::vector<Argument>& list, std::size_t first, std::size_t count, Frame* frame) {
    std::string text;
    for (std::size_t i = first; i < first + count; ++i) {
        if (i > first) text += ", ";
        if (list[i].name != kNoName) text += names_.text(list[i].name) + " = ";
        text += text_of(eval(list[i].value, frame));
    }
    say(Severity::kEcho, {}, std::move(text));
}

}  // namespace whittle
