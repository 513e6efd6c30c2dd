// planner.h — from a solid to the plan of its mesh: every leaf cut into triangles and put on the grid, every operation that matters.
//
// A combination that stands under a turn or a shear of its own is meshed as a whole in its own axes, where its flush faces are flush, and enters as a leaf; one
// that is used in many such places is meshed once.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "modeler/mesh/grid.h"
#include "modeler/mesh/plan.h"
#include "modeler/mesh/tessellate.h"

namespace whittle {

// What a use on the path to a leaf adds.
struct Path {
    Placement placement;
    Material material;
    std::string part;
    SourcePlace place;
    std::uint32_t subtractions = 0;
};

// Meshes a node in its own axes; lengths of the rule are in them.
using NodeMesher = std::function<Result<MeshResult>(NodeId, const CurveRule&)>;

class Planner {
public:
    // Leaves, tolerance and counts go into `result`. `room` is the box of the whole; `rule.scale` holds for the frame that the root stands in.
    Planner(const Solid& solid, const Use& root, const CurveRule& rule, NodeMesher mesher, MeshControl& control, const Bounds& room, MeshResult& result);

    const Plan& plan() const { return plan_; }
    const Grid& grid() const { return grid_; }
    const KnownPoints& known() const { return known_; }
    // From the axes of the grid to those of the root.
    const Placement& frame() const { return frame_; }

    Result<std::optional<Instance>> build(const Use& use, Path path);

private:
    void enter(const Use& use, Path& path) const;
    Result<std::optional<Instance>> combination(const Combination& c, const Path& path);
    void put_cutters_first(std::size_t begin, std::size_t middle);
    Result<std::optional<Instance>> leaf(NodeId node, const Path& path);
    Result<std::optional<Instance>> piece_of(const LeafMesh& mesh, const Path& path, std::uint32_t number, bool may_cross_itself);
    Result<std::shared_ptr<const Tessellation>> tessellated(NodeId node, const Placement& placement);
    bool is_turned_part(const Use& use, const Placement& placement);
    bool is_bounded(NodeId node);
    Result<std::optional<Instance>> turned_part(NodeId node, const Path& path);
    Result<std::shared_ptr<const MeshResult>> meshed_apart(NodeId node, double scale);

    const Solid& solid_;
    NodeMesher mesher_;
    MeshControl& control_;
    Bounds room_;
    MeshResult& result_;
    Placement frame_, to_frame_;
    CurveRule rule_;
    Grid grid_;
    double own_grid_mm_ = 0;
    Plan plan_;
    KnownPoints known_;
    std::map<std::pair<NodeId, double>, std::shared_ptr<const Tessellation>> tessellations_;
    std::map<std::pair<NodeId, double>, std::shared_ptr<const MeshResult>> apart_;
    std::map<NodeId, bool> bounded_;
};

bool finite(const Bounds& b);
double largest_coordinate(const Bounds& b);
// The largest coordinate of any bounded leaf, in place.
double farthest_leaf(const Solid& solid, const Use& use, const Placement& outer);

}  // namespace whittle
