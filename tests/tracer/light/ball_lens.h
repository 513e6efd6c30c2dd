// ball_lens.h — what a glass ball makes of parallel light, in closed form.
#pragma once

#include <cmath>

#include "tracer/light/scattering.h"

namespace whittle::test {

// Of parallel light of irradiance 1 on a ball about the origin: what two refractions send to a disc of radius `spot` in the plane z = -plane.
inline double flux_by_snell(double radius, double index, double plane, double spot) {
    double sum = 0;
    const int n = 200000;
    for (int i = 0; i < n; ++i) {
        const double b = radius * (i + 0.5) / n, in = std::asin(b / radius), within = std::asin(b / (radius * index));
        const double turned = 2 * (in - within), x = radius * std::sin(2 * within - in), z = radius * std::cos(in - 2 * within);
        if (std::abs(x - std::tan(turned) * (plane - z)) > spot) continue;
        const double open = 1 - fresnel_dielectric(std::cos(in), 1 / index);
        sum += open * open * 2 * kPi * b * radius / n;
    }
    return sum;
}

}  // namespace whittle::test
