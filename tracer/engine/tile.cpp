// tile.cpp — folding a program to a tile.
#include "tracer/engine/tile.h"

#include <algorithm>
#include <limits>

namespace whittle {

namespace {

std::array<double, 3> widened(const std::array<float, 3>& x) { return {x[0], x[1], x[2]}; }

// The extremes of the tile in a frame: centre and half lengths of their boxes taken through the inverse.
TileExtremes in_frame(const TileExtremes& e, const Frame& frame) {
    TileExtremes r;
    for (std::size_t i = 0; i < 3; ++i) {
        double o = frame.lift(i), ho = kRoomOfBounds * std::abs(o), d = 0, hd = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            const double k = frame.inverse[3 * i + j], size = std::abs(k);
            const double from = 0.5 * (e.o_lo[j] + e.o_hi[j]) - frame.entry(static_cast<int>(j)), way = 0.5 * (e.d_lo[j] + e.d_hi[j]);
            o += k * from;
            d += k * way;
            ho += size * (0.5 * (e.o_hi[j] - e.o_lo[j]) + kRoomOfBounds * (std::abs(from) + std::abs(frame.entry(static_cast<int>(j)))));
            hd += size * (0.5 * (e.d_hi[j] - e.d_lo[j]) + kRoomOfBounds * std::abs(way));
        }
        r.o_lo[i] = o - ho, r.o_hi[i] = o + ho;
        r.d_lo[i] = d - hd, r.d_hi[i] = d + hd;
    }
    return r;
}

// The box of a cell in the frame of its first half-space; infinite where nothing in that frame bounds it.
void local_box(const Program& program, const Leaf& leaf, FrameId frame, std::array<double, 3>& lo, std::array<double, 3>& hi) {
    lo.fill(-HUGE_VAL);
    hi.fill(HUGE_VAL);
    const auto within = [&](std::size_t i, double centre, double r) {
        lo[i] = std::max(lo[i], outward_down(centre - r) - kRoomOfBounds * r);
        hi[i] = std::min(hi[i], outward_up(centre + r) + kRoomOfBounds * r);
    };
    for (std::uint32_t k = 0; k < leaf.count; ++k) {
        const HalfSpace h = program.half_spaces[leaf.first + k];
        const Support& s = program.classes[h.id()];
        if (s.frame != frame) continue;
        if (s.kind == SupportKind::kAxisPlane && h.inverted()) lo[s.axis] = std::max(lo[s.axis], s.p[0]);
        if (h.inverted()) continue;
        if (s.kind == SupportKind::kAxisPlane) hi[s.axis] = std::min(hi[s.axis], s.p[0]);
        if (s.kind == SupportKind::kCylinder) within((s.axis + 1u) % 3, s.p[0], s.p[2]), within((s.axis + 2u) % 3, s.p[1], s.p[2]);
    }
}

// A cell of axis planes of the root frame alone, which its own box tells as much of.
bool is_box(const Program& program, const Leaf& leaf) { return leaf.slabs != Leaf::kNoSlabs && program.cell_slabs[leaf.slabs].planes == leaf.count; }

// A turned cell's own box is tighter than its box in the root frame.
bool meets_turned(const Program& program, const TileBounds& bounds, const Leaf& leaf, double& near, double& far) {
    if (leaf.kind != FormulaKind::kCell || leaf.count == 0) return true;
    const FrameId id = program.classes[program.half_spaces[leaf.first].id()].frame;
    const Frame& frame = program.frames[id];
    if (id == 0 || frame.motion != 0 || bounds.rays_meet || !bounds.culls) return true;
    std::array<double, 3> lo, hi;
    local_box(program, leaf, id, lo, hi);
    const TileBounds local = tile_bounds(in_frame(bounds.extremes, frame));
    double local_near = 0, local_far = 0;
    if (!local.coherent) return true;
    if (!local.meets(lo, hi, local_near, local_far)) return false;
    near = std::max(near, local_near);
    far = std::min(far, local_far);
    return true;
}

}  // namespace

TileScope tile_scope(const TileExtremes& extremes, const Bounds& box) {
    TileScope scope;
    scope.root = {extremes.o_lo, extremes.o_hi, extremes.d_lo, extremes.d_hi, {}, {}};
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const int k = static_cast<int>(i);
        most += std::max(std::abs(box.hi[k] - extremes.o_lo[i]), std::abs(extremes.o_hi[i] - box.lo[k]));
    }
    scope.horizon = 2 * most / std::sqrt(extremes.least_square);
    return scope;
}

void TileTree::begin(const Program& program, const TileScope& scope) {
    scope_ = scope;
    surfaces.clear();
    coarse.clear();
    whole = false;
    error_ = 0;
    if (folded_.size() != program.leaves.size() || ++stamp_ == 0) {
        folded_.assign(program.leaves.size(), {});
        stamp_ = 1;
    }
}

void TileTree::build(const Program& program, const TileBounds& bounds, Ref ref, bool shared) {
    nodes.clear();
    children.clear();
    pending_.clear();
    cells.clear();
    leaf_count = holders = 0;
    holder_lost = clipped = whole = false;
    shared_ = shared;
    if (!shared) {
        surfaces.clear();
        coarse.clear();
        error_ = 0;
    }
    root = add(program, bounds, ref);
    room = 2.5 * error_;
    placed_.clear();
    if (program.some_depend) place_leaves();
}

void TileTree::place_leaves() {
    if (root >= kTrue) return;
    if (nodes[root].kind == TileNode::Kind::kLeaf) placed_.push_back({root, root});
    pending_.assign(1, root);
    while (!pending_.empty()) {
        const std::uint32_t parent = pending_.back();
        pending_.pop_back();
        const TileNode& n = nodes[parent];
        if (n.kind == TileNode::Kind::kLeaf) continue;
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i) {
            if (children[i].leaf) {
                placed_.push_back({children[i].node, parent});
            } else if (children[i].node < kTrue) {
                pending_.push_back(children[i].node);
            }
        }
    }
}

void TileTree::build_labels(const Program& program, const TileBounds& bounds, Ref ref) {
    labels_ = true;
    build(program, bounds, ref, false);
    labels_ = false;
}

TileCell TileTree::cell_of(const Program& program, std::uint32_t leaf, bool& met, double& near, double& far) {
    TileCell cell;
    if (!shared_) {
        met = fold_cell(program, scope_, program.leaves[leaf], surfaces, coarse, cell, error_, near, far);
        return cell;
    }
    Folded& f = folded_[leaf];
    if (f.stamp != stamp_) {
        f = {stamp_, {}, -HUGE_VAL, HUGE_VAL, false};
        f.met = fold_cell(program, scope_, program.leaves[leaf], surfaces, coarse, f.cell, error_, f.near, f.far);
    }
    met = f.met;
    near = std::max(near, f.near);
    far = std::min(far, f.far);
    return f.cell;
}

void TileTree::fold(const Program& program, std::uint32_t leaf, TileCell& cell) {
    bool met = false;
    double near = -HUGE_VAL, far = HUGE_VAL;
    cell = cell_of(program, leaf, met, near, far);
    cell.missed = !met;
    room = std::max(room, 2.5 * error_);
}

bool TileTree::beyond(double near) {
    const bool is = near > window;
    clipped = clipped || is;
    work.beyond += is ? 1 : 0;
    return is;
}

bool TileTree::meets(const TileBounds& bounds, const std::array<double, 3>& lo, const std::array<double, 3>& hi, double& near, double& far) {
    const bool met = bounds.meets(lo, hi, near, far);
    work.pruned += met ? 0 : 1;
    return met;
}

std::uint32_t TileTree::add(const Program& program, const TileBounds& bounds, Ref ref) {
    return ref.is_leaf() ? add_leaf(program, bounds, ref.index()) : add_group(program, bounds, program.groups[ref.index()]);
}

std::uint32_t TileTree::add_leaf(const Program& program, const TileBounds& bounds, std::uint32_t index) {
    const Leaf& leaf = program.leaves[index];
    const FloatBox& box = program.leaf_boxes[index];
    TileNode n;
    bool met = meets(bounds, widened(box.lo), widened(box.hi), n.near, n.far) && meets_turned(program, bounds, leaf, n.near, n.far);
    if (met && beyond(n.near)) met = false;
    work.folded += met ? 1 : 0;
    TileCell cell;
    // Most cells of a tile lie behind what its rays meet, and each may be the one by which all events of the tile have to be further apart. In double that
    // is no matter, and what the tile misses is better left out beforehand.
    cell.folded = leaf.kind != FormulaKind::kCell || !(scope_.coarse || is_box(program, leaf));
    if (cell.folded) cell = cell_of(program, index, met, n.near, n.far);
    if (!met || beyond(n.near)) return leaf.negated ? kTrue : kFalse;
    n.negated = n.outside = leaf.negated;
    n.holds = leaf.fills;
    if (n.holds) {
        ++holders;
        holder_use = leaf.use;
    }
    n.leaf = index;
    n.slot = leaf_count++;
    cells.push_back(cell);
    nodes.push_back(n);
    return static_cast<std::uint32_t>(nodes.size() - 1);
}

std::uint32_t TileTree::add_group(const Program& program, const TileBounds& bounds, const Group& g) {
    TileNode n;
    n.kind = g.is_and ? TileNode::Kind::kAnd : TileNode::Kind::kOr;
    n.outside = g.outside_value;
    n.near = -HUGE_VAL;
    n.far = HUGE_VAL;
    const std::uint32_t neutral = g.is_and ? kTrue : kFalse, absorbing = g.is_and ? kFalse : kTrue;
    if (g.bounded) {
        const std::array<double, 3> lo{g.box.lo.x, g.box.lo.y, g.box.lo.z}, hi{g.box.hi.x, g.box.hi.y, g.box.hi.z};
        if (!meets(bounds, lo, hi, n.near, n.far) || beyond(n.near)) return g.outside_value ? kTrue : kFalse;
    }
    const std::size_t first = pending_.size();
    bool open = true;
    const auto take = [&](Ref ref) {
        const std::uint32_t child = add(program, bounds, ref);
        if (child == neutral) return true;
        if (child == absorbing && labels_ && !g.is_and) return n.always = true;
        if (child == absorbing) return open = false;
        pending_.push_back(child);
        return true;
    };
    for (std::uint32_t i = 0; open && i < g.plain_count; ++i) take(program.refs[g.first_plain + i]);
    if (open && g.item_count > 0) {
        const std::size_t base = waiting_.size();
        waiting_.push_back(WideChild::node(g.wide));
        while (open && waiting_.size() > base) {
            const WideChild at = waiting_.back();
            waiting_.pop_back();
            if (at.is_item()) {
                take(program.refs[at.index()]);
                continue;
            }
            const WideNode& node = program.wide[at.index()];
            std::array<double, kWideBoxes> near;
            const std::uint32_t met = boxes_met(node, bounds, near);
            work.pruned += node.count - static_cast<std::uint32_t>(__builtin_popcount(met));
            for (std::uint32_t left = met; left != 0; left &= left - 1) {
                const auto k = static_cast<std::size_t>(__builtin_ctz(left));
                if (!beyond(near[k])) waiting_.push_back(node.child[k]);
            }
        }
        waiting_.resize(base);
    }
    n.always = n.always || g.always;
    const bool held = g.hold != Group::kNoUse;
    if (labels_ && open && pending_.size() == first && !held) return g.is_and || n.always ? kTrue : kFalse;
    if (!open || (pending_.size() == first && !labels_)) {
        pending_.resize(first);
        holder_lost = holder_lost || (open && (held || g.hold_unclear));
        return open ? neutral : absorbing;
    }
    n.hold = g.hold;
    n.hold_unclear = g.hold_unclear;
    if (held || n.hold_unclear) {
        holders += n.hold_unclear ? 2 : 1;  // more than one: each place asks
        holder_use = n.hold;
        n.holds = true;
    } else if (pending_.size() == first + 1 && !n.always) {
        const std::uint32_t only = pending_[first];
        pending_.resize(first);
        return only;
    }
    const auto begin = pending_.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, pending_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const TileNode &x = nodes[a], &y = nodes[b];
        if (x.outside != y.outside) return y.outside == g.is_and;
        if (x.near != y.near) return (x.near < y.near) != (g.is_and && !x.outside);
        return a < b;
    });
    n.first = static_cast<std::uint32_t>(children.size());
    n.count = static_cast<std::uint32_t>(pending_.size() - first);
    n.cells = true;
    for (std::size_t i = first; i < pending_.size(); ++i) {
        n.holds = n.holds || nodes[pending_[i]].holds;
        n.cells = n.cells && nodes[pending_[i]].kind == TileNode::Kind::kLeaf;
    }
    for (std::size_t i = first; i < pending_.size(); ++i) {
        const TileNode& child = nodes[pending_[i]];
        children.push_back({child.near, child.far, pending_[i], child.outside, child.holds, child.kind == TileNode::Kind::kLeaf});
    }
    pending_.resize(first);
    nodes.push_back(n);
    return static_cast<std::uint32_t>(nodes.size() - 1);
}

}  // namespace whittle
