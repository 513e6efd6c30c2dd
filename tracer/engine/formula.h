// formula.h — a solid written as a formula over half-spaces: AND and OR nodes in positive form, complements pushed to the leaves.
//
// Made from the canonical solid once (lower.h), with placements multiplied exactly and rounded once a frame; read by identity.h, which gives the
// supports their classes, and by compile, which turns it into the flat program.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "csg/base/vec.h"
#include "csg/solid/solid.h"
#include "tracer/engine/engine.h"
#include "tracer/engine/motion.h"
#include "tracer/engine/support.h"

namespace whittle {

using SupportId = std::uint32_t;
using FormulaId = std::uint32_t;

// The side of a support that is inside: f <= 0 (`inverted` false) or f >= 0.
struct HalfSpaceRef {
    SupportId support = 0;
    bool inverted = false;
};

// Where a support occurs: the box (root frame) that its faces may touch, the largest box of one occurrence, and the bound of the rounding that placements brought.
struct Occurrence {
    Bounds box;
    double extent = 0;
    double rounding = 0;
    double rounding_per_size = 0;  // of an unbounded occurrence: more by this for each unit of the box that bounds it in the end
};

// All supports and frames of a solid, each once by exact equality; ids by first appearance.
class SupportTable {
public:
    SupportTable();
    // `outer`: the frame in whose plane z = 0 the section lies that stands in this one.
    FrameId frame(const Placement& placement, MotionId motion, const Twist* twist = nullptr, const Frame* outer = nullptr);
    // The frame with a body in it, new every time: bodies that coincide are told by identity.h.
    FrameId frame_of(FrameId like, std::shared_ptr<const ConvexHullBody> body);
    SupportId add(const Support& support, const Bounds& box, double rounding, double rounding_per_size);
    // Unbounded occurrences (half-spaces, quadrics) touch the solid only inside its box.
    void bound_by(const Bounds& box);
    // The supports have their classes: only the frames are asked for from now on.
    void keep_frames();

    std::vector<Frame> frames;
    std::vector<Support> supports;
    std::vector<Occurrence> occurrences;

private:
    IdTable frames_by_hash_, supports_by_hash_;
};

// A polygon swept along the axis of its frame without end: inside by parity of the crossings of its edges.
struct PrismData {
    FrameId frame = 0;
    std::uint8_t axis = 2;
    std::vector<std::vector<Vec2>> contours;  // in the coordinates axis+1, axis+2
    std::vector<SupportId> edges;             // contour by contour, edge i from vertex i to i+1; an edge of no length has none (kNoSupport)
};
inline constexpr SupportId kNoSupport = 0xFFFFFFFF;

struct TriangleList {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A closed mesh: inside by parity of the crossings of its triangles.
struct MeshData {
    FrameId frame = 0;
    std::shared_ptr<const TriangleList> mesh;
    std::vector<SupportId> facets;  // one a triangle; kNoSupport where it has no area
    bool exact = true;              // as of a node
};

enum class FormulaKind : std::uint8_t { kCell, kPrism, kMesh, kAnd, kOr, kNothing, kEverything };

struct FormulaNode {
    FormulaKind kind = FormulaKind::kNothing;
    bool negated = false;        // leaves only
    bool exact = true;           // leaves only; false: it stands for a curved surface, within a tolerance
    bool outside_value = false;  // its value everywhere outside `box`
    Bounds box;                  // may be unbounded
    double room = 0;             // leaves only: so much of the box, on every side, is there because the placement is rounded far from the origin
    std::uint32_t use = 0;       // leaves only
    std::vector<FormulaId> children;
    std::vector<HalfSpaceRef> half_spaces;  // kCell: inside all of them
    std::uint32_t data = 0;                 // kPrism, kMesh: index
};

struct Formula {
    SupportTable table;
    std::vector<FormulaNode> nodes;
    std::vector<PrismData> prisms;
    std::vector<MeshData> meshes;
    std::vector<LeafUse> uses;
    std::vector<MotionGroup> motions{1};  // Frame::motion indexes this
    FormulaId root = 0;
    double largest_displacement = 0;
    std::vector<std::string> warnings;
};

inline Bounds everywhere() { return {Vec3(-HUGE_VAL), Vec3(HUGE_VAL)}; }

}  // namespace whittle
