// watchdog.h — the thread that waits for Ctrl-C, the time limit and the memory limit while the others work.
//
// SIGINT and SIGTERM are blocked in every thread and read here, so no handler ever runs in the middle of anything. A command that can end early (render)
// asks for the first interrupt by when_interrupted(); the second, and every interrupt of the others, ends the process with 130. The limits end it
// with 3; without a limit of memory the run ends before the system would kill it (memory.h). An ending process removes the temporary files it was writing and leaves what was at their targets.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "modeler/cli/memory.h"

namespace whittle {

struct WatchdogLimits {
    double seconds = 0;  // 0: none
    MemoryLimit memory = MemoryLimit::kSystem;
    std::uint64_t bytes = 0;
};

class Watchdog {
public:
    // Make it before any other thread: the threads made later inherit the blocked signals. `outputs`: the files the command may write.
    Watchdog(WatchdogLimits limits, std::vector<std::string> outputs);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    // True from the first interrupt on.
    const std::atomic<bool>& interrupted() const;
    // `call` is made once, from the watching thread, at the first interrupt (at once if that was before); an empty one gives the interrupts back.
    void when_interrupted(std::function<void()> call);

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Gives the signals back, for a program that is about to be executed in this one's place.
void unblock_signals();

}  // namespace whittle
