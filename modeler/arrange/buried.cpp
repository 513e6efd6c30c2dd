#include "modeler/arrange/buried.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "csg/base/vec.h"

namespace whittle {
namespace {

// Of a signed distance by one normal of length 1 and differences of whole numbers: 8 roundings and more, as a share of the distances multiplied.
constexpr double kDistanceError = 0x1p-48;
// With more planes only the ellipsoid is asked: testing them costs more than cutting the facet.
constexpr std::size_t kFewPlanes = 64;

bool is_closed(const GridMesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> edges;  // smaller, larger, direction
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[k == 2 ? 0 : k + 1];
            edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1U : 0U});
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        std::ptrdiff_t balance = 0;
        for (j = i; j < edges.size() && edges[j][0] == edges[i][0] && edges[j][1] == edges[i][1]; ++j) balance += edges[j][2] != 0 ? 1 : -1;
        if (balance != 0) return false;
    }
    return true;
}

// The points below all planes of a closed mesh: all its solid angles have one sign there, so they are inside, whatever its shape. An ellipsoid in it
// answers most questions at once.
class Kernel {
public:
    explicit Kernel(const GridMesh& mesh) {
        DoubleBox box = DoubleBox::at(to_double(mesh.points.front()));
        for (const GridPoint& p : mesh.points) box.include(to_double(p));
        for (std::size_t k = 0; k < 3; ++k) {
            centre_[k] = (box.lo[k] + box.hi[k]) / 2;
            half_[k] = std::max(1.0, (box.hi[k] - box.lo[k]) / 2);
            size_ += box.hi[k] - box.lo[k];
        }
        std::set<FacetTag> seen;
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& t = mesh.triangles[i];
            const ExactPlane plane = plane_through(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
            if (!plane.valid() || !seen.insert(mesh.tags[i]).second) continue;
            planes_.push_back({unit(plane.nd), to_double(plane.at)});
            least = std::min(least, share_to(planes_.back()));
        }
        const double inner = std::max(0.0, least - kDistanceError * size_);
        inner_squared_ = inner * inner;
    }

    // A point relative to the mesh's own place.
    bool in_ellipsoid(const Approximate& p) const {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += (p[k] - centre_[k]) / half_[k] * ((p[k] - centre_[k]) / half_[k]);
        return sum * (1 + kDistanceError) < inner_squared_;
    }
    bool below_all_planes(const Approximate& p) const {
        if (planes_.size() > kFewPlanes) return false;
        for (const Plane& plane : planes_)
            if (distance(plane, p) > -kDistanceError * size_) return false;
        return true;
    }

private:
    struct Plane {
        Approximate n;  // of length 1
        Approximate at;
    };
    static Approximate to_double(const GridPoint& p) { return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}; }
    static Approximate unit(const Approximate& n) {
        const double length = std::hypot(n[0], n[1], n[2]);
        return {n[0] / length, n[1] / length, n[2] / length};
    }
    static double distance(const Plane& plane, const Approximate& p) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += plane.n[k] * (p[k] - plane.at[k]);
        return sum;
    }
    // How far the ellipsoid of the box's proportions may be blown up before it meets the plane; 1 fills the box.
    double share_to(const Plane& plane) const {
        double stretch = 0;
        for (std::size_t k = 0; k < 3; ++k) stretch += plane.n[k] * half_[k] * (plane.n[k] * half_[k]);
        return (-distance(plane, centre_) - kDistanceError * size_) / std::sqrt(stretch);
    }

    Approximate centre_{}, half_{};
    std::vector<Plane> planes_;
    double size_ = 0, inner_squared_ = 0;
};

// An operand that settles the expression, in place.
struct Cover {
    const Kernel* kernel;
    Approximate at;
    std::uint32_t operand;
};
struct Covers {
    std::map<const GridMesh*, Kernel> kernels;
    std::vector<Cover> list;
    std::vector<DoubleBox> boxes;
};

DoubleBox box_of(const Patches& patches, const Facet& facet) {
    DoubleBox box = patches.boxes[facet.first_patch];
    for (std::uint32_t i = 1; i < facet.patch_count; ++i) box.include(patches.boxes[facet.first_patch + i]);
    return box;
}

bool is_within(const Patches& patches, const Facet& facet, const Cover& cover) {
    const auto all = [&](const auto& inside) {
        for (const auto& [a, b] : patches.borders_of(facet)) {
            const Approximate& p = patches.points.near(a);
            if (!inside({p[0] - cover.at[0], p[1] - cover.at[1], p[2] - cover.at[2]})) return false;
        }
        return facet.border_count > 0;
    };
    return all([&](const Approximate& p) { return cover.kernel->in_ellipsoid(p); }) || all([&](const Approximate& p) { return cover.kernel->below_all_planes(p); });
}

std::vector<std::optional<DoubleBox>> boxes_of(const Patches& patches, std::size_t operand_count) {
    std::vector<std::optional<DoubleBox>> out(operand_count);
    for (const Facet& f : patches.facets) {
        auto& box = out[f.operand];
        if (!box) box = box_of(patches, f);
        box->include(box_of(patches, f));
    }
    return out;
}

// Nothing where an operand is not closed.
std::optional<Covers> covers_of(const Patches& patches, std::span<const Operand> operands, const Expression& expression) {
    Covers out;
    std::set<const GridMesh*> closed;
    const auto boxes = boxes_of(patches, operands.size());
    for (std::uint32_t i = 0; i < operands.size(); ++i) {
        const GridMesh* mesh = operands[i].mesh;
        if (closed.insert(mesh).second && !is_closed(*mesh)) return std::nullopt;
        if (!boxes[i] || !expression.is_settled_within(i)) continue;
        const GridPoint& o = operands[i].offset;
        out.list.push_back({&out.kernels.try_emplace(mesh, *mesh).first->second,
                            {static_cast<double>(o[0]), static_cast<double>(o[1]), static_cast<double>(o[2])}, i});
        out.boxes.push_back(*boxes[i]);
    }
    return out;
}

}  // namespace

Buried nothing_buried(const Patches& patches, std::span<const Operand> operands) {
    return {std::vector<bool>(patches.facets.size(), false), std::vector<bool>(operands.size(), false), 0};
}

Buried buried_facets(const Patches& patches, std::span<const Operand> operands, const Expression& expression) {
    Buried out = nothing_buried(patches, operands);
    const auto covers = covers_of(patches, operands, expression);
    if (!covers || covers->list.empty()) return out;
    const BoxTree tree(covers->boxes, std::vector<std::uint32_t>(covers->boxes.size(), BoxTree::kMixed));
    for (std::uint32_t f = 0; f < patches.facets.size(); ++f) {
        const Facet& facet = patches.facets[f];
        const DoubleBox box = box_of(patches, facet);
        bool within = false;
        tree.touching(box, [&](std::uint32_t i) { within = within || (strictly_within(box, covers->boxes[i]) && is_within(patches, facet, covers->list[i])); });
        out.facets[f] = within;
        out.count += within ? 1U : 0U;
    }
    if (out.count > 0)
        for (const Cover& c : covers->list) out.operands[c.operand] = true;
    return out;
}

}  // namespace whittle
