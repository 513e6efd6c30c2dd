#include "bench/page_figures.h"

#include <algorithm>

#include <fmt/format.h>

namespace whittle::bench {

namespace {

const std::vector<PageFigure>& figures() {
    static const std::vector<PageFigure> list{
        {"S1", "camera", "pov-ray flat", 1.40},     {"S1", "camera", "embree 1 ", 4.10},      {"S1", "camera", "embree 16", 13.9},     {"S1", "incoherent", "embree 1 ", 2.75},
        {"S2", "camera", "pov-ray flat", 0.070},    {"S2", "camera", "embree 1 ", 4.45},      {"S2", "camera", "embree 16", 13.8},     {"S2", "incoherent", "embree 1 ", 2.15},
        {"S3", "camera", "pov-ray flat", 0.0086},   {"S4", "camera", "pov-ray flat", 0.335},  {"S4", "camera", "embree 1 ", 2.10},     {"S4", "camera", "embree 16", 2.25},
        {"S4", "incoherent", "embree 1 ", 1.31},    {"S5", "camera", "pov-ray flat", 0.0123}, {"S6", "camera", "pov-ray flat", 0.00205}, {"S6", "camera", "embree 1 ", 5.25},
        {"S6", "camera", "embree 16", 14.3},        {"S6", "incoherent", "embree 1 ", 1.80},
    };
    return list;
}

}  // namespace

std::optional<PageFigure> page_figure(const std::string& scene, const std::string& rays, const std::string& subject) {
    const auto found = std::find_if(figures().begin(), figures().end(), [&](const PageFigure& f) { return f.scene == scene && f.rays == rays && subject.rfind(f.peer, 0) == 0; });
    return found == figures().end() ? std::nullopt : std::optional(*found);
}

std::string beside_the_page(const std::vector<Beside>& rows) {
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<double> others;
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (k != i) others.push_back(rows[k].measured / rows[k].page.mray_s);
        const double ratio = rows[i].measured / rows[i].page.mray_s;
        std::nth_element(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2), others.end());
        const bool slow = !others.empty() && ratio < 0.8 * others[others.size() / 2];
        text += fmt::format("{:3} {:11} {:14} {:9.4f} Mray/s  page {:9.4f}  x{:.2f}{}\n", rows[i].page.scene, rows[i].page.rays, rows[i].page.peer, rows[i].measured,
                            rows[i].page.mray_s, ratio, slow ? "  *" : "");
    }
    return text;
}

}  // namespace whittle::bench
