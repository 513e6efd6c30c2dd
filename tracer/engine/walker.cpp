// walker.cpp — leaping from event to event, and sweeping whole rays.
#include "tracer/engine/walker.h"

#include <algorithm>

namespace whittle {

void Walker::start(const Program& program, const Ray& ray, EngineCounters& counters, double far) {
    context_.start(program, ray, counters);
    far_ = far;
    boxes_ = program.makes(EnginePass::kBoxes);
    occlusion_ = program.makes(EnginePass::kOcclusion);
    if (slots_.size() != program.leaves.size()) {
        slots_.assign(program.leaves.size(), Slot());
        stamp_ = 0;
    }
    if (++stamp_ == 0) {
        std::fill(slots_.begin(), slots_.end(), Slot());
        stamp_ = 1;
    }
    events_.clear();
    lists_.clear();
}

bool Walker::passed(const Event& change, const Event& cursor) {
    const int c = context_.compare(change, cursor);
    return c < 0 || (c == 0 && !cursor.before);
}

Walker::Changes Walker::leaf_changes(std::uint32_t index) {
    Slot& slot = slots_[index];
    if (slot.stamp != stamp_) {
        slot.stamp = stamp_;
        const Leaf& leaf = context_.program().leaves[index];
        slot.changes.first = static_cast<std::uint32_t>(events_.size());
        const bool initial = leaf_events(leaf, context_, events_);
        slot.changes.count = static_cast<std::uint32_t>(events_.size()) - slot.changes.first;
        slot.changes.initial = initial != leaf.negated;
    }
    return slot.changes;
}

Found Walker::next_in_leaf(std::uint32_t index, const Event& cursor, bool want, Event& out) {
    const Changes c = leaf_changes(index);
    bool state = c.initial;
    for (std::uint32_t i = 0; i < c.count; ++i) {
        const Event& e = events_[c.first + i];
        if (!passed(e, cursor)) {
            if (state == want) return Found::kHere;
            out = e;
            return Found::kLater;
        }
        state = !state;
    }
    return state == want ? Found::kHere : Found::kNever;
}

// Is the group constant from `begin` on as far as the ray goes, because the ray misses its box?
bool Walker::misses(const Group& g, double begin) {
    if (!g.bounded || !boxes_) return false;
    double from = 0, to = 0;
    const std::array<double, 3> lo{g.box.lo.x, g.box.lo.y, g.box.lo.z}, hi{g.box.hi.x, g.box.hi.y, g.box.hi.z};
    const bool missed = !slab_interval(lo, hi, context_.slab(), from, to) || to < begin || from > far_;
    if (missed) ++context_.counters().skipped_by(EnginePass::kBoxes);
    return missed;
}

Found Walker::next(Ref ref, const Event& cursor, bool want, Event& out) {
    if (ref.is_leaf()) return next_in_leaf(ref.index(), cursor, want, out);
    const Group& g = context_.program().groups[ref.index()];
    if (misses(g, cursor.t - cursor.error)) return want == g.outside_value ? Found::kHere : Found::kNever;
    return g.is_and == want ? next_of_all(g, cursor, want, out) : next_of_any(g, cursor, want, out);
}

// Visits the items of the hierarchy whose boxes the ray meets between `begin` and `end`, which may shrink meanwhile, nearest first by their boxes.
// True: take(ref) was, and ended it.
template <class Take>
bool Walker::each_ahead(const Group& g, double begin, const double& end, Take take) {
    if (g.item_count == 0) return false;
    const Program& program = context_.program();
    EngineCounters& counters = context_.counters();
    std::uint32_t taken = 0;
    struct Entry {
        std::uint32_t node;
        double from;
    };
    std::array<Entry, 128> stack;
    std::size_t top = 0;
    double from = 0, to = 0;
    const auto enters = [&](std::uint32_t n) {
        if (!slab_interval(program.nodes[n].lo, program.nodes[n].hi, context_.slab(), from, to) || to < begin) return false;
        if (from <= end || !occlusion_) return true;
        ++counters.skipped_by(EnginePass::kOcclusion);
        return false;
    };
    if (enters(g.hierarchy)) stack[top++] = {g.hierarchy, from};
    while (top > 0) {
        const Entry entry = stack[--top];
        if (entry.from > end && occlusion_) {
            ++counters.skipped_by(EnginePass::kOcclusion);
            continue;
        }
        const BoxNode& node = program.nodes[entry.node];
        if (node.count > 0) {
            taken += node.count;
            for (std::uint32_t i = 0; i < node.count; ++i)
                if (take(program.refs[node.first + i])) return true;
            continue;
        }
        const bool left = enters(node.first);
        const double from_left = from;
        const bool right = enters(node.first + 1);
        const double from_right = from;
        if (left && right) {
            const bool left_first = from_left <= from_right;
            stack[top++] = left_first ? Entry{node.first + 1, from_right} : Entry{node.first, from_left};
            stack[top++] = left_first ? Entry{node.first, from_left} : Entry{node.first + 1, from_right};
        } else if (left) {
            stack[top++] = {node.first, from_left};
        } else if (right) {
            stack[top++] = {node.first + 1, from_right};
        }
    }
    counters.skipped_by(EnginePass::kHierarchy) += g.item_count - taken;
    return false;
}

Found Walker::next_of_any(const Group& g, const Event& cursor, bool want, Event& out) {
    const Program& program = context_.program();
    bool found = false;
    double best = far_;
    const auto take = [&](Ref ref) {
        Event e;
        const Found f = next(ref, cursor, want, e);
        if (f == Found::kLater && (!found || context_.compare(e, out) < 0)) {
            out = e;
            found = true;
            best = std::min(best, e.t + e.error);
        }
        return f == Found::kHere;
    };
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (take(program.refs[g.first_plain + i])) return Found::kHere;
    if (each_ahead(g, cursor.t - cursor.error, best, take)) return Found::kHere;
    return found ? Found::kLater : Found::kNever;
}

bool Walker::meets(Ref ref, const Event& cursor) {
    const Program& program = context_.program();
    if (ref.is_leaf() || program.groups[ref.index()].is_and) {
        Event e;
        const Found found = next(ref, cursor, true, e);
        return found == Found::kHere || (found == Found::kLater && e.t < far_);
    }
    const Group& g = program.groups[ref.index()];
    if (misses(g, cursor.t - cursor.error)) return g.outside_value;
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (meets(program.refs[g.first_plain + i], cursor)) return true;
    return each_ahead(g, cursor.t - cursor.error, far_, [&](Ref child) { return meets(child, cursor); });
}

// Plain children, then the items below nodes that `enters`. False: visit(ref) was, and ended it.
template <class Enters, class Visit>
bool Walker::each_entered(const Group& g, Enters enters, Visit visit) {
    const Program& program = context_.program();
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (!visit(program.refs[g.first_plain + i])) return false;
    if (g.item_count == 0) return true;
    std::uint32_t visited = 0;
    std::array<std::uint32_t, 128> stack;
    std::size_t top = 0;
    stack[top++] = g.hierarchy;
    while (top > 0) {
        const BoxNode& node = program.nodes[stack[--top]];
        if (!enters(node)) continue;
        if (node.count == 0) {
            stack[top++] = node.first + 1;
            stack[top++] = node.first;
            continue;
        }
        visited += node.count;
        for (std::uint32_t i = 0; i < node.count; ++i)
            if (!visit(program.refs[node.first + i])) return false;
    }
    context_.counters().skipped_by(EnginePass::kHierarchy) += g.item_count - visited;
    return true;
}

// Children whose boxes hold the place of the event, or may.
template <class Visit>
bool Walker::each_at(const Group& g, const Event& at, Visit visit) {
    const auto enters = [&](const BoxNode& node) {
        double from = 0, to = 0;
        return slab_interval(node.lo, node.hi, context_.slab(), from, to) && to >= at.t - at.error && from <= at.t + at.error;
    };
    return each_entered(g, enters, visit);
}

// One round over the children that may not be `want` at the cursor; moves it forward over each.
Found Walker::pass(const Group& g, Event& cursor, bool want, bool& moved) {
    Found result = Found::kHere;
    // `cursor` is captured by reference: boxes are tested against where it is by then.
    each_at(g, cursor, [&](Ref ref) {
        Event e;
        const Found f = next(ref, cursor, want, e);
        if (f == Found::kNever) {
            result = Found::kNever;
            return false;
        }
        if (f == Found::kLater) {
            cursor = e;
            moved = true;
            if (e.t - e.error > far_) {
                result = Found::kNever;
                return false;
            }
        }
        return true;
    });
    return result;
}

Found Walker::next_of_all(const Group& g, const Event& cursor, bool want, Event& out) {
    Event at = cursor;
    bool ever = false;
    while (true) {
        bool moved = false;
        if (pass(g, at, want, moved) == Found::kNever) return Found::kNever;
        if (!moved) break;
        ever = true;
        if (g.plain_count + g.item_count == 1) break;
    }
    out = at;
    return ever ? Found::kLater : Found::kHere;
}

template <class Visit>
bool Walker::each_on_ray(const Group& g, Visit visit) {
    const auto enters = [&](const BoxNode& node) {
        double from = 0, to = 0;
        return slab_interval(node.lo, node.hi, context_.slab(), from, to) && to >= 0;
    };
    return each_entered(g, enters, visit);
}

Walker::Changes Walker::all_changes(Ref ref) {
    if (ref.is_leaf()) return leaf_changes(ref.index());
    const Group& g = context_.program().groups[ref.index()];
    const auto constant = [&](bool value) { return Changes{static_cast<std::uint32_t>(events_.size()), 0, value}; };
    if (misses(g, 0)) return constant(g.outside_value);
    const std::size_t first_list = lists_.size();
    const bool open = each_on_ray(g, [&](Ref child) {
        const Changes c = all_changes(child);
        if (c.count > 0) {
            lists_.push_back(c);
            return true;
        }
        return c.initial == g.is_and;  // neutral: left out; else the group is this constant
    });
    Changes result;
    if (!open) {
        result = constant(!g.is_and);
    } else if (lists_.size() == first_list) {
        result = constant(g.is_and);
    } else if (lists_.size() == first_list + 1) {
        result = lists_[first_list];
    } else {
        result = merge(g, first_list);
    }
    lists_.resize(first_list);
    return result;
}

Walker::Changes Walker::merge(const Group& g, std::size_t first_list) {
    sweep_.clear();
    const auto n = static_cast<std::uint32_t>(lists_.size() - first_list);
    std::uint32_t held = 0;
    for (std::uint32_t k = 0; k < n; ++k) {
        const Changes& c = lists_[first_list + k];
        held += c.initial ? 1 : 0;
        for (std::uint32_t i = 0; i < c.count; ++i) sweep_.push_back({events_[c.first + i], k});
    }
    std::sort(sweep_.begin(), sweep_.end(), [&](const Tagged& a, const Tagged& b) { return context_.compare(a.event, b.event) < 0; });
    const auto value = [&] { return g.is_and ? held == n : held > 0; };
    Changes result{static_cast<std::uint32_t>(events_.size()), 0, value()};
    bool now = result.initial;
    for (std::size_t i = 0; i < sweep_.size();) {
        const std::size_t at = i;
        for (; i < sweep_.size() && (i == at || context_.compare(sweep_[at].event, sweep_[i].event) == 0); ++i) {
            Changes& c = lists_[first_list + sweep_[i].child];
            held += c.initial ? ~0u : 1u;
            c.initial = !c.initial;
        }
        if (value() != now) {
            now = !now;
            events_.push_back(sweep_[at].event);
        }
    }
    result.count = static_cast<std::uint32_t>(events_.size()) - result.first;
    return result;
}

void Walker::causes(Ref ref, const Event& at, std::vector<Cause>& out) {
    if (ref.is_leaf()) {
        const Changes c = leaf_changes(ref.index());
        for (std::uint32_t i = 0; i < c.count; ++i)
            if (context_.compare(events_[c.first + i], at) == 0) out.push_back({ref.index(), events_[c.first + i]});
        return;
    }
    Event before = at, behind = at;
    before.before = true;
    behind.before = false;
    each_at(context_.program().groups[ref.index()], at, [&](Ref child) {
        if (state(child, before) != state(child, behind)) causes(child, at, out);
        return true;
    });
}

void Walker::causes_among_met(const Event& at, std::vector<Cause>& out) {
    for (std::uint32_t leaf = 0; leaf < slots_.size(); ++leaf)
        if (slots_[leaf].stamp == stamp_) causes(Ref::leaf(leaf), at, out);
}

std::uint32_t Walker::matter_at(Ref ref, const Event& cursor) {
    const Program& program = context_.program();
    if (!state(ref, cursor)) return kNoLeafUse;
    if (ref.is_leaf()) {
        const Leaf& leaf = program.leaves[ref.index()];
        return leaf.fills ? leaf.use : kNoLeafUse;
    }
    std::uint32_t first = kNoLeafUse;
    each_at(program.groups[ref.index()], cursor, [&](Ref child) {
        const std::uint32_t use = matter_at(child, cursor);
        if (use != kNoLeafUse && (first == kNoLeafUse || program.matter_order[use] < program.matter_order[first])) first = use;
        return true;
    });
    return first;
}

void Walker::matter_changes(Ref ref, std::vector<MatterChange>& out) {
    const Program& program = context_.program();
    if (!ref.is_leaf()) {
        each_on_ray(program.groups[ref.index()], [&](Ref child) {
            matter_changes(child, out);
            return true;
        });
        return;
    }
    const Changes c = leaf_changes(ref.index());
    for (std::uint32_t i = 0; i < c.count; ++i) out.push_back({events_[c.first + i], ref.index()});
}

}  // namespace whittle
