// session.cpp — from the request to a scene, a solid, a program: each step timed and counted, each message told once.
#include "modeler/cli/session.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fmt/core.h>
#include <unistd.h>

#include "csg/base/file.h"
#include "csg/base/passes.h"
#include "modeler/cli/clip.h"
#include "modeler/cli/dependencies.h"
#include "modeler/io/files.h"
#include "modeler/io/fonts.h"
#include "modeler/io/parameter_set.h"

namespace whittle {

namespace {

Exit exit_of(Fault fault) {
    switch (fault) {
        case Fault::kScene: return Exit::kScene;
        case Fault::kCommand: return Exit::kCommand;
        case Fault::kWorld: return Exit::kWorld;
        case Fault::kInterrupted: return Exit::kInterrupted;
    }
    return Exit::kWorld;
}

// An error that was told already: the verbs only need its code.
tl::unexpected<Error> told(Fault fault) { return fail(fault, {}); }

Result<EvaluateInput> input_of(Session& session, Preview preview) {
    const CommonRequest& common = session.request.common;
    EvaluateInput input;
    input.path = session.request.inputs.front();
    if (input.path == "-") {
        auto text = read_whole_file("-");
        if (!text) return tl::unexpected<Error>(text.error());
        input.text = std::move(*text);
    }
    input.definitions = common.definitions;
    if (!common.parameter_file.empty()) {
        auto values = read_parameter_set(common.parameter_file, common.parameter_set);
        if (!values) return tl::unexpected<Error>(values.error());
        if (values->empty()) session.console.warning(fmt::format("'{}' holds no set '{}'", common.parameter_file, common.parameter_set));
        input.parameters = std::move(*values);
    }
    input.library_paths = library_paths();
    input.preview = preview.variable;
    input.time = common.time;
    input.check_parameters = common.check_parameters;
    input.hard_warnings = common.hard_warnings;
    input.cancel = &session.watchdog.interrupted();
    return input;
}

Result<void> check_stop(Session& session, const Evaluated& evaluated) {
    switch (evaluated.stop) {
        case Stop::kNone: return {};
        case Stop::kSyntax: session.console.line(fmt::format("Can't parse file '{}'!", session.request.inputs.front())); return told(Fault::kScene);
        case Stop::kScene: return told(Fault::kScene);
        case Stop::kTime:
        case Stop::kMemory: return told(Fault::kWorld);
        case Stop::kCancelled: return told(Fault::kInterrupted);
    }
    return told(Fault::kScene);
}

// Text → scene, timed by its two steps.
Result<Evaluated> evaluate_timed(Session& session, const EvaluateInput& input, Files& files) {
    Stopwatch watch;
    auto parsed = parse(input, files);
    session.stats.add("seconds.parse", watch.lap());
    if (!parsed) return fail(parsed.error().fault, fmt::format("Can't open input file '{}': {}", input.path, parsed.error().message));
    Evaluated evaluated = evaluate(std::move(*parsed), input, files);
    session.stats.add("seconds.evaluate", watch.lap());
    return evaluated;
}

}  // namespace

Exit worse(Exit a, Exit b) { return static_cast<int>(a) >= static_cast<int>(b) ? a : b; }

Exit give_up(Session& session, const Error& error) {
    if (!error.message.empty()) session.console.error(error.message);
    return exit_of(error.fault);
}

Result<Evaluated> read_text_of_scene(Session& session, Preview preview) {
    auto input = input_of(session, preview);
    if (!input) return tl::unexpected<Error>(input.error());
    Files files;
    auto evaluated = evaluate_timed(session, *input, files);
    if (!evaluated) return evaluated;
    session.console.tell(evaluated->diagnostics, evaluated->sources);
    if (auto written = write_dependencies(session.request, evaluated->files_read); !written) return tl::unexpected<Error>(written.error());
    return evaluated;
}

Result<Parsed> read_syntax_of_scene(Session& session) {
    auto input = input_of(session, {});
    if (!input) return tl::unexpected<Error>(input.error());
    Files files;
    auto parsed = parse(*input, files);
    if (!parsed) return fail(parsed.error().fault, fmt::format("Can't open input file '{}': {}", input->path, parsed.error().message));
    session.console.tell(parsed->diagnostics, parsed->sources);
    if (auto written = write_dependencies(session.request, parsed->files_read); !written) return tl::unexpected<Error>(written.error());
    if (parsed->program) return parsed;
    session.console.line(fmt::format("Can't parse file '{}'!", input->path));
    return told(Fault::kScene);
}

Result<ReadScene> read_scene(Session& session, Preview preview) {
    auto evaluated = read_text_of_scene(session, preview);
    if (!evaluated) return tl::unexpected<Error>(evaluated.error());
    if (auto ran = check_stop(session, *evaluated); !ran) return tl::unexpected<Error>(ran.error());
    ReadScene scene{std::move(*evaluated), {}, Exit::kDone};
    clip_scene(scene.evaluated.scene, session.request.render.clips);

    Stopwatch watch;
    Files files(session.request.mesh.options);
    CanonicaliseOptions reading = session.request.common.reading;
    reading.preview = preview.modifiers;
    const auto& disabled = session.request.common.disabled_passes;
    reading.passes = {!is_disabled(disabled, "equal"), !is_disabled(disabled, "disjoint"), !is_disabled(disabled, "buried")};
    auto& diagnostics = scene.evaluated.diagnostics;
    const std::size_t told_before = diagnostics.all().size();
    scene.canonical = canonicalise(scene.evaluated.scene, reading, &files, diagnostics);
    session.stats.add("seconds.compile", watch.lap());
    session.stats.set("skip.equal", static_cast<double>(scene.canonical.skipped.equal));
    session.stats.set("skip.disjoint", static_cast<double>(scene.canonical.skipped.disjoint));
    session.stats.set("skip.buried", static_cast<double>(scene.canonical.skipped.buried));
    session.stats.add("mesh.fallback", static_cast<double>(scene.canonical.mesh_fallbacks));
    session.stats.set("loaded.font", fonts_are_loaded() ? 1 : 0);
    session.console.tell(diagnostics, scene.evaluated.sources, told_before);
    const bool errors = diagnostics.count(Severity::kError) > 0;
    if (errors || (scene.canonical.something_left_out && !session.request.common.allow_missing)) scene.verdict = Exit::kScene;
    if (session.request.common.hard_warnings && diagnostics.count(Severity::kWarning) > 0) return told(Fault::kScene);
    return scene;
}

Result<void> check_something(const Canonical& canonical) {
    if (canonical.solid.root().node == kEmptyNode) return fail(Fault::kScene, "Current top level object is empty.");
    return {};
}

Result<void> check_folders(const std::vector<std::string>& outputs) {
    for (const std::string& path : outputs) {
        const auto slash = path.rfind('/');
        if (slash == std::string::npos) continue;
        const std::string folder = path.substr(0, slash + 1);
        if (::access(folder.c_str(), X_OK) != 0) return fail(Fault::kWorld, fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    }
    return {};
}

Result<void> check_not_flat(const Canonical& canonical) {
    if (!canonical.is_2d) return {};
    return fail(Fault::kScene, "Current top level object is not a 3D object.\nlinear_extrude(height) makes a solid of it; flat shapes are written to .svg, .dxf and .pdf");
}

Result<void> check_solid(const Canonical& canonical) {
    if (auto deep = check_not_flat(canonical); !deep) return deep;
    return check_something(canonical);
}

Result<ReadScene> read_whole_solid(Session& session) {
    auto scene = read_scene(session);
    if (!scene) return scene;
    if (auto solid = check_solid(scene->canonical); !solid) return tl::unexpected<Error>(solid.error());
    if (scene->evaluated.diagnostics.count(Severity::kError) > 0) return fail(Fault::kScene, "The scene has errors, nothing is written");
    if (scene->verdict != Exit::kDone) return fail(Fault::kScene, "Geometry was left out, nothing is written (--allow-missing carries on without it)");
    return scene;
}

Result<std::shared_ptr<const Program>> compile_scene(Session& session, const Solid& solid) {
    Stopwatch watch;
    EngineOptions options;
    options.snap = session.request.common.snap;
    options.disabled_passes = session.request.common.disabled_passes;
    auto program = compile(solid, options);
    session.stats.add("seconds.compile", watch.lap());
    if (!program) return program;
    const BuildReport& report = build_report(**program);
    for (const auto& warning : report.warnings) session.console.warning(warning);
    session.stats.set(report);
    session.stats.set("solids.distinct", static_cast<double>(solid.node_count()));
    return program;
}

Result<void> summarise(Session& session, const ReadScene& scene) {
    if (!session.summary.wanted()) return {};
    const RenderRequest& render = session.request.render;
    const Scene& read = scene.evaluated.scene;
    const Solid& solid = scene.canonical.solid;
    const double aspect = static_cast<double>(render.options.width) / render.options.height;
    const auto lens = resolve_camera(render.camera, read.camera, read.view, solid.root_bounds(), aspect);
    if (!lens) return tl::unexpected<Error>(lens.error());
    session.summary.note(solid, scene.canonical.is_2d, *lens);
    return {};
}

std::string default_output(const std::string& input, const std::string& suffix) {
    if (input == "-") return "out" + suffix;
    return std::filesystem::path(input).stem().string() + suffix;
}

Result<void> write_output(const std::string& path, std::string_view bytes) {
    if (path != "-") return write_file_atomically(path, bytes);
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0) return {};
    return fail(Fault::kWorld, fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

}  // namespace whittle
