// ray_lines.cpp — see ray_lines.h.
#include "modeler/cli/ray_lines.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "modeler/cli/numbers.h"

namespace whittle {

namespace {

constexpr std::size_t kPieceBytes = 1 << 20;

bool read_ray(std::string_view line, Ray& ray) {
    for (double* number : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y, &ray.direction.z})
        if (!take_number(line, *number)) return false;
    return line.find_first_not_of(" \t\r") == std::string_view::npos && is_askable(ray);
}

}  // namespace

Result<RayLines> RayLines::open(const std::string& path) {
    if (path == "-") return RayLines(path, STDIN_FILENO);
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return fail(Fault::kWorld, fmt::format("cannot read '{}': {}", path, std::strerror(errno)));
    return RayLines(path, file);
}

RayLines::RayLines(RayLines&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), pending_(std::move(other.pending_)), line_(other.line_), ended_(other.ended_) {}

RayLines::~RayLines() {
    if (file_ > STDIN_FILENO) ::close(file_);
}

Result<void> RayLines::take_line(std::string_view line, std::vector<Ray>& rays) {
    ++line_;
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') return {};
    Ray ray;
    if (!read_ray(line, ray))
        return fail(Fault::kCommand, fmt::format("{}, line {}: a ray is six numbers, ox oy oz dx dy dz, with a direction (no part of it under 1e-90 but 0, none over 1e90)", path_ == "-" ? "standard input" : path_, line_));
    rays.push_back(ray);
    return {};
}

Result<std::vector<Ray>> RayLines::next() {
    std::vector<Ray> rays;
    while (rays.empty() && !ended_) {
        const std::size_t kept = pending_.size();
        pending_.resize(kept + kPieceBytes);
        ssize_t count = 0;
        do count = ::read(file_, pending_.data() + kept, kPieceBytes);
        while (count < 0 && errno == EINTR);
        if (count < 0) return fail(Fault::kWorld, fmt::format("cannot read '{}': {}", path_, std::strerror(errno)));
        pending_.resize(kept + static_cast<std::size_t>(count));
        ended_ = count == 0;
        if (ended_ && !pending_.empty() && pending_.back() != '\n') pending_ += '\n';
        std::size_t begin = 0;
        for (auto end = pending_.find('\n'); end != std::string::npos; end = pending_.find('\n', begin)) {
            if (auto taken = take_line(std::string_view(pending_).substr(begin, end - begin), rays); !taken) return tl::unexpected<Error>(taken.error());
            begin = end + 1;
        }
        pending_.erase(0, begin);
    }
    return rays;
}

}  // namespace whittle
