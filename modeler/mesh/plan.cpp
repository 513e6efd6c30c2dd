#include "modeler/mesh/plan.h"

#include <algorithm>
#include <set>

namespace whittle {

GridPoint sum(const GridPoint& a, const GridPoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
GridPoint difference(const GridPoint& a, const GridPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
GridBox moved(const GridBox& box, const GridPoint& by) { return {sum(box.lo, by), sum(box.hi, by)}; }

bool boxes_touch(const GridBox& a, const GridBox& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] || b.lo[i] > a.hi[i]) return false;
    return true;
}
bool boxes_overlap(const GridBox& a, const GridBox& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.lo[i] >= b.hi[i] || b.lo[i] >= a.hi[i]) return false;
    return true;
}
GridBox box_around(const GridBox& a, const GridBox& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    GridBox out = a;
    for (std::size_t i = 0; i < 3; ++i) {
        out.lo[i] = std::min(a.lo[i], b.lo[i]);
        out.hi[i] = std::max(a.hi[i], b.hi[i]);
    }
    return out;
}

namespace {

class Hasher {
public:
    void add(std::uint64_t x) {
        h_ = (h_ ^ x) * 0x9FB21C651E98DF25ULL;
        h_ ^= h_ >> 28;
    }
    void add(const GridPoint& p) {
        for (const std::int64_t x : p) add(static_cast<std::uint64_t>(x));
    }
    std::uint64_t value() const { return h_; }

private:
    std::uint64_t h_ = 0x2545F4914F6CDD1DULL;
};

std::uint64_t hash_of(const GridMesh& mesh) {
    Hasher h;
    h.add(mesh.points.size());
    for (const GridPoint& p : mesh.points) h.add(p);
    for (const Triangle& t : mesh.triangles) h.add(static_cast<std::uint64_t>(t[0]) << 42 ^ static_cast<std::uint64_t>(t[1]) << 21 ^ t[2]);
    return h.value();
}
std::uint64_t hash_of(const PlanNode& node) {
    Hasher h;
    h.add(static_cast<std::uint64_t>(*node.op) + 1);
    h.add(node.a.plan);
    h.add(node.b.plan);
    h.add(node.b.offset);
    return h.value();
}

GridBox common(const GridBox& a, const GridBox& b) {
    GridBox out;
    for (std::size_t i = 0; i < 3; ++i) {
        out.lo[i] = std::max(a.lo[i], b.lo[i]);
        out.hi[i] = std::min(a.hi[i], b.hi[i]);
    }
    return out;
}

double volume(const GridBox& box) {
    double v = 1;
    for (std::size_t i = 0; i < 3; ++i) v *= static_cast<double>(box.hi[i] - box.lo[i]);
    return v;
}

}  // namespace

GridBox Plan::box(const PlanRef& ref) const { return moved(nodes_[ref.plan].box, ref.offset); }

PlanId Plan::interned(PlanNode&& node, std::uint64_t hash) {
    const auto [from, to] = by_hash_.equal_range(hash);
    for (auto at = from; at != to; ++at) {
        const PlanNode& known = nodes_[at->second];
        if (known.op == node.op && known.a == node.a && known.b == node.b && known.leaf == node.leaf && known.starts == node.starts) {
            ++reused_;
            return at->second;
        }
    }
    const auto id = static_cast<PlanId>(nodes_.size());
    if (node.op) ++nodes_[node.a.plan].users, ++nodes_[node.b.plan].users;
    nodes_.push_back(std::move(node));
    by_hash_.emplace(hash, id);
    return id;
}

Instance Plan::leaf(SnappedLeaf&& leaf, std::vector<std::uint32_t> uses) {
    PlanNode node;
    node.leaf = std::move(leaf.mesh);
    node.starts = std::move(leaf.starts);
    node.box = {{0, 0, 0}, leaf.size};
    node.tag_count = leaf.tag_count;
    node.may_cross_itself = leaf.may_cross_itself;
    const std::uint64_t hash = hash_of(node.leaf);
    return {{interned(std::move(node), hash), leaf.offset}, std::move(uses)};
}

Instance Plan::binary(SetOp op, Instance&& a, Instance&& b) {
    PlanNode node;
    node.op = op;
    node.a = {a.ref.plan, {}};
    node.b = {b.ref.plan, difference(b.ref.offset, a.ref.offset)};
    const GridBox left = box(node.a), right = box(node.b);
    node.box = op == SetOp::kUnion ? box_around(left, right) : op == SetOp::kIntersection ? common(left, right) : left;
    node.tag_count = nodes_[node.a.plan].tag_count + nodes_[node.b.plan].tag_count;
    const std::uint64_t hash = hash_of(node);
    Instance out{{interned(std::move(node), hash), a.ref.offset}, std::move(a.leaves)};
    out.leaves.insert(out.leaves.end(), b.leaves.begin(), b.leaves.end());
    return out;
}

// Halves along the longest axis of the centres: near ones meet early, so operands stay small.
Instance Plan::united(std::vector<Instance>& operands, std::size_t first, std::size_t last) {
    if (last - first == 1) return std::move(operands[first]);
    const auto centre = [&](const Instance& i) {
        const GridBox b = box(i.ref);
        return sum(b.lo, b.hi);
    };
    GridPoint lo = centre(operands[first]), hi = lo;
    for (std::size_t i = first; i < last; ++i) {
        const GridPoint c = centre(operands[i]);
        for (std::size_t k = 0; k < 3; ++k) lo[k] = std::min(lo[k], c[k]), hi[k] = std::max(hi[k], c[k]);
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
    const auto at = [&](std::size_t i) { return operands.begin() + static_cast<std::ptrdiff_t>(i); };
    std::stable_sort(at(first), at(last), [&](const Instance& a, const Instance& b) { return centre(a)[axis] < centre(b)[axis]; });
    const std::size_t middle = first + (last - first) / 2;
    Instance left = united(operands, first, middle), right = united(operands, middle, last);
    return binary(SetOp::kUnion, std::move(left), std::move(right));
}

std::optional<Instance> Plan::unite(std::vector<Instance> operands) {
    std::vector<Instance> distinct;
    std::set<std::pair<PlanId, GridPoint>> known;
    for (Instance& i : operands) {
        if (known.emplace(i.ref.plan, i.ref.offset).second) {
            distinct.push_back(std::move(i));
        } else {
            ++skipped_;
        }
    }
    if (distinct.empty()) return std::nullopt;
    return united(distinct, 0, distinct.size());
}

// Small boxes first, so that what is left stays small.
std::optional<Instance> Plan::intersect(std::vector<Instance> operands) {
    if (operands.empty()) return std::nullopt;
    std::stable_sort(operands.begin(), operands.end(), [&](const Instance& a, const Instance& b) { return volume(box(a.ref)) < volume(box(b.ref)); });
    Instance out = std::move(operands.front());
    for (std::size_t i = 1; i < operands.size(); ++i) {
        if (operands[i].ref == out.ref) {
            ++skipped_;
            continue;
        }
        if (!boxes_overlap(box(out.ref), box(operands[i].ref))) {
            ++skipped_;
            return std::nullopt;
        }
        out = binary(SetOp::kIntersection, std::move(out), std::move(operands[i]));
    }
    return out;
}

std::optional<Instance> Plan::subtract(Instance from, std::vector<Instance> cutters) {
    std::vector<Instance> kept;
    for (Instance& c : cutters) {
        if (c.ref == from.ref) {
            ++skipped_;
            return std::nullopt;
        }
        if (boxes_overlap(box(c.ref), box(from.ref))) {
            kept.push_back(std::move(c));
        } else {
            ++skipped_;
        }
    }
    auto whole = unite(std::move(kept));
    if (!whole) return from;
    if (whole->ref == from.ref) return std::nullopt;
    return binary(SetOp::kDifference, std::move(from), std::move(*whole));
}

}  // namespace whittle
