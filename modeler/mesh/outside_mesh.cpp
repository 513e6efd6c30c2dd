#include "modeler/mesh/outside_mesh.h"

#include <cmath>

#include "modeler/mesh/mesh_queries.h"

namespace whittle {
namespace {

// Rounding of a mesh's volume and of its hull's, against the volume: a dent that is smaller shows nowhere. Nor does one within the tessellation's
// own error, which makes the facets of a ball not quite convex.
constexpr double kConvexShare = 0x1p-30;

std::shared_ptr<const FacetList> facets_of(const Mesh& mesh) {
    auto list = std::make_shared<FacetList>();
    list->points = mesh.points;
    for (const Triangle& t : mesh.triangles) list->facets.push_back({t[0], t[1], t[2]});
    return list;
}

Result<MeshResult> operand_mesh(const Solid& solid, const Use& use, const MeshOptions& options) {
    MeshControl control;
    return mesh_use(solid, use, options, control);
}

}  // namespace

Result<std::shared_ptr<const FacetList>> hull_of(const Solid& solid, const std::vector<Use>& operands, const MeshOptions& options) {
    std::vector<Vec3> points;
    for (const Use& use : operands) {
        const auto made = operand_mesh(solid, use, options);
        if (!made) return tl::unexpected(made.error());
        points.insert(points.end(), made->mesh.points.begin(), made->mesh.points.end());
    }
    const auto hull = convex_hull(points);
    if (!hull) return tl::unexpected(hull.error());
    return facets_of(*hull);
}

Result<std::shared_ptr<const FacetList>> minkowski_of(const Solid& solid, const std::vector<Use>& operands, const MeshOptions& options) {
    if (operands.empty()) return fail(Fault::kScene, "minkowski() of nothing");
    std::vector<Vec3> sum;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const auto made = operand_mesh(solid, operands[i], options);
        if (!made) return tl::unexpected(made.error());
        const auto hull = convex_hull(made->mesh.points);
        if (!hull) return tl::unexpected(hull.error());
        const MassProperties own = mass_properties(made->mesh);
        if (mass_properties(*hull).volume - own.volume > kConvexShare * own.volume + made->tolerance_mm * own.area)
            return fail(Fault::kScene, "minkowski() of a solid that is not convex is not supported yet");
        if (i == 0) {
            sum = hull->points;
            continue;
        }
        auto next = minkowski_convex(sum, hull->points);
        if (!next) return tl::unexpected(next.error());
        sum = std::move(next->points);
    }
    const auto whole = convex_hull(sum);
    if (!whole) return tl::unexpected(whole.error());
    return facets_of(*whole);
}

}  // namespace whittle
