// verb_mesh.cpp — whittle mesh: scene → solid → closed triangle mesh → files.
#include <fmt/core.h>

#include "modeler/cli/answers.h"
#include "modeler/cli/job_mesh.h"
#include "modeler/cli/progress.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

class Control : public MeshControl {
public:
    Control(Session& session, Progress& progress) : session_(session), progress_(progress) {}
    bool cancelled() const override { return session_.watchdog.interrupted(); }
    void progress(double share_done) override { progress_.report(share_done); }

private:
    Session& session_;
    Progress& progress_;
};

struct Output {
    std::string path;
    MeshFormat format;
};

Result<std::vector<Output>> outputs_of(const std::vector<std::string>& paths, const std::string& format_name, bool ascii) {
    std::vector<Output> outputs;
    for (const auto& path : paths) {
        const bool in_letters = format_name == "asciistl" || (ascii && format_name != "binstl");
        const bool names_stl = format_name == "asciistl" || format_name == "binstl";
        const auto format = mesh_format(format_name.empty() ? path : names_stl ? std::string(".stl") : "." + format_name, in_letters);
        if (!format) return tl::unexpected<Error>(format.error());
        outputs.push_back({path, *format});
    }
    return outputs;
}

std::string report_json(const MeshReport& report) {
    json::Object object;
    object.count("triangles", report.triangles).count("vertices", report.vertices).count("components", report.components);
    object.number("genus", static_cast<double>(report.genus)).count("open_edges", report.open_edges).count("shared_edges", report.shared_edges);
    object.count("degenerate", report.degenerate).count("duplicate", report.duplicate).boolean("valid", report.valid());
    return object.str();
}

void print_report(const std::string& path, const MeshReport& report) {
    fmt::print("{}: {} triangles, {} vertices, {} shells, genus {}\n", path, report.triangles, report.vertices, report.components, report.genus);
    fmt::print("  open edges {}, shared edges {}, degenerate {}, duplicate {}: {}\n", report.open_edges, report.shared_edges, report.degenerate,
               report.duplicate, report.valid() ? "closed and oriented" : "not valid");
}

void answer(Session& session, const Output& output, const MeshFile& file) {
    const Request& request = session.request;
    if (request.common.json) {
        json::Object object;
        object.string("file", output.path).number("seconds", session.stats.get("seconds.mesh")).strings("warnings", session.console.warnings());
        if (request.mesh.report) object.raw("report", report_json(file.report));
        fmt::print("{}\n", object.str());
    } else if (output.path != "-") {
        if (request.mesh.report) print_report(output.path, file.report);
        else session.console.line(fmt::format("{}: {} triangles, {:.2f} s", output.path, file.report.triangles, session.stats.get("seconds.mesh")));
    }
}

Result<void> write_one(Session& session, const MeshResult& mesh, const Output& output) {
    const auto file = write_mesh(mesh, output.format);
    if (!file) return tl::unexpected<Error>(file.error());
    for (const auto& warning : file->warnings) session.console.warning(warning);
    if (auto written = write_output(output.path, file->bytes); !written) return written;
    answer(session, output, *file);
    return {};
}

}  // namespace

Result<MeshResult> make_mesh(Session& session, const Solid& solid) {
    Progress progress("Meshing", session.request.common.progress, session.console.on_terminal(), session.console.quiet());
    Control control(session, progress);
    Stopwatch watch;
    auto mesh = mesh_solid(solid, session.request.mesh.options, control);
    session.stats.add("seconds.mesh", watch.lap());
    if (!mesh) return mesh;
    for (const auto& warning : mesh->warnings) session.console.warning(warning);
    session.stats.add("mesh.booleans", static_cast<double>(mesh->stats.booleans));
    session.stats.add("mesh.fallback", static_cast<double>(mesh->stats.fallbacks));
    session.stats.add("skip.mesh_equal", static_cast<double>(mesh->stats.reused));
    session.stats.add("skip.mesh_boxes", static_cast<double>(mesh->stats.skipped_boxes));
    session.stats.set("loaded.cgal", mesh->stats.loaded_cgal ? 1 : 0);
    return mesh;
}

Exit mesh_outputs(Session& session, const std::vector<std::string>& paths, bool ascii) {
    const auto outputs = outputs_of(paths, session.request.export_format, ascii);
    if (!outputs) return give_up(session, outputs.error());
    const auto scene = read_whole_solid(session);
    if (!scene) return give_up(session, scene.error());
    const auto mesh = make_mesh(session, scene->canonical.solid);
    if (!mesh) return give_up(session, mesh.error());
    for (const auto& output : *outputs)
        if (auto written = write_one(session, *mesh, output); !written) return give_up(session, written.error());
    return scene->verdict;
}

Exit run_mesh(Session& session) {
    auto paths = session.request.outputs;
    if (paths.empty()) paths.push_back(default_output(session.request.inputs.front(), ".stl"));
    return mesh_outputs(session, paths, session.request.mesh.encoding == MeshEncoding::kAscii);
}

}  // namespace whittle
