// verb_mesh.cpp — whittle mesh: scene → solid → closed triangle mesh → files.
#include <filesystem>
#include <memory>

#include <fmt/core.h>

#include "csg/solid/part_solids.h"
#include "modeler/cli/answers.h"
#include "modeler/cli/job_mesh.h"
#include "modeler/cli/progress.h"
#include "modeler/cli/verbs.h"
#include "modeler/mesh/rework.h"

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

constexpr std::string_view kPartMark = "{part}";

// "box-{part}.stl" for a part; what no file name can hold becomes '_'.
std::string path_of_part(std::string path, const std::string& name) {
    std::string safe = name.empty() ? "rest" : name;
    for (char& c : safe)
        if (c == '/' || static_cast<unsigned char>(c) < 0x20) c = '_';
    for (std::size_t at = path.find(kPartMark); at != std::string::npos; at = path.find(kPartMark, at + safe.size())) path.replace(at, kPartMark.size(), safe);
    return path;
}

// The solid as one mesh and as a mesh a part, each made when an output first asks for it.
class Meshes {
public:
    Meshes(Session& session, const Solid& solid) : session_(session), solid_(solid) {}

    Result<std::vector<MeshPart>> whole() {
        if (!whole_) whole_ = make_mesh(session_, solid_);
        if (!*whole_) return tl::unexpected<Error>(whole_->error());
        return std::vector<MeshPart>{{"", &**whole_}};
    }

    Result<std::vector<MeshPart>> parts() {
        if (!divided_) {
            named_ = divided_by_part(solid_);
            divided_ = true;
        }
        if (named_.size() <= 1) {
            auto single = whole();
            if (single && !named_.empty()) single->front().name = named_.front().name;
            return single;
        }
        while (made_.size() < named_.size()) {
            auto mesh = make_mesh(session_, named_[made_.size()].solid);
            if (!mesh) return tl::unexpected<Error>(mesh.error());
            made_.push_back(std::make_unique<MeshResult>(std::move(*mesh)));
        }
        std::vector<MeshPart> parts;
        for (std::size_t i = 0; i < made_.size(); ++i)
            if (!made_[i]->mesh.triangles.empty()) parts.push_back({named_[i].name, made_[i].get()});
        if (parts.empty()) return fail(Fault::kScene, "Current top level object is empty.");
        return parts;
    }

private:
    Session& session_;
    const Solid& solid_;
    bool divided_ = false;
    std::optional<Result<MeshResult>> whole_;
    std::vector<NamedSolid> named_;
    std::vector<std::unique_ptr<MeshResult>> made_;
};

// An OBJ with colours names a file of materials beside it.
std::string materials_path(const Output& output) {
    if (output.format != MeshFormat::kObj || output.path == "-") return {};
    return std::filesystem::path(output.path).replace_extension(".mtl").string();
}

Result<void> write_one(Session& session, const std::vector<MeshPart>& parts, const Output& output) {
    const std::string materials = materials_path(output);
    const auto file = write_mesh(parts, output.format, std::filesystem::path(materials).filename().string());
    if (!file) return tl::unexpected<Error>(file.error());
    for (const auto& warning : file->warnings) session.console.export_warning(warning);
    if (!file->materials.empty())
        if (auto written = write_output(materials, file->materials); !written) return written;
    if (auto written = write_output(output.path, file->bytes); !written) return written;
    answer(session, output, *file);
    return {};
}

void note_parts(Summary& summary, const std::vector<MeshPart>& parts) {
    std::vector<const MeshResult*> results;
    for (const MeshPart& part : parts) results.push_back(part.result);
    summary.note(results);
}

Result<void> write_output_of(Session& session, Meshes& meshes, const Output& output) {
    const bool file_a_part = output.path.find(kPartMark) != std::string::npos;
    const auto parts = file_a_part || holds_parts(output.format) ? meshes.parts() : meshes.whole();
    if (!parts) return tl::unexpected<Error>(parts.error());
    if (session.summary.wanted()) note_parts(session.summary, *parts);
    if (!file_a_part) return write_one(session, *parts, output);
    for (const MeshPart& part : *parts)
        if (auto written = write_one(session, {part}, {path_of_part(output.path, part.name), output.format}); !written) return written;
    return {};
}

}  // namespace

namespace {

// With the triangles that --simplify and --remesh ask for.
Result<MeshResult> reworked(Session& session, MeshResult mesh, MeshControl& control) {
    const MeshRequest& request = session.request.mesh;
    const auto take = [&](const char* what, Result<Reworked> made) -> Result<void> {
        if (!made) return tl::unexpected<Error>(made.error());
        if (made->changed) {
            session.console.line(fmt::format("{}: {} triangles become {}, no point farther than {:.3g} mm", what, mesh.mesh.triangles.size(),
                                             made->result.mesh.triangles.size(), made->deviation));
        } else {
            session.console.warning(fmt::format("{}: no mesh that keeps the distance was found, the triangles stay as they are", what));
        }
        mesh = std::move(made->result);
        return {};
    };
    if (mesh.mesh.triangles.empty()) return mesh;
    if (request.simplify_mm)
        if (auto done = take("--simplify", simplified(mesh, *request.simplify_mm, control)); !done) return tl::unexpected<Error>(done.error());
    if (request.remesh_mm)
        if (auto done = take("--remesh", remeshed(mesh, *request.remesh_mm, control)); !done) return tl::unexpected<Error>(done.error());
    return mesh;
}

}  // namespace

Result<MeshResult> make_mesh(Session& session, const Solid& solid) {
    Progress progress("Meshing", session.request.common.progress, session.console.on_terminal(), session.console.quiet());
    Control control(session, progress);
    Stopwatch watch;
    auto mesh = mesh_solid_by(session.request.mesh.booleans, solid, session.request.mesh.options, control);
    if (mesh) mesh = reworked(session, std::move(*mesh), control);
    session.stats.add("seconds.mesh", watch.lap());
    if (!mesh) return mesh;
    for (const auto& warning : mesh->warnings) session.console.export_warning(warning);
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
    if (auto noted = summarise(session, *scene); !noted) return give_up(session, noted.error());
    Meshes meshes(session, scene->canonical.solid);
    for (const auto& output : *outputs)
        if (auto written = write_output_of(session, meshes, output); !written) return give_up(session, written.error());
    return scene->verdict;
}

Exit run_mesh(Session& session) {
    auto paths = session.request.outputs;
    if (paths.empty()) paths.push_back(default_output(session.request.inputs.front(), ".stl"));
    return mesh_outputs(session, paths, session.request.mesh.encoding == MeshEncoding::kAscii);
}

}  // namespace whittle
