#include "tests/stress/mask.h"

#include <algorithm>
#include <cmath>

namespace whittle::stress {

double way_of(double far) { return 20 * std::sqrt(far); }

bool is_masked(const Subject& subject, const Ray& ray, double far, double turned, std::mt19937_64& random) {
    using reference::Border;
    const auto alike = [&](const Border& x, const Border& y) {
        return x.entering == y.entering && x.leaves == y.leaves && x.holding == y.holding && std::abs((middle(x.lo, x.hi) - middle(y.lo, y.hi)).to_double()) <= way_of(far);
    };
    // A little before its beginning too: what changes there tells whether it begins inside or enters. A power of two, so that rays in faces stay in them.
    Ray longer = ray;
    longer.origin -= std::exp2(std::ceil(std::log2(way_of(far)))) * ray.direction;
    const auto here = subject.exact->borders(longer).borders;
    std::uniform_real_distribution<double> within(-1, 1);
    for (int i = 0; i < 200; ++i) {
        Ray moved = longer;
        for (int k = 0; k < 3; ++k) {
            moved.origin[k] += within(random) * far;
            moved.direction[k] += within(random) * turned;
        }
        const auto there = subject.exact->borders(moved).borders;
        if (!std::equal(here.begin(), here.end(), there.begin(), there.end(), alike)) return true;
    }
    return false;
}

}  // namespace whittle::stress
