#include <cmath>

#include "csg/eval/builtin.h"
#include "csg/eval/machine.h"
#include "csg/eval/nearest.h"
#include "csg/eval/value_ops.h"
#include "csg/eval/value_text.h"
#include "csg/lang/print_ast.h"

namespace whittle {

using namespace code;

// The ways that most evaluations take; the rest is in eval_slow, so that this frame stays small. What stands in tail position goes round instead of deeper.
Value Machine::eval(TermId id, Activation* frame) {
    for (;;) {
        const Term& term = terms_[id];
        switch (term.op) {
            case Op::kConstant: return program_.constants[term.a];
            case Op::kSlot: return frame->slots()[term.a];
            case Op::kOuter: return up(frame, term.a)->slots()[term.b];
            case Op::kMaybe: {
                const Value& value = up(frame, term.a)->slots()[term.b];
                if (!value.is_unset()) return value;
                id = term.c;
                continue;
            }
            case Op::kTernary: id = truth(term.a, frame) ? term.b : term.c; continue;
            case Op::kOr: case Op::kAnd: return Value(truth(id, frame));
            case Op::kAdd: case Op::kSubtract: case Op::kMultiply: case Op::kDivide: case Op::kModulo: case Op::kNumberFunction: case Op::kCall: {
                Value made;
                if (const Number n = number(id, frame, made); n.is) made = n.value;
                return made;
            }
            case Op::kLess: case Op::kLessEqual: case Op::kGreater: case Op::kGreaterEqual: case Op::kEqual: case Op::kNotEqual: {
                Value other;
                const std::optional<bool> yes = compared(term, id, frame, other);
                return yes ? Value(*yes) : other;
            }
            case Op::kIndex: case Op::kElement: {
                Value hold, other;
                const Value* found = element(term, frame, hold, other);
                return found ? *found : std::move(other);
            }
            case Op::kVector: return eval_vector(term, id, frame);
            case Op::kLet:
                bind_all(term.b, term.c, frame);
                id = term.a;
                continue;
            case Op::kTailCall:
                tail_ = next_frame(program_.calls[term.a], frame, id);
                return Value::unset();
            case Op::kBuiltin: return eval_builtin(term, id, frame);
            case Op::kAssert: case Op::kEcho:
                if (term.op == Op::kAssert) run_assert(program_.arguments, term.b, term.c, frame, program_.places[id]);
                else run_echo(program_.arguments, term.b, term.c, frame);
                if (term.a == code::kNone) return {};
                id = term.a;
                continue;
            default: return eval_slow(term, id, frame);
        }
    }
}

// A member of an object; a function with a parameter `this` comes as a method of it.
Value Machine::member_of(const Value& record, std::string_view name) {
    const Value* found = record.record().find(name);
    if (!found) return {};
    if (!found->is_function() || found->function().self || program_.functions[found->function().code].self == code::kNone) return *found;
    return heap_.method(found->function(), record.record());
}

Value Machine::eval_vector(const Term& term, TermId id, Activation* frame) {
    Value made = heap_.blank_vector(term.b);
    Value* elements = elements_of_new(made);
    for (std::uint32_t i = 0; i < term.b; ++i) eval_into(elements[i], program_.lists[term.a + i], frame);
    note_nesting(made);
    if (made.vector().nesting > kMaxValueNesting) fail_too_nested(id);
    return made;
}

template <std::size_t Count>
Value Machine::eval_builtin_of(const Term& term, TermId id, Activation* frame) {
    Value arguments[Count];
    for (std::size_t i = 0; i < Count; ++i) eval_into(arguments[i], program_.lists[term.b + i], frame);
    return call_builtin(term.a, arguments, program_.places[id]);
}

Value Machine::eval_builtin(const Term& term, TermId id, Activation* frame) {
    try {
        switch (term.c) {
            case 1: return eval_builtin_of<1>(term, id, frame);
            case 2: return eval_builtin_of<2>(term, id, frame);
            case 3: return eval_builtin_of<3>(term, id, frame);
            default: {
                std::vector<Value> arguments(term.c);
                for (std::uint32_t i = 0; i < term.c; ++i) arguments[i] = eval(program_.lists[term.b + i], frame);
                return call_builtin(term.a, arguments, program_.places[id]);
            }
        }
    } catch (StopRun& stop) {
        trace(stop, builtin_functions()[term.a].name, program_.places[id]);
        throw;
    }
}

Value Machine::eval_slow(const Term& term, TermId id, Activation* frame) {
    switch (term.op) {
        case Op::kDynamic: return eval_dynamic(term, id);
        case Op::kUnknown:
            if (term.b == 0) warn(program_.places[id], "Ignoring unknown variable '" + names_.text(term.a) + "'", hint(hint_for_variable, term.a));
            return {};
        case Op::kUnary: {
            Value hold;
            const Value& value = operand(term.a, frame, hold);
            std::string problem;
            Value result = unary_operation(heap_, static_cast<ast::Op>(term.b), value, problem);
            if (!problem.empty()) warn(program_.places[id], std::move(problem));
            return result;
        }
        case Op::kBinary: {
            Value first, second;
            const Value& right = operand(term.b, frame, first);
            return eval_binary(static_cast<ast::Op>(term.c), operand(term.a, frame, second), right, id);
        }
        case Op::kMember: return eval_member(term, frame);
        case Op::kRange: return eval_range(term, id, frame);
        case Op::kLetDynamic: {
            const std::size_t before = mark();
            bind_all(term.b, term.c, frame);
            Value result = eval(term.a, frame);
            undo(before);
            return result;
        }
        case Op::kFrame: {
            const FrameRef inner(heap_.frame(program_.frame_sizes[term.b], frame));
            return eval(term.a, inner.get());
        }
        case Op::kFunction: return heap_.function(term.a, frame);
        case Op::kCallValue: return call_value(id, frame);
        case Op::kTailCallValue: return tail_call_value(term, id, frame);
        case Op::kUnknownFunction:
            warn(program_.places[id], "Ignoring unknown function '" + names_.text(term.a) + "'", hint(hint_for_function, term.a));
            return {};
        default: {  // kElements, or a generator on its own: a list
            const std::size_t base = stack_.size();
            if (term.op == Op::kElements)
                for (std::uint32_t i = 0; i < term.b; ++i) push_elements(program_.lists[term.a + i], frame);
            else push_elements(id, frame);
            Value made = heap_.vector(stack_.data() + base, stack_.size() - base);
            stack_.resize(base);
            if (made.vector().nesting > kMaxValueNesting) fail_too_nested(id);
            return made;
        }
    }
}

void Machine::fail_too_nested(TermId id) { fail(program_.places[id], "Lists are nested too deeply"); }

Value Machine::eval_binary(ast::Op op, const Value& left, const Value& right, TermId id) {
    std::string problem;
    Value result = binary_operation(heap_, op, left, right, problem);
    if (problem.empty()) return result;
    const bool joins = op == ast::Op::kAdd && (left.is_string() || right.is_string());
    warn(program_.places[id], std::move(problem), joins ? "texts are joined by str(a, b)" : "");
    return result;
}

Value Machine::eval_dynamic(const Term& node, TermId id) {
    const Value& value = cells_[node.a];
    if (!value.is_unset()) return value;
    if (node.a == kParentModules && !module_names_.empty()) return Value(static_cast<double>(module_names_.size()));
    if (node.c == 0) warn(program_.places[id], "Ignoring unknown variable '" + names_.text(node.b) + "'", hint(hint_for_variable, node.b));
    return {};
}

Value Machine::eval_range(const Term& node, TermId id, Activation* frame) {
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

Value Machine::eval_member(const Term& term, Activation* frame) {
    Value hold;
    const Value& whole = operand(term.a, frame, hold);
    const std::string& name = names_.text(term.b);
    if (whole.is_vector()) return swizzle(whole, name);
    if (whole.is_record()) return member_of(whole, name);
    if (whole.is_range()) {
        if (name == "begin") return Value(whole.range().begin);
        if (name == "step") return Value(whole.range().step);
        if (name == "end") return Value(whole.range().end);
    }
    return {};
}

// Later versions: .w, .r .g .b .a, and up to four of them together, which make a vector.
Value Machine::swizzle(const Value& vector, const std::string& name) {
    constexpr std::string_view kAxes = "xyzw", kColors = "rgba";
    Value parts[4];
    if (name.size() > 4) return {};
    const std::string_view letters = kAxes.find(name[0]) != std::string_view::npos ? kAxes : kColors;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::size_t index = letters.find(name[i]);
        if (index >= vector.size()) return {};
        parts[i] = vector[index];
    }
    return name.size() == 1 ? parts[0] : heap_.vector(parts, name.size());
}

void Machine::bind(const Bind& bind, Value value, Activation* frame) {
    switch (bind.kind) {
        case BindKind::kSlot: frame->slots()[bind.target] = std::move(value); return;
        case BindKind::kDynamic: set_dynamic(bind.target, std::move(value)); return;
        case BindKind::kDuplicate:
            warn(bind.place, "Ignoring duplicate variable assignment " + names_.text(bind.name) + " = " + text_of(value));
            return;
        case BindKind::kNameless: warn(bind.place, "Assignment without variable name " + text_of(value)); return;
    }
}

void Machine::bind_all(std::uint32_t first, std::uint32_t count, Activation* frame) {
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Bind& b = program_.binds[i];
        Value made;
        const Number n = read(b.value, frame, made);
        if (n.is && b.kind == BindKind::kSlot) {
            frame->slots()[b.target] = n.value;
            continue;
        }
        if (n.is) made = n.value;
        bind(b, std::move(made), frame);
    }
}

void Machine::run_assert(const std::vector<Argument>& list, std::size_t first, std::size_t count, Activation* frame, SourcePlace place) {
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
    if (!condition) warn(place, "Ignoring unknown variable 'condition'");
    else if (truth(condition->value, frame)) return;
    std::string text = "Assertion";
    if (condition) {
        text += " '";
        print_expression(text, *condition->tree, condition->text, names_, append_number);
        text += "'";
    }
    text += " failed";
    if (message)
        if (const Value told = eval(message->value, frame); !told.is_undef()) text += ": " + text_of(told);
    fail(place, std::move(text));
}

void Machine::run_echo(const std::vector<Argument>& list, std::size_t first, std::size_t count, Activation* frame) {
    std::string text;
    Value hold;
    for (std::size_t i = first; i < first + count; ++i) {
        if (i > first) text += ", ";
        if (list[i].name != kNoName) text += names_.text(list[i].name) + " = ";
        append_text(text, operand(list[i].value, frame, hold));
    }
    say(Severity::kEcho, {}, std::move(text));
}

}  // namespace whittle
