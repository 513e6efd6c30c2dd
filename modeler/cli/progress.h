// progress.h — how far a long work is: a bar on a terminal, a line every ten seconds when piped, JSON lines for programs. On standard error.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "modeler/cli/request.h"

namespace whittle {

class Progress {
public:
    // `what` names the work ("Rendering"). Nothing is shown when `style` is kNever or quiet, nor in the first half second.
    Progress(std::string what, ProgressStyle style, bool on_terminal, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Share done, 0..1, and the time left where the worker knows it better than by the share. From any thread.
    void report(double share, std::optional<double> left_s = {});

private:
    void draw_bar(double share, const std::string& left);

    std::mutex mutex_;
    std::string what_;
    ProgressStyle style_;
    bool terminal_, silent_;
    bool bar_drawn_ = false;
    double begin_s_, shown_s_;
};

}  // namespace whittle
