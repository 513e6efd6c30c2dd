// parse.cpp — from words to a Request: the options as declaration.h has them, what goes together, and help.
#include "modeler/cli/parse.h"

#include <algorithm>

#include <fmt/format.h>

#include "modeler/cli/declaration.h"
#include "modeler/cli/nearest.h"

#ifndef WHITTLE_VERSION
#error "the build names the version"
#endif

namespace whittle {

namespace {

std::string overview() {
    std::string text = "whittle: carve solids in text, see them exactly.\n\n    whittle FILE.scad\n";
    for (const auto& verb : kVerbs) text += fmt::format("    whittle {:<8}{}\n", verb.name, verb.usage);
    text += "    whittle -o OUT [openscad options] FILE.scad\n\n";
    for (const auto& verb : kVerbs) text += fmt::format("  {:<8}{}\n", verb.name, verb.summary);
    return text + "\n`whittle VERB --help` lists a verb's options; below, those of the form without a verb.\n\n";
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

Result<void> validate(const VerbInfo* verb, Request& request) {
    const bool many_files = verb && verb->verb == Verb::kMerge;
    if (verb && verb->verb == Verb::kBench) return {};
    if (request.inputs.empty()) return fail(Fault::kCommand, many_files ? "merge wants the pictures to put together" : "no scene is named");
    const bool suite = verb && verb->verb == Verb::kCheck && request.check.suite;
    if (!many_files && !suite && request.inputs.size() > 1) return fail(Fault::kCommand, fmt::format("one scene at a time: '{}' is a second", request.inputs[1]));
    if (many_files && request.outputs.size() != 1) return fail(Fault::kCommand, "merge wants one -o FILE");
    if (request.common.parameter_set.empty() != request.common.parameter_file.empty()) return fail(Fault::kCommand, "-p and -P go together");
    if (request.verb == Verb::kSpans && request.spans.rays.empty() && request.spans.rays_file.empty())
        return fail(Fault::kCommand, "spans wants --ray ox,oy,oz,dx,dy,dz or --rays FILE");
    if (request.spans.rays_file == "-" && request.inputs[0] == "-") return fail(Fault::kCommand, "the scene and the rays cannot both be standard input");
    if (request.render.resume && request.render.watch) return fail(Fault::kCommand, "--resume and --watch exclude each other: a watched picture has no checkpoint");
    if (request.render.resume && !request.outputs.empty() && request.outputs[0] == "-") return fail(Fault::kCommand, "--resume wants a picture with a name: its checkpoint stands beside it");
    if (request.render.options.scheme && request.render.options.integrator != Integrator::kPreview)
        return fail(Fault::kCommand, "--colorscheme goes with --integrator preview");
    const auto& region = request.render.options.region;
    if (region && (region->x + region->width > request.render.options.width || region->y + region->height > request.render.options.height))
        return fail(Fault::kCommand, "--tile reaches outside the picture");
    return {};
}

// Seed, threads and passes belong to every part that knows them.
void spread_common(Request& request) {
    request.render.options.seed = request.common.seed;
    request.render.options.threads = request.common.threads;
    request.render.options.disabled_passes = request.common.disabled_passes;
    request.mesh.options.threads = request.common.threads;
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
    if (declaration.wants_version()) return Say{"whittle " WHITTLE_VERSION "\n"};
    const auto rest = declaration.app().remaining();
    if (!rest.empty()) return unexpected_word(rest, declaration.app());
    if (!declaration.refused().empty()) return fail(Fault::kCommand, declaration.refused() + " is not supported yet");
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

std::vector<std::string> verb_names() {
    std::vector<std::string> names;
    for (const auto& verb : kVerbs) names.emplace_back(verb.name);
    return names;
}

}  // namespace whittle
