// cell.cpp — the intersection of a few half-spaces: an interval, cut further by the ones that are not convex on the ray.
#include <algorithm>

#include "csg/span/interval_set.h"
#include "tracer/engine/leaf.h"

namespace whittle {

namespace {

Event event_of(ClassId id, const Crossings& c, int i) {
    const auto k = static_cast<std::size_t>(i);
    return {c.t[k], c.error[k], id, static_cast<std::uint32_t>(i)};
}

IntervalSet<Event> set_of(const Crossings& c, ClassId id, bool starts_inside) {
    IntervalSet<Event> r{starts_inside, {}};
    for (int i = 0; i < c.count; ++i) r.borders.push_back(event_of(id, c, i));
    return r;
}

// The interval on which the ray is inside all half-spaces that make one interval on it.
class Narrowing {
public:
    explicit Narrowing(RayContext& context) : context_(context) {}

    // The slabs that a cell begins with. Their number of half-spaces; 0: they have to be added one by one.
    std::uint32_t add(const CellSlabs& slabs) { return context_.crossings(slabs, lo, hi) ? slabs.planes : 0; }
    bool is_empty() { return context_.compare(lo, hi) >= 0; }

    // False: the interval is empty.
    bool add(const HalfSpace& h) {
        Crossings c;
        const ClassId id = h.id();
        context_.crossings(id, c);
        const bool starts_inside = (c.first_sign < 0) != h.inverted();
        if (c.count == 0) return starts_inside;
        if (c.count == 1) {
            const Event e = event_of(id, c, 0);
            if (starts_inside) {
                if (context_.compare(e, hi) < 0) hi = e;
            } else if (context_.compare(e, lo) > 0) {
                lo = e;
            }
        } else if (c.count == 2 && !starts_inside) {
            const Event in = event_of(id, c, 0), behind = event_of(id, c, 1);
            if (context_.compare(in, lo) > 0) lo = in;
            if (context_.compare(behind, hi) < 0) hi = behind;
        } else {
            more = true;
            return true;
        }
        return context_.compare(lo, hi) < 0;
    }

    Event lo{-HUGE_VAL, 0, kNoClass}, hi{HUGE_VAL, 0, kNoClass};
    bool more = false;  // some half-space is not one interval on the ray

private:
    RayContext& context_;
};

// All of a cell's half-spaces; of many planes those that the ray can feel. False: it is inside nowhere.
bool narrow(const Leaf& leaf, RayContext& context, Narrowing& n) {
    const Program& program = context.program();
    std::uint32_t k = 0;
    if (leaf.slabs != Leaf::kNoSlabs) {
        k = n.add(program.cell_slabs[leaf.slabs]);
        if (k > 0 && n.is_empty()) return false;
    } else if (leaf.facets != Leaf::kNoFacets) {
        const FacetTree& tree = program.facet_trees[leaf.facets];
        FacetSearch& search = context.facet_search();
        if (!search.run(program.facet_chunks, tree, facet_line(tree, context.ray().origin, context.ray().direction))) return false;
        for (const std::uint32_t plane : search.found())
            if (!n.add(program.half_spaces[leaf.first + plane])) return false;
        k = tree.planes;
    }
    for (; k < leaf.count; ++k)
        if (!n.add(program.half_spaces[leaf.first + k])) return false;
    return true;
}

}  // namespace

bool cell_events(const Leaf& leaf, RayContext& context, std::vector<Event>& out) {
    const Program& program = context.program();
    Narrowing n(context);
    if (!narrow(leaf, context, n)) return false;
    if (!n.more) {
        if (n.lo.t != -HUGE_VAL) out.push_back(n.lo);
        if (n.hi.t != HUGE_VAL) out.push_back(n.hi);
        return n.lo.t == -HUGE_VAL;
    }
    IntervalSet<Event> rest{n.lo.t == -HUGE_VAL, {}};
    if (!rest.inside_before) rest.borders.push_back(n.lo);
    if (n.hi.t != HUGE_VAL) rest.borders.push_back(n.hi);
    Crossings c;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const HalfSpace h = program.half_spaces[leaf.first + i];
        if (is_plane(program.classes[h.id()].kind)) continue;
        context.crossings(h.id(), c);
        const bool starts_inside = (c.first_sign < 0) != h.inverted();
        if (c.count > 2 || (c.count == 2 && starts_inside))
            rest = intersect(rest, set_of(c, h.id(), starts_inside), [&](const Event& a, const Event& b) { return context.compare(a, b); });
    }
    out.insert(out.end(), rest.borders.begin(), rest.borders.end());
    return rest.inside_before;
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
