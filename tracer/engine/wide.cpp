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

HWY_EXPORT(boxes_met);

BoxesMet boxes_met() { return &HWY_DYNAMIC_DISPATCH(boxes_met); }

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
        : hierarchy_(hierarchy), boxes_(boxes), first_item_(first_item), out_(out) {}

    std::uint32_t add(std::uint32_t root) {
        const auto at = static_cast<std::uint32_t>(out_.size());
        out_.emplace_back();
        std::array<Part, kWideBoxes> parts;
        parts[0] = {{}, root, false};
        std::uint32_t count = 1;
        while (open_largest(parts, count)) {}
        for (std::uint32_t k = 0; k < count; ++k) {
            const WideChild child = parts[k].item ? WideChild::item(first_item_ + parts[k].index) : WideChild::node(add(parts[k].index));
            WideNode& node = out_[at];
            node.child[k] = child;
            for (std::size_t i = 0; i < 3; ++i) node.side[0][i][k] = parts[k].box.lo[i], node.side[1][i][k] = parts[k].box.hi[i];
        }
        out_[at].count = count;
        return at;
    }

private:
    // Puts the children of the largest part that has room for them in its place. False: there is none.
    bool open_largest(std::array<Part, kWideBoxes>& parts, std::uint32_t& count) const {
        std::uint32_t largest = kWideBoxes;
        for (std::uint32_t k = 0; k < count; ++k)
            if (!parts[k].item && children(parts[k].index) + count - 1 <= kWideBoxes && (largest == kWideBoxes || parts[k].area() > parts[largest].area())) largest = k;
        if (largest == kWideBoxes) return false;
        const BoxNode& node = hierarchy_.nodes[parts[largest].index];
        const std::uint32_t n = children(parts[largest].index);
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t index = node.first + i;
            Part part{{}, index, node.count > 0};
            part.box = part.item ? boxes_[index] : FloatBox{hierarchy_.nodes[index].lo, hierarchy_.nodes[index].hi};
            parts[i == 0 ? largest : count++] = part;
        }
        return true;
    }
    std::uint32_t children(std::uint32_t node) const { return hierarchy_.nodes[node].count > 0 ? hierarchy_.nodes[node].count : 2; }

    const Hierarchy& hierarchy_;
    const std::vector<FloatBox>& boxes_;
    std::uint32_t first_item_;
    std::vector<WideNode>& out_;
};

}  // namespace

std::uint32_t widen(const Hierarchy& hierarchy, const std::vector<FloatBox>& boxes, std::uint32_t first_item, std::vector<WideNode>& nodes) {
    return Widener(hierarchy, boxes, first_item, nodes).add(0);
}

}  // namespace whittle
