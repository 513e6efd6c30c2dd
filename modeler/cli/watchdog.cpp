// watchdog.cpp — signalfd for interrupts, eventfd for the end of the work, poll for both with the time that is left.
#include "modeler/cli/watchdog.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include "csg/base/file.h"
#include "csg/base/result.h"
#include "modeler/cli/memory.h"

namespace whittle {

namespace {

using Clock = std::chrono::steady_clock;

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

}  // namespace

struct Watchdog::State {
    WatchdogLimits limits;
    std::vector<std::string> outputs;
    std::atomic<bool> interrupted{false};
    std::mutex mutex;
    std::function<void()> call;
    int signals = -1, finished = -1;
    Clock::time_point begin = Clock::now();
    std::thread thread;

    std::uint64_t left = 0;  // bytes up to the limit of memory at the last look

    void watch();
    int wait_ms() const;
    void check_limits();
    void check_memory();
    void interrupt();
    [[noreturn]] void quit(Fault fault, const char* message);
};

void Watchdog::State::quit(Fault fault, const char* message) {
    if (message) std::fprintf(stderr, "ERROR: %s\n", message);
    for (const auto& output : outputs) unlink(temporary_name(output).c_str());
    _exit(static_cast<int>(fault));
}

void Watchdog::State::interrupt() {
    const std::lock_guard lock(mutex);
    if (!call || interrupted) quit(Fault::kInterrupted, nullptr);
    interrupted = true;
    call();
}

void Watchdog::State::check_limits() {
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - begin).count();
    if (limits.seconds > 0 && elapsed_s >= limits.seconds) quit(Fault::kWorld, "The time limit is reached (--limit-time)");
    check_memory();
}

void Watchdog::State::check_memory() {
    const std::uint64_t resident = resident_bytes();
    if (limits.memory == MemoryLimit::kBytes) {
        left = limits.bytes > resident ? limits.bytes - resident : 0;
        if (left == 0) quit(Fault::kWorld, "The memory limit is reached (--limit-memory)");
    } else if (limits.memory == MemoryLimit::kSystem) {
        left = memory_left(resident, available_bytes());
        if (left > 0) return;
        const std::string message = "The memory limit is reached: this run holds " + std::to_string(resident >> 20) +
                                    " MB and there is hardly any left (--limit-memory MB sets a limit, --limit-memory none lifts it)";
        quit(Fault::kWorld, message.c_str());
    }
}

int Watchdog::State::wait_ms() const {
    const int for_memory_ms = limits.memory == MemoryLimit::kNone ? -1 : wait_for_memory_ms(left);
    if (limits.seconds <= 0) return for_memory_ms;
    const double left_s = limits.seconds - std::chrono::duration<double>(Clock::now() - begin).count();
    const int for_time_ms = static_cast<int>(std::clamp(std::ceil(left_s * 1000), 0.0, 1e9));
    return for_memory_ms < 0 ? for_time_ms : std::min(for_memory_ms, for_time_ms);
}

void Watchdog::State::watch() {
    while (true) {
        std::array<pollfd, 2> files{pollfd{signals, POLLIN, 0}, pollfd{finished, POLLIN, 0}};
        poll(files.data(), files.size(), wait_ms());
        if (files[1].revents != 0) return;
        check_limits();
        signalfd_siginfo info{};
        if (files[0].revents != 0 && read(signals, &info, sizeof info) == sizeof info) interrupt();
    }
}

Watchdog::Watchdog(WatchdogLimits limits, std::vector<std::string> outputs) : state_(std::make_unique<State>()) {
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    state_->limits = limits;
    state_->outputs = std::move(outputs);
    state_->signals = signalfd(-1, &set, SFD_CLOEXEC);
    state_->finished = eventfd(0, EFD_CLOEXEC);
    state_->thread = std::thread([state = state_.get()] { state->watch(); });
}

Watchdog::~Watchdog() {
    const std::uint64_t one = 1;
    if (write(state_->finished, &one, sizeof one) == sizeof one) state_->thread.join();
    else state_->thread.detach();
    close(state_->signals);
    close(state_->finished);
}

const std::atomic<bool>& Watchdog::interrupted() const { return state_->interrupted; }

void Watchdog::when_interrupted(std::function<void()> call) {
    const std::lock_guard lock(state_->mutex);
    state_->call = std::move(call);
    if (state_->call && state_->interrupted) state_->call();
}

void unblock_signals() {
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace whittle
