// race.cpp — rounds, medians, quartiles.
#include "bench/race.h"

#include <algorithm>
#include <ctime>

#include "bench/ray_sets.h"

namespace whittle::bench {

namespace {

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Sum {
    double checksum = 0;
    std::size_t hits = 0, rays = 0;
};

// Every `stride`-th batch. Returns the seconds.
double run(const Subject& subject, const std::vector<Ray>& rays, std::size_t stride, std::vector<Answer>& answers, Sum& sum) {
    sum = Sum();
    const double begin = thread_seconds();
    for (std::size_t batch = stride / 2; batch < rays.size() / kBatch; batch += stride) {
        subject.run(&rays[batch * kBatch], kBatch, answers.data());
        for (const Answer& a : answers)
            if (a.t >= 0) {
                ++sum.hits;
                sum.checksum += a.t + a.normal.x + a.normal.y + a.normal.z + a.surface;
            }
        sum.rays += kBatch;
    }
    return thread_seconds() - begin;
}

// The share of the batches that keeps a round short: a power of two, so that faster subjects see the same batches and more.
std::size_t stride_for(const Subject& subject, const std::vector<Ray>& rays, double seconds, std::vector<Answer>& answers) {
    const std::size_t batches = rays.size() / kBatch;
    std::size_t stride = 1;
    while (stride * 8 < batches) stride *= 2;
    Sum sum;
    while (stride > 1 && 2 * run(subject, rays, stride, answers, sum) < seconds) stride /= 2;
    return stride;
}

double quantile(const std::vector<double>& sorted, double q) {
    const double x = q * static_cast<double>(sorted.size() - 1);
    const auto i = static_cast<std::size_t>(x);
    return i + 1 < sorted.size() ? sorted[i] + (x - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]) : sorted[i];
}

}  // namespace

double sum_of_some(const Subject& subject, const std::vector<Ray>& rays) {
    std::vector<Answer> answers(kBatch);
    Sum sum;
    run(subject, rays, std::min<std::size_t>(8, rays.size() / kBatch), answers, sum);
    return sum.checksum;
}

std::vector<Lap> race(const std::vector<Subject>& subjects, const std::vector<Ray>& rays, const RaceOptions& options) {
    std::vector<Answer> answers(kBatch);
    std::vector<std::size_t> strides;
    for (const Subject& s : subjects) strides.push_back(s.own_round ? 1 : stride_for(s, rays, options.seconds_a_round, answers));
    for (const Subject& s : subjects)
        if (s.note) s.note();
    std::vector<std::vector<double>> speeds(subjects.size());
    std::vector<Sum> sums(subjects.size());
    for (int round = 0; round < options.rounds; ++round)
        for (std::size_t i = 0; i < subjects.size(); ++i) {
            if (subjects[i].own_round) {
                const OwnRound own = subjects[i].own_round();
                sums[i].rays = static_cast<std::size_t>(own.rays);
                sums[i].hits = static_cast<std::size_t>(subjects[i].hit_share * own.rays);
                speeds[i].push_back(1e-6 * own.rays / own.seconds);
                continue;
            }
            const double seconds = run(subjects[i], rays, strides[i], answers, sums[i]);
            speeds[i].push_back(1e-6 * static_cast<double>(sums[i].rays) / seconds);
        }
    std::vector<Lap> laps;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        std::sort(speeds[i].begin(), speeds[i].end());
        laps.push_back({subjects[i].name, quantile(speeds[i], 0.5), quantile(speeds[i], 0.25), quantile(speeds[i], 0.75),
                        static_cast<double>(sums[i].hits) / static_cast<double>(sums[i].rays), sums[i].checksum, sums[i].rays, subjects[i].note ? subjects[i].note() : std::string()});
    }
    return laps;
}

}  // namespace whittle::bench
