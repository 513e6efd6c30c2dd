// bvh.h — bounding volume hierarchy: binary, built by the surface area heuristic over bins; boxes in float, rounded outward.
//
// It culls and never decides: the slab test is widened by its own rounding, so a ray that touches a box enters it.
// Source: Wald, On fast construction of SAH-based bounding volume hierarchies (2007); Ize, Robust BVH ray traversal (2013).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// count > 0: leaf holding items [first, first+count); else children first and first+1.
struct BoxNode {
    std::array<float, 3> lo, hi;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

struct FloatBox {
    std::array<float, 3> lo, hi;
};

// The box in float, rounded outward.
FloatBox outward(const Bounds& box);

struct Hierarchy {
    std::vector<BoxNode> nodes;        // root first
    std::vector<std::uint32_t> order;  // items by leaf
};

// Requires: at least one box, all finite and not empty. `item_cost`: of testing an item against visiting a node.
Hierarchy build_hierarchy(const std::vector<Bounds>& boxes, double item_cost, std::uint32_t most_in_leaf);

// What a slab test needs of a ray.
struct SlabRay {
    std::array<double, 3> o, inverse;
    std::array<std::uint8_t, 3> negative;
    // In float: the origin moved along the ray, for the sides it meets first, and against it, for the others, by more than float rounds it.
    std::array<float, 3> ahead, behind, inverse_float;
    bool common;  // neither so long, so short nor so far off that boxes could not be met in float
};

SlabRay slab_ray(const std::array<double, 3>& o, const std::array<double, 3>& d);

// Interval of the ray in the box, widened. False: the line misses it. NaN (an origin in the slab's plane, no motion along it) passes.
template <class T>
inline bool slab_interval(const std::array<T, 3>& lo, const std::array<T, 3>& hi, const SlabRay& ray, double& from, double& to) {
    constexpr double kWiden = 1 + 0x1p-50;
    double a = -HUGE_VAL, b = HUGE_VAL;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = (static_cast<double>(ray.negative[i] ? hi[i] : lo[i]) - ray.o[i]) * ray.inverse[i];
        const double y = (static_cast<double>(ray.negative[i] ? lo[i] : hi[i]) - ray.o[i]) * ray.inverse[i];
        a = x > a ? x : a;
        b = y < b ? y : b;
    }
    from = a > 0 ? a * (2 - kWiden) : a * kWiden;
    to = b > 0 ? b * kWiden : b * (2 - kWiden);
    return from <= to;
}

}  // namespace whittle
