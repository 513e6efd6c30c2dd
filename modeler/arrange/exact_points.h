// exact_points.h — planes through grid points, and the points in which edges and planes meet: exact, each known by one number.
//
// A point is three integers over a fourth. Which point lies where is decided by doubles where their error bound allows it, else by integers of
// fixed width; nothing is ever decided by a tolerance. Two points are equal exactly when their numbers are: the table finds an equal point by the
// floor of its coordinates times 2^kKeyBits, which does not depend on how the point came about.
// Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic (1997), for deciding by filters; Nehring-Wirxel et al., Fast Exact Booleans for
// Iterated CSG using Octree-Embedded BSPs (2021), for homogeneous integers of fixed width.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/arrange/grid_mesh.h"
#include "modeler/arrange/wide.h"

namespace whittle {

using PointId = std::uint32_t;
using Approximate = std::array<double, 3>;

// n.p = n.at; not degenerate where `valid`. |n| < 2^103.
struct ExactPlane {
    std::array<Int128, 3> n{};
    GridPoint at{};
    Approximate nd{};  // n, rounded
    bool valid() const { return n[0] != 0 || n[1] != 0 || n[2] != 0; }
    Wide<3> offset() const;
    int largest_axis() const;  // where |nd| is largest
};

ExactPlane plane_through(const GridPoint& a, const GridPoint& b, const GridPoint& c);
// Contains a, b and the direction of `axis`. Requires: a and b differ in another coordinate.
ExactPlane plane_along(const GridPoint& a, const GridPoint& b, int axis);

// Coordinates x[i] / w, w > 0.
struct ExactPoint {
    std::array<Wide<6>, 3> x;
    Wide<5> w;
};

ExactPoint exact_point(const GridPoint& p);
// Where the line through a and b meets the plane. Requires: they lie strictly on different sides.
ExactPoint crossing_of(const GridPoint& a, const GridPoint& b, const ExactPlane& plane);
// Nothing where the planes do not meet in one point.
std::optional<ExactPoint> common_point(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r);

// Sign of n.(p - at).
int side_of(const ExactPlane& plane, const GridPoint& p);

// Sign of the area of (a, b, c) seen along `axis`: positive when counter-clockwise in the plane of the next two axes.
int turn_of(const GridPoint& a, const GridPoint& b, const GridPoint& c, int axis);
int turn_of(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis);

class PointTable {
public:
    static constexpr int kKeyBits = 11;
    using Key = std::array<std::int64_t, 3>;

    // A point that need not be in the table.
    struct Located {
        ExactPoint exact;
        Key key{};
        Approximate near{};
        bool on_grid = false;
    };
    static Located located(const ExactPoint& p);
    static Located located(const GridPoint& p);

    PointId add(const GridPoint& p);
    PointId add(const Located& p);
    PointId add(const ExactPoint& p) { return add(located(p)); }

    std::size_t size() const { return keys_.size(); }
    bool on_grid(PointId p) const { return exact_[p] == kOnGrid; }
    GridPoint grid(PointId p) const { return {keys_[p][0] >> kKeyBits, keys_[p][1] >> kKeyBits, keys_[p][2] >> kKeyBits}; }
    ExactPoint exact(PointId p) const { return on_grid(p) ? exact_point(grid(p)) : rational_[exact_[p]]; }
    const Approximate& near(PointId p) const { return near_[p]; }
    Located at(PointId p) const { return {exact(p), keys_[p], near_[p], on_grid(p)}; }

    // -1, 0, 1 by coordinate k.
    int compare(PointId a, PointId b, int k) const;
    static int compare(const Located& a, const Located& b, int k);
    int turn(PointId a, PointId b, PointId c, int axis) const;
    int side(const ExactPlane& plane, PointId p) const;
    // Like turn, for points known to differ from a straight line by more than rounding; 0 where double cannot tell.
    int turn_if_clear(PointId a, PointId b, PointId c, int axis) const;

private:
    static constexpr std::uint32_t kOnGrid = 0xFFFFFFFF;
    template <class Same>
    PointId found_or_new(const Key& key, Same same);
    void grow();

    std::vector<Key> keys_;
    std::vector<Approximate> near_;
    std::vector<std::uint32_t> exact_;  // index into rational_, or kOnGrid
    std::vector<ExactPoint> rational_;
    std::vector<std::uint32_t> slots_;  // open addressing, ids + 1
};

}  // namespace whittle
