// race.cpp — rounds, medians, quartiles.
#include "bench/race.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <utility>

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

// Of every eighth answer one, so that vectors can add.
void add(const Answers& answers, Sum& sum) {
    constexpr std::size_t kSums = 8;
    std::array<double, kSums> sums{}, hits{};
    for (std::size_t k = 0; k < kBatch; k += kSums)
        for (std::size_t j = 0; j < kSums; ++j) {
            const std::size_t i = k + j;
            const bool met = answers.t[i] >= 0 && answers.t[i] < HUGE_VAL;
            const double all = answers.t[i] + answers.normal[0][i] + answers.normal[1][i] + answers.normal[2][i] + static_cast<double>(answers.surface[i]);
            sums[j] += met ? all : 0;
            hits[j] += met ? 1 : 0;
        }
    for (std::size_t j = 0; j < kSums; ++j) {
        sum.checksum += sums[j];
        sum.hits += static_cast<std::size_t>(hits[j]);
    }
    sum.rays += kBatch;
}

// Every `stride`-th batch. Returns the seconds.
double run(const Subject& subject, const RaySet& rays, std::size_t stride, Answers& answers, Sum& sum) {
    sum = Sum();
    const double begin = thread_seconds();
    for (std::size_t batch = stride / 2; batch < rays.batches(); batch += stride) {
        subject.run(rays.batch(batch), answers);
        add(answers, sum);
    }
    return thread_seconds() - begin;
}

// The share of the batches that keeps a round short: a power of two, so that faster subjects see the same batches and more.
std::size_t stride_for(const Subject& subject, const RaySet& rays, double seconds, Answers& answers) {
    std::size_t stride = 1;
    while (stride * 8 < rays.batches()) stride *= 2;
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

RaySet::RaySet(std::vector<Ray> rays) : rays_(std::move(rays)) {
    for (std::size_t i = 0; i < 6; ++i)
        for (const Ray& ray : rays_) rows_[i].push_back(i < 3 ? ray.origin[static_cast<int>(i)] : ray.direction[static_cast<int>(i - 3)]);
}

Batch RaySet::batch(std::size_t k) const {
    Batch b;
    b.rays = &rays_[k * kBatch];
    for (std::size_t i = 0; i < 3; ++i) b.rows.origin[i] = &rows_[i][k * kBatch], b.rows.direction[i] = &rows_[i + 3][k * kBatch];
    return b;
}

double sum_of_some(const Subject& subject, const std::vector<Ray>& rays) {
    const RaySet set(rays);
    const auto answers = std::make_unique<Answers>();
    Sum sum;
    run(subject, set, std::min<std::size_t>(8, set.batches()), *answers, sum);
    return sum.checksum;
}

std::vector<Lap> race(const std::vector<Subject>& subjects, const std::vector<Ray>& rays, const RaceOptions& options) {
    const RaySet set(rays);
    const auto answers = std::make_unique<Answers>();
    std::vector<std::size_t> strides;
    for (const Subject& s : subjects) strides.push_back(s.own_round ? 1 : stride_for(s, set, options.seconds_a_round, *answers));
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
            const double seconds = run(subjects[i], set, strides[i], *answers, sums[i]);
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
