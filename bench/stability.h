// stability.h — whittle-bench stability: how far answers are from the truth as scenes become small, far, thin, grazed, deep or skewed.
#pragma once

#include <string>

namespace whittle::bench {

struct StabilityOptions {
    int rays = 2000;        // a row
    std::string csv;        // rows are also written here
    std::string cases_dir;  // scenes, rays and true first hits are written here, for programs that this one cannot call
};

// Prints the tables. 0, or 1 where Whittle lost a border or one is beyond its bound, or 3 where a file cannot be written.
int measure_stability(const StabilityOptions& options);

}  // namespace whittle::bench
