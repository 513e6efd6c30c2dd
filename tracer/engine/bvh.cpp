// bvh.cpp — binned construction.
#include "tracer/engine/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

namespace {

constexpr std::size_t kBins = 16;  // at most, and at most as many as there are items: most nodes have few, and emptying bins is then most of the work

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

// Items stand in the order of the nodes made so far: each pass over those of a node goes through memory once.
class Builder {
public:
    Builder(const std::vector<Bounds>& boxes, double item_cost, std::uint32_t most) : item_cost_(item_cost), most_(most) {
        items_.reserve(boxes.size());
        for (const Bounds& b : boxes) {
            Item item{{}, static_cast<std::uint32_t>(items_.size())};
            for (int i = 0; i < 3; ++i) {
                item.box.lo[static_cast<std::size_t>(i)] = below(b.lo[i]);
                item.box.hi[static_cast<std::size_t>(i)] = above(b.hi[i]);
            }
            items_.push_back(item);
        }
        out_.nodes.reserve(boxes.size() * 2);
        out_.nodes.emplace_back();
        build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
        out_.order.reserve(items_.size());
        for (const Item& item : items_) out_.order.push_back(item.index);
    }
    Hierarchy take() { return std::move(out_); }

private:
    struct Item {
        Box box;
        std::uint32_t index;
    };
    struct Cut {
        std::size_t axis = 3, bins = 0, bin = 0;
        double cost = HUGE_VAL, from = 0, scale = 0;
    };
    struct Bin {
        Box box;
        std::uint32_t count = 0;
    };
    using Bins = std::array<std::array<Bin, kBins>, 3>;  // by axis

    static std::size_t bin_of(const Cut& cut, const Box& box) {
        const double x = (box.centre2(cut.axis) - cut.from) * cut.scale;
        return std::min(cut.bins - 1, static_cast<std::size_t>(std::max(0.0, x)));
    }

    // The cut of least cost between two of an axis's bins, if it is less than the best so far.
    void sweep(Cut cut, const std::array<Bin, kBins>& bins, std::uint32_t all, double area, Cut& best) const {
        std::array<double, kBins> right;
        Box swept;
        std::uint32_t n = 0;
        for (std::size_t b = cut.bins; b-- > 1;) {
            swept.include(bins[b].box);
            n += bins[b].count;
            right[b] = n * swept.area();
        }
        swept = Box();
        n = 0;
        for (std::size_t b = 0; b + 1 < cut.bins; ++b) {
            swept.include(bins[b].box);
            n += bins[b].count;
            if (n == 0 || n == all) continue;
            cut.cost = 1 + item_cost_ * (n * swept.area() + right[b + 1]) / area;
            cut.bin = b;
            if (cut.cost < best.cost) best = cut;
        }
    }

    // Of the axes on which centres differ.
    static std::size_t axes_to_cut(const Item* first, const Item* last, std::array<Cut, 3>& cuts) {
        std::array<double, 3> lo, hi;
        lo.fill(HUGE_VAL);
        hi.fill(-HUGE_VAL);
        for (const Item* item = first; item != last; ++item)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double c = item->box.centre2(axis);
                lo[axis] = std::min(lo[axis], c);
                hi[axis] = std::max(hi[axis], c);
            }
        std::size_t count = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Cut cut;
            cut.axis = axis;
            cut.bins = std::min(kBins, static_cast<std::size_t>(last - first));
            cut.from = lo[axis];
            cut.scale = static_cast<double>(cut.bins) / (hi[axis] - lo[axis]);
            if (hi[axis] > lo[axis] && std::isfinite(cut.scale)) cuts[count++] = cut;
        }
        return count;
    }

    Cut best_cut(const Item* first, const Item* last, double area) {
        std::array<Cut, 3> cuts;
        const std::size_t count = axes_to_cut(first, last, cuts);
        for (std::size_t k = 0; k < count; ++k) std::fill_n(bins_[k].begin(), cuts[k].bins, Bin());
        for (const Item* item = first; item != last; ++item)
            for (std::size_t k = 0; k < count; ++k) {
                Bin& bin = bins_[k][bin_of(cuts[k], item->box)];
                bin.box.include(item->box);
                ++bin.count;
            }
        Cut best;
        for (std::size_t k = 0; k < count; ++k) sweep(cuts[k], bins_[k], static_cast<std::uint32_t>(last - first), area, best);
        return best;
    }

    void build(std::uint32_t at, std::uint32_t first, std::uint32_t last, int depth) {
        Box box;
        for (std::uint32_t i = first; i < last; ++i) box.include(items_[i].box);
        out_.nodes[at].lo = box.lo;
        out_.nodes[at].hi = box.hi;
        const std::uint32_t n = last - first;
        const double area = std::max(box.area(), std::numeric_limits<double>::min());
        const Cut cut = n > 1 ? best_cut(items_.data() + first, items_.data() + last, area) : Cut();
        if (n == 1 || (n <= most_ && cut.cost >= item_cost_ * n)) {
            out_.nodes[at].first = first;
            out_.nodes[at].count = n;
            return;
        }
        const auto begin = items_.begin() + first, end = items_.begin() + last;
        auto middle = begin + n / 2;
        // Past a depth no balanced tree has, or where centres coincide, halves keep the stack short.
        if (cut.axis < 3 && depth < 60) {
            middle = std::stable_partition(begin, end, [&](const Item& item) { return bin_of(cut, item.box) <= cut.bin; });
            if (middle == begin || middle == end) middle = begin + n / 2;
        }
        const auto split = static_cast<std::uint32_t>(middle - items_.begin());
        const auto left = static_cast<std::uint32_t>(out_.nodes.size());
        out_.nodes.emplace_back();
        out_.nodes.emplace_back();
        out_.nodes[at].first = left;
        build(left, first, split, depth + 1);
        build(left + 1, split, last, depth + 1);
    }

    std::vector<Item> items_;
    double item_cost_;
    std::uint32_t most_;
    Bins bins_;
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
    r.common = true;
    for (std::size_t i = 0; i < 3; ++i) {
        r.inverse[i] = 1 / d[i];
        r.negative[i] = std::signbit(d[i]) ? 1 : 0;
        const double length = std::abs(d[i]), room = std::copysign(std::abs(o[i]) * 0x1p-22, d[i]);
        r.common = r.common && std::abs(o[i]) < 0x1p60 && (o[i] == 0 || std::abs(o[i]) > 0x1p-100) && (length == 0 || (length > 0x1p-60 && length < 0x1p10));
        r.ahead[i] = static_cast<float>(o[i] + room);
        r.behind[i] = static_cast<float>(o[i] - room);
        r.inverse_float[i] = static_cast<float>(r.inverse[i]);
    }
    return r;
}

}  // namespace whittle
