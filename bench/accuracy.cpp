#include "bench/accuracy.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "bench/child.h"
#include "bench/light_plot.h"
#include "bench/machine.h"
#include "bench/ray_sets.h"
#include "bench/stability_truth.h"
#include "modeler/check/measure.h"
#include "modeler/mesh/mesh_queries.h"

namespace whittle::bench {

namespace {

constexpr double kPi = 3.14159265358979323846;

struct QuadInterval {
    Quad in, out;  // empty where out <= in
};

// x^2 + ... <= r^2 over the axes with `across`, and |z| <= half along the one without, if there is one.
QuadInterval round_interval(const Quad3& o, const Quad3& d, double r, int along, double half) {
    Quad a = 0, b = 0, c = -Quad(r) * r;
    for (int i = 0; i < 3; ++i) {
        if (i == along) continue;
        const auto k = static_cast<std::size_t>(i);
        a += d[k] * d[k], b += o[k] * d[k], c += o[k] * o[k];
    }
    const Quad disc = b * b - a * c;
    if (disc <= 0 || a == 0) return {1, 0};
    const Quad s = square_root(disc);
    QuadInterval t{(-b - s) / a, (-b + s) / a};
    if (along < 0) return t;
    const auto k = static_cast<std::size_t>(along);
    const Quad x = (-half - o[k]) / d[k], y = (half - o[k]) / d[k];
    return {std::max(t.in, std::min(x, y)), std::min(t.out, std::max(x, y))};
}

// First t at which the ray is in S1 (or the ball); -1: never. Requires: it starts outside, no coordinate of the direction is 0.
double true_t(const std::string& scene, const Ray& ray) {
    const Quad3 o = quad(ray.origin), d = quad(ray.direction);
    const QuadInterval ball = round_interval(o, d, scene == "ball" ? 1 : 1.2, -1, 0);
    if (scene == "ball") return ball.in < ball.out ? static_cast<double>(ball.in) : -1;
    QuadInterval box{-1e30, 1e30};
    for (std::size_t i = 0; i < 3; ++i) {
        const Quad x = (-1 - o[i]) / d[i], y = (1 - o[i]) / d[i];
        box = {std::max(box.in, std::min(x, y)), std::min(box.out, std::max(x, y))};
    }
    std::array<QuadInterval, 4> cutters{ball, round_interval(o, d, 0.75, 0, 1.1), round_interval(o, d, 0.75, 1, 1.1), round_interval(o, d, 0.75, 2, 1.1)};
    Quad t = box.in;
    for (bool moved = true; moved;) {
        moved = false;
        for (const QuadInterval& c : cutters)
            if (c.in <= t && t < c.out) t = c.out, moved = true;
    }
    return t < box.out ? static_cast<double>(t) : -1;
}

struct PointErrors {
    double rms = 0, worst = 0, disagree = 0;  // of the rays that both sides meet; share of those that one meets alone
};

PointErrors errors_of(const std::vector<double>& truth, const std::vector<double>& found) {
    std::vector<double> errors;
    std::size_t alone = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if ((truth[i] < 0) != (found[i] < 0)) ++alone;
        else if (truth[i] >= 0) errors.push_back(std::abs(truth[i] - found[i]));
    }
    PointErrors e;
    for (const double error : errors) e.rms += error * error, e.worst = std::max(e.worst, error);
    if (!errors.empty()) e.rms = std::sqrt(e.rms / static_cast<double>(errors.size()));
    e.disagree = static_cast<double>(alone) / static_cast<double>(truth.size());
    return e;
}

std::vector<double> answers_of(const Subject& subject, const std::vector<Ray>& rays) {
    const RaySet set(rays);
    const auto answers = std::make_unique<Answers>();
    std::vector<double> t;
    for (std::size_t k = 0; k < set.batches(); ++k) {
        subject.run(set.batch(k), *answers);
        for (std::size_t i = 0; i < kBatch; ++i) t.push_back(answers->met(i) ? answers->t[i] : -1);
    }
    return t;
}

struct Tables {
    std::string csv = "what,scene,subject,seconds,rms_error,worst,disagree\n";
    std::vector<LightPanel> panels;
};

void row(Tables& tables, const std::string& what, const std::string& scene, const std::string& subject, double seconds, const PointErrors& e) {
    fmt::print("{:7} {:6} {:34} {:11.3e} s  rms error {:8.1e}  worst {:8.1e}  disagree {:.5f}\n", what, scene, subject, seconds, e.rms, e.worst, e.disagree);
    std::fflush(stdout);
    tables.csv += fmt::format("{},{},{},{},{},{},{}\n", what, scene, subject, seconds, e.rms, e.worst, e.disagree);
}

// The line of the plot with that name.
LightLine& line_of(LightPanel& panel, const std::string& name) {
    for (LightLine& line : panel.lines)
        if (line.name == name) return line;
    panel.lines.push_back({name, {}, {}, 0});
    return panel.lines.back();
}

Result<void> points(const BenchScene& scene, const AccuracyOptions& options, const std::string& folder, Tables& tables) {
    const auto program = compile(scene.solid);
    if (!program) return tl::unexpected<Error>(program.error());
    const std::vector<Ray> rays = camera_rays(scene, 640, 480), few = camera_rays(scene, 64, 48);
    std::vector<double> truth;
    for (const Ray& r : few) truth.push_back(true_t(scene.name, r));
    std::vector<Subject> subjects = whittle_subjects(*program, Query::kFirst);
    const std::size_t ours = subjects.size();
    for (const double tolerance : options.tolerances) {
        if (scene.name != "ball" && tolerance < options.finest_cut) continue;
        for (Subject& s : embree_subjects(scene, peer_mesh(scene, tolerance), Query::kFirst, true)) subjects.push_back(std::move(s));
    }
    std::vector<PointErrors> errors;
    for (const Subject& s : subjects) errors.push_back(errors_of(truth, answers_of(s, few)));
    const std::vector<Subject> pov = povray_subjects(scene, folder);
    if (!pov.empty()) {
        const std::vector<double> distances = povray_distances(scene, few, folder);
        subjects.push_back(pov[0]);
        errors.push_back(distances.empty() ? PointErrors{} : errors_of(truth, distances));
    }
    const std::vector<Lap> laps = race(subjects, rays, options.race);
    LightPanel panel{scene.name + ": the visible point", {}};
    for (std::size_t i = 0; i < laps.size(); ++i) {
        row(tables, "point", scene.name, laps[i].name, 1e-6 / laps[i].median, errors[i]);
        const std::string name = i < ours ? laps[i].name : laps[i].name.substr(0, laps[i].name.find(" ("));
        line_of(panel, name).points.push_back({0, 1e-6 / laps[i].median, errors[i].rms});
    }
    tables.panels.push_back(std::move(panel));
    return {};
}

Result<void> volumes(const BenchScene& scene, double truth, const AccuracyOptions& options, Tables& tables) {
    LightPanel panel{scene.name + ": volume", {}};
    const double compiling = process_seconds();
    const auto program = compile(scene.solid);
    if (!program) return tl::unexpected<Error>(program.error());
    const double compiled = process_seconds() - compiling;
    for (const int lines : options.lines) {
        MeasureOptions how;
        how.lines = static_cast<std::uint64_t>(lines);
        const double begin = process_seconds();
        const auto measured = measure(scene.solid, **program, how);
        if (!measured) return tl::unexpected<Error>(measured.error());
        const double seconds = process_seconds() - begin + compiled, error = std::abs(measured->volume.value / truth - 1);
        row(tables, "volume", scene.name, fmt::format("chords along {} lines", lines), seconds, {error, measured->volume.error / truth, 0});
        line_of(panel, "chords").points.push_back({lines, seconds, error});
    }
    for (const double tolerance : options.tolerances) {
        if (scene.name != "ball" && tolerance < options.finest_cut) continue;
        MeshOptions how;
        how.tolerance_mm = tolerance;
        MeshControl control;
        const double begin = process_seconds();
        const auto made = mesh_solid(scene.solid, how, control);
        if (!made) return tl::unexpected<Error>(made.error());
        const double error = std::abs(mass_properties(made->mesh).volume / truth - 1), seconds = process_seconds() - begin;
        row(tables, "volume", scene.name, fmt::format("mesh at {:g}, {} triangles", tolerance, made->mesh.triangles.size()), seconds, {error, error, 0});
        line_of(panel, "mesh").points.push_back({0, seconds, error});
    }
    tables.panels.push_back(std::move(panel));
    return {};
}

}  // namespace

int measure_accuracy(const AccuracyOptions& options) {
    const ScratchFolder folder;
    if (folder.path().empty()) {
        fmt::print(stderr, "cannot make a folder for the peers' files\n");
        return 3;
    }
    fmt::print("{}\n", about_this_run());
    Tables tables;
    const BenchScene ball = ball_scene(), cut = *make_scene("S1"), plate = *make_scene("S2");
    Result<void> done = points(ball, options, folder.path(), tables);
    if (done) done = points(cut, options, folder.path(), tables);
    if (done) done = volumes(ball, 4 * kPi / 3, options, tables);
    // 100 holes, 0.7 deep above the bore of 0.3.
    if (done) done = volumes(plate, 100 - 100 * kPi * (0.3 * 0.3 * 0.7 + 0.42 * 0.42 * 0.3), options, tables);
    if (!done) {
        fmt::print(stderr, "{}\n", done.error().message);
        return 1;
    }
    const auto written = [](const std::string& path, const std::string& text) { return path.empty() || (std::ofstream(path) << text).good(); };
    return written(options.csv, tables.csv) && written(options.svg, light_plot(tables.panels, "CPU seconds; up: error")) ? 0 : 3;
}

}  // namespace whittle::bench
