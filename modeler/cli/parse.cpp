// parse.cpp — the options of every verb, declared once; from this come parsing, --help and the names that completions are tested against.
//
// CLI11 splits the words; what a word means (numbers, sizes, names of planes) is read by words.h, so that every message can say what the option wants.
#include "modeler/cli/parse.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "csg/base/passes.h"
#include "modeler/cli/nearest.h"
#include "modeler/cli/numbers.h"
#include "modeler/cli/verb_info.h"
#include "modeler/cli/words.h"

#ifndef WHITTLE_VERSION
#error "the build names the version"
#endif

namespace whittle {

namespace {

// One command line in the making: the options being declared, and what they set.
class Declaration {
public:
    Declaration(const VerbInfo* verb, Request& request) : verb_(verb), request_(request) {
        app_.name("whittle");
        app_.allow_extras(true);
        app_.set_help_flag("-h,--help", "Print this and exit");
        app_.add_flag("-v,--version", version_, "Print the version and exit");
        if (!verb_ || (verb_->verb != Verb::kBench && verb_->verb != Verb::kMerge)) declare_scene();
        declare_common();
        if (!verb_) declare_openscad();
        if (!verb_ || verb_->verb == Verb::kRender) declare_render();
        if (!verb_ || verb_->verb == Verb::kMesh || verb_->verb == Verb::kCheck) declare_mesh();
        if (verb_ && verb_->verb == Verb::kCheck) declare_check();
        if (verb_ && verb_->verb == Verb::kSpans) declare_spans();
        const bool writes = !verb_ || verb_->verb == Verb::kRender || verb_->verb == Verb::kMesh || verb_->verb == Verb::kMerge;
        if (writes) list(verb_ ? "-o" : "-o,-s,-x", "FILE", "Output; its suffix chooses the format. May be given more than once", request_.outputs, "Files");
        app_.add_option("FILE", request_.inputs, "The scene; - is standard input")->type_name("")->group("Files");
    }

    CLI::App& app() { return app_; }
    bool wants_version() const { return version_; }
    bool wants_info() const { return info_; }

private:
    using Reader = std::function<bool(const std::string&)>;

    // An option with one value, which may be given again; `read` returns false where the value is not what `wants` says.
    void value(const char* name, const char* wants, const char* help, const char* group, const Reader& read) {
        const std::string shown = name, expected = wants;
        const auto read_all = [=](const std::vector<std::string>& texts) {
            for (const auto& text : texts)
                if (!read(text)) throw CLI::ValidationError(shown, fmt::format("{} wants {}, not '{}'", shown, expected, text));
        };
        app_.add_option_function<std::vector<std::string>>(name, read_all, help)->type_name(wants)->group(group)->allow_extra_args(false);
    }
    void text(const char* name, const char* wants, const char* help, std::string& target, const char* group) {
        value(name, wants, help, group, [&target](const std::string& t) { return target = t, !t.empty(); });
    }
    void list(const char* name, const char* wants, const char* help, std::vector<std::string>& target, const char* group) {
        app_.add_option(name, target, help)->type_name(wants)->group(group)->allow_extra_args(false);
    }
    void flag(const char* name, const char* help, bool& target, const char* group, bool value = true) {
        app_.add_flag_callback(name, [&target, value] { target = value; }, help)->group(group);
    }
    // A number in [least, most].
    template <class Number>
    void number(const char* name, const char* wants, const char* help, Number& target, double least, double most, const char* group) {
        value(name, wants, help, group, [&target, least, most](const std::string& t) {
            const auto n = number_in(t);
            if (!n || *n < least || *n > most) return false;
            if (std::is_integral_v<Number> && *n != std::floor(*n)) return false;
            target = static_cast<Number>(*n);
            return true;
        });
    }
    // Names of passes, all of which must be known.
    void passes(const char* name, const char* group, std::vector<std::string>& target) {
        std::vector<std::string> known;
        for (const PassInfo& pass : known_passes()) known.emplace_back(pass.name);
        const std::string help = fmt::format("Switches passes off that only save work: {}", fmt::join(known, " "));
        const auto read = [=, &target](const std::vector<std::string>& texts) {
            for (const auto& text : texts)
                for (const auto& word : words_in(text)) {
                    const auto near = nearest(word, known);
                    if (!is_disabled(known, word))
                        throw CLI::ValidationError(name, fmt::format("{} knows no pass '{}'{}", name, word, near ? fmt::format("; did you mean {}?", *near) : ""));
                    target.push_back(word);
                }
        };
        app_.add_option_function<std::vector<std::string>>(name, read, help)->type_name("PASS,PASS")->group(group)->allow_extra_args(false);
    }
    // An option of OpenSCAD's that chooses what Whittle does not have two of: taken, so that a Makefile works with the name changed.
    void passed_over(const char* name, bool takes_value, const char* why, const char* group) {
        const std::string help = fmt::format("Taken and passed over: {}", why);
        if (takes_value) app_.add_option_function<std::string>(name, [](const std::string&) {}, help)->type_name("X")->group(group);
        else app_.add_flag_callback(name, [] {}, help)->group(group);
    }

    void declare_scene();
    void declare_common();
    void declare_openscad();
    void declare_render();
    void declare_picture();
    void declare_mesh();
    void declare_check();
    void declare_spans();

    const VerbInfo* verb_;
    Request& request_;
    CLI::App app_;
    bool version_ = false, info_ = false;
};

constexpr double kMostThreads = 4096, kMostCount = 9007199254740992.0;  // 2^53: every whole number up to it is a double

void Declaration::declare_scene() {
    constexpr const char* kGroup = "Scene";
    auto& common = request_.common;
    list("-D", "NAME=VALUE", "Sets a variable after the scene's own text", common.definitions, kGroup);
    text("-p", "FILE.json", "File of parameter sets (OpenSCAD's customizer)", common.parameter_file, kGroup);
    text("-P", "SET", "The set to take from that file", common.parameter_set, kGroup);
    value("--curves", "auto, exact, exact:N or faceted", "True curves or facets (auto: $fn=0 is a true curve, else facets)", kGroup,
          [&common](const std::string& t) { return read_curves(t, common.reading); });
    app_.add_flag_callback("--no-snap", [&common] { common.snap = false; }, "Do not make one of surfaces that agree to the last bits")->group(kGroup);
    flag("--hardwarnings", "The first warning stops the run", common.hard_warnings, kGroup);
    flag("--allow-missing", "Carry on without what is not supported yet", common.allow_missing, kGroup);
    text("-d", "FILE", "Writes the files the scene read, as a make rule", common.dependency_file, kGroup);
}

void Declaration::declare_common() {
    constexpr const char* kGroup = "Run";
    auto& common = request_.common;
    number("--threads", "N", "Threads; 0 is all cores", common.threads, 0, kMostThreads, kGroup);
    number("--seed", "N", "Seed of everything random", common.seed, 0, kMostCount, kGroup);
    value("--progress", "auto, never or json", "A bar on a terminal, a line every ten seconds when piped (auto)", kGroup, [&common](const std::string& t) {
        common.progress = t == "json" ? ProgressStyle::kJson : t == "never" ? ProgressStyle::kNever : ProgressStyle::kAuto;
        return t == "auto" || t == "never" || t == "json";
    });
    value("--diagnostics", "text or json", "json: one object a line on standard error", kGroup, [&common](const std::string& t) {
        common.diagnostics = t == "json" ? DiagnosticStyle::kJson : DiagnosticStyle::kText;
        return t == "text" || t == "json";
    });
    flag("--json", "The answer as JSON on standard output", common.json, kGroup);
    flag("-q,--quiet", "Print errors only", common.quiet, kGroup);
    text("--stats", "FILE", "Writes counters of work done; - is standard output", common.stats_file, kGroup);
    number("--limit-time", "S", "Give up after so many seconds (exit code 3)", common.limit_seconds, 0, 1e9, kGroup);
    value("--limit-memory", "MB or none", "Give up at so many megabytes (exit code 3); without it, at nine tenths of what the machine and its memory groups could give", kGroup,
          [&common](const std::string& t) {
              const auto megabytes = t == "none" ? std::optional<double>(0) : number_in(t);
              if (!megabytes || *megabytes < 0 || *megabytes > 1e9) return false;
              common.limit_memory = *megabytes > 0 ? MemoryLimit::kBytes : MemoryLimit::kNone;
              common.limit_bytes = static_cast<std::uint64_t>(*megabytes * 1048576.0);
              return true;
          });
    passes("--disable", kGroup, common.disabled_passes);
}

void Declaration::declare_openscad() {
    constexpr const char* kGroup = "OpenSCAD's";
    auto& common = request_.common;
    text("--export-format", "F", "Format of the output, instead of its suffix", request_.export_format, kGroup);
    value("--check-parameters", "true or false", "Warn of unknown and surplus arguments", kGroup, [&common](const std::string& t) {
        common.check_parameters = t != "false" && t != "0";
        return t == "true" || t == "false" || t == "1" || t == "0";
    });
    flag("--render", "A picture sees $preview = false", request_.full_render, kGroup);
    flag("--preview", "A picture sees $preview = true (the default)", request_.full_render, kGroup, false);
    number("--animate", "N", "Makes N outputs, name00000.png and on, with $t = 0, 1/N, 2/N ...", request_.frames, 1, 99999, kGroup);
    passed_over("--csglimit", true, "no scene is too large to show", kGroup);
    passed_over("--check-parameter-ranges", true, "what makes nothing is always told", kGroup);
    passed_over("--backend", true, "there is one", kGroup);
    passed_over("--enable", true, "all features are on", kGroup);
    passed_over("--debug", true, "the messages are those of -q or all", kGroup);
    passed_over("-m", true, "nothing that a scene or a command line names is ever executed", kGroup);
    passed_over("-O", true, "formats have no options of their own", kGroup);
    value("--view", "axes, crosshairs, edges, scales or wireframe", "edges draws dark lines along edges; the others are passed over", kGroup,
          [this](const std::string& t) { return read_view(t, request_.render.options.edges); });
    app_.add_flag("--info", info_, "Print how this program was built and exit")->group(kGroup);
    value("--summary", "all, cache, time, camera, geometry, bounding-box or area", "Tell what was made, at the end. May be given more than once", kGroup,
          [this](const std::string& t) {
              request_.summary.topics.push_back(t);
              return std::find(summary_topics().begin(), summary_topics().end(), t) != summary_topics().end();
          });
    text("--summary-file", "FILE", "The same as JSON, all of it where no --summary says less; - is standard output", request_.summary.file, kGroup);
}

void Declaration::declare_render() {
    constexpr const char* kGroup = "Picture";
    auto& render = request_.render;
    value("--imgsize", "W,H", "Size in pixels (512,512)", kGroup,
          [&render](const std::string& t) { return read_size(t, render.options.width, render.options.height); });
    value("--camera", "ex,ey,ez,cx,cy,cz or tx,ty,tz,rx,ry,rz,dist", "Eye and centre, or target, turn and distance", kGroup,
          [&render](const std::string& t) { return read_camera(t, render.camera.numbers); });
    flag("--viewall", "Move the eye until everything is in view", render.camera.viewall, kGroup);
    flag("--autocenter", "Look at the middle of the model", render.camera.autocenter, kGroup);
    value("--projection", "p or o", "Perspective or orthographic", kGroup, [&render](const std::string& t) {
        render.camera.orthographic = t == "o" || t == "ortho" || t == "orthographic";
        return *render.camera.orthographic || t == "p" || t == "perspective";
    });
    number("--samples", "N", "Samples a pixel (16)", render.options.samples, 1, 1e9, kGroup);
    number("--light-samples", "N", "Shadow rays a light and place (1)", render.options.light_samples, 1, 1e6, kGroup);
    number("--noise", "X", "Stop where the estimated error is below X (1/1024 where light is not drawn at random, else 0: never)", render.options.noise, 0, 1e9, kGroup);
    number("--stop-after", "S", "Stop after S seconds and keep the picture so far", render.options.stop_after_s, 0, 1e9, kGroup);
    number("--max-depth", "N", "Mirrors and refractions one after the other (16)", render.options.max_depth, 0, 1e6, kGroup);
    number("--photons", "N", "Rays from the lamps, for caustics in pictures by whitted or distributed; caustics sends its own (0)", render.options.photons, 0, 1e8, kGroup);
    value("--integrator", "auto, preview, whitted, distributed, path, caustics or cone", "How light is followed", kGroup, [&render](const std::string& t) {
        const auto kind = integrator_named(t);
        render.options.integrator = kind.value_or(Integrator::kAuto);
        return kind.has_value();
    });
    value("--sampler", "sobol, stratified or independent", "Where samples lie; the last two are there to be compared with (sobol)", kGroup, [&render](const std::string& t) {
        const auto kind = sampler_named(t);
        render.options.sampler = kind.value_or(SamplerKind::kSobol);
        return kind.has_value();
    });
    value("--filter", "box, gaussian or mitchell", "Weighs the samples around a pixel (gaussian)", kGroup, [&render](const std::string& t) {
        const auto kind = filter_named(t);
        render.options.filter = kind.value_or(FilterKind::kGaussian);
        return kind.has_value();
    });
    value("--colorscheme", "the name of one of OpenSCAD's schemes", "Background and unnamed faces of --integrator preview: Cornfield, Metallic, Sunset, ...", kGroup,
          [&render](const std::string& t) { return (render.options.scheme = color_scheme_named(t)).has_value(); });
    declare_picture();
}

void Declaration::declare_picture() {
    constexpr const char* kGroup = "Picture";
    auto& render = request_.render;
    value("--aov", "NAME,NAME", "Further planes of an EXR: depth, position, normal, solid, surface, albedo, spans, thickness, certified, cost, variance", kGroup,
          [&render](const std::string& t) { return read_planes(t, render.options.aovs); });
    flag("--edges", "Dark lines along edges", render.options.edges, kGroup);
    value("--clip", "nx,ny,nz,d", "Keep n.p <= d; cuts are solid. May be given more than once", kGroup,
          [&render](const std::string& t) { return read_clip(t, render.clips); });
    app_.add_flag_callback("--xray", [&render] { render.options.look = Look::kXray; }, "Brightness by thickness")->group(kGroup);
    number("--exposure", "STOPS", "Brightness in stops (0)", render.picture.tone.exposure, -1000, 1000, kGroup);
    value("--tonemap", "srgb, filmic or linear", "Curve from radiance to eight bits (srgb)", kGroup, [&render](const std::string& t) {
        const auto map = tonemap_named(t);
        render.picture.tone.map = map.value_or(Tonemap::kSrgb);
        return map.has_value();
    });
    value("--exr", "half or float", "Type of an EXR's colours (half)", kGroup, [&render](const std::string& t) {
        render.picture.color_type = t == "float" ? ChannelType::kFloat : ChannelType::kHalf;
        return t == "half" || t == "float";
    });
    flag("--watch", "Render again whenever a file of the scene changes", render.watch, kGroup);
    value("--tile", "x,y,w,h", "Draw this part of the picture only", kGroup, [&render](const std::string& t) { return read_tile(t, render.options.region); });
    value("--shard", "k/n", "Draw the k-th of n parts (1/n to n/n); merge puts them together", kGroup,
          [&render](const std::string& t) { return read_shard(t, render.options.shard); });
    flag("--resume", "Go on from PICTURE.part, which a rendering that was stopped leaves", render.resume, kGroup);
}

void Declaration::declare_mesh() {
    constexpr const char* kGroup = "Mesh";
    auto& mesh = request_.mesh;
    value("--tolerance", "MM", "Largest distance of a curved face from its facets", kGroup, [&mesh](const std::string& t) {
        const auto n = number_in(t);
        mesh.options.tolerance_mm = n;
        return n && *n > 0;
    });
    value("--angle", "DEG", "Largest turn from one facet of a curve to the next", kGroup, [&mesh](const std::string& t) {
        const auto n = number_in(t);
        mesh.options.angle_deg = n;
        return n && *n > 0 && *n <= 120;
    });
    value("--booleans", "exact or cgal", "Who combines meshes: our arrangement, or CGAL's corefinement as a second opinion", kGroup, [&mesh](const std::string& t) {
        mesh.booleans = t == "cgal" ? BooleanMaker::kCgal : BooleanMaker::kArrangement;
        return t == "cgal" || t == "exact";
    });
    if (verb_ && verb_->verb == Verb::kCheck) return;
    value("--simplify", "MM", "Fewer triangles, no point of the surface moved by more than this", kGroup, [&mesh](const std::string& t) {
        mesh.simplify_mm = number_in(t);
        return mesh.simplify_mm && *mesh.simplify_mm > 0;
    });
    value("--remesh", "MM", "Even triangles with sides of about this length; sharp edges stay", kGroup, [&mesh](const std::string& t) {
        mesh.remesh_mm = number_in(t);
        return mesh.remesh_mm && *mesh.remesh_mm > 0;
    });
    app_.add_flag_callback("--binary", [&mesh] { mesh.encoding = MeshEncoding::kBinary; }, "Binary STL (the default of `mesh`)")->group(kGroup);
    app_.add_flag_callback("--ascii", [&mesh] { mesh.encoding = MeshEncoding::kAscii; }, "STL in letters (the default of -o in OpenSCAD's form)")->group(kGroup);
    flag("--report", "Print what validation found", mesh.report, kGroup);
}

void Declaration::declare_check() {
    number("--lines", "N", "Lines to shoot (as many as take about a second)", request_.check.lines, 1, kMostCount, "Check");
    text("--heat", "FILE", "Writes the mesh coloured by how far it strays: blue none of what is allowed, red all (ply, off, 3mf, glb ...)", request_.check.heat_file, "Check");
    flag("--suite", "Check all the scenes named, and those in folders named: a row each", request_.check.suite, "Check");
}

void Declaration::declare_spans() {
    constexpr const char* kGroup = "Rays";
    auto& spans = request_.spans;
    value("--ray", "ox,oy,oz,dx,dy,dz", "Origin and direction (t is in units of it; no part of it under 1e-90 but 0, none over 1e90)", kGroup,
          [&spans](const std::string& t) { return read_ray(t, spans.rays); });
    text("--rays", "FILE", "One ray a line: ox oy oz dx dy dz; - is standard input", spans.rays_file, kGroup);
}

// CLI11 marks an option that may be given again with " ..."; here nearly all may.
void drop_dots(std::string& text) {
    for (auto at = text.find(" ..."); at != std::string::npos; at = text.find(" ...", at))
        if (text[at + 4] == '\n') text.erase(at, 4);
        else text.replace(at, 4, "    ");
}

std::string help_text(const VerbInfo* verb, CLI::App& app) {
    std::string text = verb ? fmt::format("whittle {} {}\n\n{}\n\n", verb->name, verb->usage, verb->summary) : overview();
    std::string options = app.help();
    drop_dots(options);
    const auto usage_end = options.find('\n');
    text += usage_end == std::string::npos ? options : options.substr(usage_end + 1);
    return text + "\nExit codes: 0 done, 1 the scene is wrong, 2 the command line is wrong, 3 the world is wrong (files, memory, time), "
                  "4 check found disagreement, 130 interrupted.\n";
}

std::vector<std::string> names_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
        for (const auto& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

// `--render=cgal` and `--preview=throwntogether` choose an engine that Whittle does not have: the value says nothing here.
void drop_engine_names(std::vector<std::string>& arguments) {
    for (auto& argument : arguments)
        for (const std::string name : {"--render", "--preview"})
            if (argument.rfind(name + "=", 0) == 0) argument = name;
}

tl::unexpected<Error> unexpected_word(const std::vector<std::string>& words, const CLI::App& app) {
    for (const auto& word : words)
        if (word.size() > 1 && word[0] == '-') {
            const std::string name = word.substr(0, word.find('='));
            const auto near = nearest(name, names_of(app));
            return fail(Fault::kCommand, fmt::format("unknown option {}{}", name, near ? fmt::format("; did you mean {}?", *near) : ""));
        }
    return fail(Fault::kCommand, fmt::format("'{}' is one word too many", words.front()));
}

}  // namespace

Result<std::variant<Request, Say>> parse_command_line(std::vector<std::string> arguments) {
    if (arguments.empty()) return fail(Fault::kCommand, "no scene is named; try: whittle --help");
    if (arguments[0] == "view") return fail(Fault::kCommand, "view is not supported yet; whittle render --watch draws again on every change");
    const VerbInfo* verb = verb_named(arguments[0]);
    if (verb) arguments.erase(arguments.begin());
    Request request;
    request.verb = verb ? verb->verb : Verb::kConvert;
    if (request.verb == Verb::kBench) return request.rest = std::move(arguments), std::variant<Request, Say>(std::move(request));
    Declaration declaration(verb, request);
    if (!verb) drop_engine_names(arguments);
    std::reverse(arguments.begin(), arguments.end());
    try {
        declaration.app().parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        return Say{help_text(verb, declaration.app())};
    } catch (const CLI::ValidationError& fault) {
        const std::string message = fault.what();
        const auto colon = message.find(": ");  // CLI11 puts the option's name in front; the message has it already
        return fail(Fault::kCommand, colon == std::string::npos ? message : message.substr(colon + 2));
    } catch (const CLI::ParseError& fault) {
        return fail(Fault::kCommand, fault.what());
    }
    if (declaration.wants_info()) return Say{info_text()};
    if (declaration.wants_version()) return Say{"whittle " WHITTLE_VERSION "\n"};
    const auto rest = declaration.app().remaining();
    if (!rest.empty()) return unexpected_word(rest, declaration.app());
    // Who asks for OpenSCAD's colours and nothing else wants the look of its preview.
    RenderOptions& options = request.render.options;
    if (options.scheme && options.integrator == Integrator::kAuto) options.integrator = Integrator::kPreview;
    if (auto valid = validate(verb, request); !valid) return tl::unexpected<Error>(valid.error());
    if (!verb && request.outputs.empty()) request.verb = Verb::kRender;
    spread_common(request);
    return request;
}

std::vector<std::string> option_names(const std::string& verb) {
    Request request;
    Declaration declaration(verb_named(verb), request);
    return names_of(declaration.app());
}

}  // namespace whittle
