// program.cpp — see program.h.
#include "bench/program.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "bench/child.h"

namespace whittle::bench {

namespace {

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

bool time_row(const ProgramOptions& options, const char* what, const char* goal, const std::vector<std::string>& words) {
    std::vector<double> wall, cpu;
    for (int i = 0; i < options.rounds; ++i) {
        const ChildRun run = run_child(words);
        if (!run.good) {
            fmt::print(stderr, "{}: '{}' failed\n", what, fmt::join(words, " "));
            return false;
        }
        wall.push_back(run.wall_s);
        cpu.push_back(run.cpu_s());
    }
    fmt::print("{:34} wall {:8.2f} ms  cpu {:8.2f} ms  goal {}\n", what, 1e3 * median(wall), 1e3 * median(cpu), goal);
    std::fflush(stdout);
    return true;
}

// A counter of the --stats file.
double counter(const std::string& stats, const std::string& name) {
    const auto at = stats.find('"' + name + "\": ");
    return at == std::string::npos ? 0 : std::strtod(stats.c_str() + at + name.size() + 4, nullptr);
}

// Microseconds a ray, camera and shadow, on one thread; 0 where it failed.
double ray_us(const ProgramOptions& options, const std::string& scene, const std::filesystem::path& folder) {
    const std::string stats = (folder / "stats.json").string();
    std::vector<double> each;
    for (int i = 0; i < options.rounds; ++i) {
        if (!run_child({options.program, "render", scene, "-o", (folder / "ray.png").string(), "--imgsize", "640,480", "--samples", "4", "--threads", "1", "--stats", stats}).good)
            return 0;
        std::ifstream in(stats);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        each.push_back(1e6 * counter(text, "seconds.render") / std::max(1.0, counter(text, "rays.camera") + counter(text, "rays.shadow")));
    }
    return median(each);
}

constexpr const char* kPlate = "difference() {\n    cube([110, 110, 8]);\n    for (x = [10 : 10 : 100], y = [10 : 10 : 100]) translate([x, y, -1]) cylinder(h = 10, r = 3);\n}\n";

bool time_all(const ProgramOptions& options, const std::filesystem::path& folder) {
    const std::string& program = options.program;
    const std::string cube = options.examples + "/carved_cube.scad", picture = (folder / "a.png").string(), plate = (folder / "plate.scad").string();
    std::ofstream(plate) << kPlate;
    if (!time_row(options, "--help", "10 ms", {program, "--help"})) return false;
    if (!time_row(options, "spans, one ray", "10 ms", {program, "spans", cube, "--ray=-100,1,2,1,0,0"})) return false;
    for (const char* samples : {"1", "4", "16"})
        if (!time_row(options, fmt::format("carved cube 640x480, {} samples", samples).c_str(), "300 ms on 2 cores",
                      {program, "render", cube, "-o", picture, "--imgsize", "640,480", "--samples", samples}))
            return false;
    const double one = ray_us(options, cube, folder), hundred = ray_us(options, plate, folder);
    if (one == 0 || hundred == 0) return false;
    fmt::print("a ray: carved cube {:.3f} us, plate of 100 holes {:.3f} us: x{:.2f}  goal x3\n", one, hundred, hundred / one);
    return true;
}

}  // namespace

int time_program(const ProgramOptions& options) {
    const ScratchFolder folder;
    if (folder.path().empty()) {
        fmt::print(stderr, "cannot make a folder for the pictures\n");
        return 3;
    }
    return time_all(options, folder.path()) ? 0 : 3;
}

}  // namespace whittle::bench
