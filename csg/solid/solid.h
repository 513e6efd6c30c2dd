// solid.h — the canonical solid: a hash-consed DAG of shapes, placements and set operations.
//
// Equal sets are one node with one id: building a node twice gives the id of the first. What is not geometry (colour, matter, place in the
// text, author's order) sits on *uses* of nodes. Every number in it is finite; sizes are positive; nothing in it needs to be checked again.
// A 2D node lies in the plane z = 0 of its frame; it appears only below Extrusion and Revolution, or as the root of a 2D scene.
//
// Source: Roth, Ray Casting for Modeling Solids (1982); Goto, hash-consing (1974).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "csg/base/vec.h"
#include "csg/eval/matter.h"
#include "csg/lang/source.h"

namespace whittle {

using NodeId = std::uint32_t;
using LabelId = std::uint32_t;
using MotionId = std::uint32_t;  // 0: does not move

inline constexpr NodeId kEmptyNode = 0;
inline constexpr LabelId kNoLabel = 0;

// Facets are counter-clockwise seen from outside; each has at least three indices into `points`.
struct FacetList {
    std::vector<Vec3> points;
    std::vector<std::vector<std::uint32_t>> facets;
    bool operator==(const FacetList&) const = default;
};

namespace shape {

struct Box { Vec3 lo, hi; bool operator==(const Box&) const = default; };
// Centre at the origin; a ball when the radii are equal.
struct Ellipsoid { Vec3 radii; bool operator==(const Ellipsoid&) const = default; };
// True cylinder or cone about z: radius r0 at z0, r1 at z1; z0 < z1; r0, r1 >= 0, not both 0.
struct Frustum { double z0, z1, r0, r1; bool operator==(const Frustum&) const = default; };
// About z; minor > major is the spindle, filled.
struct Torus { double major, minor; bool operator==(const Torus&) const = default; };
struct HalfSpace { Vec3 n; double d; bool operator==(const HalfSpace&) const = default; };  // n.p <= d
// c0 x^2 + c1 y^2 + c2 z^2 + c3 xy + c4 xz + c5 yz + c6 x + c7 y + c8 z + c9 <= 0
struct Quadric { std::array<double, 10> c; bool operator==(const Quadric&) const = default; };
struct Capsule { Vec3 p, q; double r; bool operator==(const Capsule&) const = default; };
struct RoundBox { Vec3 lo, hi; double r; bool operator==(const RoundBox&) const = default; };
// OpenSCAD's n-gon solids (openscad-language 1.15), vertices on +x first.
struct FacetedBall { double r; int n; bool operator==(const FacetedBall&) const = default; };
struct FacetedFrustum { double z0, z1, r0, r1; int n; bool operator==(const FacetedFrustum&) const = default; };
struct Polyhedron { std::shared_ptr<const FacetList> mesh; bool operator==(const Polyhedron& o) const { return *mesh == *o.mesh; } };
// The 2D node `profile` swept from z0 to z1; scale_top and twist at z1 relative to z0, twist clockwise in degrees going up.
// slices == 0: the true ruled or helical surface; slices > 0 is OpenSCAD's faceted one.
struct Extrusion {
    NodeId profile; double z0, z1; double twist_deg; Vec2 scale_top; int slices;
    bool operator==(const Extrusion&) const = default;
};
// The 2D node `profile` (x -> radius, y -> z) turned about z from start_deg by angle_deg in (0, 360] counter-clockwise from +x.
// fragments == 0: the true surface; fragments > 0 is OpenSCAD's faceted one.
struct Revolution {
    NodeId profile; double start_deg, angle_deg; int fragments;
    bool operator==(const Revolution&) const = default;
};
// 2D shapes.
struct Disc { double r; bool operator==(const Disc&) const = default; };
struct Rectangle { Vec2 lo, hi; bool operator==(const Rectangle&) const = default; };
struct Polygon {  // even-odd over all contours
    std::shared_ptr<const std::vector<std::vector<Vec2>>> contours;
    bool operator==(const Polygon& o) const { return *contours == *o.contours; }
};

}  // namespace shape

using Shape = std::variant<shape::Box, shape::Ellipsoid, shape::Frustum, shape::Torus, shape::HalfSpace, shape::Quadric, shape::Capsule,
                           shape::RoundBox, shape::FacetedBall, shape::FacetedFrustum, shape::Polyhedron, shape::Extrusion, shape::Revolution,
                           shape::Disc, shape::Rectangle, shape::Polygon>;

// What a use adds to the node it uses. Materials nest: the outermost wins, parameter by parameter (nested() in matter.h).
struct Label {
    Material material;
    SourcePlace place;
    std::string part;
    bool operator==(const Label&) const = default;
};

// A motion over the shutter: the placement at time 0 and at time 1 (rigid part interpolated on the screw, see tracer/engine).
struct Motion { Placement start, end; bool operator==(const Motion&) const = default; };

struct Use {
    NodeId node = kEmptyNode;
    LabelId label = kNoLabel;
    MotionId motion = 0;
    Placement placement;
    bool operator==(const Use&) const = default;
};

enum class SetOp : std::uint8_t { kUnion, kIntersection, kDifference };

// kDifference: the first operand less all the others. Operands keep the author's order.
struct Combination {
    SetOp op = SetOp::kUnion;
    std::vector<Use> operands;
    bool operator==(const Combination&) const = default;
};

using Node = std::variant<Shape, Combination>;

// An immutable solid. Children have smaller ids than their parents. Node 0 is the empty set (a union of nothing).
class Solid {
public:
    const Node& node(NodeId id) const { return nodes_[id]; }
    std::size_t node_count() const { return nodes_.size(); }
    Use root() const { return root_; }
    const Label& label(LabelId id) const { return labels_[id]; }
    const Motion& motion(MotionId id) const { return motions_[id]; }
    // Closed box around the node in its own frame, outward rounded; infinite where unbounded, empty where the node is empty. Motion included.
    const Bounds& bounds(NodeId id) const { return bounds_[id]; }
    // Box of the whole solid in the root frame.
    Bounds root_bounds() const;
    bool is_2d(NodeId id) const { return flat_[id]; }
    // The id of the first node that is equal to this one once all labels are removed: equal for equal geometry.
    NodeId geometry(NodeId id) const { return geometry_[id]; }

private:
    friend class SolidBuilder;
    std::vector<Node> nodes_;
    std::vector<Bounds> bounds_;
    std::vector<bool> flat_;
    std::vector<NodeId> geometry_;
    std::vector<Label> labels_;
    std::vector<Motion> motions_;
    Use root_;
};

// Box around a placed box, outward rounded.
Bounds placed_bounds(const Bounds& box, const Placement& placement);

// Makes a solid bottom-up. Laws: shape(s) == shape(s); combine simplifies what needs no geometry: A-A, A&0, A|0 -> A, a union of one
// unlabelled identity use is that use's node, equal operands of a union or intersection once, operands whose boxes are disjoint.
class SolidBuilder {
public:
    SolidBuilder();
    NodeId shape(Shape shape);
    NodeId combine(SetOp op, std::vector<Use> operands);
    LabelId label(Label label);
    MotionId motion(Motion motion);
    const Bounds& bounds(NodeId id) const { return solid_.bounds_[id]; }
    bool is_2d(NodeId id) const { return solid_.flat_[id]; }
    // The builder is spent afterwards.
    Solid finish(Use root);

private:
    NodeId intern(Node node);
    Solid solid_;
    std::unordered_multimap<std::uint64_t, NodeId> by_hash_;
    std::unordered_multimap<std::uint64_t, LabelId> labels_by_hash_;
};

}  // namespace whittle
