// light.h — pictures: processor time against error, an integrator, a sampler and a number of samples a row.
#pragma once

#include <string>
#include <vector>

namespace whittle::bench {

struct LightOptions {
    std::string folder = "examples";  // of the scenes
    std::vector<std::string> scenes{"carved_cube", "bearing", "glass_of_water", "lens", "lattice", "castle", "mug", "chain"};
    std::vector<std::string> integrators{"whitted", "distributed", "path"};
    std::vector<std::string> samplers{"sobol", "stratified", "independent"};
    std::string against;  // the integrator whose converged picture is every row's reference; empty: each its own
    int width = 96, height = 72;
    int most_samples = 64;         // 1, 4, 16 ... up to this
    int reference_samples = 1024;  // of each integrator's own reference, with another seed
    std::string csv, svg;
};

// One thread and its own processor time. The error is the root of the mean square difference of linear radiance, clipped at white, from the picture at
// `reference_samples` of the integrator itself, or of `against`; `bias` is that picture's distance from the path tracer's. Prints a table; returns the
// program's exit code.
int time_light(const LightOptions& options);

}  // namespace whittle::bench
