#include "bench/light.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "bench/light_plot.h"
#include "bench/machine.h"
#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"
#include "modeler/io/files.h"
#include "tracer/light/render.h"

namespace whittle::bench {

namespace {

struct Staged {
    Evaluated evaluated;
    Canonical canonical;
    std::shared_ptr<const Program> program;
};

std::optional<Staged> staged(const std::string& path) {
    EvaluateInput input;
    input.path = path;
    input.library_paths = library_paths();
    Files files;
    Result<Evaluated> evaluated = evaluate(input, files);
    if (!evaluated) {
        fmt::print(stderr, "{}: {}\n", path, evaluated.error().message);
        return std::nullopt;
    }
    Staged scene{std::move(*evaluated), {}, nullptr};
    scene.canonical = canonicalise(scene.evaluated.scene, {}, &files, scene.evaluated.diagnostics);
    Result<std::shared_ptr<const Program>> program = compile(scene.canonical.solid);
    if (!program) {
        fmt::print(stderr, "{}: {}\n", path, program.error().message);
        return std::nullopt;
    }
    scene.program = *program;
    return scene;
}

struct Drawn {
    std::vector<Vec3> pixels;  // clipped at white
    double seconds = 0;
};

std::optional<Drawn> drawn(const Staged& staged, const LightOptions& options, Integrator integrator, SamplerKind sampler, int samples, std::uint64_t seed) {
    RenderScene scene;
    scene.lights = staged.evaluated.scene.lights;
    scene.camera = staged.evaluated.scene.camera;
    scene.view = staged.evaluated.scene.view;
    scene.solid = &staged.canonical.solid;
    RenderOptions o;
    o.width = options.width;
    o.height = options.height;
    o.samples = samples;
    o.integrator = integrator;
    o.sampler = sampler;
    o.seed = seed;
    o.threads = 1;
    RenderControl control;
    const double begin = process_seconds();
    const Result<RenderResult> result = render(staged.program, scene, o, control);
    if (!result) {
        fmt::print(stderr, "{}\n", result.error().message);
        return std::nullopt;
    }
    Drawn picture{{}, process_seconds() - begin};
    for (std::size_t i = 0; i < result->film.pixels.size(); ++i) picture.pixels.push_back(glm::min(result->film.color(i), Vec3(1)));
    return picture;
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]) / 3;
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// All rows of one integrator and sampler, as a line of the plot.
std::optional<LightLine> measured(const Staged& scene, const LightOptions& options, const LightLine& named, const Drawn& converged) {
    LightLine line = named;
    for (int samples = 1; samples <= options.most_samples; samples *= 4) {
        const std::optional<Drawn> picture = drawn(scene, options, *integrator_named(line.name), *sampler_named(line.sampler), samples, 0);
        if (!picture) return std::nullopt;
        line.points.push_back({samples, picture->seconds, distance(picture->pixels, converged.pixels)});
    }
    return line;
}

std::string print(const std::string& scene, const LightLine& line) {
    std::string rows;
    for (const LightPoint& p : line.points) {
        fmt::print("{:16} {:12} {:12} {:5} samples {:9.4f} s   rmse {:.5f}   bias {:.5f}\n", scene, line.name, line.sampler, p.samples, p.seconds, p.error, line.bias);
        rows += fmt::format("{},{},{},{},{},{},{}\n", scene, line.name, line.sampler, p.samples, p.seconds, p.error, line.bias);
    }
    std::fflush(stdout);
    return rows;
}

bool written(const std::string& path, const std::string& text) {
    if (path.empty()) return true;
    std::ofstream out(path);
    out << text;
    return static_cast<bool>(out);
}

// All lines of a scene; none where something could not be drawn. Rows are printed and added to `rows`.
std::optional<LightPanel> panel_of(const LightOptions& options, const std::string& name, std::string& rows) {
    const std::optional<Staged> scene = staged(options.folder + "/" + name + ".scad");
    if (!scene) return std::nullopt;
    const std::optional<Drawn> truth = drawn(*scene, options, Integrator::kPath, SamplerKind::kSobol, options.reference_samples, 2);
    if (!truth) return std::nullopt;
    LightPanel panel{name, {}};
    for (const std::string& integrator : options.integrators) {
        const std::string& reference = options.against.empty() ? integrator : options.against;
        const std::optional<Drawn> converged = drawn(*scene, options, *integrator_named(reference), SamplerKind::kSobol, options.reference_samples, 1);
        if (!converged) return std::nullopt;
        for (const std::string& sampler : options.samplers) {
            std::optional<LightLine> line = measured(*scene, options, {integrator, sampler, {}, distance(converged->pixels, truth->pixels)}, *converged);
            if (!line) return std::nullopt;
            rows += print(name, *line);
            panel.lines.push_back(std::move(*line));
        }
    }
    return panel;
}

}  // namespace

int time_light(const LightOptions& options) {
    std::string rows = "scene,integrator,sampler,samples,cpu_seconds,rmse,bias\n";
    std::vector<LightPanel> panels;
    for (const std::string& name : options.scenes) {
        std::optional<LightPanel> panel = panel_of(options, name, rows);
        if (!panel) return 1;
        panels.push_back(std::move(*panel));
    }
    return written(options.csv, rows) && written(options.svg, light_plot(panels)) ? 0 : 3;
}

}  // namespace whittle::bench
