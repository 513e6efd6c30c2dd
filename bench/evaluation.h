// evaluation.h — how fast scripts are evaluated: the whittle program against the openscad program, both started anew, in one run.
#pragma once

#include <string>

namespace whittle::bench {

struct EvaluationOptions {
    std::string scripts = "bench/evaluation";  // every .scad in this folder
    std::string whittle = "whittle", openscad = "openscad";
    int rounds = 5;
    std::string csv;
};

// Prints a row a script: processor time (user and system, least of the rounds, which alternate), largest resident memory, the ratio, and whether the messages
// are the same; then the geometric mean of the ratios, and what a node of the scene takes in both. Returns an exit code.
int time_evaluation(const EvaluationOptions& options);

}  // namespace whittle::bench
