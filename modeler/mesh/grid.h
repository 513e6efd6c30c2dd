// grid.h — the decimal grid on which leaves are put before booleans.
//
// Two leaves that the author wrote as touching have coordinates that differ by roundings only (0.1+0.2 and 0.3). On a common grid, coarse against
// roundings and fine against the model, they are equal, and the exact boolean sees one plane. The grid is decimal because authors are: 0.3 is a grid
// point, and a grid point divided by a power of ten is the double nearest to that decimal, so what was written comes back as written.
#pragma once

#include <memory>
#include <optional>

#include "csg/base/result.h"
#include "modeler/arrange/grid_mesh.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// With it, a 3 x 3 determinant of differences stays below 2^127.
inline constexpr std::int64_t kLargestGridCoordinate = std::int64_t{1} << 40;

// A closed triangulated leaf in doubles.
struct LeafMesh {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> group;  // of each triangle, where it matters which of `group_count` uses one is of
    std::uint32_t group_count = 0;
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
};

struct Grid {
    double per_mm = 1;  // a power of ten

    // The finest grid on which coordinates of the result stay below kLargestGridCoordinate / 2 and those of any leaf below kLargestPlacedCoordinate.
    static Grid for_sizes(double largest_of_result, double largest_of_leaves);
    static Grid for_size(double largest) { return for_sizes(largest, largest); }
    std::int64_t snapped(double mm) const;
    double mm(double grid_units) const { return grid_units / per_mm; }
};

// A leaf on the grid, moved so that the low corner of its box is the origin.
struct SnappedLeaf {
    GridMesh mesh;
    GridPoint offset{};
    GridPoint size{};
    FacetTag tag_count = 0;
    std::vector<FacetTag> starts;   // the first tag of each group, where there are groups
    bool may_cross_itself = false;  // the shape does not promise that the mesh does not: to be looked at before a boolean
};

// Where points were before they went onto the grid, by grid point; the first leaf that has one says.
class KnownPoints {
public:
    KnownPoints();
    ~KnownPoints();
    KnownPoints(KnownPoints&&) noexcept;
    KnownPoints& operator=(KnownPoints&&) noexcept;
    void add(const GridPoint& at, const Vec3& was);
    const Vec3* find(const GridPoint& at) const;

private:
    struct Table;
    std::unique_ptr<Table> table_;
};

// The leaf after `placement` and, into the axes of the grid, `to_frame`, a rotation; on the grid: equal points merged, what has become nothing dropped, turned outward where the placement mirrors,
// tagged by exactly coplanar regions of a group. Empty where nothing is left.
SnappedLeaf snap_leaf(const LeafMesh& leaf, const Placement& placement, const Placement& to_frame, const Grid& grid, KnownPoints& known);

}  // namespace whittle
