// exact_kernel.h — exact set operations on triangle meshes behind a plain interface; the module whittle_cgal implements it.
//
// Points enter on an integer grid and stay exact rationals between operations. Every triangle carries a tag, the planar facet of a leaf it is part
// of: a result's tags are the operands' own, shifted so that they do not collide. CGAL's headers cost about a minute of compiling and its
// library a hundredth of a second of loading, so nothing includes them but the module, and nothing opens the module before a boolean is needed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/solid/solid.h"
#include "modeler/arrange/grid_mesh.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// With it, a 3 x 3 determinant of differences stays below 2^127.
inline constexpr std::int64_t kLargestGridCoordinate = std::int64_t{1} << 40;

// A mesh of exact points inside the module.
class ExactMesh {
public:
    virtual ~ExactMesh() = default;
    GridBox box;               // outward rounded
    std::size_t triangles = 0;
};
using ExactRef = std::shared_ptr<const ExactMesh>;

// A part of an operand: the mesh moved by `offset`, its tags raised by `tag_base`.
struct PlacedExact {
    ExactRef mesh;
    GridPoint offset{};
    FacetTag tag_base = 0;
};

// Where the module reports, and asks whether to go on.
struct KernelWatch {
    const MeshControl* control = nullptr;
    bool decimate = true;
    std::uint64_t booleans = 0, fallbacks = 0, decimated = 0;
    double seconds_decimate = 0;
};

// A result in grid units, each coordinate the exact one rounded to double.
struct RoundedMesh {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<FacetTag> tags;
};

class ExactKernel {
public:
    virtual ~ExactKernel() = default;
    // Requires what GridMesh promises.
    virtual Result<ExactRef> load(const GridMesh& mesh) const = 0;
    // a op b, each operand the disjoint union of its parts. kInterrupted when the watch says so; kWorld for what CGAL throws.
    virtual Result<ExactRef> combine(SetOp op, std::span<const PlacedExact> a, std::span<const PlacedExact> b, KernelWatch& watch) const = 0;
    virtual RoundedMesh rounded(const ExactMesh& mesh) const = 0;

    // Queries on doubles (queries_cgal.cpp).
    virtual Result<std::uint64_t> self_intersections(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) const = 0;
    virtual Result<Mesh> convex_hull(const std::vector<Vec3>& points) const = 0;
};

// The module's one kernel, opened on the first call; kWorld fault when it is not installed.
Result<const ExactKernel*> exact_kernel();

}  // namespace whittle
