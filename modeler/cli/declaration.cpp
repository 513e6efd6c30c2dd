#include "modeler/cli/declaration.h"

#include "csg/base/passes.h"
#include "modeler/cli/nearest.h"
#include "modeler/cli/words.h"

namespace whittle {

namespace {

constexpr double kMostThreads = 4096, kMostCount = 9007199254740992.0;  // 2^53: every whole number up to it is a double

}  // namespace

void Declaration::passes(const char* name, const char* group, std::vector<std::string>& target) {
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
    flag("-q", "Print errors only", common.quiet, kGroup);
    text("--stats", "FILE", "Writes counters of work done; - is standard output", common.stats_file, kGroup);
    number("--limit-time", "S", "Give up after so many seconds (exit code 3)", common.limit_seconds, 0, 1e9, kGroup);
    value("--limit-memory", "MB", "Give up at so many megabytes (exit code 3)", kGroup, [&common](const std::string& t) {
        const auto n = number_in(t);
        if (!n || *n < 0 || *n > 1e9) return false;
        common.limit_bytes = static_cast<std::uint64_t>(*n * 1048576.0);
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
    for (const char* name : {"-m", "--view", "--summary", "--summary-file", "-O"}) not_yet(name, true, kGroup);
    not_yet("--info", false, kGroup);
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
    number("--noise", "X", "Stop where the estimated error is below X", render.options.noise, 0, 1e9, kGroup);
    number("--stop-after", "S", "Stop after S seconds and keep the picture so far", render.options.stop_after_s, 0, 1e9, kGroup);
    number("--max-depth", "N", "Mirrors and refractions one after the other (16)", render.options.max_depth, 1, 1e6, kGroup);
    value("--integrator", "auto, preview, whitted, distributed, path, caustics or cone", "How light is followed", kGroup, [&render](const std::string& t) {
        const auto kind = integrator_named(t);
        render.options.integrator = kind.value_or(Integrator::kAuto);
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
    value("--ray", "ox,oy,oz,dx,dy,dz", "Origin and direction (of any length; t is in units of it)", kGroup,
          [&spans](const std::string& t) { return read_ray(t, spans.rays); });
    text("--rays", "FILE", "One ray a line: ox oy oz dx dy dz; - is standard input", spans.rays_file, kGroup);
}

}  // namespace whittle
