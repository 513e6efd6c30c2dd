// wide.h — the hierarchy of a wide group as single rays go through it: eight boxes a node, met by one ray together. Private to the engine.
//
// Made of the binary hierarchy by opening the largest children first, as long as they hold more items than a node has places; what holds fewer is a node of
// its own or, where there is room, its items. So an item is asked only where the ray meets its own box.
// Boxes are float, rounded outward, and met in float with room for its roundings (in double by rays of uncommon lengths): they cull and never decide.
// Source: Wald, Benthin, Boulos, Getting rid of packets (2008); Dammertz, Hanika, Keller, Shallow bounding volume hierarchies (2008).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/engine/bvh.h"
#include "tracer/engine/tile_bounds.h"

namespace whittle {

inline constexpr std::size_t kWideBoxes = 8;

// A node of the wide hierarchy, or an item.
struct WideChild {
    std::uint32_t packed = 0;
    bool is_item() const { return (packed >> 31) != 0; }
    std::uint32_t index() const { return packed & 0x7FFFFFFF; }
    static WideChild item(std::uint32_t i) { return {i | 0x80000000}; }
    static WideChild node(std::uint32_t i) { return {i}; }
};

struct alignas(64) WideNode {
    std::array<std::array<std::array<float, kWideBoxes>, 3>, 2> side{};  // least and greatest, by axis, by child
    std::array<WideChild, kWideBoxes> child;
    std::uint32_t count = 0;
};

// Appends the hierarchy, whose items are numbered in its order from `first_item` on, to `nodes`; returns its root. `boxes`: of the items, in that order.
std::uint32_t widen(const Hierarchy& hierarchy, const std::vector<FloatBox>& boxes, std::uint32_t first_item, std::vector<WideNode>& nodes);

// Children by bit: whose boxes the ray meets in [begin, end]; and how many it meets, but only later.
struct BoxesAhead {
    std::uint32_t met = 0, late = 0;
};
// `from`, of all that are met: no later than where the ray enters the box. Requires: a common ray.
using BoxesAheadOf = BoxesAhead (*)(const WideNode& node, const SlabRay& ray, double begin, double end, std::array<float, kWideBoxes>& from);

// The same of any ray; slow.
BoxesAhead boxes_ahead_in_double(const WideNode& node, const SlabRay& ray, double begin, double end, std::array<float, kWideBoxes>& from);

// Children by bit whose boxes touch a box.
using BoxesTouchedBy = std::uint32_t (*)(const WideNode& node, const FloatBox& box);

// For the processor at hand: the answers are the same on every one.
BoxesAheadOf boxes_ahead();
BoxesTouchedBy boxes_touched();

// Children by bit whose boxes the tile's rays may meet at t >= 0, none before `near`.
std::uint32_t boxes_met(const WideNode& node, const TileBounds& bounds, std::array<double, kWideBoxes>& near);

}  // namespace whittle
