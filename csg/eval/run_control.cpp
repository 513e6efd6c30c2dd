#include <algorithm>
#include <cmath>

#include "csg/eval/machine.h"
#include "csg/eval/value_ops.h"

namespace whittle {

using namespace code;

void Machine::make_loop(const Inst& inst, Activation* frame) {
    const std::size_t first = pending_.size();
    const FrameRef own(inst.frame_size == code::kNone ? nullptr : heap_.frame(program_.frame_sizes[inst.frame_size], frame));
    if (!inst.binds.empty()) make_loop_level(inst, 0, own.get() ? own.get() : frame);
    if (inst.kind == InstKind::kIntersectionFor) add_node(inst, scene::Intersection{}, first);
    else add_node(inst, scene::Group{"for"}, first);
}

void Machine::make_loop_level(const Inst& inst, std::size_t level, Activation* frame) {
    if (level == inst.binds.size()) return make_scope(inst.children, frame);
    const Bind& variable = inst.binds[level];
    const Value values = eval(variable.value, frame);
    const auto round = [&](const Value& value) {
        tick();
        const FrameRef own(inst.frame_size == code::kNone ? nullptr : copy_frame(frame, program_.frame_sizes[inst.frame_size]));
        Activation* inside = own.get() ? own.get() : frame;
        const std::size_t before = mark();
        set_loop_variable(variable, value, inside);
        make_loop_level(inst, level + 1, inside);
        undo(before);
    };
    if (values.is_range()) {
        const std::uint32_t count = range_count(values.range());
        if (count >= kMaxModuleIterations)
            return warn(inst.place, "Bad range parameter in for statement: too many elements (" + std::to_string(count) + ")",
                        "a range in a for of modules has fewer than 10000 elements");
        for (std::uint32_t i = 0; i < count; ++i) round(Value(range_at(values.range(), i)));
    } else if (values.is_vector()) {
        for (std::uint32_t i = 0; i < values.size(); ++i) round(values[i]);
    } else if (values.is_string()) {
        for (std::uint32_t i = 0; i < values.string_object().points; ++i) round(character_at(heap_, values.string_object(), i));
    } else if (values.is_record()) {
        for (std::uint32_t i = 0; i < values.record().size; ++i) round(values.record().names()[i]);
    } else if (!values.is_undef()) {
        round(values);
    }
}

void Machine::make_if(const Inst& inst, Activation* frame) {
    const bool yes = !inst.arguments.empty() && eval(inst.arguments[0].value, frame).truth();
    if (!yes && inst.otherwise == code::kNone && !inst.has_else) return;
    const std::size_t first = pending_.size();
    make_scope(yes ? inst.children : inst.otherwise, frame);
    add_node(inst, scene::Group{"if"}, first);
}

void Machine::make_let(const Inst& inst, Activation* frame) {
    if (inst.kind == InstKind::kAssign)
        say(Severity::kDeprecated, inst.place, "The assign() module will be removed in future releases. Use a regular assignment instead.");
    const std::size_t first = pending_.size();
    const FrameRef own(inst.frame_size == code::kNone ? nullptr : heap_.frame(program_.frame_sizes[inst.frame_size], frame));
    Activation* inside = own.get() ? own.get() : frame;
    for (const Bind& b : inst.binds) bind(b, eval(b.value, inside), inside);
    make_scope(inst.children, inside);
    add_node(inst, scene::Group{"let"}, first);
}

// One child of the module whose body is being made; `index` as given, truncated.
void Machine::make_child(const ModuleCall& call, double index, const Inst& inst) {
    const std::vector<InstId>* written = call.inst->children == code::kNone ? nullptr : &program_.scopes[call.inst->children].insts;
    const int count = written ? static_cast<int>(written->size()) : 0;
    const int n = std::isfinite(index) ? static_cast<int>(std::clamp(index, -2e9, 2e9)) : 0;
    const char* which = names_.text(inst.name) == "child" ? "Child" : "Children";
    if (n < 0) return warn({}, std::string("Negative ") + (which[5] ? "children" : "child") + " index (" + std::to_string(n) + ") not allowed");
    if (n >= count)
        return warn({}, std::string(which) + " index (" + std::to_string(n) + ") out of bounds (" + std::to_string(count) + " children)");
    make((*written)[static_cast<std::size_t>(n)], call.caller);
}

// children(), children(n), children([list or range]): evaluated where they were written, now.
void Machine::make_children(const Inst& inst, Activation* frame) {
    const bool old_form = names_.text(inst.name) == "child";
    if (old_form) say(Severity::kDeprecated, {}, "child() will be removed in future releases. Use children() instead.");
    Activation* module = frame;
    while (module && !module->call) module = module->parent;
    if (!module) return;
    const ModuleCall call = *module->call;
    const std::size_t first = pending_.size();
    // While they run, the module on top is the one around the call.
    if (inst.arguments.empty()) {
        if (old_form) return make_child(call, 0, inst);
        if (call.inst->children != code::kNone)
            for (const InstId id : program_.scopes[call.inst->children].insts) make(id, call.caller);
        return add_node(inst, scene::Group{"children"}, first);
    }
    const Value which = eval(inst.arguments[0].value, frame);
    if (which.is_number()) return make_child(call, which.number(), inst);
    if (which.is_vector()) {
        for (std::uint32_t i = 0; i < which.size(); ++i)
            if (which[i].is_number()) make_child(call, which[i].number(), inst);
            else warn({}, "Bad parameter type (" + bare_text_of(which[i]) + ") for children, only accept: empty, number, vector, range.");
    } else if (which.is_range()) {
        const std::uint32_t count = range_count(which.range());
        if (count >= kMaxModuleIterations)
            return warn(inst.place, "Bad range parameter for children: too many elements (" + std::to_string(count) + ")");
        for (std::uint32_t i = 0; i < count; ++i) make_child(call, range_at(which.range(), i), inst);
    } else {
        return warn(inst.place, "Bad parameter type (" + text_of(which) + ") for children, only accept: empty, number, vector, range");
    }
    add_node(inst, scene::Group{"children"}, first);
}

}  // namespace whittle
