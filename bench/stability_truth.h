// stability_truth.h — crossings of a few nested convex shapes in binary128: the truth that the stability tables compare with.
//
// A solid here is shape 0 less shape 1 plus shape 2 less ..., each inside the one before, so that inside means inside an odd number of them.
#pragma once

#include <array>
#include <vector>

#include "csg/base/vec.h"

namespace whittle::bench {

__extension__ typedef __float128 Quad;
using Quad3 = std::array<Quad, 3>;

struct NestedShape {
    bool is_ball = false;
    double half = 1;  // a box's half edge or a ball's radius
};

// A point of the shapes' space goes to linear * p + offset.
struct QuadPlacement {
    std::array<Quad3, 3> linear;
    Quad3 offset;
};

Quad square_root(Quad x);  // 0 for x <= 0
Quad3 quad(const Vec3& v);
Vec3 rounded(const Quad3& v);
Quad3 apply_to_direction(const QuadPlacement& m, const Quad3& d);
Quad3 apply_to_point(const QuadPlacement& m, const Quad3& p);

// t >= 0 of all borders of the nest on o + t d, ascending.
std::vector<Quad> crossings(const std::vector<NestedShape>& nest, const QuadPlacement& placement, const Quad3& o, const Quad3& d);

}  // namespace whittle::bench
