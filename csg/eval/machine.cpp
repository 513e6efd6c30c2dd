#include "csg/eval/machine.h"

#include <algorithm>

#include "csg/eval/value_text.h"
#include "csg/lang/print_ast.h"

namespace whittle {

using namespace code;

Machine::Machine(const Program& program, const Names& names, Heap& heap, const EvaluateInput& input, Diagnostics& diagnostics, const RunFiles& files)
    : program_(program), terms_(program.terms.data()), constants_(program.constants.data()), names_(names), heap_(heap), input_(input), diagnostics_(diagnostics), files_(files), cells_(program.dynamics.size(), Value::unset()),
      last_matches_(program.value_calls.size()) {
    cells_[kFn] = Value(0.0);
    cells_[kFa] = Value(12.0);
    cells_[kFs] = Value(2.0);
    cells_[kT] = Value(input.time);
    cells_[kPreview] = Value(input.preview);
    // What a command-line run of OpenSCAD lets a program read, whatever the camera.
    const double zero[3] = {0, 0, 0};
    cells_[kVpr] = heap.numbers(zero, 3);
    cells_[kVpt] = heap.numbers(zero, 3);
    cells_[kVpd] = Value(500.0);
    cells_[kVpf] = Value(22.5);
    if (input.limits.seconds > 0)
        deadline_ = std::chrono::steady_clock::now() +
                    std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(input.limits.seconds));
}

Stop Machine::run(Scene& scene) {
    scene_ = &scene;
    Stop stop = Stop::kNone;
    Activation* frame = heap_.frame(program_.files[0].layout.slots, nullptr);
    try {
        const code::Scope& body = program_.scopes[program_.files[0].body];
        run_binds(body, frame);
        make_all(body, frame);
    } catch (const StopRun& ended) {
        stop = ended.reason;
    }
    if (stop != Stop::kNone) {  // nothing is made of half a program
        scene = Scene{};
        pending_.clear();
        roots_.clear();
    }
    finish(scene);
    return stop;  // the frame goes with the heap
}

// Messages that equal the last five are not repeated.
void Machine::say(Severity severity, SourcePlace place, std::string text, std::string hint) {
    if (severity == Severity::kWarning || severity == Severity::kError || severity == Severity::kTrace) {
        std::string key = std::to_string(place.file) + ":" + std::to_string(place.line) + ":" + text;
        if (recent_.size() == 5 && std::all_of(recent_.begin(), recent_.end(), [&](const std::string& r) { return r == key; })) return;
        if (recent_.size() == 5) recent_.erase(recent_.begin());
        recent_.push_back(std::move(key));
    }
    if (severity == Severity::kDeprecated)
        for (const Diagnostic& d : diagnostics_.all())
            if (d.severity == severity && d.text == text && d.place.line == place.line && d.place.file == place.file) return;
    diagnostics_.add(severity, place, std::move(text), std::move(hint));
    if (severity == Severity::kWarning && input_.hard_warnings) throw StopRun{Stop::kScene, 0};
}

void Machine::fail(SourcePlace place, std::string text, std::string hint) {
    say(Severity::kError, place, std::move(text), std::move(hint));
    throw StopRun{Stop::kScene};
}

void Machine::fail_too_deep(const char* what, NameId name, SourcePlace place, std::uint32_t levels) {
    depth_ -= levels;
    fail(place, std::string("Recursion detected calling ") + what + " '" + names_.text(name) + "'", "does every way through it come to an end?");
}

void Machine::trace(StopRun& stop, std::string_view name, SourcePlace place) {
    if (stop.traces_left <= 0) return;
    --stop.traces_left;
    say(Severity::kTrace, place, "called by '" + std::string(name) + "'");
}

void Machine::check_limits() {
    if (input_.cancel && input_.cancel->load(std::memory_order_relaxed)) throw StopRun{Stop::kCancelled, 0};
    if (input_.limits.seconds > 0 && std::chrono::steady_clock::now() > deadline_) {
        diagnostics_.add(Severity::kError, {}, "Evaluation took longer than the time limit");
        throw StopRun{Stop::kTime, 0};
    }
    const std::uint64_t held = heap_.bytes() + stack_.capacity() * sizeof(Value) + (scene_ ? scene_->nodes.size() * sizeof(SceneNode) : 0);
    if (input_.limits.memory_bytes > 0 && held > input_.limits.memory_bytes) {
        diagnostics_.add(Severity::kError, {}, "Evaluation needs more than the memory limit");
        throw StopRun{Stop::kMemory, 0};
    }
}

const std::string& Machine::hint(HintSearch search, NameId name) {
    const auto [found, added] = hints_.try_emplace({search, name});
    if (added) found->second = search(program_, names_, name);
    return found->second;
}

std::string Machine::text_of(const Value& value) const {
    std::string out;
    append_text(out, value);
    return out;
}

void Machine::append_text(std::string& out, const Value& value) const {
    append_value(out, value, [this](std::string& text, std::uint32_t index) {
        const code::Function& f = program_.functions[index];
        print_expression(text, *f.ast, f.literal, names_, append_number);
    });
}

std::string Machine::bare_text_of(const Value& value) const { return value.is_string() ? std::string(value.string()) : text_of(value); }

void Machine::set_dynamic(std::uint32_t which, Value value) {
    trail_.emplace_back(which, std::move(cells_[which]));
    cells_[which] = std::move(value);
}

void Machine::undo(std::size_t mark) {
    while (trail_.size() > mark) {
        cells_[trail_.back().first] = std::move(trail_.back().second);
        trail_.pop_back();
    }
}

Facets Machine::facets() const {
    const auto number = [this](std::uint32_t which, double otherwise) { return cells_[which].is_number() ? cells_[which].number() : otherwise; };
    return {number(kFn, 0), number(kFa, 0), number(kFs, 0), number(kFe, 0)};
}

}  // namespace whittle
