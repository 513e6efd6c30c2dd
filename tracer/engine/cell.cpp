// cell.cpp — the intersection of a few half-spaces: an interval, cut further by the ones that are not convex on the ray.
#include <algorithm>

#include "tracer/engine/leaf.h"

namespace whittle {

namespace {

Event event_of(ClassId id, const Crossings& c, int i) {
    const auto k = static_cast<std::size_t>(i);
    return {c.t[k], c.error[k], id, static_cast<std::uint8_t>(i), false};
}

// out[first...] (changes of a set, `inside` before the first) intersected with another set's changes.
bool intersect(RayContext& context, std::vector<Event>& out, std::size_t first, bool inside, const Crossings& c, ClassId id, bool c_inside) {
    const std::vector<Event> a(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
    out.resize(first);
    const bool before_all = inside && c_inside;
    bool now = before_all;
    std::size_t i = 0;
    int j = 0;
    while (i < a.size() || j < c.count) {
        int order = i == a.size() ? 1 : j == c.count ? -1 : context.compare(a[i], event_of(id, c, j));
        const Event e = order <= 0 ? a[i] : event_of(id, c, j);
        if (order <= 0) inside = !inside, ++i;
        if (order >= 0) c_inside = !c_inside, ++j;
        if ((inside && c_inside) != now) {
            now = !now;
            out.push_back(e);
        }
    }
    return before_all;
}

}  // namespace

bool cell_events(const Leaf& leaf, RayContext& context, std::vector<Event>& out) {
    const Program& program = context.program();
    const Event far_before{-HUGE_VAL, 0, kNoClass, 0, false}, far_behind{HUGE_VAL, 0, kNoClass, 0, false};
    Event lo = far_before, hi = far_behind;
    bool more = false;  // some half-space is not one interval on the ray
    Crossings c;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const HalfSpace h = program.half_spaces[leaf.first + i];
        const ClassId id = h.id();
        context.crossings(id, c);
        const bool starts_inside = (c.first_sign < 0) != h.inverted();
        if (c.count == 0) {
            if (!starts_inside) return false;
            continue;
        }
        if (c.count == 1) {
            const Event e = event_of(id, c, 0);
            if (starts_inside) {
                if (context.compare(e, hi) < 0) hi = e;
            } else if (context.compare(e, lo) > 0) {
                lo = e;
            }
        } else if (c.count == 2 && !starts_inside) {
            const Event in = event_of(id, c, 0), behind = event_of(id, c, 1);
            if (context.compare(in, lo) > 0) lo = in;
            if (context.compare(behind, hi) < 0) hi = behind;
        } else {
            more = true;
            continue;
        }
        if (context.compare(lo, hi) >= 0) return false;
    }
    const std::size_t first = out.size();
    bool inside = lo.t == -HUGE_VAL;
    if (!inside) out.push_back(lo);
    if (hi.t != HUGE_VAL) out.push_back(hi);
    for (std::uint32_t i = 0; more && i < leaf.count; ++i) {
        const HalfSpace h = program.half_spaces[leaf.first + i];
        if (is_plane(program.classes[h.id()].kind)) continue;
        context.crossings(h.id(), c);
        const bool starts_inside = (c.first_sign < 0) != h.inverted();
        if (c.count > 2 || (c.count == 2 && starts_inside)) inside = intersect(context, out, first, inside, c, h.id(), starts_inside);
    }
    return inside;
}

void sort_by_parity(RayContext& context, std::vector<Event>& events, std::size_t first) {
    const auto from = events.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(from, events.end(), [&](const Event& a, const Event& b) { return context.compare(a, b) < 0; });
    std::size_t kept = first;
    for (std::size_t i = first; i < events.size();) {
        std::size_t j = i + 1;
        while (j < events.size() && context.compare(events[i], events[j]) == 0) ++j;
        if ((j - i) % 2 == 1) events[kept++] = events[i];
        i = j;
    }
    events.resize(kept);
}

bool leaf_events(const Leaf& leaf, RayContext& context, std::vector<Event>& out) {
    ++context.counters().primitive_tests;
    if (leaf.kind == FormulaKind::kCell) return cell_events(leaf, context, out);
    if (leaf.kind == FormulaKind::kPrism) return prism_events(context.program().prisms[leaf.first], context, out);
    return mesh_events(context.program().meshes[leaf.first], context, out);
}

}  // namespace whittle
