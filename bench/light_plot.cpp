#include "bench/light_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace whittle::bench {

namespace {

constexpr double kWidth = 260, kHeight = 190, kLeft = 44, kTop = 26, kBottom = 30, kRight = 10;
constexpr int kColumns = 4;
constexpr std::array<const char*, 6> kInks{"#1b6ca8", "#d1495b", "#3a7d44", "#e09f3e", "#6a4c93", "#444444"};

// Decades that hold all values: exponents of 10.
struct Decades {
    int lo = 99, hi = -99;
    void hold(double value) {
        if (!(value > 0)) return;
        lo = std::min(lo, static_cast<int>(std::floor(std::log10(value))));
        hi = std::max(hi, static_cast<int>(std::ceil(std::log10(value))));
    }
    double share(double value) const { return (std::log10(std::max(value, std::pow(10.0, lo))) - lo) / std::max(1, hi - lo); }
};

std::string grid(const Decades& across, const Decades& up, double w, double h) {
    std::string svg;
    for (int e = across.lo; e <= across.hi; ++e) {
        const double x = kLeft + w * across.share(std::pow(10.0, e));
        svg += fmt::format("<path d='M{:.1f} {:.1f}v{:.1f}' stroke='#ddd'/><text x='{:.1f}' y='{:.1f}' text-anchor='middle'>1e{}</text>\n", x, kTop, h, x, kTop + h + 12, e);
    }
    for (int e = up.lo; e <= up.hi; e += up.hi - up.lo > 8 ? 3 : 1) {
        const double y = kTop + h * (1 - up.share(std::pow(10.0, e)));
        svg += fmt::format("<path d='M{:.1f} {:.1f}h{:.1f}' stroke='#ddd'/><text x='{:.1f}' y='{:.1f}' text-anchor='end'>1e{}</text>\n", kLeft, y, w, kLeft - 4, y + 3, e);
    }
    return svg;
}

std::string panel(const LightPanel& p, const std::string& axes) {
    const double w = kWidth - kLeft - kRight, h = kHeight - kTop - kBottom;
    Decades across, up;
    for (const LightLine& line : p.lines)
        for (const LightPoint& point : line.points) across.hold(point.seconds), up.hold(point.error);
    std::string svg = fmt::format("<text x='{:.1f}' y='14' font-weight='bold'>{}</text>\n", kLeft, p.scene) + grid(across, up, w, h);
    for (std::size_t i = 0; i < p.lines.size(); ++i) {
        const char* ink = kInks[i % kInks.size()];
        std::string path, dots;
        for (const LightPoint& point : p.lines[i].points) {
            const double x = kLeft + w * across.share(point.seconds), y = kTop + h * (1 - up.share(point.error));
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
            dots += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='2.5' fill='{}'/>", x, y, ink);
        }
        svg += fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.5'/>{}\n", path, ink, dots);
        svg += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='{}' text-anchor='end'>{}</text>\n", kLeft + w, kTop + 10 + 11 * static_cast<double>(i), ink, p.lines[i].name);
    }
    return svg + fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", kLeft + w / 2, kHeight - 4, axes);
}

}  // namespace

std::string light_plot(const std::vector<LightPanel>& panels, const std::string& axes) {
    const int rows = (static_cast<int>(panels.size()) + kColumns - 1) / kColumns;
    std::string svg = fmt::format("<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' font-family='sans-serif' font-size='9'>\n"
                                  "<rect width='100%' height='100%' fill='white'/>\n",
                                  kColumns * kWidth, rows * kHeight);
    for (std::size_t i = 0; i < panels.size(); ++i)
        svg += fmt::format("<g transform='translate({} {})'>\n{}</g>\n", static_cast<double>(i % kColumns) * kWidth, static_cast<double>(i / kColumns) * kHeight, panel(panels[i], axes));
    return svg + "</svg>\n";
}

}  // namespace whittle::bench
