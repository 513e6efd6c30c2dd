// placer.h — writes half-spaces given in a shape's own coordinates into the frame that holds them.
#pragma once

#include <optional>

#include "tracer/engine/chain.h"
#include "tracer/engine/formula.h"

namespace whittle {

// How much of a chain's axis map a shape can take into its own numbers.
// kRigid: also even scales by powers of two. kExact: what rounds nothing, so powers of two on each axis and no shift.
enum class Absorb { kAny, kUniformScale, kRigid, kExact, kNothing };

// Boxes are wider by so many times what their placements may be rounded by.
inline constexpr double kBoxRoom = 4;

class Placer {
public:
    // `box`: the shape's, in its own coordinates. `twist`: that of the frame; goes with kNothing.
    Placer(Formula& formula, const Chain& chain, MotionId motion, const Bounds& box, Absorb absorb, const Twist* twist = nullptr);

    // Inside where the coordinate is at most (below) or at least `value`.
    HalfSpaceRef axis_plane(int axis, double value, bool below);
    HalfSpaceRef plane(Vec3 n, double d);  // n.p <= d; needs kRigid or less, unless is_axis_plane(n, d)
    static bool is_axis_plane(Vec3 n, double d);  // n has one entry that is not zero, and d divided by it is a double
    HalfSpaceRef ball(Vec3 centre, double r);
    HalfSpaceRef ellipsoid(Vec3 centre, Vec3 radii);
    HalfSpaceRef cylinder(int axis, Vec3 through, double r);
    HalfSpaceRef cone(int axis, Vec3 through, double z0, double z1, double r0, double r1);
    HalfSpaceRef tube(Vec3 p, Vec3 q, double r);
    HalfSpaceRef quadric(const std::array<double, 10>& c);  // needs kExact or kNothing
    HalfSpaceRef torus(Vec3 centre, double major, double minor);       // about z
    HalfSpaceRef torus_core(Vec3 centre, double major, double minor);  // about z
    SupportId edge_plane(int axis, Vec2 a, Vec2 b);
    SupportId parabola(int axis, Vec2 a, Vec2 c, Vec2 b);  // like an edge plane's, the points are the frame's
    // In a frame with a twist, given in its profile. Inside on the left of a -> b. Requires: a != b.
    HalfSpaceRef turned_side(Vec2 a, Vec2 b);
    // The image of the unit disc: u and v are where its axes go.
    HalfSpaceRef turned_ellipse(Vec2 centre, Vec2 u, Vec2 v);
    HalfSpaceRef turned_parabola(Vec2 a, Vec2 c, Vec2 b);
    HalfSpaceRef convex(std::shared_ptr<const ConvexHullBody> body);  // needs kNothing
    SupportId facet(const Vec3& a, const Vec3& b, const Vec3& c);
    // Inside on the left of a -> b, given in the frame's coordinates axis+1, axis+2. Requires: a != b.
    HalfSpaceRef edge_side(int axis, Vec2 a, Vec2 b);
    // The same along the shape's own third axis, in its own coordinates.
    HalfSpaceRef upright_side(Vec2 a, Vec2 b);
    // Outside where the corners, given in the shape's coordinates, turn left. Requires: they do not lie on a line.
    HalfSpaceRef side(const Vec3& a, const Vec3& b, const Vec3& c);

    FrameId frame() const { return frame_; }
    // What of the chain the shape's numbers take in.
    const AxisMap& absorbed() const { return map_; }
    // The frame's axis that the shape's axis becomes.
    int axis_of(int axis) const;
    // The point in the frame's coordinates, each rounded once.
    Vec3 point(Vec3 p);
    double length(double r, int axis);
    // Do the frame's coordinates turn as the shape's do not?
    bool mirrors() const;
    // Around the shape, in the root frame, outward rounded.
    const Bounds& root_box() const { return root_box_; }

private:
    struct RootPlane {
        int axis;
        double value;
        bool flipped;
    };
    // The axis plane of the root frame that the frame's plane x_i = value is, where it is one exactly.
    std::optional<RootPlane> in_root(int i, double value) const;
    HalfSpaceRef add(SupportKind kind, int axis, std::array<double, 10> p, bool inverted);
    HalfSpaceRef add_to(FrameId frame, SupportKind kind, int axis, std::array<double, 10> p, bool inverted);
    double coordinate(std::size_t i, double local);
    double rounded(Wide x);
    double most_shrunk() const;

    Formula& formula_;
    FrameId frame_ = 0;
    AxisMap map_;
    Bounds root_box_;
    double rounding_ = 0, rounding_per_size_ = 0;
};

}  // namespace whittle
