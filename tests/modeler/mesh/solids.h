// solids.h — small solids for the tests of meshes, and what the tests ask of every mesh.
#pragma once

#include <catch2/catch.hpp>

#include "csg/solid/solid.h"
#include "modeler/mesh/mesh.h"
#include "modeler/mesh/mesh_queries.h"

namespace whittle::test {

inline Use at(NodeId node, Vec3 by = Vec3{0}) {
    Use use;
    use.node = node;
    use.placement = Placement::translation(by);
    return use;
}
inline Use placed(NodeId node, const Placement& placement) {
    Use use;
    use.node = node;
    use.placement = placement;
    return use;
}

// Meshes `node` of the builder (which is spent) and requires what every mesh promises.
inline MeshResult meshed(SolidBuilder& builder, Use root, const MeshOptions& options = {}) {
    const Solid solid = builder.finish(root);
    MeshControl control;
    auto result = mesh_solid(solid, options, control);
    if (!result) FAIL(result.error().message);
    INFO("open " << result->report.open_edges << " degenerate " << result->report.degenerate << " duplicate " << result->report.duplicate);
    CHECK(result->report.valid());
    CHECK(result->mesh.leaf.size() == result->mesh.triangles.size());
    return std::move(*result);
}
inline MeshResult meshed(SolidBuilder& builder, NodeId node, const MeshOptions& options = {}) { return meshed(builder, at(node), options); }

inline double volume(const MeshResult& result) { return mass_properties(result.mesh).volume; }
inline double area(const MeshResult& result) { return mass_properties(result.mesh).area; }

}  // namespace whittle::test
