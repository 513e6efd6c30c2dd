// solid.h — the canonical solid: a hash-consed DAG of shapes, placements and set operations.
//
// Equal sets are one node with one id: building a node twice gives the id of the first. What is not geometry (colour, matter, place in the
// text, author's order) sits on *uses* of nodes. Every number in it is finite; sizes are positive; nothing in it needs to be checked again.
// A 2D node lies in the plane z = 0 of its frame; it appears only below Extrusion and Revolution, or as the root of a 2D scene. A 3D node stands below a 2D one
// only as the solid whose section a polygon is.
//
// Source: Roth, Ray Casting for Modeling Solids (1982); Goto, hash-consing (1974).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
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

// The image of the unit ball under the matrix of these columns: a ball, an ellipsoid, an ellipse's disc where w is 0, a segment where v is 0 too.
struct BallImage { Vec3 u, v, w; bool operator==(const BallImage&) const = default; };
// The Minkowski sum of a point and such images; without any, the point.
struct ConvexPart { Vec3 centre; std::vector<BallImage> images; bool operator==(const ConvexPart&) const = default; };
class ConvexHullBody;  // csg/solid/convex_body.h

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
// The convex hull of parts that has an inside.
struct ConvexBody {
    std::shared_ptr<const ConvexHullBody> hull;
    bool operator==(const ConvexBody& o) const;
};
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
    // Unless empty, what the set is in truth: the part of this 3D node in the plane z = 0, where what is just above counts. The contours are within `deviation` of
    // its outline.
    NodeId section = kEmptyNode;
    double deviation = 0;
    bool operator==(const Polygon& o) const { return section == o.section && deviation == o.deviation && *contours == *o.contours; }
};

// Between the chord from a to b and the quadratic Bezier curve with control point c, an arc of a parabola. The three are not on one line.
struct ParabolicSegment { Vec2 a, c, b; bool operator==(const ParabolicSegment&) const = default; };

}  // namespace shape

using Shape = std::variant<shape::Box, shape::Ellipsoid, shape::Frustum, shape::Torus, shape::HalfSpace, shape::Quadric, shape::Capsule,
                           shape::RoundBox, shape::ConvexBody, shape::FacetedBall, shape::FacetedFrustum, shape::Polyhedron, shape::Extrusion, shape::Revolution,
                           shape::Disc, shape::Rectangle, shape::Polygon, shape::ParabolicSegment>;

// 2D shapes with a side that is not straight.
inline bool is_curved_2d(const Shape& s) {
    const auto* polygon = std::get_if<shape::Polygon>(&s);
    return polygon ? polygon->section != kEmptyNode : std::holds_alternative<shape::Disc>(s) || std::holds_alternative<shape::ParabolicSegment>(s);
}

// What a use adds to the node it uses. Materials nest: the outermost wins, parameter by parameter (nested() in matter.h). The place is that of the
// primitive and stands on the use of its shape; a label further out has none (line 0), and its part, if any, wins over those within.
struct Label {
    Material material;
    SourcePlace place;
    std::string part;
    bool operator==(const Label&) const = default;
};

// A motion over the shutter: the placement at time 0 and at time 1 (rigid part interpolated on the screw, see tracer/engine).
struct Motion { Placement start, end; bool operator==(const Motion&) const = default; };

// A point of the node goes through the motion, then through the placement. A use carries one placement of the author's; a chain whose product
// would round is a chain of unions of one use, so that the engine can multiply it exactly.
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

// The box of a use in the frame above it: its node's, moved and placed.
Bounds use_bounds(const Bounds& node_box, const Use& use, const Motion& motion);

// Open-addressed table from hashes to ids; the caller compares what the ids stand for. Insertion order decides nothing.
class IdTable {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;
    // The id of an entry with this hash for which same(id) holds, else kNone.
    template <class Same>
    std::uint32_t find(std::uint64_t hash, Same same) const {
        if (slots_.empty()) return kNone;
        for (std::size_t i = hash & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
            if (slots_[i].id == kNone) return kNone;
            if (slots_[i].hash == hash && same(slots_[i].id)) return slots_[i].id;
        }
    }
    void insert(std::uint64_t hash, std::uint32_t id);
    void reserve(std::size_t entries);

private:
    struct Slot { std::uint64_t hash; std::uint32_t id; };
    void put(Slot slot);
    std::vector<Slot> slots_;  // a power of two of them, at most two thirds full
    std::size_t used_ = 0;
};

// The skips made while a solid is built. Each leaves the set and its labels as they are.
struct SolidPasses {
    bool equal = true;     // A-A, A&A, A|A
    bool disjoint = true;  // cutters that miss, intersections of disjoint boxes
    bool buried = true;    // parts inside a box
};
struct SkipCounts { std::uint64_t equal = 0, disjoint = 0, buried = 0; };

// Makes a solid bottom-up. Laws: shape(s) == shape(s); combine simplifies what needs no geometry: A-A, A&0, A|0 -> A, a union of one
// unlabelled identity use is that use's node, equal operands of a union or intersection once, operands whose boxes are disjoint,
// (A|B)|C -> A|B|C and likewise for & and for the first operand of -, where the inner use is unlabelled and in place.
// An operand is dropped only where its matter cannot show (same materials, or nothing clear in either).
class SolidBuilder {
public:
    explicit SolidBuilder(SolidPasses passes = {});
    // Requires: finite numbers and the sizes solid.h asks for; a profile is 2D. kEmptyNode where the shape certainly has no inside.
    NodeId shape(Shape shape);
    // Requires: operands all 2D or all 3D; finite placements with a determinant that is not zero.
    NodeId combine(SetOp op, std::vector<Use> operands);
    LabelId label(Label label);
    MotionId motion(Motion motion);
    // `outer` on top of `use`: placements folded where that is exact, else `use` is wrapped.
    Use placed(const Placement& outer, Use use);
    // `outer` around the use's own label.
    Use labelled(const Label& outer, Use use);
    Bounds bounds(NodeId id) const { return solid_.bounds_[id]; }
    Bounds bounds(const Use& use) const { return use_bounds(bounds(use.node), use, solid_.motions_[use.motion]); }
    bool is_2d(NodeId id) const { return solid_.flat_[id]; }
    // References hold until something is added.
    const Node& node(NodeId id) const { return solid_.nodes_[id]; }
    const Label& label_of(LabelId id) const { return solid_.labels_[id]; }
    // The solid as it is now, for those who need to look at part of it; root() is the empty node.
    const Solid& so_far() const { return solid_; }
    const SkipCounts& skipped() const { return skipped_; }
    // Nodes that the root does not reach are dropped. The builder is spent afterwards.
    Solid finish(Use root);

private:
    NodeId intern(Node node, std::uint64_t hash, const Bounds& bounds, bool flat, bool plain);
    NodeId geometry_of(NodeId id);
    std::optional<Use> folded(const Use& outer) const;
    void flatten(SetOp op, std::vector<Use>& operands);
    bool drop_empty(SetOp op, std::vector<Use>& operands) const;
    bool subtracts_itself(SetOp op, const std::vector<Use>& operands);
    void drop_equal(SetOp op, std::vector<Use>& operands);
    bool drop_disjoint(SetOp op, std::vector<Use>& operands);
    bool drop_buried(SetOp op, std::vector<Use>& operands);
    bool same_set(const Use& a, const Use& b) const;
    bool may_absorb(const Use& kept, const Use& dropped) const;

    SolidPasses passes_;
    SkipCounts skipped_;
    Solid solid_;
    std::vector<bool> plain_;  // per node: no label within names anything clear
    IdTable nodes_by_hash_, geometry_by_hash_, labels_by_hash_, motions_by_hash_;
};

}  // namespace whittle
