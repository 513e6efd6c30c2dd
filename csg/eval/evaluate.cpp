#include "csg/eval/evaluate.h"

#include <filesystem>
#include <new>

#include "csg/eval/large_stack.h"
#include "csg/eval/lower.h"
#include "csg/eval/machine.h"
#include "csg/eval/parameters.h"
#include "csg/eval/read_program.h"
#include "csg/eval/value_text.h"
#include "csg/lang/print_program.h"

namespace whittle {

Result<Parsed> parse(const EvaluateInput& input, Outside& outside) {
    std::string text;
    if (input.text) {
        text = *input.text;
    } else {
        Result<std::string> read = outside.read_text(input.path);
        if (!read) return tl::unexpected<Error>(read.error());
        text = std::move(*read);
    }
    Parsed out;
    auto program = std::make_shared<ProgramText>();
    bool good = false;
    const bool ran = run_on_large_stack([&] {
        good = ProgramReader(input, outside, out, *program).run(std::move(text));
        if (good) set_parameters(*program->files[0], program->names, input.parameters);
    });
    if (!ran) return fail(Fault::kWorld, "no memory for the reader's stack");
    if (good) out.program = std::move(program);
    return out;
}

namespace {

void empty_scene(Scene& scene) {
    scene = Scene{};
    SceneNode root;
    root.what = scene::Group{"root"};
    scene.nodes.push_back(std::move(root));
}

void run_program(const Parsed& parsed, const EvaluateInput& input, Outside& outside, Heap& heap, Evaluated& out) {
    // Names of built-ins join those of the text: a copy keeps the parsed program constant.
    Names names;
    for (NameId i = 1; i < parsed.program->names.size(); ++i) names.intern(parsed.program->names.text(i));
    const code::Program program = lower(parsed.program->files, names, heap);
    Machine machine(program, names, heap, input, out.diagnostics, {outside, out.sources, out.files_read, parsed.program->fonts});
    out.scene = Scene{};
    out.stop = machine.run(out.scene);
    out.scene.fonts = parsed.program->fonts;
}

}  // namespace

Evaluated evaluate(Parsed parsed, const EvaluateInput& input, Outside& outside) {
    Evaluated out;
    out.sources = std::move(parsed.sources);
    out.diagnostics = std::move(parsed.diagnostics);
    out.files_read = std::move(parsed.files_read);
    empty_scene(out.scene);
    if (!parsed.program) {
        out.stop = Stop::kSyntax;
        return out;
    }
    const bool ran = run_on_large_stack([&] {
        Heap heap;
        heap.set_limit(input.limits.memory_bytes);
        try {
            run_program(parsed, input, outside, heap, out);
        } catch (const std::bad_alloc&) {
            out.diagnostics.add(Severity::kError, {}, "Evaluation ran out of memory");
            out.stop = Stop::kMemory;
            empty_scene(out.scene);
        }
    });
    if (!ran) {
        out.diagnostics.add(Severity::kError, {}, "no memory for the evaluator's stack");
        out.stop = Stop::kMemory;
    }
    return out;
}

Result<Evaluated> evaluate(const EvaluateInput& input, Outside& outside) {
    Result<Parsed> parsed = parse(input, outside);
    if (!parsed) return tl::unexpected<Error>(parsed.error());
    return evaluate(std::move(*parsed), input, outside);
}

namespace {

template <class Print>
Result<std::string> printed(const Parsed& parsed, Print print) {
    std::string out;
    const bool ran = run_on_large_stack([&] {
        const ast::Ast& tree = parsed.program->files[0]->ast;
        out = print(tree, parsed.program->names, custom_variables(tree, parsed.sources.files[0].text, 0));
    });
    if (!ran) return fail(Fault::kWorld, "no memory for the printer's stack");
    return out;
}

}  // namespace

Result<std::string> ast_text(const Parsed& parsed) {
    return printed(parsed, [](const ast::Ast& tree, const Names& names, const auto& variables) { return print_program(tree, names, variables, append_number); });
}

Result<std::string> parameters_text(const Parsed& parsed) {
    const std::string title = std::filesystem::path(parsed.sources.files[0].path).stem().string();
    return printed(parsed, [&title](const ast::Ast& tree, const Names& names, const auto& variables) { return print_parameters(tree, names, variables, title); });
}

std::string echo_text(const Diagnostics& diagnostics, const SourceTable& sources) {
    std::string out;
    bool unreadable = false;
    std::size_t length = 0;
    for (const Diagnostic& d : diagnostics.all()) length += d.text.size() + 8;
    out.reserve(length);
    for (const Diagnostic& d : diagnostics.all()) {
        if (d.severity == Severity::kNote) continue;
        unreadable |= d.severity == Severity::kError && d.text.rfind("Parser error", 0) == 0;
        if (d.severity == Severity::kEcho) out.append("ECHO: ").append(d.text);
        else out += format_line(d, sources);
        out.push_back('\n');
    }
    if (unreadable) out += "Can't parse file '" + sources.files[0].path + "'!\n\n";
    return out;
}

}  // namespace whittle
