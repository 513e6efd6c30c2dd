#include "bench/two_workers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace whittle::bench {

namespace {

struct Spent {
    double cpu_s = 0, wall_s = 0;
};

Spent run(const std::function<void()>& work, int pieces) {
    const auto cpu_now = [] {
        timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    };
    const double cpu = cpu_now();
    const auto wall = std::chrono::steady_clock::now();
    for (int i = 0; i < pieces; ++i) work();
    return {cpu_now() - cpu, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count()};
}

WorkerSpeed of(const std::array<Spent, 2>& spent, int pieces) {
    return {pieces / spent[0].cpu_s + pieces / spent[1].cpu_s, 2 * pieces / std::max(spent[0].wall_s, spent[1].wall_s)};
}

}  // namespace

WorkerSpeed two_threads(const Worker& worker, int pieces) {
    std::array<Spent, 2> spent;
    std::array<std::thread, 2> threads;
    std::atomic<int> ready = 0;
    for (std::size_t i = 0; i < 2; ++i)
        threads[i] = std::thread([&, i] {
            const auto work = worker();
            work();
            for (++ready; ready < 2;) std::this_thread::yield();
            spent[i] = run(work, pieces);
        });
    for (std::thread& t : threads) t.join();
    return of(spent, pieces);
}

WorkerSpeed two_processes(const Worker& worker, int pieces) {
    std::array<Spent, 2> spent{};
    std::array<int, 2> results{}, go{};
    if (::pipe(results.data()) != 0 || ::pipe(go.data()) != 0) return {};
    std::array<pid_t, 2> children{};
    for (pid_t& child : children) {
        child = ::fork();
        if (child != 0) continue;
        // Both have warmed up when the parent lets them go.
        const auto work = worker();
        work();
        char word = 1;
        if (::write(results[1], &word, 1) != 1 || ::read(go[0], &word, 1) != 1) ::_exit(1);
        const Spent mine = run(work, pieces);
        ::_exit(::write(results[1], &mine, sizeof mine) == sizeof mine ? 0 : 1);
    }
    char words[2] = {};
    bool good = std::all_of(children.begin(), children.end(), [](pid_t p) { return p > 0; });
    for (char& word : words) good = good && ::read(results[0], &word, 1) == 1;
    good = ::write(go[1], words, 2) == 2 && good;
    for (Spent& s : spent) good = good && ::read(results[0], &s, sizeof s) == sizeof s;
    for (const int fd : {results[0], results[1], go[0], go[1]}) ::close(fd);
    for (const pid_t child : children)
        if (child > 0) ::waitpid(child, nullptr, 0);
    return good ? of(spent, pieces) : WorkerSpeed{};
}

}  // namespace whittle::bench
