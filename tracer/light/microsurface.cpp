#include "tracer/light/microsurface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <sleef.h>

#include "tracer/light/sampler.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A rough diamond's ray leaves after 4 bounces in the mean; of 10^6 none needed 100.
constexpr int kMostBounces = 200;

// Heights of facets are spread evenly over -1..1.
double below(double height) { return std::clamp(0.5 * (height + 1), 0.0, 1.0); }
double height_of(double share) { return std::clamp(2 * share - 1, -1.0, 1.0); }

// Directions so near the plane of the surface meet a facet at once.
constexpr double kLevel = 1e-6;

double smith_lambda(double cosine, double alpha) {
    const double tan2 = (1 - cosine * cosine) / (cosine * cosine), root = std::sqrt(1 + alpha * alpha * std::max(0.0, tan2));
    return cosine > 0 ? 0.5 * (root - 1) : 0.5 * (-root - 1);
}

// The next height at which a ray from `height` meets a facet; infinite: none.
double next_height(double cosine, double height, double alpha, double u) {
    if (std::abs(cosine) < kLevel) return height;
    const double here = below(height);
    // Straight down every facet below is met once.
    if (cosine < -1 + 1e-12) return height_of(u * here);
    const double lambda = smith_lambda(cosine, alpha);
    if (cosine > 0 && !(here > 0)) return height;
    if (cosine > 0 && u > 1 - Sleef_cinz_powd1_u10purec(here, lambda)) return kInfinity;
    return height_of(here / Sleef_cinz_powd1_u10purec(1 - u, 1 / lambda));
}

std::array<double, 4> inverted(std::array<double, 4> etas) {
    for (double& e : etas) e = 1 / e;
    return etas;
}

}  // namespace

Stream::Stream(Vec2 seed) : key_(sobol::hash(static_cast<std::uint32_t>(seed.x * 0x1p32), static_cast<std::uint32_t>(seed.y * 0x1p32))) {}
double Stream::next() { return sobol::unit(sobol::hash(key_, ++count_)); }

MicroWalk walk_microsurface(Vec3 direction, Vec3 normal, const std::array<double, 4>& etas, double alpha, Vec2 u, Stream stream) {
    const ShadingFrame frame(normal);
    Vec3 ray = frame.to_local(direction);
    MicroWalk walk;
    bool behind = false;
    double height = 1;
    for (int bounce = 0; bounce < kMostBounces; ++bounce) {
        // Behind the surface the world stands on its head.
        const double side = behind ? -1 : 1;
        // The first facet is met for certain: none lies above the viewer's own.
        double met = height;
        if (bounce > 0) met = next_height(side * ray.z, side * height, alpha, stream.next());
        else if (ray.z < 0) met = next_height(ray.z, height, alpha, stream.next());
        if (met == kInfinity) {
            walk.left = true;
            walk.through = behind;
            walk.direction = glm::normalize(frame.to_world(ray));
            return walk;
        }
        height = side * met;
        const Vec3 view = -side * ray;
        const Vec3 micro = ggx_visible_normal(view, alpha, bounce == 0 ? u : Vec2(stream.next(), stream.next()));
        const std::array<double, 4> here = behind ? inverted(etas) : etas;
        const double cosine = std::clamp(glm::dot(view, micro), 0.0, 1.0), mirror = fresnel_dielectric(cosine, here[0]);
        if (stream.next() < mirror) {
            for (std::size_t i = 0; i < here.size(); ++i) walk.mirrored[i] *= fresnel_dielectric(cosine, here[i]);
            ray = side * mirrored(-view, micro);
            continue;
        }
        const std::optional<Vec3> bent = refracted(-view, micro, here[0]);
        if (!bent) return walk;
        ray = side * *bent;
        behind = !behind;
        walk.bent = true;
    }
    return walk;
}

}  // namespace whittle
