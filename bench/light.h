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
    int width = 96, height = 72;
    int most_samples = 64;         // 1, 4, 16 ... up to this
    int reference_samples = 1024;  // of each integrator's own reference, with another seed
    std::string csv, svg;
};

// One thread and its own processor time. The error is the root of the mean square difference of linear radiance, clipped at white, from the integrator's own
// picture at `reference_samples`; `bias` is that picture's distance from the path tracer's. Prints a table; returns the program's exit code.
int time_light(const LightOptions& options);

}  // namespace whittle::bench
