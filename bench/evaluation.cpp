#include "bench/evaluation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace whittle::bench {
namespace {

struct Cost {
    double seconds = INFINITY;  // least
    long kilobytes = 0;
    bool ran = false;
};

// One run of `program -o OUT SCRIPT`, all it says thrown away.
Cost run(const std::string& program, const std::string& out, const std::string& script) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::string words[] = {program, "-o", out, script};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    pid_t child = 0;
    const bool started = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    rusage usage{};
    int status = 0;
    if (!started || wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) == 127) return {};
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss, true};
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

}  // namespace

int time_evaluation(const EvaluationOptions& options) {
    std::vector<fs::path> scripts;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(options.scripts, ignored))
        if (entry.path().extension() == ".scad") scripts.push_back(entry.path());
    std::sort(scripts.begin(), scripts.end());
    std::string folder = (fs::temp_directory_path(ignored) / "whittle-bench-XXXXXX").string();
    if (scripts.empty() || !mkdtemp(folder.data())) {
        fmt::print(stderr, "no scripts in '{}', or no folder for answers\n", options.scripts);
        return 3;
    }
    const fs::path ours = fs::path(folder) / "ours.echo", theirs = fs::path(folder) / "theirs.echo";
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
    fs::remove_all(folder, ignored);
    if (!options.csv.empty() && !(std::ofstream(options.csv) << lines)) return 3;
    if (!all_ran) fmt::print(stderr, "a program did not run: '{}', '{}'\n", options.whittle, options.openscad);
    return all_ran ? 0 : 3;
}

}  // namespace whittle::bench
