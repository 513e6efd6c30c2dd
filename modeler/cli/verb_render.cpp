// verb_render.cpp — whittle render: scene → film → picture files; --watch draws again on every change.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <fmt/core.h>

#include "csg/solid/look_alike.h"
#include "csg/solid/sheet.h"
#include "modeler/cli/answers.h"
#include "modeler/cli/checkpoint.h"
#include "modeler/cli/job_render.h"
#include "modeler/cli/progress.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

constexpr std::chrono::milliseconds kLookEvery{150};

struct Output {
    std::string path;
    ImageFormat format;
};

Result<std::vector<Output>> outputs_of(const std::vector<std::string>& paths, const std::string& format_name) {
    std::vector<Output> outputs;
    for (const auto& path : paths) {
        const auto format = image_format_of(format_name.empty() ? path : "." + format_name);
        if (!format) return fail(Fault::kCommand, fmt::format("'{}': render writes .png, .exr, .jpg and .tif", path));
        outputs.push_back({path, *format});
    }
    return outputs;
}

void count(Stats& stats, const RenderCounters& counters) {
    const auto add = [&stats](const char* name, std::uint64_t value) { stats.add(name, static_cast<double>(value)); };
    add("rays.camera", counters.camera);
    add("rays.shadow", counters.shadow);
    add("rays.reflection", counters.reflection);
    add("rays.refraction", counters.refraction);
    add("rays.diffuse", counters.diffuse);
    add("photons", counters.photons);
    add("media_stack", counters.media_stack);
    add("normals", counters.normals);
    add("wavelengths", counters.wavelengths);
    add("draws", counters.draws);
    add("skip.shadows", counters.skipped_shadows);
    add("skip.media", counters.skipped_media);
    add("skip.lens", counters.skipped_lens);
    add("skip.shutter", counters.skipped_shutter);
    add("skip.spectrum", counters.skipped_spectrum);
    add("skip.photons", counters.skipped_photons);
    add("skip.areas", counters.skipped_areas);
    stats.add(counters.engine);
}

// A picture that the scene names, from beside the text that names it.
Result<Image> read_picture(Session& session, const ReadScene& scene, ImageFiles& files, const std::string& name, const SourcePlace& place) {
    const SourceTable& sources = scene.evaluated.sources;
    const std::filesystem::path text = place.file < sources.files.size() ? sources.files[place.file].path : std::string();
    auto image = files.read(text.parent_path() / name);
    if (image) return image;
    Diagnostics told;
    told.add(Severity::kError, place, fmt::format("Can't read the environment '{}': {}", name, image.error().message));
    session.console.tell(told, sources);
    return fail(image.error().fault, "");
}

// The film to go on from, where --resume asks for one and it is there.
Result<std::optional<Film>> film_so_far(Session& session, const Checkpoint& checkpoint) {
    if (!session.request.render.resume) return std::nullopt;
    auto film = checkpoint.read();
    if (film && !*film) session.console.line(fmt::format("{} is not there: nothing to resume, drawn from the beginning", checkpoint.path()));
    return film;
}

Result<RenderResult> draw(Session& session, const ReadScene& scene, const std::shared_ptr<const Program>& program, ImageFiles& files, const Checkpoint* checkpoint) {
    const Scene& read = scene.evaluated.scene;
    RenderScene stage{read.lights, read.camera, read.view, session.request.render.camera, &scene.canonical.solid, {}};
    stage.read_picture = [&](const std::string& name, const SourcePlace& place) { return read_picture(session, scene, files, name, place); };
    Result<std::optional<Film>> before = checkpoint ? film_so_far(session, *checkpoint) : std::nullopt;
    if (!before) return tl::unexpected<Error>(before.error());
    Progress progress("Rendering", session.request.common.progress, session.console.on_terminal(), session.console.quiet());
    RenderControl control;
    control.progress = [&progress](const RenderProgress& now) { progress.report(now.done, now.left_s); };
    // A checkpoint in the middle is a convenience: that it cannot be written is told at the end.
    if (checkpoint) control.keep = [checkpoint](const Film& film) { static_cast<void>(checkpoint->write(film)); };
    session.watchdog.when_interrupted([&control] { control.stop = true; });
    auto result = render(program, stage, session.request.render.options, control, *before ? &**before : nullptr);
    session.watchdog.when_interrupted({});
    return result;
}

// After a rendering that ended early the checkpoint stays, after a whole one there is none.
Result<void> settle(Session& session, const Checkpoint& checkpoint, const RenderResult& drawn) {
    if (drawn.complete || checkpoint.path().empty()) {
        checkpoint.remove();
        return {};
    }
    if (auto written = checkpoint.write(drawn.film); !written) return written;
    session.console.line(fmt::format("Stopped after {} samples; --resume goes on from {}", drawn.samples_finished, checkpoint.path()));
    return {};
}

Result<void> write_picture(Session& session, ImageFiles& files, const RenderResult& drawn, const Output& output) {
    PictureOptions picture = session.request.render.picture;
    picture.tone.exposure += drawn.exposure;
    const auto& region = session.request.render.options.region;
    const auto image = image_of(region ? cropped(drawn.film, *region) : drawn.film, output.format, picture);
    if (!image) return tl::unexpected<Error>(image.error());
    const auto bytes = files.encode(*image, output.format);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    return write_output(output.path, *bytes);
}

std::string integrator_and_reason(const RenderResult& drawn) {
    return drawn.reason.empty() ? std::string(integrator_name(drawn.integrator)) : fmt::format("{} ({})", integrator_name(drawn.integrator), drawn.reason);
}

std::string samples_of_pixels(const RenderResult& drawn) {
    if (drawn.samples_finished == drawn.samples_most) return fmt::format("{}", drawn.samples_finished);
    return fmt::format("{} to {}", drawn.samples_finished, drawn.samples_most);
}

void answer(Session& session, const std::vector<Output>& outputs, const RenderResult& drawn) {
    for (const auto& output : outputs) {
        if (session.request.common.json)
            fmt::print("{}\n", json::Object().string("file", output.path).string("integrator", std::string(integrator_name(drawn.integrator))).number("seconds", drawn.seconds).strings("warnings", session.console.warnings()).str());
        else if (output.path != "-")
            session.console.line(fmt::format("{}: {} x {}, {} samples, {}, {:.2f} s", output.path, drawn.film.width, drawn.film.height, samples_of_pixels(drawn),
                                             integrator_and_reason(drawn), drawn.seconds));
    }
}

// A 2D scene is shown as a sheet around z = 0, a thousandth of its size thick.
void raise_flat(Canonical& canonical) {
    if (!canonical.is_2d) return;
    const Bounds box = canonical.solid.root_bounds();
    const double size = box.empty() ? 1 : std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
    const double half = size > 0 && std::isfinite(size) ? size / 2000 : 1;
    canonical.solid = as_sheet(canonical.solid, -half, half);
}

// What a watched scene was when it was drawn last.
struct Before {
    std::vector<std::string> files_read;
    Solid solid;
    std::shared_ptr<const Program> program;
};

// The program of `solid`: the one of before where only the camera, the lights or the text around have changed.
Result<std::shared_ptr<const Program>> program_of(Session& session, const Solid& solid, Before& before) {
    if (before.program && look_alike(before.solid, solid)) {
        session.console.line("The solid is what it was: nothing is built anew");
        return before.program;
    }
    auto program = compile_scene(session, solid);
    if (program && session.request.render.watch) before.solid = solid, before.program = *program;
    return program;
}

Exit render_once(Session& session, const std::vector<Output>& outputs, Preview preview, Before& before) {
    auto scene = read_scene(session, preview);
    if (!scene) return give_up(session, scene.error());
    before.files_read = scene->evaluated.files_read;
    if (auto something = check_something(scene->canonical); !something) return give_up(session, something.error());
    if (auto noted = summarise(session, *scene); !noted) return give_up(session, noted.error());
    raise_flat(scene->canonical);
    ImageFiles files;
    // A PNG needs no image library.
    for (const auto& output : outputs)
        if (output.format != ImageFormat::kPng) files.start_loading();
    const auto program = program_of(session, scene->canonical.solid, before);
    if (!program) return give_up(session, program.error());
    const Checkpoint checkpoint(session, *scene, outputs.front().path);
    const bool kept = !session.request.render.watch;
    const auto drawn = draw(session, *scene, *program, files, kept ? &checkpoint : nullptr);
    if (!drawn) return give_up(session, drawn.error());
    for (const auto& warning : drawn->warnings) session.console.warning(warning);
    count(session.stats, drawn->counters);
    session.stats.add("seconds.render", drawn->seconds);
    for (const auto& output : outputs)
        if (auto written = write_picture(session, files, *drawn, output); !written) return give_up(session, written.error());
    session.stats.set("loaded.image", files.loaded() ? 1 : 0);
    answer(session, outputs, *drawn);
    if (kept)
        if (auto settled = settle(session, checkpoint, *drawn); !settled) return give_up(session, settled.error());
    return session.watchdog.interrupted() ? Exit::kInterrupted : scene->verdict;
}

// When each file was last written; a file that is gone has the earliest time.
std::vector<std::filesystem::file_time_type> times_of(const std::vector<std::string>& files) {
    std::vector<std::filesystem::file_time_type> times;
    for (const auto& file : files) {
        std::error_code fault;
        const auto time = std::filesystem::last_write_time(file, fault);
        times.push_back(fault ? std::filesystem::file_time_type::min() : time);
    }
    return times;
}

// Ends by Ctrl-C only.
Exit watch(Session& session, const std::vector<Output>& outputs, Preview preview) {
    Before before;
    before.files_read = {session.request.inputs.front()};
    const std::vector<std::string>& files = before.files_read;
    while (true) {
        const auto begin = times_of(files);
        const auto known = files;
        if (render_once(session, outputs, preview, before) == Exit::kInterrupted) return Exit::kInterrupted;
        auto seen = files == known ? begin : times_of(files);
        while (times_of(files) == seen) std::this_thread::sleep_for(kLookEvery);
    }
}

}  // namespace

Exit render_outputs(Session& session, const std::vector<std::string>& paths, Preview preview) {
    const auto outputs = outputs_of(paths, session.request.export_format);
    if (!outputs) return give_up(session, outputs.error());
    if (session.request.render.watch) return watch(session, *outputs, preview);
    Before nothing;
    return render_once(session, *outputs, preview, nothing);
}

Exit run_render(Session& session) {
    auto paths = session.request.outputs;
    if (paths.empty()) paths.push_back(default_output(session.request.inputs.front(), ".png"));
    return render_outputs(session, paths, {false, session.request.render.options.integrator == Integrator::kPreview});
}

}  // namespace whittle
