// two_workers.h — the same work by two threads of one process, and by two processes: what sharing a program costs.
#pragma once

#include <functional>
#include <vector>

namespace whittle::bench {

struct WorkerSpeed {
    double by_cpu = 0;   // sum over both of work / own processor seconds
    double by_wall = 0;  // work of both / seconds of the slower
};

// `work()` is one piece of it, with memory of its own made by `worker()` in the thread that uses it.
using Worker = std::function<std::function<void()>()>;
WorkerSpeed two_threads(const Worker& worker, int pieces);
// By fork(). Zeros where a child could not be started or failed.
WorkerSpeed two_processes(const Worker& worker, int pieces);

}  // namespace whittle::bench
