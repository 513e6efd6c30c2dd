// scaling.cpp — families of scenes from small to large; two threads against two processes.
#include "bench/scaling.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/race.h"
#include "bench/ray_sets.h"
#include "bench/two_workers.h"

namespace whittle::bench {

namespace {

struct Built {
    std::shared_ptr<const Program> program;
    double seconds = 0, kept = 0, peak = 0, primitives = 1;
    std::vector<Ray> camera, incoherent;
    std::string name;
};

Result<Built> built(const std::string& name) {
    const BenchScene scene = *make_scene(name);
    Built b;
    b.name = name;
    b.primitives = scene.primitives;
    const std::size_t held = bytes_held();
    const bool peak_known = reset_peak();
    const std::size_t resident = peak_bytes();
    const double begin = process_seconds();
    auto program = compile(scene.solid);
    b.seconds = process_seconds() - begin;
    if (!program) return tl::unexpected<Error>(program.error());
    b.program = std::move(*program);
    b.kept = static_cast<double>(bytes_held()) - static_cast<double>(held);
    b.peak = peak_known ? static_cast<double>(peak_bytes()) - static_cast<double>(resident) : NAN;
    b.camera = camera_rays(scene, 640, 480);
    b.incoherent = incoherent_rays(scene, 100 * kBatch);
    return b;
}

// Several subjects with rays of their own in one race: each answers its own batches, evenly spread, for about `seconds`.
Subject on_own_rays(const Built& b, const Subject& subject, const std::vector<Ray>& rays, double seconds) {
    Subject own;
    own.name = b.name;
    const auto answers = std::make_shared<Answers>();
    const auto set = std::make_shared<const RaySet>(rays);
    own.own_round = [subject, set, seconds, answers] {
        const double begin = process_seconds();
        std::size_t done = 0;
        // A step that shares no factor with the number of batches visits all before one comes twice.
        do subject.run(set->batch(done * 769 % set->batches()), *answers);
        while (++done < 8 || process_seconds() - begin < seconds);
        return OwnRound{static_cast<double>(done * kBatch), process_seconds() - begin};
    };
    return own;
}

std::vector<Lap> race_of(const std::vector<Built>& family, bool camera, const ScalingOptions& options) {
    std::vector<Subject> subjects;
    for (const Built& b : family) subjects.push_back(on_own_rays(b, whittle_subjects(b.program, Query::kFirst)[camera ? 0 : 1], camera ? b.camera : b.incoherent, options.seconds));
    RaceOptions race_options;
    race_options.rounds = options.rounds;
    return race(subjects, family.front().camera, race_options);
}

Result<std::string> measured(const std::string& names, const ScalingOptions& options) {
    std::vector<Built> family;
    std::stringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        auto one = built(name);
        if (!one) return tl::unexpected<Error>(one.error());
        family.push_back(std::move(*one));
    }
    const std::vector<Lap> camera = race_of(family, true, options), alone = race_of(family, false, options);
    std::string rows;
    for (std::size_t i = 0; i < family.size(); ++i) {
        const Built& b = family[i];
        const double growth = camera[0].median / camera[i].median, alone_growth = alone[0].median / alone[i].median;
        const double logs = std::log(b.primitives) / std::log(family[0].primitives);
        fmt::print("{:16} compile {:8.3f} s  {:7.0f} B a primitive kept, {:7.0f} at most  camera packets {:8.3f} us ({:.3f} - {:.3f}) x{:<6.2f} incoherent, single {:8.3f} us x{:<6.2f} log N x{:.2f}\n",
                   b.name, b.seconds, b.kept / b.primitives, b.peak / b.primitives, 1 / camera[i].median, 1 / camera[i].upper, 1 / camera[i].lower, growth, 1 / alone[i].median,
                   alone_growth, logs);
        rows += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", b.name, b.primitives, b.seconds, b.kept, b.peak, camera[i].median, growth, alone[i].median, alone_growth, logs);
    }
    std::fflush(stdout);
    return rows;
}

double middle(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

Result<std::string> workers(const std::string& name, const ScalingOptions& options) {
    const auto one = built(name);
    if (!one) return tl::unexpected<Error>(one.error());
    const auto set = std::make_shared<const RaySet>(one->camera);
    const Worker worker = [&]() -> std::function<void()> {
        const Subject subject = whittle_subjects(one->program, Query::kFirst)[0];
        return [subject, set, answers = std::make_shared<Answers>()] {
            for (std::size_t k = 0; k < set->batches(); k += 16) subject.run(set->batch(k), *answers);
        };
    };
    const auto once = worker();
    const double begin = process_seconds();
    once();
    const int pieces = std::max(2, static_cast<int>(options.seconds / (process_seconds() - begin)));
    std::vector<double> cpu, wall;
    for (int round = 0; round < options.rounds; ++round) {
        const WorkerSpeed threads = two_threads(worker, pieces), processes = two_processes(worker, pieces);
        if (processes.by_cpu == 0) return tl::unexpected<Error>(Error{Fault::kWorld, "cannot start two processes"});
        cpu.push_back(threads.by_cpu / processes.by_cpu);
        wall.push_back(threads.by_wall / processes.by_wall);
    }
    fmt::print("{:16} two threads over two processes: by processor time {:.3f} ({:.3f} - {:.3f}), by the clock {:.3f} ({:.3f} - {:.3f})\n", name, middle(cpu, 0.5), middle(cpu, 0.25),
               middle(cpu, 0.75), middle(wall, 0.5), middle(wall, 0.25), middle(wall, 0.75));
    std::fflush(stdout);
    return fmt::format("{},threads_over_processes,{},{}\n", name, middle(cpu, 0.5), middle(wall, 0.5));
}

}  // namespace

int measure_scaling(const ScalingOptions& options) {
    fmt::print("{}\n", about_this_run());
    std::string csv = "scene,primitives,compile_s,bytes_kept,bytes_peak,camera_mray_s,camera_growth,incoherent_mray_s,incoherent_growth,log_growth\n";
    for (const auto* list : {&options.families, &options.threads})
        for (const std::string& name : *list) {
            const auto rows = list == &options.families ? measured(name, options) : workers(name, options);
            if (!rows) {
                fmt::print(stderr, "{}\n", rows.error().message);
                return 1;
            }
            csv += *rows;
        }
    return options.csv.empty() || std::ofstream(options.csv) << csv ? 0 : 3;
}

}  // namespace whittle::bench
