#include "modeler/cli/frames.h"

#include <filesystem>

#include <fmt/core.h>

#include "modeler/cli/session.h"

namespace whittle {

namespace {

std::string numbered(const std::string& path, int frame) {
    if (path == "-") return path;
    const std::filesystem::path whole(path);
    return (whole.parent_path() / fmt::format("{}{:05}{}", whole.stem().string(), frame, whole.extension().string())).string();
}

}  // namespace

std::vector<Request> frames_of(const Request& request) {
    if (request.frames == 0) return {request};
    std::vector<Request> frames(static_cast<std::size_t>(request.frames), request);
    for (int i = 0; i < request.frames; ++i) {
        Request& frame = frames[static_cast<std::size_t>(i)];
        frame.common.time = static_cast<double>(i) / request.frames;
        if (frame.outputs.empty()) frame.outputs.push_back(default_output(request.inputs.front(), ".png"));
        for (std::string& output : frame.outputs) output = numbered(output, i);
    }
    return frames;
}

}  // namespace whittle
