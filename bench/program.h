// program.h — times the program as a person runs it: how soon it answers, how long a picture takes, what a ray costs in a plate of many holes.
#pragma once

#include <string>

namespace whittle::bench {

struct ProgramOptions {
    std::string program;   // path of whittle
    std::string examples;  // folder of carved_cube.scad
    int rounds = 7;
};

// Prints a row each: median wall and processor time over the rounds, beside the goal. Returns the exit code: 3 where the program cannot be run.
int time_program(const ProgramOptions& options);

}  // namespace whittle::bench
