// box_tree.h — a tree of boxes: pairs that touch, and boxes that touch a given one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace whittle {

// Closed; coordinates of grid points below 2^53 are exact.
struct DoubleBox {
    std::array<double, 3> lo{}, hi{};
    void include(const std::array<double, 3>& p) {
        for (std::size_t i = 0; i < 3; ++i) lo[i] = std::min(lo[i], p[i]), hi[i] = std::max(hi[i], p[i]);
    }
    void include(const DoubleBox& b) { include(b.lo), include(b.hi); }
    static DoubleBox at(const std::array<double, 3>& p) { return {p, p}; }
};

inline bool touch(const DoubleBox& a, const DoubleBox& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] || b.lo[i] > a.hi[i]) return false;
    return true;
}

inline bool strictly_within(const DoubleBox& a, const DoubleBox& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.lo[i] <= b.lo[i] || a.hi[i] >= b.hi[i]) return false;
    return true;
}

class BoxTree {
public:
    static constexpr std::uint32_t kMixed = 0xFFFFFFFF;

    // `owner[i]`: pairs of one owner are not asked for; kMixed: asked for against all.
    BoxTree(std::vector<DoubleBox> boxes, std::vector<std::uint32_t> owner) : boxes_(std::move(boxes)), owner_(std::move(owner)) {
        if (boxes_.empty()) return;
        std::vector<Entry> entries(boxes_.size());
        for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {twice_centre(i), i};
        order_.resize(boxes_.size());
        nodes_.reserve(boxes_.size() / 2);
        build(entries, 0, static_cast<std::uint32_t>(entries.size()));
    }

    // visit(i, j) once for every pair of touching boxes with different owners, in an order that depends on the boxes alone.
    template <class Visit>
    void pairs(const Visit& visit) const {
        if (!nodes_.empty()) pairs_within(0, visit);
    }
    template <class Visit>
    void touching(const DoubleBox& box, const Visit& visit) const {
        if (!nodes_.empty()) touching(0, box, visit);
    }

private:
    struct Node {
        DoubleBox box;
        std::uint32_t first, last, right, owner;  // right == 0: a leaf of the tree
    };
    static constexpr std::uint32_t kFew = 6;

    struct Entry {
        std::array<double, 3> centre;  // doubled
        std::uint32_t box;
    };

    std::uint32_t build(std::vector<Entry>& entries, std::uint32_t first, std::uint32_t last) {
        const auto id = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({boxes_[entries[first].box], first, last, 0, owner_[entries[first].box]});
        if (last - first <= kFew) {
            Node& node = nodes_[id];
            for (std::uint32_t i = first; i < last; ++i) {
                order_[i] = entries[i].box;
                node.box.include(boxes_[order_[i]]);
                if (owner_[order_[i]] != node.owner) node.owner = kMixed;
            }
            return id;
        }
        DoubleBox centres = DoubleBox::at(entries[first].centre);
        for (std::uint32_t i = first; i < last; ++i) centres.include(entries[i].centre);
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (centres.hi[k] - centres.lo[k] > centres.hi[axis] - centres.lo[axis]) axis = k;
        const std::uint32_t middle = first + (last - first) / 2;
        const auto at = [&](std::uint32_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(last), [&](const Entry& a, const Entry& b) {
            return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.box < b.box;
        });
        const std::uint32_t left = build(entries, first, middle), right = build(entries, middle, last);
        Node& node = nodes_[id];
        node.right = right;
        node.box = nodes_[left].box;
        node.box.include(nodes_[right].box);
        node.owner = nodes_[left].owner == nodes_[right].owner ? nodes_[left].owner : kMixed;
        return id;
    }
    std::array<double, 3> twice_centre(std::uint32_t i) const {
        const DoubleBox& b = boxes_[i];
        return {b.lo[0] + b.hi[0], b.lo[1] + b.hi[1], b.lo[2] + b.hi[2]};
    }

    bool apart(std::uint32_t a, std::uint32_t b) const { return a == b && a != kMixed; }

    template <class Visit>
    void pairs_within(std::uint32_t id, const Visit& visit) const {
        const Node& n = nodes_[id];
        if (n.owner != kMixed) return;
        if (n.right == 0) {
            for (std::uint32_t i = n.first; i < n.last; ++i)
                for (std::uint32_t j = i + 1; j < n.last; ++j) meet(order_[i], order_[j], visit);
            return;
        }
        pairs_within(id + 1, visit);
        pairs_within(n.right, visit);
        pairs_between(id + 1, n.right, visit);
    }
    template <class Visit>
    void pairs_between(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
        const Node &m = nodes_[a], &n = nodes_[b];
        if (apart(m.owner, n.owner) || !touch(m.box, n.box)) return;
        if (m.right == 0 && n.right == 0) {
            for (std::uint32_t i = m.first; i < m.last; ++i)
                for (std::uint32_t j = n.first; j < n.last; ++j) meet(order_[i], order_[j], visit);
        } else if (n.right == 0 || (m.right != 0 && m.last - m.first >= n.last - n.first)) {
            pairs_between(a + 1, b, visit);
            pairs_between(m.right, b, visit);
        } else {
            pairs_between(a, b + 1, visit);
            pairs_between(a, n.right, visit);
        }
    }
    template <class Visit>
    void meet(std::uint32_t i, std::uint32_t j, const Visit& visit) const {
        if (!apart(owner_[i], owner_[j]) && touch(boxes_[i], boxes_[j])) visit(i, j);
    }
    template <class Visit>
    void touching(std::uint32_t id, const DoubleBox& box, const Visit& visit) const {
        const Node& n = nodes_[id];
        if (!touch(n.box, box)) return;
        if (n.right == 0) {
            for (std::uint32_t i = n.first; i < n.last; ++i)
                if (touch(boxes_[order_[i]], box)) visit(order_[i]);
            return;
        }
        touching(id + 1, box, visit);
        touching(n.right, box, visit);
    }

    std::vector<DoubleBox> boxes_;
    std::vector<std::uint32_t> owner_, order_;
    std::vector<Node> nodes_;
};

}  // namespace whittle
