// child.cpp — fork, limits, exec, wait4.
#include "bench/child.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace whittle::bench {

namespace {

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

[[noreturn]] void become(std::vector<char*>& arguments, const std::string& output, const ChildLimits& limits) {
    const int to = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (to < 0 || ::dup2(to, STDOUT_FILENO) < 0 || ::dup2(to, STDERR_FILENO) < 0) ::_exit(127);
    if (limits.cpu_s > 0) {
        const auto whole = static_cast<rlim_t>(std::ceil(limits.cpu_s));
        const rlimit cpu{whole, whole + 1};
        ::setrlimit(RLIMIT_CPU, &cpu);
    }
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
}

}  // namespace

ChildRun run_child(std::vector<std::string> words, const std::string& output, const ChildLimits& limits) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ChildRun run;
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    if (child == 0) become(arguments, output, limits);
    int status = 0;
    rusage usage{};
    if (child < 0 || ::wait4(child, &status, 0, &usage) != child) return run;
    run.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    run.user_s = seconds(usage.ru_utime);
    run.system_s = seconds(usage.ru_stime);
    run.kilobytes = usage.ru_maxrss;
    run.good = WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == limits.accepted);
    run.in_time = !(WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL));
    return run;
}

ScratchFolder::ScratchFolder() {
    std::error_code fault;
    std::string name = (std::filesystem::temp_directory_path(fault) / "whittle-bench-XXXXXX").string();
    if (::mkdtemp(name.data())) path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace whittle::bench
