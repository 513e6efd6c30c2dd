// machine.h — runs code: expressions to values, instantiations to scene nodes.
//
// Walks the resolved tree. Variables are slots; $-variables are cells with an undo trail (shallow binding), so reading one costs the same
// however deep the calls go. What ends a run early (failed assert, endless recursion, a limit) unwinds as StopRun and never leaves run().
#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "csg/base/degrees.h"
#include "csg/eval/code.h"
#include "csg/eval/evaluate.h"
#include "csg/eval/large_stack.h"
#include "csg/eval/lookup_memo.h"
#include "csg/eval/memo.h"
#include "csg/eval/random.h"
#include "csg/eval/value.h"
#include "csg/lang/diagnostics.h"
#include "csg/lang/names.h"

namespace whittle {

struct StopRun {
    Stop reason;
    int traces_left = 12;  // callers still to be named
};

// An activation of a module: where its children are to be evaluated.
struct ModuleCall {
    const code::Inst* inst = nullptr;
    Activation* caller = nullptr;
};

// The files of a run: where built-ins find what the author names, and the list of what was read.
struct RunFiles {
    Outside& outside;
    const SourceTable& sources;
    std::vector<std::string>& read;
    const std::vector<std::string>& fonts;  // that the text names
};

class Machine {
public:
    Machine(const code::Program& program, const Names& names, Heap& heap, const EvaluateInput& input, Diagnostics& diagnostics, const RunFiles& files);

    // Runs the main file. The scene is empty after a stop.
    Stop run(Scene& scene);

    Heap& heap() { return heap_; }
    const Names& names() const { return names_; }
    RandomNumbers& random() { return random_; }
    LookupMemo& lookup_memo() { return lookup_memo_; }
    double sine(double degrees) { return sine_(degrees); }
    double cosine(double degrees) { return cosine_(degrees); }
    const std::vector<NameId>& module_names() const { return module_names_; }
    Facets facets() const;
    // Placement of the node being made, in the root's frame (lights need it).
    const Placement& placement() const { return placement_; }
    void add_light(Light light);
    void set_camera(Camera camera);

    void warn(SourcePlace place, std::string text, std::string hint = {}) { say(Severity::kWarning, place, std::move(text), std::move(hint)); }
    void say(Severity severity, SourcePlace place, std::string text, std::string hint = {});
    [[noreturn]] void fail(SourcePlace place, std::string text, std::string hint = {});
    std::string text_of(const Value& value) const;
    void append_text(std::string& out, const Value& value) const;
    std::string bare_text_of(const Value& value) const;
    Outside& outside() { return files_.outside; }
    // The outside, knowing the fonts that the text names.
    Outside& fonts();
    // The path of a file that a call at `place` names: beside the text of the call, else beside the main file, else in the libraries; where there is
    // none, beside the text. It joins the list of files read.
    std::string find_file(SourcePlace place, std::string_view name);
    // Makes a node without children a child of the node being made.
    void add_child(SourcePlace place, scene::What what);
    // How a .csg file calls it: relative to the main file's folder.
    std::string name_of_file(const std::string& path) const;
    // Checks limits now and then: call it in every loop of unbounded length.
    void tick() {
        if (++ticks_ % 1024 == 0) check_limits();
    }

private:
    using TermId = code::TermId;

    // Expressions (run_expression.cpp, run_number.cpp).
    Value eval(TermId id, Activation* frame);
    // What most terms are, kept in registers. Where `is` is false, the value is no number and lies in what was handed over for it.
    struct Number { double value; bool is; };
    Number number(TermId id, Activation* frame, Value& other);
    inline Number read(TermId id, Activation* frame, Value& other);  // the same, inline for the commonest
    static inline Number number_of(const Value& value, Value& other);
    Number number_of_operation(const code::Term& term, TermId id, Activation* frame, Value& other);
    Number number_of_function(const code::Term& term, TermId id, Activation* frame, Value& other);
    const Value* element(const code::Term& term, Activation* frame, Value& hold, Value& other);
    inline void eval_into(Value& target, TermId id, Activation* frame);
    inline const Value& operand(TermId id, Activation* frame, Value& hold);
    bool truth(TermId id, Activation* frame);
    // Of two numbers; else nothing, and the result is `other`.
    std::optional<bool> compared(const code::Term& term, TermId id, Activation* frame, Value& other);
    Value eval_index(const code::Term& term, Activation* frame);
    Value eval_vector(const code::Term& term, TermId id, Activation* frame);
    Value eval_builtin(const code::Term& term, TermId id, Activation* frame);
    template <std::size_t Count>
    Value eval_builtin_of(const code::Term& term, TermId id, Activation* frame);
    Value eval_slow(const code::Term& term, TermId id, Activation* frame);
    [[noreturn]] void fail_too_nested(TermId id);
    Value eval_binary(ast::Op op, const Value& left, const Value& right, TermId id);
    Value eval_range(const code::Term& node, TermId id, Activation* frame);
    Value eval_member(const code::Term& term, Activation* frame);
    Value member_of(const Value& record, std::string_view name);
    Value swizzle(const Value& vector, const std::string& name);
    Value eval_dynamic(const code::Term& node, TermId id);
    void bind(const code::Bind& bind, Value value, Activation* frame);
    void bind_all(std::uint32_t first, std::uint32_t count, Activation* frame);
    void run_assert(const std::vector<code::Argument>& list, std::size_t first, std::size_t count, Activation* frame, SourcePlace place);
    void run_echo(const std::vector<code::Argument>& list, std::size_t first, std::size_t count, Activation* frame);

    // Lists (run_elements.cpp).
    inline void push(Value value);
    void push_elements(TermId id, Activation* frame);
    void push_for(const code::Term& node, TermId id, std::uint32_t bind, Activation* frame);
    void push_elements_in_frames(TermId id, Activation* frame);
    void push_for_frames(const code::Term& term, TermId id, std::uint32_t level, Activation* frame, std::uint32_t size);
    Activation* copy_frame(Activation* frame, std::uint32_t size);
    void set_loop_variable(const code::Bind& variable, const Value& value, Activation* frame);
    void push_for_c(const code::Loop& loop, TermId id, Activation* frame);
    void push_each(const Value& value, TermId id);
    template <class Body>
    void for_values(const Value& values, std::uint32_t limit, SourcePlace place, Body body);

    // Calls (run_call.cpp).
    Number call_function(const code::Call& call, Activation* frame, TermId id, Value& other);
    Activation* next_frame(const code::Call& call, Activation* frame, TermId id);
    Value run_tail_calls(const code::Function& function, NameId name);
    Value call_value(TermId id, Activation* frame);
    Value tail_call_value(const code::Term& term, TermId id, Activation* frame);
    Value call_other_than_function(const code::ValueCall& call, const Value& callee, Activation* frame, SourcePlace place);
    Activation* frame_of_value_call(std::uint32_t which, const Value& callee, Activation* frame, SourcePlace place);
    const code::Matched& matched_values(std::uint32_t which, std::uint32_t function, bool is_method);
    Value call_builtin(std::uint32_t builtin, std::span<Value> arguments, SourcePlace place);
    Activation* home_frame(const code::Home& home, Activation* frame);
    struct Frames { Activation* home; Activation* caller; Activation* into; };
    void set_parameters(NameId callee, const std::vector<code::Parameter>& parameters, const code::Matched& matched, const Frames& frames, SourcePlace place);
    void set_plain_parameters(const code::Matched& matched, Activation* caller, Activation* into);
    void trace(StopRun& stop, std::string_view name, SourcePlace place);

    // $-variables.
    void set_dynamic(std::uint32_t which, Value value);
    std::size_t mark() const { return trail_.size(); }
    void undo(std::size_t mark);

    // Instantiations (run_statement.cpp, run_control.cpp).
    void run_binds(const code::Scope& scope, Activation* frame);
    void make_all(const code::Scope& scope, Activation* frame);
    void make(code::InstId id, Activation* frame);
    void make_kind(const code::Inst& inst, Activation* frame);
    void make_builtin(const code::Inst& inst, Activation* frame);
    void warn_of_facets(SourcePlace place);
    void make_user(const code::Inst& inst, Activation* frame);
    void make_loop(const code::Inst& inst, Activation* frame);
    void make_loop_level(const code::Inst& inst, std::size_t level, Activation* frame);
    void make_if(const code::Inst& inst, Activation* frame);
    void make_let(const code::Inst& inst, Activation* frame);
    void make_children(const code::Inst& inst, Activation* frame);
    void make_child(const ModuleCall& call, double index, const code::Inst& inst);
    void make_scope(code::ScopeId scope, Activation* frame);
    void add_node(const code::Inst& inst, scene::What&& what, std::size_t first_child);
    void finish(Scene& scene);
    void read_view(Scene& scene);
    void keep_root(Scene& scene);

    void check_limits();
    // The hint for an unknown name, searched for once.
    using HintSearch = std::string (*)(const code::Program&, const Names&, NameId);
    const std::string& hint(HintSearch search, NameId name);

    // Levels of the C stack that a call may take, for as long as it lives. Fails as endless recursion beyond kMaxDepth.
    class Depth {
    public:
        Depth(Machine& machine, std::uint32_t levels, const char* what, NameId name, const SourcePlace& place) : machine_(machine), levels_(levels) {
            if ((machine.depth_ += levels) > kMaxDepth) machine.fail_too_deep(what, name, place, levels);
        }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        ~Depth() { machine_.depth_ -= levels_; }

    private:
        Machine& machine_;
        std::uint32_t levels_;
    };
    [[noreturn]] void fail_too_deep(const char* what, NameId name, SourcePlace place, std::uint32_t levels);

    // Nested evaluations: about 400,000. Each takes at most 2600 bytes of the stack, even in a build with sanitizers.
    static constexpr std::uint32_t kMaxDepth = kLargeStackBytes / 2600;
    static constexpr std::uint32_t kMaxIterations = 1000000;  // of a C-style for, of a tail call

    static constexpr std::uint32_t kMaxModuleIterations = 10000;  // of a range in a for of modules

    static constexpr double kLeastFacet = 0.01;  // $fa and $fs of OpenSCAD's primitives

    // A node marked with `!`, and the lights made under it.
    struct Root { SceneNodeId node; SourcePlace place; std::size_t first_light, end_light; };

    const code::Program& program_;
    const code::Term* terms_;
    const Value* constants_;
    const Names& names_;
    Heap& heap_;
    const EvaluateInput& input_;
    Diagnostics& diagnostics_;
    RunFiles files_;
    RandomNumbers random_;
    Memo<sind> sine_;
    Memo<cosd> cosine_;
    LookupMemo lookup_memo_;
    std::vector<Value> cells_;                              // $-variables
    std::vector<std::pair<std::uint32_t, Value>> trail_;    // what they were
    std::vector<Value, LargeAllocator<Value>> stack_;       // elements of lists being made
    std::vector<SceneNodeId> pending_;                      // children of nodes being made
    std::vector<Root> roots_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, code::Matched> matches_;  // of a value call with a function or method it met
    struct LastMatch { std::uint32_t function = 0; bool is_method = false; const code::Matched* matched = nullptr; };
    std::vector<LastMatch> last_matches_;                   // by value call
    std::map<std::pair<HintSearch, NameId>, std::string> hints_;
    Activation* tail_ = nullptr;                                 // of the call that a body ended in
    std::vector<NameId> module_names_;
    std::vector<std::string> recent_;                       // last messages
    Placement placement_;
    Scene* scene_ = nullptr;
    bool fonts_known_ = false;
    std::uint32_t depth_ = 0;
    std::uint64_t ticks_ = 0;
    std::chrono::steady_clock::time_point deadline_{};
};

// The frame that many levels outwards.
inline Activation* up(Activation* frame, std::uint32_t levels) {
    for (; levels > 0; --levels) frame = frame->parent;
    return frame;
}

// The value of a term without a copy where it lies in a slot or is constant, else evaluated into `hold`. A slot keeps its value while other parts of the same
// expression are evaluated: every let, for and parameter has a slot of its own, and every call a frame of its own.
const Value& Machine::operand(TermId id, Activation* frame, Value& hold) {
    const code::Term& term = terms_[id];
    if (term.op == code::Op::kSlot) return frame->slots()[term.a];
    if (term.op == code::Op::kConstant) return constants_[term.a];
    if (term.op == code::Op::kOuter) return up(frame, term.a)->slots()[term.b];
    hold = eval(id, frame);
    return hold;
}

Machine::Number Machine::number_of(const Value& value, Value& other) {
    if (value.is_number()) return {value.number(), true};
    other = value;
    return {0, false};
}

Machine::Number Machine::read(TermId id, Activation* frame, Value& other) {
    const code::Term& term = terms_[id];
    if (term.op == code::Op::kSlot && frame->slots()[term.a].is_number()) return {frame->slots()[term.a].number(), true};
    if (term.op == code::Op::kConstant && constants_[term.a].is_number()) return {constants_[term.a].number(), true};
    return number(id, frame, other);
}

// Requires: nothing that is evaluated reads `target`.
void Machine::eval_into(Value& target, TermId id, Activation* frame) {
    if (const Number n = read(id, frame, target); n.is) target = n.value;
}

// Onto the stack of list elements, which soon becomes large pages.
void Machine::push(Value value) {
    constexpr std::size_t kLarge = kLargePage / sizeof(Value), kSmall = kLarge / 32;
    if (stack_.size() == stack_.capacity()) stack_.reserve(stack_.capacity() < kSmall ? kSmall : std::max(kLarge, 2 * stack_.capacity()));
    stack_.push_back(std::move(value));
}

}  // namespace whittle
