#include <algorithm>

#include "csg/eval/builtin.h"
#include "csg/eval/builtin_arguments.h"
#include "csg/eval/machine.h"
#include "csg/eval/match_arguments.h"
#include "csg/eval/nearest.h"

namespace whittle {

using namespace code;

// The frame a callee is defined in, with a reference for the caller of this. A used file's is made anew and its assignments are run.
Activation* Machine::home_frame(const Home& home, Activation* frame) {
    if (home.library == code::kNone) {
        for (std::uint32_t i = 0; i < home.frames_up; ++i) frame = frame->parent;
        retain(frame);
        return frame;
    }
    const File& file = program_.files[home.library];
    FrameRef made(heap_.frame(file.layout.slots, nullptr));
    run_binds(program_.scopes[file.body], made.get());
    retain(made.get());
    return made.get();
}

// Sets the parameters of a call in `into`. Defaults see the frame of the definition, not the other parameters, and are evaluated before the arguments, given or
// not; the arguments see the $-variables as they were before the call.
void Machine::set_parameters(NameId callee, const std::vector<Parameter>& parameters, const Matched& matched, const Frames& frames, SourcePlace place) {
    std::vector<std::pair<std::uint32_t, Value>> dynamics;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Parameter& p = parameters[i];
        if (!p.dynamic && p.constant && i < 64 && (matched.given >> i & 1)) continue;
        Value value = p.value == code::kNone ? Value() : eval(p.value, frames.home);
        if (p.dynamic) dynamics.emplace_back(p.target, std::move(value));
        else frames.into->slots()[p.target] = std::move(value);
    }
    if (input_.check_parameters)
        for (const Complaint& complaint : matched.complaints) warn(place, complaint.text, hint_of_complaint(names_, complaint, callee, parameters));
    for (const Passed& p : matched.passed) {
        Value value = eval(p.value, frames.caller);
        if (p.to == Passed::To::kParameter || p.to == Passed::To::kSlot) frames.into->slots()[p.target] = std::move(value);
        else if (p.to == Passed::To::kDynamic) dynamics.emplace_back(p.target, std::move(value));
    }
    for (auto& [which, value] : dynamics) set_dynamic(which, std::move(value));
}

Machine::Number Machine::call_function(const Call& call, Activation* frame, TermId id, Value& other) {
    const code::Function& f = program_.functions[call.function];
    tick();
    const Depth depth(*this, f.depth + 1, "function", call.name, program_.places[id]);
    const std::size_t before = mark();
    try {
        const FrameRef inner(next_frame(call, frame, id));
        Number result = number(f.body, inner.get(), other);
        if (tail_) {
            other = run_tail_calls(f, call.name);
            result = {other.is_number() ? other.number() : 0, other.is_number()};
        }
        if (trail_.size() > before) undo(before);
        return result;
    } catch (StopRun& stop) {
        trace(stop, names_.text(call.name), program_.places[id]);
        throw;
    }
}

// The parameters of a call whose match is plain.
void Machine::set_plain_parameters(const Matched& matched, Activation* caller, Activation* into) {
    Value* slots = into->slots();
    for (const Matched::Default& d : matched.defaults) slots[d.slot] = d.value == code::kNone ? Value() : constants_[terms_[d.value].a];
    for (const Passed& p : matched.passed) eval_into(slots[p.target], p.value, caller);
}

// The frame of a call of a known function, its parameters set.
Activation* Machine::next_frame(const Call& call, Activation* frame, TermId id) {
    const code::Function& f = program_.functions[call.function];
    if (call.plain) {
        Activation* home = frame;
        for (std::uint32_t i = 0; i < call.home.frames_up; ++i) home = home->parent;
        FrameRef inner(heap_.frame(f.layout.slots, home));
        set_plain_parameters(call.matched, frame, inner.get());
        return inner.take();
    }
    const FrameRef home(home_frame(call.home, frame));
    FrameRef inner(heap_.frame(f.layout.slots, home.get()));
    set_parameters(call.name, f.parameters, call.matched, {home.get(), frame, inner.get()}, program_.places[id]);
    return inner.take();
}

// A body that ended in a call of its own function left that call's frame in tail_: goes round until one ends in a value.
Value Machine::run_tail_calls(const code::Function& f, NameId name) {
    for (std::uint32_t rounds = 0;;) {
        const FrameRef current(std::exchange(tail_, nullptr));
        if (++rounds > kMaxIterations) fail(f.place, "Recursion detected calling function '" + names_.text(name) + "'");
        tick();
        Value result = eval(f.body, current.get());
        if (!tail_) return result;
    }
}

Value Machine::call_other_than_function(const ValueCall& call, const Value& callee, Activation* frame, SourcePlace place) {
    if (call.otherwise == ValueCall::Otherwise::kBuiltin) {
        std::vector<Value> values;
        std::vector<NameId> given;
        for (const Argument& a : call.arguments) {
            values.push_back(eval(a.value, frame));
            given.push_back(a.name);
        }
        const auto made = [this](std::string_view text) { return text.empty() ? Value() : heap_.string(text); };
        values = arranged_arguments<Value>(builtin_functions()[call.target], given, std::move(values), names_, made);
        return call_builtin(call.target, values, place);
    }
    if (call.name != kNoName) warn(place, "Ignoring unknown function '" + names_.text(call.name) + "'", hint(hint_for_function, call.name));
    else warn(place, std::string("Can't call function on ") + type_name(callee.type()));
    return {};
}

// The frame of a call of what `callee` is, else of the function of that name: its parameters set, `this` too.
Activation* Machine::frame_of_value_call(std::uint32_t which, const Value& callee, Activation* frame, SourcePlace place) {
    const ValueCall& call = program_.value_calls[which];
    const std::uint32_t function = callee.is_function() ? callee.function().code : call.target;
    const code::Function& f = program_.functions[function];
    RecordObject* self = callee.is_function() ? callee.function().self : nullptr;
    const Matched& matched = matched_values(which, function, self != nullptr);
    if (callee.is_function()) retain(callee.function().frame);
    const FrameRef home(callee.is_function() ? callee.function().frame : home_frame(call.home, frame));
    FrameRef inner(heap_.frame(f.layout.slots, home.get()));
    if (matched.plain) set_plain_parameters(matched, frame, inner.get());
    else set_parameters(call.name, f.parameters, matched, {home.get(), frame, inner.get()}, place);
    if (self && !(f.self < 64 && (matched.given >> f.self & 1))) {
        ++self->refs;
        inner.get()->slots()[f.parameters[f.self].target] = Value(self);
    }
    return inner.take();
}

Value Machine::call_value(TermId id, Activation* frame) {
    const std::uint32_t which = program_.terms[id].a;
    const ValueCall& call = program_.value_calls[which];
    const SourcePlace place = program_.places[id];
    const Value callee = eval(call.callee, frame);
    if (!callee.is_function() && call.otherwise != ValueCall::Otherwise::kFunction) return call_other_than_function(call, callee, frame, place);
    const code::Function& f = program_.functions[callee.is_function() ? callee.function().code : call.target];
    tick();
    const Depth depth(*this, f.depth + 1, "function", call.name, place);
    const std::size_t before = mark();
    try {
        const FrameRef inner(frame_of_value_call(which, callee, frame, place));
        Value result = eval(f.body, inner.get());
        if (tail_) result = run_tail_calls(f, call.name);
        undo(before);
        return result;
    } catch (StopRun& stop) {
        trace(stop, names_.text(call.name), place);
        throw;
    }
}

// A function literal that calls itself through a variable goes round like a named function.
Value Machine::tail_call_value(const Term& term, TermId id, Activation* frame) {
    const Value callee = eval(program_.value_calls[term.a].callee, frame);
    if (!callee.is_function() || callee.function().code != term.b) return call_value(id, frame);
    tail_ = frame_of_value_call(term.a, callee, frame, program_.places[id]);
    return Value::unset();
}

// The match of a call's arguments with the function it met: made once, and the last one found at once.
const Matched& Machine::matched_values(std::uint32_t which, std::uint32_t function, bool is_method) {
    LastMatch& last = last_matches_[which];
    if (last.matched && last.function == function && last.is_method == is_method) return *last.matched;
    const std::tuple key{which, function, is_method};
    auto found = matches_.find(key);
    if (found == matches_.end()) {
        const std::vector<Argument>& arguments = program_.value_calls[which].arguments;
        const code::Function& f = program_.functions[function];
        std::vector<NameId> given;
        for (const Argument& a : arguments) given.push_back(a.name);
        const auto dynamic_of = [this](NameId name) {
            return static_cast<std::uint32_t>(std::find(program_.dynamics.begin(), program_.dynamics.end(), name) - program_.dynamics.begin());
        };
        Matched made = match_arguments(given, {f.parameters, f.layout, f.parameters.size(), is_method ? f.self : code::kNone}, names_, dynamic_of);
        for (Passed& passed : made.passed) passed.value = arguments[passed.value].value;
        note_plain(made, f.parameters);
        found = matches_.emplace(key, std::move(made)).first;
    }
    last = {function, is_method, &found->second};
    return found->second;
}

Value Machine::call_builtin(std::uint32_t builtin, std::span<Value> arguments, SourcePlace place) {
    const BuiltinFunction& f = builtin_functions()[builtin];
    FunctionCall call{*this, f.name, place, arguments};
    return f.run(call);
}

}  // namespace whittle
