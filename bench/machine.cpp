#include "bench/machine.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "bench_commit.h"

namespace whittle::bench {

namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string machine() { return fmt::format("{}, {} cores", processor(), std::thread::hardware_concurrency()); }

}  // namespace

std::string about_this_run() {
    double load = 0;
    ::getloadavg(&load, 1);
    return fmt::format("{}, load {:.1f}; commit {}", machine(), load, WHITTLE_BENCH_COMMIT);
}

std::string json_of_run(const std::string& rows) {
    return fmt::format("{{\"machine\":\"{}\",\"commit\":\"{}\",\"rows\":[{}]}}\n", machine(), WHITTLE_BENCH_COMMIT, rows);
}

double process_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace whittle::bench
