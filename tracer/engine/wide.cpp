// wide.cpp — see wide.h.
#include "tracer/engine/wide.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/engine/wide_targets.inc"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>  // NOLINT: includes wide_targets.inc for every target but the last
#include <hwy/highway.h>

#include "tracer/engine/wide_targets.inc"

namespace whittle {

HWY_EXPORT(boxes_ahead_of);
HWY_EXPORT(boxes_touched_by);
HWY_EXPORT(boxes_met_by);

BoxesAheadOf boxes_ahead() { return &HWY_DYNAMIC_DISPATCH(boxes_ahead_of); }
BoxesAhead boxes_ahead_in_double(const WideNode& node, const SlabRay& ray, double begin, double end, std::array<float, kWideBoxes>& from) {
    BoxesAhead ahead;
    for (std::uint32_t k = 0; k < node.count; ++k) {
        std::array<float, 3> lo, hi;
        for (std::size_t i = 0; i < 3; ++i) lo[i] = node.side[0][i][k], hi[i] = node.side[1][i][k];
        double enters = 0, leaves = 0;
        from[k] = -HUGE_VALF;  // it may be beyond float
        if (!slab_interval(lo, hi, ray, enters, leaves) || leaves < begin) continue;
        if (enters <= end) {
            ahead.met |= 1u << k;
        } else {
            ++ahead.late;
        }
    }
    return ahead;
}

BoxesTouchedBy boxes_touched() { return &HWY_DYNAMIC_DISPATCH(boxes_touched_by); }

namespace {

// A child that waits for its place: a node of the binary hierarchy, or an item.
struct Part {
    FloatBox box;
    std::uint32_t index = 0;
    bool item = false;

    double area() const {
        const double x = double(box.hi[0]) - box.lo[0], y = double(box.hi[1]) - box.lo[1], z = double(box.hi[2]) - box.lo[2];
        return x * y + y * z + z * x;
    }
};

class Widener {
public:
    Widener(const Hierarchy& hierarchy, const std::vector<FloatBox>& boxes, std::uint32_t first_item, std::vector<WideNode>& out)
        : hierarchy_(hierarchy), boxes_(boxes), first_item_(first_item), out_(out), items_(hierarchy.nodes.size()) {
        // Children stand behind their parents.
        for (std::size_t i = items_.size(); i-- > 0;) {
            const BoxNode& node = hierarchy.nodes[i];
            items_[i] = node.count > 0 ? node.count : items_[node.first] + items_[node.first + 1];
        }
    }

    std::uint32_t add(std::uint32_t root) {
        const auto at = static_cast<std::uint32_t>(out_.size());
        out_.emplace_back();
        Parts parts;
        parts.count = 1;
        parts.part[0] = {{}, root, false};
        while (open_largest(parts)) {}
        while (take_items_of_least(parts)) {}
        for (std::uint32_t k = 0; k < parts.count; ++k) {
            const Part& part = parts.part[k];
            const WideChild child = part.item ? WideChild::item(first_item_ + part.index) : WideChild::node(add(part.index));
            WideNode& node = out_[at];
            node.child[k] = child;
            for (std::size_t i = 0; i < 3; ++i) node.side[0][i][k] = part.box.lo[i], node.side[1][i][k] = part.box.hi[i];
        }
        out_[at].count = parts.count;
        return at;
    }

private:
    struct Parts {
        std::array<Part, kWideBoxes> part;
        std::uint32_t count = 0;
    };

    // Puts its two children in the place of the largest part that has more items than a node of its own takes. False: there is none, or no room.
    bool open_largest(Parts& parts) const {
        std::uint32_t largest = kWideBoxes;
        for (std::uint32_t k = 0; k < parts.count && parts.count < kWideBoxes; ++k) {
            const Part& part = parts.part[k];
            const bool opens = !part.item && items_[part.index] > kWideBoxes && hierarchy_.nodes[part.index].count == 0;
            if (opens && (largest == kWideBoxes || part.area() > parts.part[largest].area())) largest = k;
        }
        if (largest == kWideBoxes) return false;
        const std::uint32_t first = hierarchy_.nodes[parts.part[largest].index].first;
        for (const std::uint32_t index : {first, first + 1}) {
            const FloatBox box{hierarchy_.nodes[index].lo, hierarchy_.nodes[index].hi};
            parts.part[index == first ? largest : parts.count++] = {box, index, false};
        }
        return true;
    }

    // Puts its items in the place of the part that has the fewest: a node less. False: there is no room for them.
    bool take_items_of_least(Parts& parts) const {
        std::uint32_t least = kWideBoxes;
        for (std::uint32_t k = 0; k < parts.count; ++k)
            if (!parts.part[k].item && (least == kWideBoxes || items_[parts.part[k].index] < items_[parts.part[least].index])) least = k;
        if (least == kWideBoxes) return false;
        const std::uint32_t node = parts.part[least].index, n = items_[node];
        if (parts.count + n - 1 > kWideBoxes) return false;
        std::uint32_t left = node;
        while (hierarchy_.nodes[left].count == 0) left = hierarchy_.nodes[left].first;
        const std::uint32_t first = hierarchy_.nodes[left].first;  // the items of a subtree stand in a row
        for (std::uint32_t i = 0; i < n; ++i) parts.part[i == 0 ? least : parts.count++] = {boxes_[first + i], first + i, true};
        return true;
    }

    const Hierarchy& hierarchy_;
    const std::vector<FloatBox>& boxes_;
    std::uint32_t first_item_;
    std::vector<WideNode>& out_;
    std::vector<std::uint32_t> items_;  // below each node of the hierarchy
};

}  // namespace

std::uint32_t boxes_met(const WideNode& node, const TileBounds& bounds, std::array<double, kWideBoxes>& near) {
    if (bounds.culls && bounds.rays_meet == nullptr) return HWY_DYNAMIC_DISPATCH(boxes_met_by)(node, bounds, near);
    std::uint32_t met = 0;
    for (std::uint32_t k = 0; k < node.count; ++k) {
        std::array<double, 3> lo, hi;
        for (std::size_t i = 0; i < 3; ++i) lo[i] = node.side[0][i][k], hi[i] = node.side[1][i][k];
        double far = 0;
        if (bounds.meets(lo, hi, near[k], far)) met |= 1u << k;
    }
    return met;
}

std::uint32_t widen(const Hierarchy& hierarchy, const std::vector<FloatBox>& boxes, std::uint32_t first_item, std::vector<WideNode>& nodes) {
    return Widener(hierarchy, boxes, first_item, nodes).add(0);
}

}  // namespace whittle
