// accuracy.h — whittle-bench accuracy: run time against error, for solids whose answers are known.
//
// Points: time of a camera ray against the root mean square error of the visible point, for a ball and for S1, whose crossings binary128 gives. Volumes: time of a volume
// against its error, by the quadrature of chords and by meshes. Pictures are `whittle-bench light`.
#pragma once

#include <string>
#include <vector>

#include "bench/race.h"

namespace whittle::bench {

struct AccuracyOptions {
    std::vector<double> tolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5};  // chord errors of meshes, of the radius
    double finest_cut = 1e-4;                                      // finest of them for solids that need booleans
    std::vector<int> lines{1000, 10'000, 100'000, 1'000'000};      // of a quadrature
    RaceOptions race{5, 0.1};
    std::string csv, svg;
};

// Prints tables; returns the program's exit code.
int measure_accuracy(const AccuracyOptions& options);

}  // namespace whittle::bench
