#include "tracer/light/aims.h"

#include <cmath>

namespace whittle {

namespace {

// A ball that touches a lamp from outside: its cap is open, not a hemisphere.
constexpr double kMargin = 1 + 1e-9;

double length2(Vec3 v) { return glm::dot(v, v); }
Bounds hull(const Bounds& a, const Bounds& b) { return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)}; }

// Four times the square of the ball's radius: lamps shine at that much.
double size(const Bounds& box) { return length2(box.hi - box.lo); }

// What one ball around both is larger than two.
double growth(const Bounds& a, const Bounds& b) { return size(hull(a, b)) - size(a) - size(b); }

// Boxes worth one ball become one; with `always` the two that suit each other best, too. False: nothing was joined.
bool join(std::vector<Bounds>& boxes, bool always) {
    double least = always ? HUGE_VAL : 0;
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = i + 1; k < boxes.size(); ++k)
            if (const double g = growth(boxes[i], boxes[k]); g < least || (g == least && second == 0)) least = g, first = i, second = k;
    if (second == 0) return false;
    boxes[first] = hull(boxes[first], boxes[second]);
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(second));
    return true;
}

}  // namespace

std::vector<Aim> aims_around(const std::vector<Bounds>& things) {
    std::vector<Bounds> boxes;
    for (const Bounds& thing : things) {
        if (thing.empty() || !std::isfinite(size(thing))) continue;
        boxes.push_back(thing);
        // One too many: the best two are joined, so a thousand things cost a thousand looks at a few.
        if (boxes.size() > kMostAims) join(boxes, true);
    }
    while (join(boxes, false)) {}
    std::vector<Aim> aims;
    for (const Bounds& box : boxes)
        if (size(box) > 0) aims.push_back({box.lo + 0.5 * (box.hi - box.lo), 0.5 * std::sqrt(size(box)) * kMargin});
    return aims;
}

}  // namespace whittle
