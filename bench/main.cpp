// main.cpp — whittle-bench: times the engine against its peers, in one run.
//
//     whittle-bench rays [--scenes S1,S2] [--queries first,any,spans] [--rounds 7] [--seconds 0.25] [--csv FILE]
//     whittle-bench program [--program PATH] [--examples FOLDER] [--rounds 7]
//
// One thread, its own processor time, alternating rounds. A row shows million rays a second (median and quartiles over the rounds) and the ratio to
// the first row of its group, which is the engine's.
#include <cstdio>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/program.h"
#include "bench/race.h"
#include "bench/ray_sets.h"

using namespace whittle;
using namespace whittle::bench;

namespace {

struct Choice {
    std::vector<std::string> scenes = scene_names();
    std::vector<std::string> queries{"first", "any", "spans"};
    std::vector<std::string> rays{"camera", "incoherent"};
    std::string only;
    RaceOptions race;
    std::string csv;
};

Query query_of(const std::string& name) { return name == "first" ? Query::kFirst : name == "any" ? Query::kAny : Query::kSpans; }

std::string print(const std::string& scene, const std::string& query, const std::string& rays, const std::vector<Lap>& laps) {
    std::string lines;
    for (const Lap& lap : laps) {
        const double ratio = laps.front().median / lap.median;
        fmt::print("{:3} {:6} {:11} {:28} {:8.3f} ({:.3f} - {:.3f}) Mray/s  x{:<7.2f} hits {:.4f}  sum {:.9g}  {}\n", scene, query, rays, lap.name, lap.median, lap.lower,
                   lap.upper, ratio, lap.hit_share, lap.checksum, lap.note);
        lines += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", scene, query, rays, lap.name, lap.median, lap.lower, lap.upper, ratio, lap.rays, lap.hit_share,
                             lap.checksum);
    }
    std::fflush(stdout);
    return lines;
}

int time_rays(const Choice& choice) {
    std::string lines = "scene,query,rays,subject,mray_s_median,mray_s_lower,mray_s_upper,first_row_over_this,rays_a_round,hit_share,checksum\n";
    for (const std::string& name : choice.scenes) {
        const BenchScene scene = make_scene(name);
        for (const std::string& kind : choice.rays) {
            const bool coherent = kind == "camera";
            const std::vector<Ray> rays = coherent ? camera_rays(scene, 640, 480) : incoherent_rays(scene, 400 * kBatch);
            for (const std::string& query : choice.queries) {
                Result<std::vector<Subject>> subjects = whittle_subjects(scene, query_of(query));
                if (!subjects) {
                    fmt::print(stderr, "{}: {}\n", name, subjects.error().message);
                    return 1;
                }
                const bool peers = choice.only.find("whittle") == std::string::npos;
                if (peers)
                    for (Subject& peer : embree_subjects(scene, query_of(query), coherent)) subjects->push_back(std::move(peer));
                std::erase_if(*subjects, [&](const Subject& s) { return s.name.find(choice.only) == std::string::npos; });
                if (subjects->empty()) continue;
                lines += print(name, query, kind, race(*subjects, rays, choice.race));
            }
        }
    }
    if (choice.csv.empty()) return 0;
    std::ofstream out(choice.csv);
    out << lines;
    return out ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Times the engine against its peers."};
    Choice choice;
    CLI::App* rays = app.add_subcommand("rays", "rays through solids");
    rays->add_option("--scenes", choice.scenes, "of S1 ... S6")->delimiter(',')->check(CLI::IsMember(scene_names()));
    rays->add_option("--queries", choice.queries, "of first, any, spans")->delimiter(',')->check(CLI::IsMember({"first", "any", "spans"}));
    rays->add_option("--rays", choice.rays, "of camera, incoherent")->delimiter(',')->check(CLI::IsMember({"camera", "incoherent"}));
    rays->add_option("--only", choice.only, "subjects whose name holds this");
    rays->add_option("--rounds", choice.race.rounds, "alternating rounds")->check(CLI::Range(1, 1000));
    rays->add_option("--seconds", choice.race.seconds_a_round, "of one subject in a round, about")->check(CLI::PositiveNumber);
    rays->add_option("--csv", choice.csv, "also write the rows here");
    CLI::App* program = app.add_subcommand("program", "the program itself: start, picture, a ray in a plate of holes");
    ProgramOptions whole{"whittle", "examples", 7};
    program->add_option("--program", whole.program, "path of whittle");
    program->add_option("--examples", whole.examples, "folder of the examples");
    program->add_option("--rounds", whole.rounds, "runs of each")->check(CLI::Range(1, 1000));
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    if (program->parsed()) return time_program(whole);
    return time_rays(choice);
}
