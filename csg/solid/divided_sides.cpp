#include "csg/solid/divided_sides.h"

#include <algorithm>
#include <queue>

#include "csg/base/degrees.h"

namespace whittle {
namespace {

constexpr double kAsLong = 0.999;  // later versions of OpenSCAD cut sides of a like length together

// The longest that the side a, b becomes in any slice.
double longest_on_the_way(Vec2 a, Vec2 b, const SideStretch& stretch) {
    const Vec2 side = b - a, top = stretch.scale_top;
    if (top.x == top.y) return glm::length(side) * std::max(1.0, top.x);
    double longest = 0;
    for (int j = 0; j <= stretch.slices; ++j) {
        const double share = static_cast<double>(j) / stretch.slices, turn = -stretch.twist_deg * share;
        const Vec2 turned{cosd(turn) * side.x - sind(turn) * side.y, sind(turn) * side.x + cosd(turn) * side.y};
        longest = std::max(longest, glm::length(turned * (Vec2(1) + (top - Vec2(1)) * share)));
    }
    return longest;
}

struct Side {
    std::size_t index;
    double length;
    int pieces = 1;
    // Between the length of a piece now and after one more cut.
    double need() const { return length / (pieces + 0.5); }
    bool operator<(const Side& o) const { return need() < o.need() || (need() == o.need() && index > o.index); }
};

// Into how many pieces each side of a contour goes.
std::vector<int> pieces_of_sides(const std::vector<Vec2>& contour, int segments, const SideStretch& stretch) {
    std::priority_queue<Side> sides;
    for (std::size_t i = 0; i < contour.size(); ++i) sides.push({i, longest_on_the_way(contour[i], contour[(i + 1) % contour.size()], stretch)});
    std::vector<int> pieces(contour.size(), 1);
    std::size_t total = contour.size();
    std::vector<Side> alike;
    for (;;) {
        alike.clear();
        const double most = sides.top().need();
        while (!sides.empty() && sides.top().need() >= kAsLong * most) {
            alike.push_back(sides.top());
            sides.pop();
        }
        total += alike.size();
        if (!(most > 0) || total > static_cast<std::size_t>(segments)) return pieces;
        for (Side& side : alike) {
            pieces[side.index] = ++side.pieces;
            sides.push(side);
        }
    }
}

}  // namespace

Contours with_divided_sides(const Contours& contours, int segments, const SideStretch& stretch) {
    Contours out;
    for (const auto& contour : contours) {
        auto& divided = out.emplace_back();
        if (contour.size() >= static_cast<std::size_t>(segments)) {
            divided = contour;
            continue;
        }
        const std::vector<int> pieces = pieces_of_sides(contour, std::min(segments, kMostSegments), stretch);
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Vec2 a = contour[i], way = contour[(i + 1) % contour.size()] - a;
            for (int k = 0; k < pieces[i]; ++k) divided.push_back(k == 0 ? a : a + way * (static_cast<double>(k) / pieces[i]));
        }
    }
    return out;
}

}  // namespace whittle
