#include "modeler/mesh/stretch.h"

#include <algorithm>
#include <cmath>

namespace whittle {

// The root of the largest eigenvalue of its Gram matrix, by Cardano's trigonometric form.
double largest_stretch(const Placement& p) {
    double g[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            g[i][j] = 0;
            for (int k = 0; k < 3; ++k) g[i][j] += p.linear(k, i) * p.linear(k, j);
        }
    const double off = g[0][1] * g[0][1] + g[0][2] * g[0][2] + g[1][2] * g[1][2];
    const double mean = (g[0][0] + g[1][1] + g[2][2]) / 3;
    if (off == 0) return std::sqrt(std::max({g[0][0], g[1][1], g[2][2]}));
    double spread = 2 * off;
    for (int i = 0; i < 3; ++i) spread += (g[i][i] - mean) * (g[i][i] - mean), g[i][i] -= mean;
    const double s = std::sqrt(spread / 6);
    const double det = g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) - g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
                       g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
    const double angle = std::acos(std::clamp(det / (2 * s * s * s), -1.0, 1.0)) / 3;
    return std::sqrt(std::max(0.0, mean + 2 * s * std::cos(angle)));
}

}  // namespace whittle
