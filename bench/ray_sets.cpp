// ray_sets.cpp — camera and incoherent rays.
#include "bench/ray_sets.h"

#include <cmath>
#include <random>

#include "csg/base/degrees.h"

namespace whittle::bench {

Lens camera_lens(const BenchScene& scene) {
    Lens lens;
    lens.forward = -glm::normalize(scene.from);
    lens.right = glm::normalize(glm::cross(lens.forward, Vec3(0, 0, 1)));
    lens.up = glm::cross(lens.right, lens.forward);
    lens.eye = scene.centre - lens.forward * (scene.radius / sind(20));
    lens.half_height = sind(10.5) / cosd(10.5);
    return lens;
}

std::vector<Ray> camera_rays(const BenchScene& scene, int width, int height) {
    const Lens lens = camera_lens(scene);
    const double half = lens.half_height;
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int tile = 0; tile < (width / kTile) * (height / kTile); ++tile)
        for (int i = 0; i < kBatch; ++i) {
            const int block = i / 16, in_block = i % 16;
            const int x = tile % (width / kTile) * kTile + block % 4 * 4 + in_block % 4, y = tile / (width / kTile) * kTile + block / 4 * 4 + in_block / 4;
            const double px = (x + 0.5 - 0.5 * width) / (0.5 * height) * half, py = (0.5 * height - y - 0.5) / (0.5 * height) * half;
            Ray ray;
            ray.origin = lens.eye;
            ray.direction = glm::normalize(lens.forward + px * lens.right + py * lens.up);
            rays.push_back(ray);
        }
    return rays;
}

std::vector<Ray> incoherent_rays(const BenchScene& scene, int count) {
    std::mt19937_64 engine(77);
    const auto between = [&](double a, double b) { return a + (b - a) * (static_cast<double>(engine() >> 11) * 0x1p-53); };
    std::vector<Ray> rays;
    while (rays.size() < static_cast<std::size_t>(count)) {
        Vec3 v;
        for (int i = 0; i < 3; ++i) v[i] = between(-1, 1);
        const double l = glm::length(v);
        if (l > 1 || l < 0.1) continue;
        Vec3 to;
        for (int i = 0; i < 3; ++i) to[i] = between(scene.box.lo[i], scene.box.hi[i]);
        Ray ray;
        ray.origin = scene.centre + v * (scene.radius / l);
        ray.direction = glm::normalize(to - ray.origin);
        rays.push_back(ray);
    }
    return rays;
}

}  // namespace whittle::bench
