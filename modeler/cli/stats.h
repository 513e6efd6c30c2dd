// stats.h — counters of work done, under the fixed names of docs/command-line; tests and benchmarks read them.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "csg/base/result.h"
#include "tracer/engine/engine.h"

namespace whittle {

class Stats {
public:
    // Every fixed name at 0.
    Stats();
    void set(std::string_view name, double value) { values_[std::string(name)] = value; }
    void add(std::string_view name, double value) { values_[std::string(name)] += value; }
    double get(std::string_view name) const;
    void add(const EngineCounters& counters);
    void set(const BuildReport& report);
    // One JSON object, a counter a line, by name.
    std::string text() const;

private:
    std::map<std::string, double> values_;
};

// Seconds since it was made, or since the last lap().
class Stopwatch {
public:
    Stopwatch();
    double lap();

private:
    double begin_;
};

// Largest resident memory of the process so far, in bytes.
double peak_bytes();

}  // namespace whittle
