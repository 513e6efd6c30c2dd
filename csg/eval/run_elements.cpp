#include "csg/eval/machine.h"
#include "csg/eval/value_ops.h"

namespace whittle {

using namespace code;

// Pushes what an element of a list stands for onto the stack: one value, or any number for a generator.
void Machine::push_elements(TermId id, Activation* frame) {
    const Term& term = program_.terms[id];
    switch (term.op) {
        case Op::kFor: {
            const std::size_t before = mark();
            push_for(term, id, 0, frame);
            undo(before);
            return;
        }
        case Op::kForC: {
            const std::size_t before = mark();
            push_for_c(program_.loops[term.a], id, frame);
            undo(before);
            return;
        }
        case Op::kIf: {
            const bool yes = truth(term.a, frame);
            if (yes) push_elements(term.b, frame);
            else if (term.c != code::kNone) push_elements(term.c, frame);
            return;
        }
        case Op::kEach: {
            const Op inside = terms_[term.a].op;
            if (inside != Op::kFor && inside != Op::kForC && inside != Op::kIf && inside != Op::kEach && inside != Op::kLet && inside != Op::kLetDynamic &&
                inside != Op::kFrame) {
                Value hold;
                return push_each(operand(term.a, frame, hold), id);
            }
            // `each` of a generator expands every value of it.
            const std::size_t base = stack_.size();
            push_elements(term.a, frame);
            std::vector<Value> made(std::make_move_iterator(stack_.begin() + static_cast<std::ptrdiff_t>(base)), std::make_move_iterator(stack_.end()));
            stack_.resize(base);
            for (const Value& value : made) push_each(value, id);
            return;
        }
        case Op::kLet:
            bind_all(term.b, term.c, frame);
            return push_elements(term.a, frame);
        case Op::kLetDynamic: {
            const std::size_t before = mark();
            bind_all(term.b, term.c, frame);
            push_elements(term.a, frame);
            undo(before);
            return;
        }
        case Op::kFrame: {
            const Op inside = program_.terms[term.a].op;
            if (inside == Op::kFor) return push_elements_in_frames(id, frame);
            const FrameRef inner(heap_.frame(program_.frame_sizes[term.b], frame));
            return push_elements(term.a, inner.get());
        }
        case Op::kSlot: push(frame->slots()[term.a]); return;
        default: {
            Value other;
            const Number n = number(id, frame, other);
            push(n.is ? Value(n.value) : std::move(other));
            return;
        }
    }
}

// Calls body(value) for what a loop over `values` goes through. Ranges of `limit` and more elements are refused.
template <class Body>
void Machine::for_values(const Value& values, std::uint32_t limit, SourcePlace place, Body body) {
    if (values.is_range()) {
        const RangeObject& range = values.range();
        const std::uint32_t count = range_count(range);
        if (count >= limit) return warn(place, "Bad range parameter in for statement: too many elements (" + std::to_string(count) + ")");
        for (std::uint32_t i = 0; i < count; ++i) body(Value(range_at(range, i)));
    } else if (values.is_vector()) {
        for (std::uint32_t i = 0; i < values.size(); ++i) body(values[i]);
    } else if (values.is_string()) {
        for (std::uint32_t i = 0; i < values.string_object().points; ++i) body(character_at(heap_, values.string_object(), i));
    } else if (values.is_record()) {
        for (std::uint32_t i = 0; i < values.record().size; ++i) body(values.record().names()[i]);
    } else if (!values.is_undef()) {
        body(values);
    }
}

void Machine::push_for(const Term& term, TermId id, std::uint32_t level, Activation* frame) {
    if (term.c == 0) return push_elements(term.a, frame);
    const Bind& variable = program_.binds[term.b + level];
    const Value values = eval(variable.value, frame);
    for_values(values, kMaxIterations, program_.places[id], [&](const Value& value) {
        tick();
        set_loop_variable(variable, value, frame);
        if (level + 1 == term.c) push_elements(term.a, frame);
        else push_for(term, id, level + 1, frame);
    });
}

// A loop whose body holds function literals: every round has a frame of its own, which they keep.
void Machine::push_elements_in_frames(TermId id, Activation* frame) {
    const Term& outer = program_.terms[id];
    const Term& loop = program_.terms[outer.a];
    const std::size_t before = mark();
    const FrameRef first(heap_.frame(program_.frame_sizes[outer.b], frame));
    push_for_frames(loop, outer.a, 0, first.get(), program_.frame_sizes[outer.b]);
    undo(before);
}

void Machine::push_for_frames(const Term& term, TermId id, std::uint32_t level, Activation* frame, std::uint32_t size) {
    if (level == term.c) return push_elements(term.a, frame);
    const Bind& variable = program_.binds[term.b + level];
    const Value values = eval(variable.value, frame);
    for_values(values, kMaxIterations, program_.places[id], [&](const Value& value) {
        tick();
        const FrameRef round(copy_frame(frame, size));
        set_loop_variable(variable, value, round.get());
        push_for_frames(term, id, level + 1, round.get(), size);
    });
}

Activation* Machine::copy_frame(Activation* frame, std::uint32_t size) {
    Activation* copy = heap_.frame(size, frame->parent);
    copy->call = frame->call;
    for (std::uint32_t i = 0; i < size; ++i) copy->slots()[i] = frame->slots()[i];
    return copy;
}

// A loop variable named twice is set by the inner loop.
void Machine::set_loop_variable(const Bind& variable, const Value& value, Activation* frame) {
    if (variable.kind == BindKind::kSlot || variable.kind == BindKind::kDuplicate) {
        Value& slot = frame->slots()[variable.target];
        if (value.is_number()) slot = value.number();
        else slot = value;
    } else if (variable.kind == BindKind::kDynamic) set_dynamic(variable.target, value);
}

void Machine::push_for_c(const Loop& loop, TermId id, Activation* frame) {
    for (const std::uint32_t slot : loop.unset) frame->slots()[slot] = Value::unset();
    bind_all(loop.first_init, loop.inits, frame);
    for (std::uint32_t rounds = 0; truth(loop.condition, frame); ++rounds) {
        if (rounds == kMaxIterations) fail(program_.places[id], "For loop counter exceeded limit", "a C-style for stops after 1000000 rounds");
        tick();
        push_elements(loop.body, frame);
        bind_all(loop.first_step, loop.steps, frame);
    }
}

void Machine::push_each(const Value& value, TermId id) {
    if (value.is_vector() || value.is_range() || value.is_string()) {
        for_values(value, kMaxIterations, program_.places[id], [this](const Value& element) { push(element); });
    } else if (!value.is_undef()) {
        push(value);
    }
}

}  // namespace whittle
