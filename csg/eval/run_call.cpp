#include <algorithm>
#include <unordered_map>

#include "csg/eval/builtin.h"
#include "csg/eval/machine.h"
#include "csg/eval/nearest.h"

namespace whittle {

using namespace code;

// The frame a callee is defined in, with a reference for the caller of this. A used file's is made anew and its assignments are run.
Frame* Machine::home_frame(const Home& home, Frame* frame) {
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

// Defaults see the frame of the definition, not the other parameters, and are evaluated before the arguments, given or not.
void Machine::set_defaults(const std::vector<Parameter>& parameters, const Matched& matched, Frame* home, Frame* into) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Parameter& p = parameters[i];
        if (p.dynamic) continue;
        if (p.constant && i < 64 && (matched.given >> i & 1)) continue;
        into->slots()[p.target] = p.value == code::kNone ? Value() : eval(p.value, home);
    }
}

void Machine::set_dynamic_defaults(const std::vector<Parameter>& parameters, Frame* home) {
    for (const Parameter& p : parameters)
        if (p.dynamic) set_dynamic(p.target, p.value == code::kNone ? Value() : eval(p.value, home));
}

void Machine::pass_arguments(const Matched& matched, Frame* caller, Frame* into, SourcePlace place) {
    if (input_.check_parameters)
        for (const std::string& complaint : matched.complaints) warn(place, complaint);
    for (const Passed& p : matched.passed) {
        Value value = eval(p.value, caller);
        if (p.to == Passed::To::kParameter || p.to == Passed::To::kSlot) into->slots()[p.target] = std::move(value);
        else if (p.to == Passed::To::kDynamic) set_dynamic(p.target, std::move(value));
    }
}

Value Machine::call_function(const Call& call, Frame* frame, SourcePlace place) {
    const code::Function& f = program_.functions[call.function];
    tick();
    const Depth depth(*this, f.depth + 1, "function", call.name, place);
    const std::size_t before = mark();
    try {
        const FrameRef home(home_frame(call.home, frame));
        Frame* inner = heap_.frame(f.layout.slots, home.get());
        const FrameRef held(inner);
        set_defaults(f.parameters, call.matched, home.get(), inner);
        if (call.sets_dynamic) set_dynamic_defaults(f.parameters, home.get());
        pass_arguments(call.matched, frame, inner, place);
        retain(inner);
        Value result = run_function(call.function, home.get(), inner, call.name);
        if (trail_.size() > before) undo(before);
        return result;
    } catch (StopRun& stop) {
        trace(stop, names_.text(call.name), place);
        throw;
    }
}

// Evaluates the body. A call of itself in tail position goes round here instead of deeper. Takes over the reference to `frame`.
Value Machine::run_function(std::uint32_t function, Frame* home, Frame* frame, NameId name) {
    const code::Function& f = program_.functions[function];
    FrameRef current(frame);
    FrameRef scope(nullptr);  // of a let with a frame of its own
    Frame* at = frame;
    TermId id = f.body;
    for (std::uint32_t rounds = 0;;) {
        const Term& term = program_.terms[id];
        switch (term.op) {
            case Op::kTernary: id = eval(term.a, at).truth() ? term.b : term.c; continue;
            case Op::kLet:
                bind_all(term.b, term.c, at);
                id = term.a;
                continue;
            case Op::kFrame:
                if (program_.terms[term.a].op != Op::kLet) break;
                scope.reset(heap_.frame(program_.frame_sizes[term.b], at));
                at = scope.get();
                id = term.a;
                continue;
            case Op::kAssert:
                if (term.a == code::kNone) break;
                run_assert(program_.arguments, term.b, term.c, at, program_.places[id]);
                id = term.a;
                continue;
            case Op::kEcho:
                if (term.a == code::kNone) break;
                run_echo(program_.arguments, term.b, term.c, at);
                id = term.a;
                continue;
            case Op::kTailCall: {
                const Call& call = program_.calls[term.a];
                if (++rounds > kMaxIterations) fail(f.place, "Recursion detected calling function '" + names_.text(name) + "'");
                tick();
                Frame* next = heap_.frame(f.layout.slots, home);
                FrameRef held(next);
                set_defaults(f.parameters, call.matched, home, next);
                set_dynamic_defaults(f.parameters, home);
                pass_arguments(call.matched, at, next, program_.places[id]);
                retain(next);
                current.reset(next);
                scope.reset(nullptr);
                at = next;
                id = f.body;
                continue;
            }
            default: break;
        }
        return eval(id, at);
    }
}

Matched Machine::match_values(const std::vector<Argument>& arguments, const std::vector<Parameter>& parameters, const Layout& layout) const {
    Matched out;
    std::unordered_map<std::string, Passed> by_name;
    std::size_t next = 0;
    for (const Argument& a : arguments) {
        NameId name = a.name;
        const auto same = [&](const Parameter& p) { return p.name == name; };
        if (name == kNoName) {
            if (next >= parameters.size()) {
                if (next++ == parameters.size()) out.complaints.push_back("Too many unnamed arguments supplied");
                continue;
            }
            name = parameters[next++].name;
        } else {
            if (!names_.is_dynamic(name) && std::none_of(parameters.begin(), parameters.end(), same))
                out.complaints.push_back("variable " + names_.text(name) + " not specified as parameter");
            if (by_name.count(names_.text(name))) out.complaints.push_back("argument " + names_.text(name) + " supplied more than once");
        }
        Passed passed;
        passed.value = a.value;
        const auto found = std::find_if(parameters.begin(), parameters.end(), same);
        const auto extra = std::find_if(layout.extras.begin(), layout.extras.end(), [&](const Layout::Extra& e) { return e.name == name; });
        const auto known = std::find(program_.dynamics.begin(), program_.dynamics.end(), name);
        if (found != parameters.end()) {
            passed.to = found->dynamic ? Passed::To::kDynamic : Passed::To::kParameter;
            passed.target = found->target;
            passed.parameter = static_cast<std::uint32_t>(found - parameters.begin());
        } else if (names_.is_dynamic(name) && known != program_.dynamics.end()) {
            passed.to = Passed::To::kDynamic;
            passed.target = static_cast<std::uint32_t>(known - program_.dynamics.begin());
        } else if (extra != layout.extras.end()) {
            passed.to = Passed::To::kSlot;
            passed.target = extra->slot;
        }
        by_name[names_.text(name)] = passed;
    }
    for (const auto& [name, passed] : by_name) {
        out.passed.push_back(passed);
        if (passed.to == Passed::To::kParameter && passed.parameter < 64) out.given |= std::uint64_t{1} << passed.parameter;
    }
    return out;
}

Value Machine::call_value(TermId id, Frame* frame) {
    const ValueCall& call = program_.value_calls[program_.terms[id].a];
    const SourcePlace place = program_.places[id];
    const Value callee = eval(call.callee, frame);
    if (!callee.is_function() && call.otherwise == ValueCall::Otherwise::kBuiltin) {
        std::vector<Value> values;
        std::vector<std::string_view> names;
        for (const Argument& a : call.arguments) values.push_back(eval(a.value, frame));
        return call_builtin(call.target, values, names, place);
    }
    if (!callee.is_function() && call.otherwise == ValueCall::Otherwise::kNothing) {
        if (call.name != kNoName) warn(place, "Ignoring unknown function '" + names_.text(call.name) + "'", hint_for_function(program_, names_, call.name));
        else warn(place, std::string("Can't call function on ") + type_name(callee.type()));
        return {};
    }
    Call made;
    made.name = call.name;
    made.function = callee.is_function() ? callee.function().code : call.target;
    const code::Function& f = program_.functions[made.function];
    const std::pair<std::uint32_t, std::uint32_t> key{program_.terms[id].a, made.function};
    auto cached = matches_.find(key);
    if (cached == matches_.end()) cached = matches_.emplace(key, match_values(call.arguments, f.parameters, f.layout)).first;
    const Matched& matched = cached->second;
    tick();
    const Depth depth(*this, f.depth + 1, "function", call.name, place);
    const std::size_t before = mark();
    try {
        Frame* around = nullptr;
        if (callee.is_function()) {
            around = callee.function().frame;
            retain(around);
        } else {
            around = home_frame(call.home, frame);
        }
        const FrameRef home(around);
        Frame* inner = heap_.frame(f.layout.slots, around);
        const FrameRef held(inner);
        set_defaults(f.parameters, matched, around, inner);
        set_dynamic_defaults(f.parameters, around);
        pass_arguments(matched, frame, inner, place);
        retain(inner);
        Value result = run_function(made.function, around, inner, call.name);
        undo(before);
        return result;
    } catch (StopRun& stop) {
        trace(stop, names_.text(call.name), place);
        throw;
    }
}

Value Machine::call_builtin(std::uint32_t builtin, std::vector<Value>& arguments, std::vector<std::string_view>& names, SourcePlace place) {
    const BuiltinFunction& f = builtin_functions()[builtin];
    FunctionCall call{*this, f.name, place, arguments, names};
    return f.run(call);
}

}  // namespace whittle
