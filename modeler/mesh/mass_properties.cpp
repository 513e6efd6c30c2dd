// mass_properties.cpp — volume, area, centroid and inertia of a closed mesh: integrals over the tetrahedra from one point to its triangles.
//
// Moments are taken about the middle of the box, so that a mesh far from the origin keeps its digits, and summed with Neumaier's compensation.
// Source: Eberly, Polyhedral Mass Properties (2002); Neumaier (1974).
#include <cmath>

#include "modeler/mesh/mesh_queries.h"

namespace whittle {
namespace {

class Sum {
public:
    void add(double x) {
        const double s = sum_ + x;
        lost_ += std::fabs(sum_) >= std::fabs(x) ? (sum_ - s) + x : (x - s) + sum_;
        sum_ = s;
    }
    double value() const { return sum_ + lost_; }

private:
    double sum_ = 0, lost_ = 0;
};

}  // namespace

MassProperties mass_properties(const Mesh& mesh) {
    MassProperties out;
    if (mesh.triangles.empty()) return out;
    const Bounds box = mesh_bounds(mesh);
    const Vec3 middle = (box.lo + box.hi) / 2.0;
    Sum volume, area;
    std::array<Sum, 3> first;
    std::array<Sum, 9> second;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.points[t[0]] - middle, b = mesh.points[t[1]] - middle, c = mesh.points[t[2]] - middle;
        area.add(glm::length(glm::cross(b - a, c - a)) / 2);
        const double six = glm::dot(a, glm::cross(b, c));  // six times the signed volume of the tetrahedron (0, a, b, c)
        volume.add(six / 6);
        const Vec3 s = a + b + c;
        for (int i = 0; i < 3; ++i) {
            first[static_cast<std::size_t>(i)].add(six * s[i] / 24);
            for (int j = i; j < 3; ++j) second[static_cast<std::size_t>(3 * i + j)].add(six * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]) / 120);
        }
    }
    out.volume = volume.value();
    out.area = area.value();
    if (out.volume == 0) return out;
    const Vec3 mean{first[0].value() / out.volume, first[1].value() / out.volume, first[2].value() / out.volume};
    out.centroid = middle + mean;
    std::array<double, 9> moment{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            moment[static_cast<std::size_t>(3 * i + j)] = moment[static_cast<std::size_t>(3 * j + i)] =
                second[static_cast<std::size_t>(3 * i + j)].value() - out.volume * mean[i] * mean[j];
    const double trace = moment[0] + moment[4] + moment[8];
    for (std::size_t k = 0; k < 9; ++k) out.inertia[k] = (k % 4 == 0 ? trace : 0) - moment[k];
    return out;
}

}  // namespace whittle
