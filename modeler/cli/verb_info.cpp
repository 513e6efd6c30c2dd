#include "modeler/cli/verb_info.h"

#include <vector>

#include <fmt/format.h>

#include "modeler/cli/nearest.h"
#include "modeler/cli/parse.h"

#ifndef WHITTLE_VERSION
#error "the build names the version"
#endif

namespace whittle {
namespace {

constexpr VerbInfo kVerbs[] = {
    {"render", Verb::kRender, "FILE.scad [-o picture.png|.exr|.jpg|.tif]", "Draws the exact solid."},
    {"mesh", Verb::kMesh, "FILE.scad [-o part.stl|.3mf|.off|.obj|.ply|.amf|.glb|.om]", "Writes the solid as a closed triangle mesh (exact booleans)."},
    {"check", Verb::kCheck, "FILE.scad", "Do the exact solid and its mesh agree, within a bound fixed beforehand? Exit code 4 if not."},
    {"measure", Verb::kMeasure, "FILE.scad", "Volume, area, centroid, inertia and bounds, each with its error."},
    {"spans", Verb::kSpans, "FILE.scad --ray ox,oy,oz,dx,dy,dz", "What a ray meets: where, on which surface, of which line of the scene."},
    {"merge", Verb::kMerge, "A.exr B.exr ... -o all.exr", "Puts the shards of one render together."},
    {"bench", Verb::kBench, "[NAME]", "Run time against error and against peers (needs the program whittle-bench)."},
};

// A word that no file is called by: what stands where a verb belongs.
bool is_bare(const std::string& word) { return word.find_first_of("./") == std::string::npos && word != "-"; }

tl::unexpected<Error> no_verb(const std::string& word) {
    const auto near = nearest(word, verb_names());
    return fail(Fault::kCommand, fmt::format("'{}' is no verb{}", word, near ? fmt::format("; did you mean {}?", *near) : "; whittle --help lists them"));
}

}  // namespace

const VerbInfo* verb_named(std::string_view name) {
    for (const auto& info : kVerbs)
        if (name == info.name) return &info;
    return nullptr;
}

std::vector<std::string> verb_names() {
    std::vector<std::string> names;
    for (const auto& verb : kVerbs) names.emplace_back(verb.name);
    return names;
}

std::string overview() {
    std::string text = "whittle: carve solids in text, see them exactly.\n\n    whittle FILE.scad\n";
    for (const auto& verb : kVerbs) text += fmt::format("    whittle {:<8}{}\n", verb.name, verb.usage);
    text += "    whittle -o OUT [openscad options] FILE.scad\n\n";
    for (const auto& verb : kVerbs) text += fmt::format("  {:<8}{}\n", verb.name, verb.summary);
    return text + "\n`whittle VERB --help` lists a verb's options; below, those of the form without a verb.\n\n";
}

std::string info_text() {
    return "whittle " WHITTLE_VERSION "\ncompiler: " __VERSION__ "\nlanguage: OpenSCAD 2021.01 and later additions\n"
           "modules, opened when needed: whittle_image whittle_cgal whittle_openmesh whittle_font\n";
}

Result<void> validate(const VerbInfo* verb, const Request& request) {
    const bool many_files = verb && verb->verb == Verb::kMerge;
    if (verb && verb->verb == Verb::kBench) return {};
    if (request.inputs.empty()) return fail(Fault::kCommand, many_files ? "merge wants the pictures to put together" : "no scene is named");
    const bool suite = verb && verb->verb == Verb::kCheck && request.check.suite;
    if (!verb && request.inputs.size() > 1 && is_bare(request.inputs[0])) return no_verb(request.inputs[0]);
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

void spread_common(Request& request) {
    request.render.options.seed = request.common.seed;
    request.render.options.threads = request.common.threads;
    request.render.options.disabled_passes = request.common.disabled_passes;
    request.mesh.options.threads = request.common.threads;
}

}  // namespace whittle
