// race.h — subjects timed against each other: alternating rounds in one run, the thread's own processor time.
#pragma once

#include <cstdint>
#include <span>

#include "bench/subject.h"

namespace whittle::bench {

struct Lap {
    std::string name;
    double median = 0, lower = 0, upper = 0;  // million rays a second: median and quartiles over the rounds
    double hit_share = 0;
    double checksum = 0;       // over the t, normal and surface of every ray timed, summed inside the timing
    std::size_t rays = 0;      // a round; slow subjects get every n-th batch
    std::string note;
};

struct RaceOptions {
    int rounds = 7;
    double seconds_a_round = 0.25;  // for one subject, about
};

// The sums of all answers to one batch of 8 (at least one), untimed: equal for subjects that should agree.
double sum_of_some(const Subject& subject, const std::vector<Ray>& rays);

// Requires: rays.size() is a multiple of kBatch.
std::vector<Lap> race(const std::vector<Subject>& subjects, const std::vector<Ray>& rays, const RaceOptions& options);

}  // namespace whittle::bench
