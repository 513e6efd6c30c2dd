// reference.cpp — see reference.h.
#include "tests/reference/reference.h"

#include <algorithm>

#include "tests/reference/on_ray.h"
#include "tests/reference/shapes.h"

namespace whittle::reference {

namespace {

constexpr long kBits = 200;

// A support on a ray: its roots, and its sign before the first, between neighbours, and after the last.
struct Trace {
    std::vector<Root> roots;
    std::vector<int> signs;
};

Trace trace(const Polynomial& p) {
    Trace t;
    if (!p.is_zero()) t.roots = real_roots(p, kBits);
    if (t.roots.empty()) {
        t.signs = {p.sign_at(Dyadic())};
        return t;
    }
    t.signs.push_back(p.sign_at(t.roots.front().lo - Dyadic(1.0)));
    for (std::size_t i = 1; i < t.roots.size(); ++i) t.signs.push_back(p.sign_at(middle(t.roots[i - 1].hi, t.roots[i].lo)));
    t.signs.push_back(p.sign_at(t.roots.back().hi + Dyadic(1.0)));
    return t;
}

// A facet that the ray passes: behind it where its support, linear in t, has the sign `after`.
struct Passed {
    std::uint32_t support;
    int after;
};

// Root number `root` of support `support`.
struct Event {
    std::uint32_t support, root;
};

// The events of all supports, ascending, equal ones in one group.
std::vector<std::vector<Event>> grouped(std::vector<Trace>& traces) {
    std::vector<Event> events;
    for (std::uint32_t s = 0; s < traces.size(); ++s)
        for (std::uint32_t r = 0; r < traces[s].roots.size(); ++r) events.push_back({s, r});
    const auto order = [&](const Event& a, const Event& b) {
        if (a.support == b.support) return a.root <=> b.root;
        return compare(traces[a.support].roots[a.root], traces[b.support].roots[b.root]);
    };
    std::stable_sort(events.begin(), events.end(), [&](const Event& a, const Event& b) { return order(a, b) < 0; });
    std::vector<std::vector<Event>> groups;
    for (const Event& e : events) {
        if (!groups.empty() && order(groups.back().back(), e) == 0) groups.back().push_back(e);
        else groups.push_back({e});
    }
    return groups;
}

// The branch of a use below the placements `outer`.
std::size_t grow(Tree& tree, const Solid& solid, const Use& use, const Matrix& outer, const Options& options) {
    const Matrix placed = outer * exact(use.placement);
    Branch branch;
    if (const auto* shape = std::get_if<Shape>(&solid.node(use.node))) {
        branch.is_leaf = true;
        branch.leaf = static_cast<std::uint32_t>(tree.leaves.size());
        const FormPoint p = pulled_back(root_frame_point(), options.round_chains ? rounded(placed) : placed);
        tree.leaves.push_back(shape_formula(tree.formulas, solid, *shape, p));
    } else {
        const auto& combination = std::get<Combination>(solid.node(use.node));
        branch.op = combination.op;
        for (const Use& operand : combination.operands) branch.operands.push_back(grow(tree, solid, operand, placed, options));
    }
    tree.branches.push_back(std::move(branch));
    return tree.branches.size() - 1;
}

}  // namespace

Tree tree_of(const Solid& solid, const Options& options) {
    Tree tree;
    tree.root = grow(tree, solid, solid.root(), exact(Placement{}), options);
    if (options.fuse > 0) tree.formulas.fuse(options.fuse);
    return tree;
}

Evaluator::Evaluator(Tree tree) : tree_(std::move(tree)), readers_(tree_.formulas.supports().size()) {
    for (std::uint32_t i = 0; i < leaf_count(); ++i)
        if (const auto facets = tree_.faceted.find(i); facets != tree_.faceted.end()) {
            for (const Facet& f : facets->second.facets)
                for (const std::uint32_t s : {f.support, f.own})
                    if (readers_[s].empty() || readers_[s].back() != i) readers_[s].push_back(i);
        } else {
            for (const std::uint32_t s : tree_.formulas.reads(tree_.leaves[i])) readers_[s].push_back(i);
        }
}

bool Evaluator::holds(std::size_t id, const std::vector<bool>& leaf_holds) const {
    const Branch& b = tree_.branches[id];
    if (b.is_leaf) return leaf_holds[b.leaf];
    if (b.operands.empty()) return false;
    const auto operand_holds = [&](std::size_t o) { return holds(o, leaf_holds); };
    switch (b.op) {
        case SetOp::kUnion: return std::any_of(b.operands.begin(), b.operands.end(), operand_holds);
        case SetOp::kIntersection: return std::all_of(b.operands.begin(), b.operands.end(), operand_holds);
        case SetOp::kDifference: return operand_holds(b.operands[0]) && std::none_of(b.operands.begin() + 1, b.operands.end(), operand_holds);
    }
    return false;
}

Borders Evaluator::borders(const Ray& ray, const std::set<std::uint32_t>& leaving) const {
    OnRay on_ray(ray);
    std::vector<Trace> traces(readers_.size());
    std::vector<int> signs(readers_.size());
    for (std::size_t s = 0; s < readers_.size(); ++s) {
        if (readers_[s].empty()) continue;
        const Form& support = tree_.formulas.supports()[s];
        traces[s] = trace(leaving.count(static_cast<std::uint32_t>(s)) != 0 ? on_ray.leaving(support) : on_ray.along(support));
        signs[s] = traces[s].signs[0];
    }
    std::map<std::uint32_t, std::vector<Passed>> behind;
    std::map<std::uint32_t, bool> throughout;
    for (const auto& [leaf, solid] : tree_.faceted) {
        for (const std::size_t i : passed(solid.facets, ray)) {
            const Facet& f = solid.facets[i];
            const std::vector<Root>& roots = traces[f.support].roots;
            const bool near = !roots.empty() && (f.support == f.own || is_near(f, solid.along, ray, roots[0].lo));
            const std::uint32_t s = near ? f.support : f.own;
            behind[leaf].push_back({s, traces[s].signs.back()});
        }
        throughout[leaf] = is_along(solid, ray) && holds_along(solid, ray);
    }
    const auto leaf_holds_now = [&](std::uint32_t leaf) {
        if (tree_.faceted.count(leaf) == 0) return tree_.formulas.holds(tree_.leaves[leaf], signs);
        const auto& list = behind[leaf];
        return throughout[leaf] || std::count_if(list.begin(), list.end(), [&](const Passed& p) { return signs[p.support] == p.after; }) % 2 != 0;
    };
    std::vector<bool> leaf_holds(leaf_count());
    for (std::uint32_t i = 0; i < leaf_count(); ++i) leaf_holds[i] = leaf_holds_now(i);

    Borders result;
    bool inside = holds(tree_.root, leaf_holds);
    result.starts_inside = inside;
    for (const std::vector<Event>& group : grouped(traces)) {
        const Root* first = &traces[group[0].support].roots[group[0].root];
        std::vector<std::uint32_t> touched;
        for (const Event& e : group) {
            signs[e.support] = traces[e.support].signs[e.root + 1];
            touched.insert(touched.end(), readers_[e.support].begin(), readers_[e.support].end());
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        Border border{first->lo, first->hi, true, {}, {}};
        const std::vector<bool> held = leaf_holds;
        for (const std::uint32_t leaf : touched) {
            const bool now = leaf_holds_now(leaf);
            if (now != leaf_holds[leaf]) border.leaves.push_back(leaf);
            leaf_holds[leaf] = now;
        }
        const bool now_inside = holds(tree_.root, leaf_holds);
        const bool at_or_before_zero = first->lo.sign() < 0 || first->is_zero();
        border.entering = now_inside;
        for (std::uint32_t i = 0; now_inside != inside && i < leaf_count(); ++i)
            if (now_inside ? leaf_holds[i] : held[i]) border.holding.push_back(i);
        if (now_inside != inside && first->lo.sign() >= 0 && (!first->is_zero() || (now_inside && leaving.empty()))) result.borders.push_back(std::move(border));
        inside = now_inside;
        if (at_or_before_zero) result.starts_inside = inside;
    }
    return result;
}

}  // namespace whittle::reference
