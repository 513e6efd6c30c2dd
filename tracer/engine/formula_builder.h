// formula_builder.h — the walk from solid to formula; private to lower*.cpp.
#pragma once

#include <functional>
#include <map>
#include <tuple>

#include "csg/base/result.h"
#include "tracer/engine/chain.h"
#include "tracer/engine/formula.h"
#include "tracer/engine/placer.h"

namespace whittle {

// Below an extrusion whose sides are turned: the placement of the extrusion, and one piece of its way up.
struct Turning {
    Chain chain;
    Twist twist;
    bool failed = false;  // some part of the profile could not be written
};

// Where in the tree a node stands.
struct Site {
    Chain chain;
    MotionId motion = 0;
    bool negated = false;
    std::uint32_t subtractions = 0;
    std::uint32_t use = 0xFFFFFFFF;  // set below an extrusion or revolution: its profile belongs to its use
    bool exact = true;  // false: what is made stands for a curved surface, within a tolerance
    std::array<double, 2> heights{-HUGE_VAL, HUGE_VAL};  // below an extrusion: what lies outside its ends does not matter
    const Material* material = nullptr;
    SourcePlace place;
    Turning* turning = nullptr;  // if set, `chain` is that within the profile
};

inline constexpr std::uint32_t kNoUse = 0xFFFFFFFF;
inline constexpr FormulaId kNoFormula = 0xFFFFFFFF;

class FormulaBuilder {
public:
    explicit FormulaBuilder(const Solid& solid) : solid_(solid) {}
    Result<Formula> run();

private:
    FormulaId node(NodeId id, const Site& site);
    FormulaId use(const Use& use, const Site& site);
    FormulaId combination(const Combination& c, const Site& site);
    FormulaId shape(NodeId id, const Shape& shape, Site site);
    // The material, from the last few if it is among them.
    const SharedMaterial& shared(const Material& material);

    // One shape each; `site.use` is set.
    FormulaId box(Vec3 lo, Vec3 hi, const Site& site);
    FormulaId operator_shape(const shape::Ellipsoid& s, const Site& site);
    FormulaId operator_shape(const shape::Frustum& s, const Site& site);
    FormulaId operator_shape(const shape::Torus& s, const Site& site);
    FormulaId operator_shape(const shape::HalfSpace& s, const Site& site);
    FormulaId operator_shape(const shape::Quadric& s, const Site& site);
    FormulaId operator_shape(const shape::Capsule& s, const Site& site);
    FormulaId operator_shape(const shape::RoundBox& s, const Site& site);
    FormulaId convex(NodeId id, const shape::ConvexBody& s, const Site& site);
    FormulaId operator_shape(const shape::Extrusion& s, const Site& site);
    FormulaId operator_shape(const shape::Revolution& s, const Site& site);
    FormulaId operator_shape(const shape::Disc& s, const Site& site);
    FormulaId operator_shape(const shape::Rectangle& s, const Site& site);
    FormulaId operator_shape(const shape::Polygon& s, const Site& site);
    FormulaId operator_shape(const shape::ParabolicSegment& s, const Site& site);
    // The part of a 3D node in the plane z = 0, swept along z; kNoFormula where that takes facets.
    FormulaId section(NodeId solid, const Site& site);
    // Below a section: planes along the section's own, on whose one side all of it lies. False: on the outer one.
    bool drop_constant_planes(std::vector<HalfSpaceRef>& half_spaces) const;
    // Of a 2D shape swept along z: where it matters.
    static Bounds swept(Vec2 lo, Vec2 hi, const Site& site) { return {Vec3(lo, site.heights[0]), Vec3(hi, site.heights[1])}; }
    FormulaId faceted(NodeId id, const Site& site);
    // A ball or frustum of facets as one cell; kNoFormula where its planes would not be told apart well.
    template <class S>
    FormulaId of_belts(const S& s, const Site& site);
    // Where the profile is one parabola and nothing else.
    const shape::ParabolicSegment* profile_segment(const shape::Extrusion& s) const;
    // A profile of straight sides under a scale.
    FormulaId stretched(NodeId id, const shape::Extrusion& e, const Site& site);
    static HalfSpaceRef stretched_side(Placer& placer, const shape::Extrusion& e, Vec2 p, Vec2 q);
    bool has_straight_sides(NodeId profile) const;
    // A profile that turns, or has curves and shrinks unevenly.
    FormulaId turned(NodeId id, const shape::Extrusion& e, const Site& site);
    FormulaId turned_shape(NodeId id, const Shape& shape, const Site& site);
    // A set of straight sides.
    FormulaId turned_polygons(NodeId id, const Site& site);
    Vec2 turned_image(Vec2 p, const Site& site);
    // In both coordinates of a profile in the placement, for the report.
    void note_rounding(double length, const Placement& placement);
    // The profile's contours, their rounding noted. `placement`: of the profile.
    std::vector<std::vector<Vec2>> profile_rings(NodeId profile, const Placement& placement);
    FormulaId turned_ring(const std::vector<Vec2>& ring, const Site& site);
    // `around`: their convex hull holds the cell's section before it is turned.
    FormulaId turned_cell(const std::vector<Vec2>& around, const Site& site, const std::function<std::vector<HalfSpaceRef>(Placer&)>& sides);
    FormulaId tapered(NodeId id, const shape::Extrusion& e, const shape::ParabolicSegment& s, const Site& site);
    // Are the facets of the shape its true surface? False for a smooth twist, and where true arcs become chords.
    bool has_flat_faces(NodeId id) const;
    FormulaId prism(const std::vector<std::vector<Vec2>>& contours, const Site& site);

    // Revolution of a 2D node; `plane` maps the profile's plane (x: radius, y: height).
    FormulaId revolved(NodeId id, const Chain& plane, const Site& site);
    FormulaId revolved_disc(double x, double z, double r, const Site& site);
    FormulaId revolved_polygon(const std::vector<std::vector<Vec2>>& contours, const Site& site);
    FormulaId ring(double z0, double z1, Vec2 inner0, Vec2 inner1, Vec2 outer0, Vec2 outer1, bool has_inner, const Site& site);
    FormulaId wedge(double start_deg, double angle_deg, const Bounds& box, const Site& site);

    // Nodes; simplified where that needs no geometry. AND and OR swap where the site is negated.
    static FormulaNode leaf(FormulaKind kind, const Bounds& box, const Site& site);
    FormulaId cell(std::vector<HalfSpaceRef> half_spaces, const Bounds& box, const Site& site);
    FormulaId all_of(std::vector<FormulaId> children, const Site& site);
    FormulaId any_of(std::vector<FormulaId> children, const Site& site);
    FormulaId join(FormulaKind kind, const std::vector<FormulaId>& children);
    FormulaId constant(bool value);
    FormulaId push(FormulaNode node);
    void order_cuts();

    // Uses made below a difference: [first, middle) of what is cut, [middle, end) of what cuts.
    struct Parted { std::size_t first, middle, end; };

    const Solid& solid_;
    std::vector<Parted> differences_;
    std::vector<SharedMaterial> materials_;
    Formula out_;
    // By node, and by the permutation and scales that its points took in.
    std::map<std::tuple<NodeId, std::array<std::uint8_t, 3>, std::array<double, 3>>, std::shared_ptr<const TriangleList>> triangles_;
    std::string failure_;
};

}  // namespace whittle
