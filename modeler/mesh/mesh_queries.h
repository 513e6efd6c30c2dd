// mesh_queries.h — what the check and measure ask of a finished mesh: integrals over it, and every crossing of a ray.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "csg/span/ray.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// Of a closed mesh, unit density. `inertia` is about the centroid, row-major, mm^5. Sums are compensated, so each value is good to about
// 1e-14 of the sum of its terms' magnitudes.
struct MassProperties {
    double volume = 0, area = 0;
    Vec3 centroid{0};
    std::array<double, 9> inertia{};
};
MassProperties mass_properties(const Mesh& mesh);

// A place where a ray goes through the mesh. `entering`: from outside to inside, by the triangle's orientation.
struct MeshCrossing {
    double t = 0;
    double t_error = 0;
    std::uint32_t triangle = 0;
    bool entering = false;
};

// Rays against a mesh, watertight: which triangles a ray meets is decided exactly, and a ray through an edge or a vertex meets what its neighbour
// o + e v1 + e^2 v2 does, so crossings of a closed mesh alternate. Immutable; shared by threads.
class MeshRays {
public:
    explicit MeshRays(const Mesh& mesh);
    ~MeshRays();
    MeshRays(MeshRays&&) noexcept;
    MeshRays& operator=(MeshRays&&) noexcept;
    // All crossings with t >= 0, by t. Time and wavelength of the ray do not matter.
    void crossings(const Ray& ray, std::vector<MeshCrossing>& out) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Pairs of triangles that cross or overlap though they share no edge or vertex there, by CGAL: a second opinion, for tests, on what
// MeshReport::self_intersections says. kWorld fault when the CGAL part is not installed.
Result<std::uint64_t> count_self_intersections(const Mesh& mesh);

}  // namespace whittle
