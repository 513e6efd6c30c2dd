#include "bench/edits.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "bench/machine.h"
#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"
#include "csg/solid/look_alike.h"
#include "modeler/io/files.h"
#include "tracer/engine/engine.h"

namespace whittle::bench {

namespace {

// A plate less `pins` turned pins in rows of 100, the first of radius `first`; seen from `distance`.
std::string text_of(int pins, double first, double distance) {
    return fmt::format("$vpd = {};\nfirst = {};\ndifference() {{\n    cube([400, {}, 5]);\n    for (j = [0 : {}], i = [0 : 99]) translate([4 * i + 2, 4 * j + 2, 2]) rotate([i % 7, j % 5, 0])\n"
                       "        cylinder(h = 20, r = i + j == 0 ? first : 1, center = true);\n}}\n",
                       distance, first, pins / 25, pins / 100 - 1);
}

struct State {
    Solid solid;
    std::shared_ptr<const Program> program;
};

// Reading, canonicalising, comparing, compiling: seconds.
using Steps = std::array<double, 4>;

// Takes the text in as `render --watch` does: compiled only if the solid does not look as before.
Result<Steps> take_in(const std::string& text, State& state) {
    Files files;
    EvaluateInput input;
    input.path = "edited.scad";
    input.text = text;
    Steps steps{};
    double begin = process_seconds();
    const auto lap = [&] {
        const double now = process_seconds(), spent = now - begin;
        begin = now;
        return spent;
    };
    Result<Evaluated> evaluated = evaluate(input, files);
    if (!evaluated) return tl::unexpected<Error>(evaluated.error());
    if (evaluated->stopped() || !evaluated->diagnostics.all().empty()) return tl::unexpected<Error>(Error{Fault::kScene, "the scene is not read as meant"});
    steps[0] = lap();
    Canonical canonical = canonicalise(evaluated->scene, {}, &files, evaluated->diagnostics);
    steps[1] = lap();
    const bool same = state.program && look_alike(state.solid, canonical.solid);
    steps[2] = lap();
    if (!same) {
        auto program = compile(canonical.solid);
        if (!program) return tl::unexpected<Error>(program.error());
        state = {std::move(canonical.solid), std::move(*program)};
        steps[3] = lap();
    }
    return steps;
}

double middle(std::vector<Steps>& all, std::size_t step) {
    std::sort(all.begin(), all.end(), [&](const Steps& a, const Steps& b) { return a[step] < b[step]; });
    return all[all.size() / 2][step];
}

}  // namespace

int time_edits(const EditOptions& options) {
    fmt::print("{}\n", about_this_run());
    // First, the camera moved, one number changed; each round starts anew.
    const std::array<const char*, 3> names{"first reading", "camera moved", "one radius changed"};
    std::array<std::vector<Steps>, 3> all;
    for (int round = 0; round < options.rounds; ++round) {
        State state;
        const std::array<std::string, 3> texts{text_of(options.primitives, 1, 500), text_of(options.primitives, 1, 700), text_of(options.primitives, 1.1, 700)};
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const Result<Steps> steps = take_in(texts[i], state);
            if (!steps) {
                fmt::print(stderr, "{}\n", steps.error().message);
                return 1;
            }
            all[i].push_back(*steps);
        }
    }
    std::string csv = "edit,read_s,canonicalise_s,compare_s,compile_s\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
        Steps s{};
        for (std::size_t k = 0; k < s.size(); ++k) s[k] = middle(all[i], k);
        fmt::print("{:20} read {:8.2f} ms  canonicalise {:8.2f} ms  compare {:8.2f} ms  compile {:8.2f} ms\n", names[i], 1e3 * s[0], 1e3 * s[1], 1e3 * s[2], 1e3 * s[3]);
        csv += fmt::format("{},{},{},{},{}\n", names[i], s[0], s[1], s[2], s[3]);
    }
    return options.csv.empty() || std::ofstream(options.csv) << csv ? 0 : 3;
}

}  // namespace whittle::bench
