// tessellate_flat.cpp — shapes with flat faces given by planes or by lists: half-spaces cut to the room, polyhedra.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "modeler/mesh/tessellate.h"
#include "modeler/mesh/triangulate.h"

namespace whittle {
namespace {

// A convex solid as polygons, cut by half-spaces.
class ConvexCut {
public:
    explicit ConvexCut(const Bounds& box) {
        const Tessellation t = tessellate_box(box.lo, box.hi);
        points_ = t.mesh.points;
        faces_ = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    }

    // Keeps n.p <= d. A corner on the plane stays.
    void keep(const Vec3& n, double d) {
        side_.clear();
        for (const Vec3& p : points_) side_.push_back(glm::dot(n, p) - d);
        cuts_.clear();
        std::vector<std::vector<std::uint32_t>> kept;
        std::map<std::uint32_t, std::uint32_t> lid;  // from where a face leaves the solid to where it comes back
        for (const auto& face : faces_) {
            std::vector<std::uint32_t> left;
            std::uint32_t out = 0, in = 0;
            bool crossed = false;
            for (std::size_t i = 0; i < face.size(); ++i) {
                const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
                const bool a_in = side_[a] <= 0, b_in = side_[b] <= 0;
                if (a_in) left.push_back(a);
                if (a_in == b_in) continue;
                const std::uint32_t c = cut(a, b);
                left.push_back(c);
                (a_in ? out : in) = c;
                crossed = true;
            }
            if (left.size() >= 3) kept.push_back(std::move(left));
            if (crossed) lid[in] = out;
        }
        if (!lid.empty()) {  // the face's new edge runs out -> in; the lid's runs back
            std::vector<std::uint32_t> loop;
            for (std::uint32_t at = lid.begin()->first; loop.size() < lid.size(); at = lid[at]) loop.push_back(at);
            kept.push_back(std::move(loop));
        }
        faces_.swap(kept);
    }

    LeafMesh triangles() const {
        LeafMesh mesh;
        mesh.points = points_;
        for (const auto& f : faces_)
            for (std::size_t i = 1; i + 1 < f.size(); ++i) mesh.triangles.push_back({f[0], f[i], f[i + 1]});
        return mesh;
    }

private:
    // One point for an edge, whichever face asks.
    std::uint32_t cut(std::uint32_t a, std::uint32_t b) {
        const auto [lo, hi] = std::minmax(a, b);
        const auto [at, fresh] = cuts_.try_emplace({lo, hi}, static_cast<std::uint32_t>(points_.size()));
        if (fresh) {
            const double t = side_[lo] / (side_[lo] - side_[hi]);
            Vec3 p = points_[lo] + t * (points_[hi] - points_[lo]);
            for (int i = 0; i < 3; ++i)
                if (points_[lo][i] == points_[hi][i]) p[i] = points_[lo][i];
            points_.push_back(p);
        }
        return at->second;
    }

    std::vector<Vec3> points_;
    std::vector<std::vector<std::uint32_t>> faces_;
    std::vector<double> side_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts_;
};

// A planar facet's points seen along the axis nearest to its normal, counter-clockwise, on 2^40 steps of its size.
std::vector<GridPoint2> flattened(const std::vector<Vec3>& corners) {
    Vec3 n{0}, lo = corners[0], hi = corners[0];
    for (std::size_t i = 0; i < corners.size(); ++i) {
        n += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
        lo = glm::min(lo, corners[i]);
        hi = glm::max(hi, corners[i]);
    }
    const Vec3 a = glm::abs(n);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double extent = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z});
    const double steps = extent > 0 ? 0x1p40 / extent : 1;
    std::vector<GridPoint2> flat;
    for (const Vec3& p : corners) {
        GridPoint2 g{std::llround((p[u] - lo[u]) * steps), std::llround((p[v] - lo[v]) * steps)};
        if (n[axis] < 0) std::swap(g.x, g.y);
        flat.push_back(g);
    }
    return flat;
}

void add_facet(LeafMesh& mesh, const std::vector<Vec3>& points, const std::vector<std::uint32_t>& facet) {
    if (facet.size() == 3) {
        mesh.triangles.push_back({facet[0], facet[1], facet[2]});
        return;
    }
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> contour;
    for (const std::uint32_t v : facet) {
        contour.push_back(static_cast<std::uint32_t>(corners.size()));
        corners.push_back(points[v]);
    }
    if (const auto triangles = triangulate(flattened(corners), {contour})) {
        for (const Triangle& t : *triangles) mesh.triangles.push_back({facet[t[0]], facet[t[1]], facet[t[2]]});
    } else {  // not a simple polygon: a fan keeps its border
        for (std::size_t i = 1; i + 1 < facet.size(); ++i) mesh.triangles.push_back({facet[0], facet[i], facet[i + 1]});
    }
}

}  // namespace

Bounds widened(const Bounds& room) {
    const double margin = glm::length(room.hi - room.lo) / 8;
    return {room.lo - margin, room.hi + margin};
}

Tessellation tessellate_half_space(const shape::HalfSpace& s, const Bounds& room) {
    ConvexCut cut(widened(room));
    cut.keep(s.n, s.d);
    Tessellation out;
    out.mesh = cut.triangles();
    return out;
}

Result<Tessellation> tessellate_polyhedron(const FacetList& list) {
    Tessellation out;
    out.mesh.points = list.points;
    for (const auto& facet : list.facets) add_facet(out.mesh, list.points, facet);
    double volume = 0;
    for (const Triangle& t : out.mesh.triangles) volume += glm::dot(list.points[t[0]], glm::cross(list.points[t[1]], list.points[t[2]]));
    if (volume < 0)  // facets listed from inside
        for (Triangle& t : out.mesh.triangles) std::swap(t[1], t[2]);
    return out;
}

}  // namespace whittle
