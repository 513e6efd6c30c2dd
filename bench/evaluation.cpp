#include "bench/evaluation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "bench/child.h"

namespace fs = std::filesystem;

namespace whittle::bench {
namespace {

struct Cost {
    double seconds = INFINITY;  // least
    long kilobytes = 0;
    bool ran = false;
};

// One run of `program -o OUT SCRIPT`.
Cost run(const std::string& program, const std::string& out, const std::string& script) {
    const ChildRun run = run_child({program, "-o", out, script}, "/dev/null", {0, 1});
    return run.good ? Cost{run.cpu_s(), run.kilobytes, true} : Cost{};
}

void keep_least(Cost& best, const Cost& cost) {
    best.ran = cost.ran;
    best.seconds = std::min(best.seconds, cost.seconds);
    best.kilobytes = std::max(best.kilobytes, cost.kilobytes);
}

std::string text_of(const fs::path& path) {
    std::stringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

// What one cube of many takes: the largest resident memory of a run that makes 160,000 less that of a run that makes one; negative where a run failed.
double bytes_a_node(const std::string& program, const fs::path& folder) {
    constexpr int kSide = 400;
    const fs::path script = folder / "cubes.scad";
    double kilobytes[2];
    for (const int side : {1, kSide}) {
        std::ofstream(script) << fmt::format("for (i = [1 : {0}], j = [1 : {0}]) cube(i + j);\n", side);
        const Cost cost = run(program, folder / "cubes.echo", script);
        if (!cost.ran) return -1;
        kilobytes[side > 1] = static_cast<double>(cost.kilobytes);
    }
    return (kilobytes[1] - kilobytes[0]) * 1024 / (kSide * kSide - 1);
}

}  // namespace

int time_evaluation(const EvaluationOptions& options) {
    std::vector<fs::path> scripts;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(options.scripts, ignored))
        if (entry.path().extension() == ".scad") scripts.push_back(entry.path());
    std::sort(scripts.begin(), scripts.end());
    const ScratchFolder folder;
    if (scripts.empty() || folder.path().empty()) {
        fmt::print(stderr, "no scripts in '{}', or no folder for answers\n", options.scripts);
        return 3;
    }
    const fs::path ours = fs::path(folder.path()) / "ours.echo", theirs = fs::path(folder.path()) / "theirs.echo";
    std::string lines = "script,whittle_s,openscad_s,ratio,whittle_kb,openscad_kb,same\n";
    double logs = 0;
    bool all_ran = true;
    for (const fs::path& script : scripts) {
        Cost whittle, openscad;
        for (int round = 0; round < options.rounds; ++round) {
            keep_least(whittle, run(options.whittle, ours, script));
            keep_least(openscad, run(options.openscad, theirs, script));
        }
        all_ran = all_ran && whittle.ran && openscad.ran;
        const double ratio = openscad.seconds / whittle.seconds;
        const bool same = text_of(ours) == text_of(theirs);
        logs += std::log(ratio);
        fmt::print("{:14} whittle {:7.3f} s {:5d} MB   openscad {:7.3f} s {:5d} MB   x{:<6.1f} {}\n", script.stem().string(), whittle.seconds, whittle.kilobytes / 1024,
                   openscad.seconds, openscad.kilobytes / 1024, ratio, same ? "same messages" : "other messages");
        std::fflush(stdout);
        lines += fmt::format("{},{},{},{},{},{},{}\n", script.stem().string(), whittle.seconds, openscad.seconds, ratio, whittle.kilobytes, openscad.kilobytes, same);
    }
    fmt::print("geometric mean x{:.1f}\n", std::exp(logs / static_cast<double>(scripts.size())));
    fmt::print("a scene node: whittle {:.0f} bytes, openscad {:.0f} bytes\n", bytes_a_node(options.whittle, folder.path()), bytes_a_node(options.openscad, folder.path()));
    if (!options.csv.empty() && !(std::ofstream(options.csv) << lines)) return 3;
    if (!all_ran) fmt::print(stderr, "a program did not run: '{}', '{}'\n", options.whittle, options.openscad);
    return all_ran ? 0 : 3;
}

}  // namespace whittle::bench
