// tessellate.h — every shape as a closed triangle mesh in its own frame, within the tolerance of a CurveRule.
//
// Points of true curves lie on the curve, so a mesh of a convex shape is inside it. Points at multiples of 90 degrees are exact. Equal points may
// be listed twice and triangles between them may be empty: snap_leaf (grid.h) joins and drops them.
#pragma once

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "modeler/mesh/curve_rule.h"
#include "modeler/mesh/grid.h"

namespace whittle {

struct Tessellation {
    LeafMesh mesh;
    double error = 0;             // no point of the shape's surface is farther from the mesh, in the root frame; 0 for flat shapes
    std::vector<LeafMesh> more;   // further pieces, which meet the first and each other in single points at most
    std::optional<LeafMesh> less; // where the shape is all of this mesh but the pieces (the outside of a quadric)
};

// `room` is a box in the shape's frame that holds all of the shape that matters: unbounded shapes are cut a little outside of it.
// Errors: kScene for a shape that is 2D, or a polyhedron or profile that encloses nothing.
Result<Tessellation> tessellate(const Solid& solid, NodeId node, const CurveRule& rule, const Bounds& room);

// The pieces, one file each.
Tessellation tessellate_box(const Vec3& lo, const Vec3& hi);
Tessellation tessellate_rounded(const Vec3& lo, const Vec3& hi, double r, const CurveRule& rule);  // box [lo, hi] grown by r
Tessellation tessellate_ellipsoid(const Vec3& radii, const CurveRule& rule);
Tessellation tessellate_capsule(const shape::Capsule& s, const CurveRule& rule);
Result<Tessellation> tessellate_convex(const shape::ConvexBody& s, const CurveRule& rule);
Tessellation tessellate_frustum(const shape::Frustum& s, const CurveRule& rule);
Tessellation tessellate_torus(const shape::Torus& s, const CurveRule& rule);
Tessellation tessellate_half_space(const shape::HalfSpace& s, const Bounds& room);
Result<Tessellation> tessellate_quadric(const shape::Quadric& s, const CurveRule& rule, const Bounds& room);
Tessellation tessellate_faceted_ball(const shape::FacetedBall& s);
Tessellation tessellate_faceted_frustum(const shape::FacetedFrustum& s);
Result<Tessellation> tessellate_polyhedron(const FacetList& list);
Result<Tessellation> tessellate_extrusion(const Solid& solid, const shape::Extrusion& s, const CurveRule& rule);
Result<Tessellation> tessellate_revolution(const Solid& solid, const shape::Revolution& s, const CurveRule& rule);

// Helpers shared by them.
// The room and an eighth of its diagonal around it: what is cut there shows nowhere.
Bounds widened(const Bounds& room);
// Two rings of n points each, numbered consecutively from a and from b, b above a, joined by a wall that faces outward when the rings run
// counter-clockwise seen from above.
void join_rings(LeafMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t n);
// A convex ring of n points from `first` closed by triangles; counter-clockwise as the ring runs, or reversed.
enum class Facing { kAsListed, kReversed };
void close_ring(LeafMesh& mesh, std::uint32_t first, std::uint32_t n, Facing facing);

}  // namespace whittle
