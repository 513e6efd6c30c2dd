// bvh.cpp — binned construction.
#include "tracer/engine/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace whittle {

namespace {

constexpr std::size_t kBins = 16;

float below(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafterf(f, -HUGE_VALF) : f;
}
float above(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) < x ? std::nextafterf(f, HUGE_VALF) : f;
}

struct Box {
    std::array<float, 3> lo{HUGE_VALF, HUGE_VALF, HUGE_VALF}, hi{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

    void include(const Box& o) {
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = std::min(lo[i], o.lo[i]);
            hi[i] = std::max(hi[i], o.hi[i]);
        }
    }
    double area() const {
        const double x = double(hi[0]) - lo[0], y = double(hi[1]) - lo[1], z = double(hi[2]) - lo[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
    double centre2(std::size_t axis) const { return double(lo[axis]) + hi[axis]; }
};

class Builder {
public:
    Builder(const std::vector<Bounds>& boxes, double item_cost, std::uint32_t most) : item_cost_(item_cost), most_(most) {
        boxes_.reserve(boxes.size());
        for (const Bounds& b : boxes) {
            Box box;
            for (int i = 0; i < 3; ++i) {
                box.lo[static_cast<std::size_t>(i)] = below(b.lo[i]);
                box.hi[static_cast<std::size_t>(i)] = above(b.hi[i]);
            }
            boxes_.push_back(box);
        }
        out_.order.resize(boxes.size());
        std::iota(out_.order.begin(), out_.order.end(), 0u);
        out_.nodes.reserve(boxes.size() * 2);
        out_.nodes.emplace_back();
        build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
    }
    Hierarchy take() { return std::move(out_); }

private:
    struct Cut {
        std::size_t axis = 3, bin = 0;
        double cost = HUGE_VAL, from = 0, scale = 0;
    };

    std::size_t bin_of(const Cut& cut, std::uint32_t item) const {
        const double x = (boxes_[item].centre2(cut.axis) - cut.from) * cut.scale;
        return std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, x)));
    }

    Cut best_cut(std::uint32_t first, std::uint32_t last, double area) const {
        Cut best;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Cut cut;
            cut.axis = axis;
            double lo = HUGE_VAL, hi = -HUGE_VAL;
            for (std::uint32_t i = first; i < last; ++i) {
                const double c = boxes_[out_.order[i]].centre2(axis);
                lo = std::min(lo, c);
                hi = std::max(hi, c);
            }
            if (!(hi > lo)) continue;
            cut.from = lo;
            cut.scale = kBins / (hi - lo);
            if (!std::isfinite(cut.scale)) continue;
            std::array<Box, kBins> box;
            std::array<std::uint32_t, kBins> count{};
            for (std::uint32_t i = first; i < last; ++i) {
                const std::size_t b = bin_of(cut, out_.order[i]);
                box[b].include(boxes_[out_.order[i]]);
                ++count[b];
            }
            std::array<double, kBins> right{};
            Box sweep;
            std::uint32_t n = 0;
            for (std::size_t b = kBins; b-- > 1;) {
                sweep.include(box[b]);
                n += count[b];
                right[b] = n * sweep.area();
            }
            sweep = Box();
            n = 0;
            for (std::size_t b = 0; b + 1 < kBins; ++b) {
                sweep.include(box[b]);
                n += count[b];
                if (n == 0 || n == last - first) continue;
                cut.cost = 1 + item_cost_ * (n * sweep.area() + right[b + 1]) / area;
                cut.bin = b;
                if (cut.cost < best.cost) best = cut;
            }
        }
        return best;
    }

    void build(std::uint32_t at, std::uint32_t first, std::uint32_t last, int depth) {
        Box box;
        for (std::uint32_t i = first; i < last; ++i) box.include(boxes_[out_.order[i]]);
        out_.nodes[at].lo = box.lo;
        out_.nodes[at].hi = box.hi;
        const std::uint32_t n = last - first;
        const double area = std::max(box.area(), std::numeric_limits<double>::min());
        const Cut cut = n > 1 ? best_cut(first, last, area) : Cut();
        if (n == 1 || (n <= most_ && cut.cost >= item_cost_ * n)) {
            out_.nodes[at].first = first;
            out_.nodes[at].count = n;
            return;
        }
        const auto begin = out_.order.begin() + first, end = out_.order.begin() + last;
        auto middle = begin + n / 2;
        // Past a depth no balanced tree has, or where centres coincide, halves keep the stack short.
        if (cut.axis < 3 && depth < 60) {
            middle = std::stable_partition(begin, end, [&](std::uint32_t i) { return bin_of(cut, i) <= cut.bin; });
            if (middle == begin || middle == end) middle = begin + n / 2;
        }
        const auto split = static_cast<std::uint32_t>(middle - out_.order.begin());
        const auto left = static_cast<std::uint32_t>(out_.nodes.size());
        out_.nodes.emplace_back();
        out_.nodes.emplace_back();
        out_.nodes[at].first = left;
        build(left, first, split, depth + 1);
        build(left + 1, split, last, depth + 1);
    }

    std::vector<Box> boxes_;
    double item_cost_;
    std::uint32_t most_;
    Hierarchy out_;
};

}  // namespace

FloatBox outward(const Bounds& box) {
    FloatBox r;
    for (std::size_t i = 0; i < 3; ++i) {
        r.lo[i] = below(box.lo[static_cast<int>(i)]);
        r.hi[i] = above(box.hi[static_cast<int>(i)]);
    }
    return r;
}

Hierarchy build_hierarchy(const std::vector<Bounds>& boxes, double item_cost, std::uint32_t most_in_leaf) {
    return Builder(boxes, item_cost, most_in_leaf).take();
}

SlabRay slab_ray(const std::array<double, 3>& o, const std::array<double, 3>& d) {
    SlabRay r;
    r.o = o;
    for (std::size_t i = 0; i < 3; ++i) {
        r.inverse[i] = 1 / d[i];
        r.negative[i] = std::signbit(d[i]) ? 1 : 0;
    }
    return r;
}

}  // namespace whittle
