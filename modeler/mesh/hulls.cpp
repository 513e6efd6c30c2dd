// hulls.cpp — queries that the module answers, and sums of convex sets by way of them.
#include "modeler/mesh/exact_kernel.h"
#include "modeler/mesh/mesh_queries.h"

namespace whittle {

Result<std::uint64_t> count_self_intersections(const Mesh& mesh) {
    const auto kernel = exact_kernel();
    if (!kernel) return tl::unexpected(kernel.error());
    return (*kernel)->self_intersections(mesh.points, mesh.triangles);
}

Result<Mesh> convex_hull(const std::vector<Vec3>& points) {
    const auto kernel = exact_kernel();
    if (!kernel) return tl::unexpected(kernel.error());
    return (*kernel)->convex_hull(points);
}

// Only corners of the hulls matter, so the sums are taken of those.
Result<Mesh> minkowski_convex(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    const auto left = convex_hull(a), right = convex_hull(b);
    if (!left) return left;
    if (!right) return right;
    std::vector<Vec3> sums;
    sums.reserve(left->points.size() * right->points.size());
    for (const Vec3& p : left->points)
        for (const Vec3& q : right->points) sums.push_back(p + q);
    return convex_hull(sums);
}

}  // namespace whittle
