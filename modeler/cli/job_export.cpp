#include "modeler/cli/job_export.h"

#include <fmt/core.h>

#include "modeler/cli/answers.h"
#include "modeler/export/flat_files.h"
#include "modeler/export/pov.h"

namespace whittle {

namespace {

void answer(Session& session, const std::string& path, const std::string& what) {
    if (session.request.common.json) fmt::print("{}\n", json::Object().string("file", path).strings("warnings", session.console.warnings()).str());
    else if (path != "-") session.console.line(fmt::format("{}: {}", path, what));
}

Result<std::string> pov_of(Session& session, const ReadScene& scene) {
    if (auto solid = check_solid(scene.canonical); !solid) return tl::unexpected<Error>(solid.error());
    const RenderRequest& render = session.request.render;
    const Scene& read = scene.evaluated.scene;
    const double aspect = static_cast<double>(render.options.width) / render.options.height;
    const auto lens = resolve_camera(render.camera, read.camera, read.view, scene.canonical.solid.root_bounds(), aspect);
    if (!lens) return tl::unexpected<Error>(lens.error());
    auto file = pov_scene(scene.canonical.solid, read.lights, *lens, aspect, session.request.mesh.options);
    if (!file) return tl::unexpected<Error>(file.error());
    for (const auto& warning : file->warnings) session.console.warning(warning);
    return std::move(file->text);
}

}  // namespace

bool is_scene_format(const std::string& format) { return format == "pov"; }
bool is_drawing_format(const std::string& format) { return format == "svg" || format == "dxf" || format == "pdf"; }

Exit export_outputs(Session& session, const std::vector<std::pair<std::string, std::string>>& outputs) {
    const auto scene = read_scene(session);
    if (!scene) return give_up(session, scene.error());
    if (scene->verdict != Exit::kDone) return give_up(session, {Fault::kScene, "Geometry was left out, nothing is written (--allow-missing carries on without it)"});
    if (auto noted = summarise(session, *scene); !noted) return give_up(session, noted.error());
    std::vector<Outline> outlines;
    if (is_drawing_format(outputs.front().second)) {
        if (scene->canonical.solid.root().node != kEmptyNode && !scene->canonical.is_2d)
            return give_up(session, {Fault::kScene, "Current top level object is not a 2D object."});
        outlines = outlines_of(scene->canonical.solid);
        if (outlines.empty()) return give_up(session, {Fault::kScene, "Current top level object is empty."});
        session.summary.note(outlines);
    }
    for (const auto& [path, format] : outputs) {
        const auto text = format == "pov" ? pov_of(session, *scene) : Result<std::string>(format == "svg" ? svg_text(outlines) : format == "dxf" ? dxf_text(outlines) : pdf_text(outlines));
        if (!text) return give_up(session, text.error());
        if (auto written = write_output(path, *text); !written) return give_up(session, written.error());
        answer(session, path, format == "pov" ? "scene for POV-Ray 3.7" : fmt::format("{} outlines, area {:.6g} mm2", outlines.size(), area_of(outlines)));
    }
    return scene->verdict;
}

}  // namespace whittle
