// machine.h — where and of what a measurement is: printed above every table; and what it costs.
#pragma once

#include <string>

namespace whittle::bench {

// "AMD EPYC ..., 2 cores, load 1.2; commit abc1234".
std::string about_this_run();

// {"machine":..,"commit":..,"rows":[ROWS]}
std::string json_of_run(const std::string& rows);

// Processor time of all threads so far, in seconds.
double process_seconds();

}  // namespace whittle::bench
