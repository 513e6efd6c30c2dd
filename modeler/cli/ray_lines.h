// ray_lines.h — rays as text, "ox oy oz dx dy dz" a line, read in pieces so that an asking program gets its answers while it still asks.
#pragma once

#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/span/ray.h"

namespace whittle {

class RayLines {
public:
    // "-" is standard input.
    static Result<RayLines> open(const std::string& path);
    RayLines(RayLines&&) noexcept;
    RayLines(const RayLines&) = delete;
    RayLines& operator=(const RayLines&) = delete;
    RayLines& operator=(RayLines&&) = delete;
    ~RayLines();

    // The rays of the whole lines that are there by now (at least one ray, else the end of the file: empty). Empty lines and lines that begin with # are passed over.
    // Faults: kCommand for a line that is no ray (its number is told), kWorld where reading fails.
    Result<std::vector<Ray>> next();

private:
    RayLines(std::string path, int file) : path_(std::move(path)), file_(file) {}
    Result<void> take_line(std::string_view line, std::vector<Ray>& rays);

    std::string path_;
    int file_ = -1;
    std::string pending_;  // the last line's beginning
    std::size_t line_ = 0;
    bool ended_ = false;
};

}  // namespace whittle
