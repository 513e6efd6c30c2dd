// verb_convert.cpp — OpenSCAD's own form, `whittle -o OUT FILE.scad`: each output's suffix (or --export-format) chooses the job.
#include <algorithm>
#include <cctype>

#include <fmt/core.h>

#include "csg/eval/dump_csg.h"
#include "csg/eval/evaluate.h"
#include "modeler/cli/job_export.h"
#include "modeler/cli/job_mesh.h"
#include "modeler/cli/job_render.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

enum class Job { kPicture, kMesh, kScene, kDrawing, kCsg, kEcho, kAst, kParameters, kNotYet, kUnknown };

std::string format_of(const std::string& path, const std::string& format_name) {
    std::string format = format_name;
    if (format.empty()) {
        const auto dot = path.rfind('.');
        const auto slash = path.rfind('/');
        if (dot != std::string::npos && (slash == std::string::npos || dot > slash)) format = path.substr(dot + 1);
    }
    std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return format;
}

Job job_of(const std::string& format) {
    const auto among = [&format](std::initializer_list<const char*> names) { return std::find(names.begin(), names.end(), format) != names.end(); };
    if (among({"png", "exr", "jpg", "jpeg", "tif", "tiff"})) return Job::kPicture;
    if (among({"stl", "asciistl", "binstl", "off", "obj", "ply", "3mf", "amf", "glb", "om"})) return Job::kMesh;
    if (is_scene_format(format)) return Job::kScene;
    if (is_drawing_format(format)) return Job::kDrawing;
    if (format == "csg") return Job::kCsg;
    if (format == "echo") return Job::kEcho;
    if (format == "ast") return Job::kAst;
    if (format == "param") return Job::kParameters;
    if (among({"nef3", "nefdbg", "term", "wrl"})) return Job::kNotYet;
    return Job::kUnknown;
}

// As in OpenSCAD, $preview is true where nothing is made of the scene.
constexpr Preview kAsPreviewed{true, false};

// The messages and nothing else, as OpenSCAD puts them in the file; a scene that is wrong leaves them there too.
Exit write_echo(Session& session, const std::string& path) {
    session.console.tell_echoes(false);
    const auto evaluated = read_text_of_scene(session, kAsPreviewed);
    session.console.tell_echoes(true);
    if (!evaluated) return give_up(session, evaluated.error());
    const auto written = write_output(path, echo_text(evaluated->diagnostics, evaluated->sources));
    if (!written) return give_up(session, written.error());
    return evaluated->stopped() ? Exit::kScene : Exit::kDone;
}

Exit write_csg(Session& session, const std::string& path) {
    const auto evaluated = read_text_of_scene(session, kAsPreviewed);
    if (!evaluated) return give_up(session, evaluated.error());
    if (evaluated->stopped()) return Exit::kScene;
    const auto written = write_output(path, dump_csg(evaluated->scene));
    return written ? Exit::kDone : give_up(session, written.error());
}

// The program as it was read, or the parameters it declares: nothing is run.
Exit write_syntax(Session& session, const std::string& path, Job job) {
    const auto parsed = read_syntax_of_scene(session);
    if (!parsed) return give_up(session, parsed.error());
    const auto text = job == Job::kAst ? ast_text(*parsed) : parameters_text(*parsed);
    if (!text) return give_up(session, text.error());
    const auto written = write_output(path, *text);
    return written ? Exit::kDone : give_up(session, written.error());
}

Exit write_text(Session& session, const std::string& path, Job job) {
    if (job == Job::kCsg) return write_csg(session, path);
    return job == Job::kEcho ? write_echo(session, path) : write_syntax(session, path, job);
}

Exit refuse(Session& session, const std::string& path, Job job) {
    const char* why = job == Job::kNotYet ? "this format is not supported yet" : "unknown suffix; known are png exr jpg tif stl off obj ply 3mf amf glb om svg dxf pdf pov csg echo ast param";
    return give_up(session, {Fault::kCommand, fmt::format("'{}': {}", path, why)});
}

}  // namespace

Exit run_convert(Session& session) {
    const Request& request = session.request;
    std::vector<std::string> pictures, meshes;
    std::vector<std::pair<std::string, Job>> texts;
    std::vector<std::pair<std::string, std::string>> scenes, drawings;
    for (const auto& path : request.outputs) {
        const Job job = job_of(format_of(path, request.export_format));
        if (job == Job::kNotYet || job == Job::kUnknown) return refuse(session, path, job);
        if (job == Job::kScene) scenes.emplace_back(path, format_of(path, request.export_format));
        else if (job == Job::kDrawing) drawings.emplace_back(path, format_of(path, request.export_format));
        else if (job == Job::kPicture) pictures.push_back(path);
        else if (job == Job::kMesh) meshes.push_back(path);
        else texts.emplace_back(path, job);
    }
    Exit done = Exit::kDone;
    for (const auto& [path, job] : texts) done = worse(done, write_text(session, path, job));
    if (!meshes.empty()) done = worse(done, mesh_outputs(session, meshes, request.mesh.encoding != MeshEncoding::kBinary));
    for (const auto& exports : {scenes, drawings})
        if (!exports.empty()) done = worse(done, export_outputs(session, exports));
    const bool modifiers = request.render.options.integrator == Integrator::kPreview;
    if (!pictures.empty()) done = worse(done, render_outputs(session, pictures, {!request.full_render, modifiers}));
    return done;
}

}  // namespace whittle
