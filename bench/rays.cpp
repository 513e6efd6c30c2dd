// rays.cpp — scenes x kinds of rays x queries, a race each.
#include "bench/rays.h"

#include <cstdio>
#include <fstream>

#include <fmt/format.h>

#include "bench/child.h"
#include "bench/machine.h"
#include "bench/page_figures.h"
#include "bench/ray_sets.h"

namespace whittle::bench {

namespace {

constexpr const char* kHead = "scene,query,rays,subject,mray_s_median,mray_s_lower,mray_s_upper,first_row_over_this,rays_a_round,hit_share,checksum\n";

Query query_of(const std::string& name) { return name == "first" ? Query::kFirst : name == "any" ? Query::kAny : Query::kSpans; }

// What all rows have gathered.
struct Report {
    std::string csv = kHead, json;
    std::vector<Beside> beside;
};

void print(const std::string& scene, const std::string& query, const std::string& rays, const std::vector<Lap>& laps, Report& report) {
    for (const Lap& lap : laps) {
        const double ratio = laps.front().median / lap.median;
        fmt::print("{:3} {:6} {:11} {:28} {:8.4f} ({:.4f} - {:.4f}) Mray/s  x{:<7.2f} hits {:.4f}  sum {:.9g}  {}\n", scene, query, rays, lap.name, lap.median, lap.lower,
                   lap.upper, ratio, lap.hit_share, lap.checksum, lap.note);
        report.csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", scene, query, rays, lap.name, lap.median, lap.lower, lap.upper, ratio, lap.rays, lap.hit_share,
                                  lap.checksum);
        report.json += fmt::format("{}{{\"scene\":\"{}\",\"query\":\"{} {}\",\"program\":\"{}\",\"value\":{},\"lower\":{},\"upper\":{},\"unit\":\"Mray/s\",\"ratio\":{}}}",
                                   report.json.empty() ? "" : ",\n", scene, query, rays, lap.name, lap.median, lap.lower, lap.upper, ratio);
        if (const auto page = query == "first" ? page_figure(scene, rays, lap.name) : std::nullopt) report.beside.push_back({*page, lap.median});
    }
    std::fflush(stdout);
}

Result<void> time_scene(const BenchScene& scene, const RaysOptions& options, const std::string& folder, Report& report) {
    EngineOptions engine;
    engine.disabled_passes = options.disabled;
    const auto program = compile(scene.solid, engine);
    if (!program) return tl::unexpected<Error>(program.error());
    const bool peers = options.only.find("whittle") == std::string::npos;
    const PeerMesh mesh = peers && options.only.find("pov") == std::string::npos ? peer_mesh(scene) : PeerMesh{};
    for (const std::string& kind : options.rays) {
        const bool coherent = kind == "camera";
        const std::vector<Ray> rays = coherent ? camera_rays(scene, 640, 480) : incoherent_rays(scene, 400 * kBatch);
        for (const std::string& query : options.queries) {
            std::vector<Subject> subjects = whittle_subjects(*program, query_of(query));
            if (subjects.size() == 2 && sum_of_some(subjects[0], rays) != sum_of_some(subjects[1], rays))
                return tl::unexpected<Error>(Error{Fault::kWorld, fmt::format("{}, {} {}: packets and single rays do not agree", scene.name, kind, query)});
            const auto add = [&](std::vector<Subject> more) { std::move(more.begin(), more.end(), std::back_inserter(subjects)); };
            if (peers) add(embree_subjects(scene, mesh, query_of(query), coherent));
            if (peers && coherent && query == "first" && options.only.find("embree") == std::string::npos) add(povray_subjects(scene, folder));
            std::erase_if(subjects, [&](const Subject& s) { return s.name.find(options.only) == std::string::npos; });
            if (!subjects.empty()) print(scene.name, query, kind, race(subjects, rays, options.race), report);
        }
    }
    return {};
}

Result<void> time_file(const std::string& path, bool faceted, const RaysOptions& options, const std::string& folder, Report& report) {
    Result<BenchScene> scene = file_scene(path, faceted);
    if (!scene) return tl::unexpected<Error>(scene.error());
    const auto slash = path.rfind('/');
    scene->name = path.substr(slash == std::string::npos ? 0 : slash + 1) + (faceted ? " in facets" : "");
    return time_scene(*scene, options, folder, report);
}

Result<void> time_all(const RaysOptions& options, const std::string& folder, Report& report) {
    for (const std::string& path : options.files)
        for (const bool faceted : {false, true})
            if (options.twins || faceted == options.faceted)
                if (auto done = time_file(path, faceted, options, folder, report); !done) return done;
    if (!options.files.empty()) return {};
    for (const std::string& name : options.scenes)
        if (auto done = time_scene(*make_scene(name), options, folder, report); !done) return done;
    return {};
}

bool written(const std::string& path, const std::string& text) { return path.empty() || (std::ofstream(path) << text).good(); }

}  // namespace

int time_rays(const RaysOptions& options) {
    const ScratchFolder folder;
    if (folder.path().empty()) {
        fmt::print(stderr, "cannot make a folder for the peers' files\n");
        return 3;
    }
    Report report;
    fmt::print("{}\n", about_this_run());
    const Result<void> done = time_all(options, folder.path(), report);
    if (!done) {
        fmt::print(stderr, "{}\n", done.error().message);
        return 1;
    }
    if (!report.beside.empty())
        fmt::print("\nPeers beside the prototypes' page (another machine; * under 80 % of it relative to the others)\n{}", beside_the_page(report.beside));
    return written(options.csv, report.csv) && written(options.json, json_of_run(report.json)) ? 0 : 3;
}

}  // namespace whittle::bench
