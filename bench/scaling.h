// scaling.h — whittle-bench scaling: what grows with the number of primitives, and what two threads do to each other.
#pragma once

#include <string>
#include <vector>

namespace whittle::bench {

struct ScalingOptions {
    std::vector<std::string> families{"plate25,plate100,plate400,plate2500,plate10000", "balls100,balls1000,balls10000,balls100000,balls1000000",
                                      "instances1000,instances10000,instances100000,instances1000000", "mesh10000,mesh100000,mesh1000000"};
    std::vector<std::string> threads{"S1", "S2", "S3", "S6", "balls100000"};  // scenes for two threads against two processes
    int rounds = 7;
    double seconds = 0.2;  // of one subject in a round, about
    std::string csv;
};

// One row a scene: processor seconds of compile(), bytes that the program keeps and needs at most while it is made (a primitive), time a ray and how it grew
// from the family's first scene; all scenes of a family alternate. Then two threads on one program against two processes with one thread each.
// Prints tables; returns the program's exit code.
int measure_scaling(const ScalingOptions& options);

}  // namespace whittle::bench
