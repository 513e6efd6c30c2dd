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

namespace whittle {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMemoryLookEvery_ms = 20;

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

std::uint64_t resident_bytes() {
    std::FILE* file = std::fopen("/proc/self/statm", "re");
    if (!file) return 0;
    unsigned long long whole = 0, resident = 0;
    const int read = std::fscanf(file, "%llu %llu", &whole, &resident);
    std::fclose(file);
    return read == 2 ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
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

    void watch();
    int wait_ms() const;
    void check_limits();
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
    if (limits.bytes > 0 && resident_bytes() > limits.bytes) quit(Fault::kWorld, "The memory limit is reached (--limit-memory)");
}

int Watchdog::State::wait_ms() const {
    if (limits.bytes > 0) return kMemoryLookEvery_ms;
    if (limits.seconds <= 0) return -1;
    const double left_s = limits.seconds - std::chrono::duration<double>(Clock::now() - begin).count();
    return static_cast<int>(std::clamp(std::ceil(left_s * 1000), 0.0, 1e9));
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
