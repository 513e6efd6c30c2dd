// progress.cpp — see progress.h.
#include "modeler/cli/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <fmt/core.h>

namespace whittle {

namespace {

constexpr double kBarEvery_s = 0.1, kJsonEvery_s = 0.5, kLineEvery_s = 10, kSilentAtFirst_s = 0.5;
constexpr int kBarWidth = 32;
constexpr double kLeastShare = 0.02;  // below it, the speed so far says little

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void put(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace

Progress::Progress(std::string what, ProgressStyle style, bool on_terminal, bool quiet)
    : what_(std::move(what)),
      style_(style),
      terminal_(on_terminal),
      silent_(style == ProgressStyle::kNever || (quiet && style != ProgressStyle::kJson)),
      begin_s_(now_s()),
      shown_s_(begin_s_) {}

Progress::~Progress() {
    if (bar_drawn_) put("\r\x1b[K");
}

void Progress::report(double share, std::optional<double> left_s) {
    if (silent_) return;
    const std::lock_guard lock(mutex_);
    const double now = now_s(), elapsed_s = now - begin_s_;
    const bool bar = style_ == ProgressStyle::kAuto && terminal_;
    const double every_s = style_ == ProgressStyle::kJson ? kJsonEvery_s : bar ? kBarEvery_s : kLineEvery_s;
    if (now - shown_s_ < every_s || elapsed_s < kSilentAtFirst_s) return;
    shown_s_ = now;
    share = std::clamp(share, 0.0, 1.0);
    if (!left_s && share > kLeastShare) left_s = elapsed_s * (1 - share) / share;
    const bool told = left_s && std::isfinite(*left_s);
    const std::string left = told ? fmt::format(", {:.0f} s left", *left_s) : std::string();
    if (style_ == ProgressStyle::kJson)
        put(fmt::format("{{\"progress\":{:.4f},\"work\":\"{}\",\"seconds\":{:.1f},\"left\":{}}}\n", share, what_, elapsed_s, told ? fmt::format("{:.1f}", *left_s) : "null"));
    else if (bar)
        draw_bar(share, left);
    else
        put(fmt::format("{}: {:.0f} % after {:.0f} s{}\n", what_, share * 100, elapsed_s, left));
}

void Progress::draw_bar(double share, const std::string& left) {
    const int filled = static_cast<int>(share * kBarWidth);
    put(fmt::format("\r{} [{}{}] {:3.0f} %{}\x1b[K", what_, std::string(static_cast<std::size_t>(filled), '#'),
                    std::string(static_cast<std::size_t>(kBarWidth - filled), '.'), share * 100, left));
    bar_drawn_ = true;
}

}  // namespace whittle
