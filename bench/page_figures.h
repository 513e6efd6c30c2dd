// page_figures.h — what the prototypes' measurements said of the peers, so that a peer that runs unusually slowly here shows.
//
// Another machine has other absolute figures; all peers should then be faster or slower by about the same factor. One that is under 80 % of the others'
// factor is marked: it is built, called or exported worse than it was there.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace whittle::bench {

// Million rays a second, first hit, the middle of the range that was measured. `peer` is the beginning of a subject's name.
struct PageFigure {
    std::string scene, rays, peer;
    double mray_s = 0;
};
std::optional<PageFigure> page_figure(const std::string& scene, const std::string& rays, const std::string& subject);

struct Beside {
    PageFigure page;
    double measured = 0;
};

// A line a figure: measured, page, their ratio, and "*" where that is under 80 % of the median of the other lines' ratios.
std::string beside_the_page(const std::vector<Beside>& rows);

}  // namespace whittle::bench
