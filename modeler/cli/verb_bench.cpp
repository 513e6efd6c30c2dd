// verb_bench.cpp — whittle bench: becomes the program whittle-bench that stands beside this one.
#include <cerrno>
#include <cstring>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "modeler/cli/verbs.h"
#include "tracer/image/image_file.h"

namespace whittle {

Exit run_bench(const Request& request, Console& console) {
    const std::string program = (running_program_dir() / "whittle-bench").string();
    std::vector<std::string> words{program};
    words.insert(words.end(), request.rest.begin(), request.rest.end());
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    console.error(fmt::format("bench needs the program {}, which cannot be started: {}", program, std::strerror(errno)));
    return Exit::kWorld;
}

}  // namespace whittle
