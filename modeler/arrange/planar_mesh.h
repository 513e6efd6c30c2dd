// planar_mesh.h — a constrained triangulation in one plane, exact: segments may overlap and cross, and where they cross a point is made.
//
// The plane is seen along one axis. Triangles that have not been cut by a constraint are close to Delaunay's, by a circle test in double that only
// decides which of two right answers is nicer.
// Source: Lawson, Software for C1 surface interpolation (1977); Sloan, A fast algorithm for generating constrained Delaunay triangulations (1993).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "modeler/arrange/exact_points.h"

namespace whittle {

// What fixes the line of a constraint in its plane: another plane through it, and, where the constraint is part of an edge between grid points, these.
struct LineSupport {
    ExactPlane plane;
    bool is_edge = false;
    GridPoint a{}, b{};
};

class PlanarMesh {
public:
    using VertexId = std::uint32_t;
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;
    static constexpr VertexId kCorners = 4;  // of the frame around everything: vertices 0 to 3

    struct Cell {
        std::array<VertexId, 3> v;             // counter-clockwise seen along the axis
        std::array<std::uint32_t, 3> across;   // neighbour over the edge v[k], v[k+1]
        std::array<std::uint32_t, 3> support;  // of a constraint on that edge, kNone: not constrained
    };

    // Requires: n[axis] > 0; all that is inserted lies in the plane and, seen along the axis, strictly inside the frame.
    PlanarMesh(PointTable& points, const ExactPlane& plane, int axis, const GridPoint& frame_lo, const GridPoint& frame_hi);

    void insert(std::span<const PointId> points);
    std::uint32_t add_support(const LineSupport& support);
    // Both ends have been inserted.
    void constrain(PointId from, PointId to, std::uint32_t support);
    // A constraint could not be kept: the input was not what it has to be. What follows means nothing.
    bool failed() const { return failed_; }
    // Flips towards Delaunay's triangulation within the constraints.
    void improve();

    const std::vector<Cell>& cells() const { return cells_; }
    PointId point(VertexId v) const { return ids_[v]; }
    // A cell at the frame, outside of all that was inserted.
    std::uint32_t frame_cell() const { return at_[0]; }
    // Calls visit(cell, k) for the constrained edges v[k] -> v[k+1] that make up the straight line between two inserted points.
    template <class Visit>
    void along(PointId from, PointId to, const Visit& visit) {
        const VertexId end = local_.at(to);
        for (VertexId at = local_.at(from); at != end && !failed_;) {
            const Step step = step_towards(at, end);
            if (step.kind != Step::Kind::kVertex) {
                failed_ = true;
                return;
            }
            const auto edge = find_edge(at, step.vertex);
            if (edge) visit(edge->first, edge->second);
            at = step.vertex;
        }
    }

private:
    using Edge = std::pair<std::uint32_t, std::size_t>;  // cell, edge
    struct Step {
        enum class Kind { kVertex, kEdge, kLost } kind = Kind::kLost;
        VertexId vertex = 0;
        Edge edge{0, 0};
    };

    int turn(VertexId a, VertexId b, VertexId c) const { return points_.turn(ids_[a], ids_[b], ids_[c], axis_); }
    bool ahead(VertexId from, VertexId via, VertexId to) const;
    VertexId insert_point(PointId p);
    VertexId new_vertex(PointId p);
    Edge locate(PointId p, int& zeros) const;
    Edge locate_slowly(PointId p, int& zeros) const;
    void split_cell(std::uint32_t t, VertexId p);
    void split_edge(Edge edge, VertexId p);
    void flip(Edge edge);
    bool convex(Edge edge) const;
    bool nicer_flipped(Edge edge) const;
    void legalise(std::vector<Edge>& stack);
    Step step_towards(VertexId from, VertexId to) const;
    std::optional<Edge> find_edge(VertexId a, VertexId b) const;
    bool open_way(VertexId from, VertexId to, std::uint32_t support, VertexId& reached);
    void clear_crossed(VertexId from, VertexId to, std::vector<std::array<VertexId, 2>>& crossed);
    std::optional<PointId> crossing(std::uint32_t support, std::uint32_t other);
    void mark(VertexId a, VertexId b, std::uint32_t support);
    void replace_neighbour(std::uint32_t cell, std::uint32_t was, std::uint32_t is);
    std::size_t index_of(std::uint32_t cell, std::uint32_t neighbour) const;
    static std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }

    PointTable& points_;
    ExactPlane plane_;
    int axis_;
    std::vector<Cell> cells_;
    std::vector<PointId> ids_;            // of vertices
    std::vector<std::uint32_t> at_;       // a cell of each vertex
    std::unordered_map<PointId, VertexId> local_;
    std::vector<LineSupport> supports_;
    std::uint32_t last_ = 0;
    bool failed_ = false;
};

}  // namespace whittle
