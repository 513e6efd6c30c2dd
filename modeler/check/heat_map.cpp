#include "modeler/check/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "modeler/check/agreement.h"
#include "modeler/check/leaf_distance.h"

namespace whittle {

namespace {

// Steps from none to all of what is allowed; one more colour stands for what is beyond.
constexpr std::uint32_t kSteps = 16;

Vec4 colour_of(std::uint32_t step) {
    if (step > kSteps) return {1, 1, 1, 1};
    const double x = static_cast<double>(step) / kSteps;
    return {std::clamp(2 * x - 1, 0.0, 1.0), 1 - std::fabs(2 * x - 1), std::clamp(1 - 2 * x, 0.0, 1.0), 1};
}

}  // namespace

Result<HeatMap> heat_map(const Solid& solid, const MeshResult& made) {
    const auto leaves = LeafDistances::of(solid);
    if (!leaves) return tl::unexpected(leaves.error());
    const Bounds box = mesh_bounds(made.mesh);
    const double reach = made.mesh.points.empty() ? 0 : glm::length(box.hi - box.lo) + std::max(glm::length(box.lo), glm::length(box.hi));
    const double rounding = allowed_rounding(made.grid_mm, reach), tolerance = leaves->any_curved() ? made.tolerance_mm : 0;
    HeatMap out;
    out.result = made;
    out.allowed_mm = tolerance + rounding;
    const Mesh& mesh = made.mesh;
    std::vector<double> deviations(mesh.triangles.size(), 0);
    constexpr double kReach = 4;
    tbb::parallel_for(std::size_t{0}, mesh.triangles.size(), [&](std::size_t i) {
        const Triangle& t = mesh.triangles[i];
        const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        for (const Vec3& p : {(a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0})
            deviations[i] = std::max(deviations[i], leaves->nearest(p, out.allowed_mm, out.allowed_mm, kReach).distance);
    });
    out.result.leaves.assign(kSteps + 2, {});
    for (std::uint32_t k = 0; k < out.result.leaves.size(); ++k) out.result.leaves[k].material.color = colour_of(k);
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        out.most_mm = std::max(out.most_mm, deviations[i]);
        const bool beyond = deviations[i] > out.allowed_mm;
        out.beyond += beyond ? 1U : 0U;
        const double step = out.allowed_mm > 0 ? std::round(deviations[i] / out.allowed_mm * kSteps) : 0;
        out.result.mesh.leaf[i] = beyond ? kSteps + 1 : static_cast<std::uint32_t>(step);
    }
    return out;
}

}  // namespace whittle
