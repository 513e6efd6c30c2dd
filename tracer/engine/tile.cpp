// tile.cpp — folding a program to a tile.
#include "tracer/engine/tile.h"

#include <algorithm>
#include <limits>

namespace whittle {

namespace {

// A few roundings, relative, with plenty of room: culling may keep too much, never too little.
constexpr double kRoom = 0x1p-44;

double lower(double x) { return x - std::abs(x) * kRoom; }
double upper(double x) { return x + std::abs(x) * kRoom; }

std::array<double, 3> widened(const std::array<float, 3>& x) { return {x[0], x[1], x[2]}; }

}  // namespace

TileBounds tile_bounds(const TileExtremes& extremes) {
    const auto& [o_lo, o_hi, d_lo, d_hi, least_square] = extremes;
    (void)least_square;
    TileBounds b;
    b.extremes = extremes;
    b.o_lo = o_lo;
    b.o_hi = o_hi;
    double best = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double least = d_lo[i] > 0 ? d_lo[i] : d_hi[i] < 0 ? -d_hi[i] : 0;
        if (!(least > best)) continue;
        best = least;
        b.axis = i;
        b.backward = d_hi[i] < 0;
    }
    b.slowest = best;
    b.fastest = std::max(std::abs(d_lo[b.axis]), std::abs(d_hi[b.axis]));
    b.coherent = best >= 0x1p-500 && b.fastest < 2 * b.slowest;
    for (std::size_t i = 0; i < 3; ++i) {
        b.coherent = b.coherent && std::isfinite(o_lo[i]) && std::isfinite(o_hi[i]) && std::isfinite(d_lo[i]) && std::isfinite(d_hi[i]);
        if (i == b.axis) continue;
        b.n_lo[i] = lower(d_lo[i] < 0 ? d_lo[i] / b.slowest : d_lo[i] / b.fastest);
        b.n_hi[i] = upper(d_hi[i] > 0 ? d_hi[i] / b.slowest : d_hi[i] / b.fastest);
        if (b.n_lo[i] == 0) b.n_lo[i] = -std::numeric_limits<double>::min();
        if (b.n_hi[i] == 0) b.n_hi[i] = std::numeric_limits<double>::min();
        b.inverse_lo[i] = 1 / b.n_lo[i];
        b.inverse_hi[i] = 1 / b.n_hi[i];
    }
    return b;
}

bool TileBounds::meets(const std::array<double, 3>& lo, const std::array<double, 3>& hi, double& near, double& far) const {
    if (!culls) {
        near = 0, far = HUGE_VAL;
        return true;
    }
    if (rays_meet) return rays_meet(rays, lo, hi, near, far);
    const double ahead_lo = backward ? o_lo[axis] - hi[axis] : lo[axis] - o_hi[axis];
    const double ahead_hi = backward ? o_hi[axis] - lo[axis] : hi[axis] - o_lo[axis];
    double w0 = std::max(0.0, ahead_lo), w1 = ahead_hi;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == axis) continue;
        // The upper line o_hi + w n_hi must not stay below lo, nor the lower one above hi.
        const double rise = (lo[i] - o_hi[i]) * inverse_hi[i], fall = (hi[i] - o_lo[i]) * inverse_lo[i];
        if (n_hi[i] > 0) {
            w0 = rise > w0 ? rise : w0;
        } else {
            w1 = rise < w1 ? rise : w1;
        }
        if (n_lo[i] < 0) {
            w0 = fall > w0 ? fall : w0;
        } else {
            w1 = fall < w1 ? fall : w1;
        }
    }
    near = lower(lower(w0) / fastest);
    far = upper(upper(w1) / slowest);
    return lower(w0) <= upper(w1) && w1 >= 0;
}

namespace {

// The extremes of the tile in a frame: centre and half lengths of their boxes taken through the inverse.
TileExtremes in_frame(const TileExtremes& e, const Frame& frame) {
    TileExtremes r;
    for (std::size_t i = 0; i < 3; ++i) {
        double o = 0, ho = 0, d = 0, hd = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            const double k = frame.inverse[3 * i + j], size = std::abs(k);
            const double from = 0.5 * (e.o_lo[j] + e.o_hi[j]) - frame.placement.offset(static_cast<int>(j)), way = 0.5 * (e.d_lo[j] + e.d_hi[j]);
            o += k * from;
            d += k * way;
            ho += size * (0.5 * (e.o_hi[j] - e.o_lo[j]) + kRoom * (std::abs(from) + std::abs(frame.placement.offset(static_cast<int>(j)))));
            hd += size * (0.5 * (e.d_hi[j] - e.d_lo[j]) + kRoom * std::abs(way));
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
        lo[i] = std::max(lo[i], lower(centre - r) - kRoom * r);
        hi[i] = std::min(hi[i], upper(centre + r) + kRoom * r);
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
    holder_lost = clipped = false;
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
        std::array<std::uint32_t, 128> stack;
        std::size_t top = 0;
        stack[top++] = g.hierarchy;
        while (open && top > 0) {
            const BoxNode& node = program.nodes[stack[--top]];
            double near = 0, far = 0;
            if (!meets(bounds, widened(node.lo), widened(node.hi), near, far) || beyond(near)) continue;
            if (node.count == 0) {
                stack[top++] = node.first + 1;
                stack[top++] = node.first;
                continue;
            }
            for (std::uint32_t i = 0; open && i < node.count; ++i) take(program.refs[node.first + i]);
        }
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
