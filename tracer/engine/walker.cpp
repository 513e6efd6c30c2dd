// walker.cpp — leaping from event to event, and sweeping whole rays.
#include "tracer/engine/walker.h"

#include <algorithm>
#include <utility>

namespace whittle {

void Walker::start(const Program& program, const Ray& ray, EngineCounters& counters, double far) {
    context_.start(program, ray, counters);
    far_ = far;
    boxes_ = program.makes(EnginePass::kBoxes);
    occlusion_ = program.makes(EnginePass::kOcclusion);
    boxes_ahead_ = context_.slab().common ? boxes_ahead() : &boxes_ahead_in_double;
    boxes_touched_ = boxes_touched();
    top_ = 0;
    met_.clear();
    met_balls_.clear();
    if (slots_.size() < program.leaves.size()) slots_.resize(program.leaves.size());
    if (++stamp_ == 0) {
        std::fill(slots_.begin(), slots_.end(), Slot());
        stamp_ = 1;
    }
    events_.clear();
    lists_.clear();
}

Walker::Changes Walker::leaf_changes(std::uint32_t index) {
    Slot& slot = slots_[index];
    if (slot.stamp != stamp_) {
        slot.stamp = stamp_;
        met_.push_back(index);
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
    const Event* const change = events_.data() + c.first;
    std::uint32_t i = 0;
    while (i < c.count && passed(change[i], cursor)) ++i;
    if ((c.initial != (i % 2 != 0)) == want) return Found::kHere;
    if (i == c.count) return Found::kNever;
    out = change[i];
    return Found::kLater;
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

namespace {

// Brings the node's boxes near before they are asked for.
void fetch(const WideNode& node) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&node);
    for (std::size_t at = 0; at < sizeof node; at += 64) __builtin_prefetch(bytes + at);
}

}  // namespace

// Puts the node's children that the ray meets in `range` on the stack, the nearest on top.
void Walker::open(const WideNode& node, const Range& range) {
    const Program& program = context_.program();
    if (waiting_.size() < top_ + kWideBoxes) waiting_.resize(2 * (top_ + kWideBoxes));
    std::array<float, kWideBoxes> from;
    const BoxesAhead ahead = boxes_ahead_(node, context_.slab(), range.begin, range.end, from);
    late_ += ahead.late;
    Waiting* const met = waiting_.data() + top_;
    std::size_t count = 0;
    for (std::uint32_t left = ahead.met; left != 0; left &= left - 1) {
        const auto k = static_cast<std::size_t>(__builtin_ctz(left));
        if (!node.child[k].is_item()) fetch(program.wide[node.child[k].index()]);
        else if (!program.balls.empty()) __builtin_prefetch(&program.balls[node.child[k].index()]);
        std::size_t at = count++;
        for (; at > 0 && met[at - 1].from < from[k]; --at) met[at] = met[at - 1];
        met[at] = {node.child[k], from[k]};
    }
    top_ += count;
}

// Visits the items of the hierarchy whose boxes the ray meets in `range`, which may change meanwhile, nearest first by their boxes within a node.
// True: take(its ref's number) was, and ended it.
template <class Take>
bool Walker::each_item(const Group& g, const Range& range, Take take) {
    if (g.item_count == 0) return false;
    std::uint32_t taken = 0;
    const std::size_t base = top_;
    open(context_.program().wide[g.wide], range);
    while (top_ > base) {
        const Waiting next = waiting_[--top_];
        if (next.from > range.end) {
            ++late_;
        } else if (!next.child.is_item()) {
            open(context_.program().wide[next.child.index()], range);
        } else {
            ++taken;
            if (!take(next.child.index())) continue;
            top_ = base;
            return true;
        }
    }
    context_.counters().skipped_by(EnginePass::kHierarchy) += g.item_count - taken;
    return false;
}

template <class Take>
bool Walker::each_ahead(const Group& g, const Range& range, Take take) {
    if (!occlusion_) return each_item(g, {range.begin, HUGE_VAL}, take);
    const std::uint64_t outer = std::exchange(late_, 0);
    const bool ended = each_item(g, range, take);
    context_.counters().skipped_by(EnginePass::kOcclusion) += late_;
    late_ = outer;
    return ended;
}

Found Walker::next_in_item(std::uint32_t ref, const Event& cursor, bool want, Event& out) {
    const ItemBall* found = context_.program().ball(ref);
    Crossings c;
    if (!want || !found || !context_.crossings(*found, c)) return next(context_.program().refs[ref], cursor, want, out);
    const ItemBall& ball = *found;
    ++context_.counters().primitive_tests;
    if (c.count == 0) return Found::kNever;
    const Event in{c.t[0], c.error[0], ball.id}, behind{c.t[1], c.error[1], ball.id, 1};
    met_balls_.push_back({ref, in, behind});
    if (!passed(in, cursor)) {
        out = in;
        return Found::kLater;
    }
    return passed(behind, cursor) ? Found::kNever : Found::kHere;
}

Found Walker::next_of_any(const Group& g, const Event& cursor, bool want, Event& out) {
    const Program& program = context_.program();
    bool found = false;
    Range range{cursor.t - cursor.error, far_};
    const auto take = [&](Found f, const Event& e) {
        if (f == Found::kLater && (!found || context_.compare(e, out) < 0)) {
            out = e;
            found = true;
            range.end = std::min(range.end, e.t + e.error);
        }
        return f == Found::kHere;
    };
    Event e;
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (take(next(program.refs[g.first_plain + i], cursor, want, e), e)) return Found::kHere;
    if (each_ahead(g, range, [&](std::uint32_t ref) { return take(next_in_item(ref, cursor, want, e), e); })) return Found::kHere;
    return found ? Found::kLater : Found::kNever;
}

bool Walker::meets(Ref ref, const Event& cursor) {
    const Program& program = context_.program();
    if (ref.is_leaf() || program.groups[ref.index()].is_and) {
        Event e;
        return is_before_far(next(ref, cursor, true, e), e);
    }
    const Group& g = program.groups[ref.index()];
    if (misses(g, cursor.t - cursor.error)) return g.outside_value;
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (meets(program.refs[g.first_plain + i], cursor)) return true;
    return each_ahead(g, {cursor.t - cursor.error, far_}, [&](std::uint32_t item) {
        if (!program.ball(item)) return meets(program.refs[item], cursor);
        Event e;
        return is_before_far(next_in_item(item, cursor, true, e), e);
    });
}

// Plain children, then the items whose boxes the ray meets in `range`. False: visit(ref) was, and ended it.
template <class Visit>
bool Walker::each_entered(const Group& g, const Range& range, Visit visit) {
    const Program& program = context_.program();
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (!visit(program.refs[g.first_plain + i])) return false;
    return !each_item(g, range, [&](std::uint32_t ref) { return !visit(program.refs[ref]); });
}

// Visits the items of the hierarchy whose boxes touch a place, which may change meanwhile. True: take(its ref's number) was, and ended it.
template <class Take>
bool Walker::each_item_at(const Group& g, const FloatBox& place, Take take) {
    if (g.item_count == 0) return false;
    const Program& program = context_.program();
    std::uint32_t taken = 0;
    const std::size_t base = top_;
    for (WideChild at = WideChild::node(g.wide);; at = waiting_[--top_].child) {
        if (at.is_item()) {
            ++taken;
            if (take(at.index())) {
                top_ = base;
                return true;
            }
        } else {
            if (waiting_.size() < top_ + kWideBoxes) waiting_.resize(2 * (top_ + kWideBoxes));
            const WideNode& node = program.wide[at.index()];
            for (std::uint32_t left = boxes_touched_(node, place); left != 0; left &= left - 1) waiting_[top_++].child = node.child[static_cast<std::size_t>(__builtin_ctz(left))];
        }
        if (top_ == base) break;
    }
    context_.counters().skipped_by(EnginePass::kHierarchy) += g.item_count - taken;
    return false;
}

// Plain children, then the items whose boxes hold the place of an event. False: as above.
template <class Visit>
bool Walker::each_entered_at(const Group& g, const Event& at, Visit visit) {
    const Program& program = context_.program();
    for (std::uint32_t i = 0; i < g.plain_count; ++i)
        if (!visit(program.refs[g.first_plain + i])) return false;
    return !each_item_at(g, context_.place_of(at), [&](std::uint32_t ref) { return !visit(program.refs[ref]); });
}

// Moves the cursor over the node to where it is next `want`. kNever: nowhere before the ray's far end.
Found Walker::advance(Ref ref, Event& cursor, bool want) {
    Event e;
    const Found found = next(ref, cursor, want, e);
    if (found != Found::kLater) return found;
    cursor = e;
    return e.t - e.error > far_ ? Found::kNever : found;
}

// One round over the items that may not be `want` at the cursor; moves it forward over each. kHere: it has not moved.
Found Walker::advance_over_items(const Group& g, Event& cursor, bool want) {
    Found result = Found::kHere;
    FloatBox place = context_.place_of(cursor);
    each_item_at(g, place, [&](std::uint32_t ref) {
        const Found found = advance(context_.program().refs[ref], cursor, want);
        if (found == Found::kHere) return false;
        result = found;
        place = context_.place_of(cursor);
        return found == Found::kNever;
    });
    return result;
}

// Plain children and, as one, the items take turns until all agree at the cursor. A plain child that has moved it there does.
Found Walker::next_of_all(const Group& g, const Event& cursor, bool want, Event& out) {
    const std::uint32_t parts = g.plain_count + (g.item_count > 0 ? 1 : 0);
    out = cursor;
    bool ever = false;
    std::uint32_t k = 0;
    for (std::uint32_t agree = 0; agree < parts; k = k + 1 < parts ? k + 1 : 0) {
        const bool plain = k < g.plain_count;
        const Found found = plain ? advance(context_.program().refs[g.first_plain + k], out, want) : advance_over_items(g, out, want);
        if (found == Found::kNever) return found;
        ever = ever || found == Found::kLater;
        agree = found == Found::kHere ? agree + 1 : plain ? 1 : 0;
    }
    return ever ? Found::kLater : Found::kHere;
}

Walker::Changes Walker::all_changes(Ref ref) {
    if (ref.is_leaf()) return leaf_changes(ref.index());
    const Group& g = context_.program().groups[ref.index()];
    const auto constant = [&](bool value) { return Changes{static_cast<std::uint32_t>(events_.size()), 0, value}; };
    if (misses(g, 0)) return constant(g.outside_value);
    const std::size_t first_list = lists_.size();
    const bool open = each_entered(g, {0, HUGE_VAL}, [&](Ref child) {
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
    const Event before = Event::beside(at, true), behind = Event::beside(at, false);
    each_entered_at(context_.program().groups[ref.index()], at, [&](Ref child) {
        if (state(child, before) != state(child, behind)) causes(child, at, out);
        return true;
    });
}

void Walker::causes_among_met(const Event& at, std::vector<Cause>& out) {
    const std::size_t slotted = met_.size();
    for (std::size_t i = 0; i < slotted; ++i) causes(Ref::leaf(met_[i]), at, out);
    for (const MetBall& ball : met_balls_) {
        const std::uint32_t leaf = context_.program().refs[ball.ref].index();
        if (slots_[leaf].stamp == stamp_) continue;
        for (const Event& e : {ball.in, ball.out})
            if (context_.compare(e, at) == 0) out.push_back({leaf, e});
    }
}

// In a flat program every leaf that changes where the event was found has been met: a union asks all that may come before its nearest part, an
// intersection all whose boxes hold the place where it ends.
bool Walker::sole_cause(const Event& at, Cause& cause, const ItemBall*& ball) {
    if (!context_.program().flat) return false;
    std::uint32_t leaves = 0;
    const auto is_at = [&](const Event& e) {
        const double d = e.t - at.t, room = e.error + at.error;
        return d <= room && d >= -room && context_.compare(e, at) == 0;
    };
    for (const std::uint32_t leaf : met_) {
        const Changes& c = slots_[leaf].changes;
        for (std::uint32_t i = 0; i < c.count; ++i) {
            if (!is_at(events_[c.first + i])) continue;
            cause = {leaf, events_[c.first + i]};
            ball = nullptr;
            ++leaves;
        }
    }
    for (const MetBall& met : met_balls_)
        for (const Event& e : {met.in, met.out}) {
            if (!is_at(e)) continue;
            const std::uint32_t leaf = context_.program().refs[met.ref].index();
            if (!met_.empty() && slots_[leaf].stamp == stamp_) continue;
            cause = {leaf, e};
            ball = context_.program().ball(met.ref);
            ++leaves;
        }
    return leaves == 1;
}

std::uint32_t Walker::matter_at(Ref ref, const Event& cursor) {
    const Program& program = context_.program();
    if (!state(ref, cursor)) return kNoLeafUse;
    if (ref.is_leaf()) {
        const Leaf& leaf = program.leaves[ref.index()];
        return leaf.fills ? leaf.use : kNoLeafUse;
    }
    std::uint32_t first = kNoLeafUse;
    each_entered_at(program.groups[ref.index()], cursor, [&](Ref child) {
        const std::uint32_t use = matter_at(child, cursor);
        if (use != kNoLeafUse && (first == kNoLeafUse || program.matter_order[use] < program.matter_order[first])) first = use;
        return true;
    });
    return first;
}

void Walker::matter_changes(Ref ref, std::vector<MatterChange>& out) {
    const Program& program = context_.program();
    if (!ref.is_leaf()) {
        each_entered(program.groups[ref.index()], {0, HUGE_VAL}, [&](Ref child) {
            matter_changes(child, out);
            return true;
        });
        return;
    }
    const Changes c = leaf_changes(ref.index());
    for (std::uint32_t i = 0; i < c.count; ++i) out.push_back({events_[c.first + i], ref.index()});
}

bool Walker::are_certain(const std::vector<Cause>& causes) const {
    const Program& program = context_.program();
    if (!program.some_doubtful) return true;
    const auto may_be_unsettled = [&](ClassId id) { return !has_polynomial(program.classes[id].kind); };
    for (const Cause& c : causes) {
        const Leaf& leaf = program.leaves[c.leaf];
        if (!leaf.exact) return false;
        if (leaf.kind != FormulaKind::kCell) continue;
        // They stand last.
        for (std::uint32_t k = leaf.count; k-- > 0;) {
            const ClassId id = program.half_spaces[leaf.first + k].id();
            if (!may_be_unsettled(id)) break;
            if (context_.unsettled(id)) return false;
        }
        if (!context_.is_transcendental(c.event.id())) continue;
        for (const Cause& other : causes)
            if (other.event.id() != c.event.id()) return false;
    }
    return true;
}

}  // namespace whittle
