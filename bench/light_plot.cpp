#include "bench/light_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace whittle::bench {

namespace {

constexpr double kWidth = 330, kHeight = 190, kLeft = 44, kTop = 26, kBottom = 30, kRight = 80;
constexpr int kColumns = 4;
constexpr std::array<const char*, 6> kInks{"#1b6ca8", "#d1495b", "#3a7d44", "#e09f3e", "#6a4c93", "#444444"};

constexpr std::array<const char*, 3> kDashes{"", "5 2", "1 2"};

// The names by which lines have inks, or those by which they are dashed, in the order they come.
std::vector<std::string> names_of(const LightPanel& p, std::string LightLine::* name) {
    std::vector<std::string> names;
    for (const LightLine& line : p.lines)
        if (!(line.*name).empty() && std::find(names.begin(), names.end(), line.*name) == names.end()) names.push_back(line.*name);
    return names;
}

std::size_t place_in(const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::string dash(std::size_t i) { return kDashes[i % kDashes.size()][0] ? fmt::format(" stroke-dasharray='{}'", kDashes[i % kDashes.size()]) : std::string(); }

// Right of the plot, from its upper corner down: inks, then dashes.
std::string legend(const std::vector<std::string>& inks, const std::vector<std::string>& dashes, double left) {
    std::string svg;
    double y = kTop + 10;
    for (std::size_t i = 0; i < inks.size(); ++i, y += 11)
        svg += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='{}'>{}</text>\n", left, y, kInks[i % kInks.size()], inks[i]);
    for (std::size_t i = 0; dashes.size() > 1 && i < dashes.size(); ++i, y += 11)
        svg += fmt::format("<path d='M{:.1f} {:.1f}h18' stroke='#444'{}/><text x='{:.1f}' y='{:.1f}'>{}</text>\n", left, y - 3, dash(i), left + 22, y, dashes[i]);
    return svg;
}

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
    const std::vector<std::string> inks = names_of(p, &LightLine::name), dashes = names_of(p, &LightLine::sampler);
    for (const LightLine& line : p.lines) {
        const char* ink = kInks[place_in(inks, line.name) % kInks.size()];
        std::string path, dots;
        for (const LightPoint& point : line.points) {
            const double x = kLeft + w * across.share(point.seconds), y = kTop + h * (1 - up.share(point.error));
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
            dots += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='2' fill='{}'/>", x, y, ink);
        }
        const std::string dashed = line.sampler.empty() ? std::string() : dash(place_in(dashes, line.sampler));
        svg += fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.5'{}/>{}\n", path, ink, dashed, dots);
    }
    svg += legend(inks, dashes, kLeft + w + 6);
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
