// main.cpp — the table of contents: read the command line, do the verb, tell the counters.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>

#include <fmt/core.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include "modeler/cli/frames.h"
#include "modeler/cli/parse.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

Exit run_verb(Session& session) {
    switch (session.request.verb) {
        case Verb::kRender: return run_render(session);
        case Verb::kMesh: return run_mesh(session);
        case Verb::kCheck: return run_check(session);
        case Verb::kMeasure: return run_measure(session);
        case Verb::kSpans: return run_spans(session);
        case Verb::kMerge: return run_merge(session);
        case Verb::kConvert: return run_convert(session);
        case Verb::kBench: return run_bench(session.request, session.console);
    }
    return Exit::kCommand;
}

Exit write_stats(Session& session) {
    const auto& file = session.request.common.stats_file;
    if (file.empty()) return Exit::kDone;
    session.stats.set("bytes.peak", peak_bytes());
    const auto written = write_output(file, session.stats.text());
    return written ? Exit::kDone : give_up(session, written.error());
}

Exit run(const Request& request) {
    Console console(request.common.diagnostics, request.common.quiet);
    if (request.verb == Verb::kBench) return run_bench(request, console);
    const std::vector<Request> frames = frames_of(request);
    std::vector<std::string> outputs;
    for (const Request& frame : frames) outputs.insert(outputs.end(), frame.outputs.begin(), frame.outputs.end());
    if (const auto room = check_folders(outputs); !room) {
        console.error(room.error().message);
        return Exit::kWorld;
    }
    Watchdog watchdog({request.common.limit_seconds, request.common.limit_memory, request.common.limit_bytes}, outputs);
    std::optional<tbb::global_control> threads;
    if (request.common.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request.common.threads));
    Stats stats;
    Summary summary(request.summary);
    Stopwatch whole_run;
    Exit done = Exit::kDone;
    // What is wrong with the scene may be so at one time only; what is wrong with the world stays.
    for (std::size_t i = 0; i < frames.size() && done <= Exit::kScene; ++i) {
        Session session{frames[i], console, stats, watchdog, summary};
        done = worse(done, run_verb(session));
    }
    Session whole{request, console, stats, watchdog, summary};
    if (const auto told = summary.tell(console, whole_run.lap()); !told) done = worse(done, give_up(whole, told.error()));
    return worse(done, write_stats(whole));
}

int whittle_main(std::vector<std::string> arguments) {
    const auto parsed = parse_command_line(std::move(arguments));
    if (!parsed) {
        fmt::print(stderr, "whittle: {}\n", parsed.error().message);
        return static_cast<int>(Exit::kCommand);
    }
    if (const auto* say = std::get_if<Say>(&*parsed)) {
        fmt::print("{}", say->text);
        return static_cast<int>(std::fflush(stdout) == 0 ? Exit::kDone : Exit::kWorld);
    }
    return static_cast<int>(run(std::get<Request>(*parsed)));
}

// Where memory that is refused cannot be thrown out of (a thread's start, a noexcept move), the run still ends with the message and the code of the others.
[[noreturn]] void say_why_and_end() {
    try {
        if (const auto fault = std::current_exception()) std::rethrow_exception(fault);
    } catch (const std::bad_alloc&) {
        std::fputs("ERROR: Out of memory\n", stderr);
        _exit(static_cast<int>(Exit::kWorld));
    } catch (...) {
    }
    std::abort();
}

}  // namespace

}  // namespace whittle

int main(int argc, char** argv) {
    std::set_terminate(whittle::say_why_and_end);
    try {
        return whittle::whittle_main(std::vector<std::string>(argv + 1, argv + argc));
    } catch (const std::bad_alloc&) {
        std::fputs("ERROR: Out of memory\n", stderr);
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "ERROR: %s\n", fault.what());
    }
    return static_cast<int>(whittle::Exit::kWorld);
}
