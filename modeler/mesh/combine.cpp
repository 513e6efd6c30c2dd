#include "modeler/mesh/combine.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "csg/base/module_file.h"
#include "modeler/arrange/box_tree.h"
#include "modeler/arrange/sets.h"
#include "modeler/mesh/own_points.h"

namespace whittle {
namespace {

GridBox common(const GridBox& a, const GridBox& b) {
    GridBox out;
    for (std::size_t i = 0; i < 3; ++i) out.lo[i] = std::max(a.lo[i], b.lo[i]), out.hi[i] = std::min(a.hi[i], b.hi[i]);
    return out;
}

// A leaf of the expression, in place.
struct Leaf {
    PlanId plan = 0;  // a leaf of the plan, or a combination whose result is known
    GridPoint offset{};
    FacetTag tag_base = 0;
    std::uint32_t number = 0;     // the author's
    std::uint32_t first_use = 0;  // in the plan's order
    GridBox box;
};

// A set expression without operands that cannot matter. Terms are made after their children.
struct Term {
    std::optional<SetOp> op;  // nothing: a leaf
    std::uint32_t leaf = 0;
    std::vector<std::uint32_t> children;
};

Mesh in_doubles(const Operand& operand) {
    Mesh out;
    for (const GridPoint& p : operand.mesh->points) {
        const GridPoint q = sum(p, operand.offset);
        out.points.emplace_back(static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]));
    }
    out.triangles = operand.mesh->triangles;
    for (const FacetTag tag : operand.mesh->tags) out.leaf.push_back(tag + operand.tag_base);
    return with_own_points(out);
}

// Where two operands have a facet in one place CGAL chooses whose it is.
Result<ArrangedMesh> combined_by_cgal(std::span<const Operand> operands, const std::vector<BooleanStep>& steps) {
    const auto entry = module_entry("whittle_cgal.so", "whittle_cgal_booleans_1", "the part that combines meshes by CGAL");
    if (!entry) return tl::unexpected(entry.error());
    std::vector<Mesh> meshes;
    for (const Operand& o : operands) meshes.push_back(in_doubles(o));
    Mesh made;
    std::string fault;
    if (!reinterpret_cast<decltype(&whittle_cgal_booleans_1)>(*entry)(meshes, steps, made, fault))
        return fail(Fault::kScene, "CGAL declines: " + fault + " (--booleans=exact does not)");
    ArrangedMesh out;
    out.points = std::move(made.points);
    out.triangles = std::move(made.triangles);
    out.tags = std::move(made.leaf);
    out.on_grid = std::all_of(out.points.begin(), out.points.end(), [](const Vec3& p) { return p == glm::round(p); });
    return out;
}

class Combiner {
public:
    Combiner(const Plan& plan, std::span<const std::uint32_t> uses, const CombineOptions& options, MeshControl& control)
        : plan_(plan), uses_(uses), options_(options), control_(control), use_count_(plan.size(), 1), mixed_(plan.size(), false) {
        for (PlanId id = 0; id < plan.size(); ++id) {
            const PlanNode& n = plan.node(id);
            if (n.op) use_count_[id] = use_count_[n.a.plan] + use_count_[n.b.plan];
            if (!n.starts.empty()) use_count_[id] = static_cast<std::uint32_t>(n.starts.size());
        }
    }

    Result<Parts> run(PlanId root, MeshStats& stats) {
        if (options_.tell_matters) look_at(root, 0);
        if (auto solved = solve_shared(root); !solved) return tl::unexpected(solved.error());
        auto parts = combined(root, true);
        stats.booleans += booleans_;
        stats.decimated += work_.removed;
        stats.seconds_boolean += work_.seconds_cut + work_.seconds_classify;
        stats.seconds_decimate += work_.seconds_join;
        return parts;
    }

private:
    // What stands in one place: its first matter, whether there are others, and whether there are cutters whose faces show them.
    struct Seen {
        std::uint32_t fills = OperandMatter::kNone;
        bool several = false, silent = false;
        void add(const Seen& other) {
            several = several || other.several || (fills != OperandMatter::kNone && other.fills != OperandMatter::kNone && fills != other.fills);
            silent = silent || other.silent;
            if (fills == OperandMatter::kNone) fills = other.fills;
        }
    };
    // Marks what in any of its places has several matters to be told apart.
    Seen look_at(PlanId id, std::uint32_t first_use) {
        const PlanNode& n = plan_.node(id);
        Seen seen;
        if (n.op) {
            seen = look_at(n.a.plan, first_use);
            seen.add(look_at(n.b.plan, first_use + use_count_[n.a.plan]));
        } else {
            for (std::uint32_t i = 0; i < use_count_[id]; ++i) {
                const OperandMatter& m = options_.matters[uses_[first_use + i]];
                seen.add({m.fills, false, m.shows_filled});
            }
        }
        if (seen.several && seen.silent) mixed_[id] = true;
        return seen;
    }

    // Results used at several places are made once, where they lie on the grid: they can then stand for leaves.
    Result<void> solve_shared(PlanId root) {
        std::vector<bool> needed(root + 1, false), off_grid(root + 1, false);
        needed[root] = true;
        for (PlanId id = root + 1; id-- > 0;)
            if (const PlanNode& n = plan_.node(id); needed[id] && n.op) needed[n.a.plan] = needed[n.b.plan] = true;
        for (PlanId id = 0; id < root; ++id) {
            const PlanNode& n = plan_.node(id);
            if (!needed[id] || !n.op) continue;
            off_grid[id] = off_grid[n.a.plan] || off_grid[n.b.plan];
            if (n.users < 2 || off_grid[id] || mixed_[id]) continue;
            const auto parts = combined(id, false);
            if (!parts) return tl::unexpected(parts.error());
            if (auto mesh = on_grid(*parts)) {
                solved_.emplace(id, std::move(*mesh));
            } else {
                off_grid[id] = true;
            }
        }
        return {};
    }

    // All parts as one mesh; nothing where a point is not on the grid.
    std::optional<GridMesh> on_grid(const Parts& parts) const {
        GridMesh out;
        for (const Part& part : parts) {
            const auto first = static_cast<std::uint32_t>(out.points.size());
            if (part.made) {
                if (!part.made->on_grid) return std::nullopt;
                for (const Vec3& p : part.made->points) out.points.push_back({std::llround(p.x), std::llround(p.y), std::llround(p.z)});
            } else {
                for (const GridPoint& p : mesh_of(part.leaf).points) out.points.push_back(sum(p, part.offset));
            }
            const auto& triangles = part.made ? part.made->triangles : mesh_of(part.leaf).triangles;
            const auto& tags = part.made ? part.made->tags : mesh_of(part.leaf).tags;
            for (const auto& t : triangles) out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            for (const FacetTag tag : tags) out.tags.push_back(tag + part.tag_base);
        }
        return out;
    }

    const GridMesh& mesh_of(PlanId id) const {
        const auto known = solved_.find(id);
        return known == solved_.end() ? plan_.node(id).leaf : known->second;
    }

    // `whole`: the root is the one that `uses` speaks of.
    Result<Parts> combined(PlanId root, bool whole) {
        whole_ = whole;
        leaves_.clear();
        terms_.clear();
        const auto top = expand({root, {}}, 0, 0, plan_.node(root).box);
        if (!top) return Parts{};
        const auto groups = groups_of();
        std::vector<Result<Parts>> made(groups.size());
        std::vector<ArrangeStats> work(groups.size());
        tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t i) { made[i] = arranged(groups[i], *top, work[i]); });
        Parts parts;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (!made[i]) return tl::unexpected(made[i].error());
            for (Part& p : *made[i]) parts.push_back(std::move(p));
            booleans_ += groups[i].size() > 1 ? 1U : 0U;
            work_ += work[i];
        }
        return parts;
    }

    // What lies in `room`, as a term; nothing where that is empty.
    std::optional<std::uint32_t> expand(const PlanRef& ref, FacetTag tag_base, std::uint32_t first_use, const GridBox& room) {
        const PlanNode& n = plan_.node(ref.plan);
        const GridBox box = moved(n.box, ref.offset);
        // What only touches decides nothing but whose face shows: of two that abut within a third neither does.
        if (!(tells() ? boxes_touch(box, room) : boxes_overlap(box, room))) return std::nullopt;
        if (!n.op || solved_.contains(ref.plan)) {
            if (mesh_of(ref.plan).triangles.empty()) return std::nullopt;
            leaves_.push_back({ref.plan, ref.offset, tag_base, whole_ ? uses_[first_use] : first_use, first_use, box});
            return term({std::nullopt, static_cast<std::uint32_t>(leaves_.size() - 1), {}});
        }
        const PlanRef a{n.a.plan, sum(n.a.offset, ref.offset)}, b{n.b.plan, sum(n.b.offset, ref.offset)};
        const FacetTag tag_b = tag_base + plan_.node(a.plan).tag_count;
        const std::uint32_t use_b = first_use + use_count_[a.plan];
        const bool both = *n.op == SetOp::kIntersection;
        const auto left = expand(a, tag_base, first_use, both ? common(room, plan_.box(b)) : room);
        if (!left && *n.op != SetOp::kUnion) return std::nullopt;
        const auto right = expand(b, tag_b, use_b, *n.op == SetOp::kUnion ? room : common(room, plan_.box(a)));
        if (!right) return both ? std::nullopt : left;
        if (!left) return right;
        return term({n.op, 0, {*left, *right}});
    }
    std::uint32_t term(Term t) {
        terms_.push_back(std::move(t));
        return static_cast<std::uint32_t>(terms_.size() - 1);
    }

    // Leaves whose boxes touch, directly or through others.
    std::vector<std::vector<std::uint32_t>> groups_of() const {
        std::vector<DoubleBox> boxes;
        std::vector<std::uint32_t> owner(leaves_.size());
        std::iota(owner.begin(), owner.end(), 0U);
        for (const Leaf& l : leaves_) {
            DoubleBox b;
            for (std::size_t k = 0; k < 3; ++k) b.lo[k] = static_cast<double>(l.box.lo[k]), b.hi[k] = static_cast<double>(l.box.hi[k]);
            boxes.push_back(b);
        }
        DisjointSets sets(leaves_.size());
        BoxTree(boxes, owner).pairs([&](std::uint32_t i, std::uint32_t j) { sets.join(i, j); });
        std::vector<std::vector<std::uint32_t>> groups;
        std::map<std::uint32_t, std::size_t> number;
        for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
            const auto [at, fresh] = number.try_emplace(sets.find(i), groups.size());
            if (fresh) groups.emplace_back();
            groups[at->second].push_back(i);
        }
        return groups;
    }

    // Operands that are left of an expression, and how they are combined.
    struct Narrowed {
        std::vector<std::uint32_t> operands;
        std::vector<BooleanStep> steps;
    };

    // The expression with all leaves outside the group empty. Gives the operands that are left; nothing where the whole is empty.
    std::optional<Expression::Id> narrowed(std::uint32_t id, const std::vector<std::uint32_t>& group, Expression& out, Narrowed& left) const {
        const Term& t = terms_[id];
        if (!t.op) {
            if (!std::binary_search(group.begin(), group.end(), t.leaf)) return std::nullopt;
            left.steps.push_back({static_cast<std::uint32_t>(left.operands.size()), SetOp::kUnion});
            left.operands.push_back(t.leaf);
            return out.operand();
        }
        const std::size_t first_step = left.steps.size();
        std::vector<Expression::Id> children;
        for (std::size_t i = 0; i < t.children.size(); ++i) {
            const auto child = narrowed(t.children[i], group, out, left);
            if (child) {
                children.push_back(*child);
                if (children.size() > 1) left.steps.push_back({BooleanStep::kOperation, *t.op});
            } else if (*t.op == SetOp::kIntersection || (*t.op == SetOp::kDifference && i == 0)) {
                left.steps.resize(first_step);
                return std::nullopt;
            }
        }
        if (children.empty()) return std::nullopt;
        return children.size() == 1 ? children.front() : out.combine(*t.op, children);
    }

    bool tells() const { return whole_ && options_.tell_matters; }

    // Of all leaves of an operand together. Results for several places are made without: each place may have its own.
    OperandMatter matter_of(const Leaf& l) const {
        if (!whole_) return {};
        OperandMatter out = options_.matters[uses_[l.first_use]];
        bool several = false, silent = false;
        for (std::uint32_t i = 0; i < use_count_[l.plan]; ++i) {
            const OperandMatter& m = options_.matters[uses_[l.first_use + i]];
            silent = silent || m.shows_filled;
            if (m.subtractions == 0) several = several || (out.subtractions == 0 && out.fills != m.fills);
            if (m.subtractions < out.subtractions) out = m;
        }
        if (several) out.fills = OperandMatter::kNone;
        out.hides_cutters = silent && out.subtractions == 0;
        return out;
    }

    Result<Parts> arranged(const std::vector<std::uint32_t>& group, std::uint32_t top, ArrangeStats& stats) const {
        if (control_.cancelled()) return fail(Fault::kInterrupted, "interrupted");
        Expression expression;
        Narrowed left;
        const std::vector<std::uint32_t>& used = left.operands;
        const auto root = narrowed(top, group, expression, left);
        if (!root) return Parts{};
        expression.finish(*root);
        if (used.size() == 1 && !plan_.node(leaves_[used[0]].plan).may_cross_itself) {
            const Leaf& l = leaves_[used[0]];
            if (!solved_.contains(l.plan)) return Parts{Part{l.plan, std::nullopt, l.offset, l.tag_base}};
        }
        std::vector<Operand> operands;
        for (const std::uint32_t i : used) {
            const Leaf& l = leaves_[i];
            operands.push_back({&mesh_of(l.plan), l.offset, l.tag_base, l.number, !solved_.contains(l.plan) && plan_.node(l.plan).may_cross_itself, matter_of(l)});
        }
        auto mesh = options_.booleans == BooleanMaker::kCgal ? combined_by_cgal(operands, left.steps)
                                                             : arrange(operands, expression, {options_.decimate, [this] { return control_.cancelled(); }, tells()}, stats);
        if (!mesh) return tl::unexpected(mesh.error());
        if (mesh->triangles.empty()) return Parts{};
        return Parts{Part{0, std::move(*mesh), {}, 0}};
    }

    const Plan& plan_;
    std::span<const std::uint32_t> uses_;
    const CombineOptions& options_;
    MeshControl& control_;
    std::vector<std::uint32_t> use_count_;
    std::vector<bool> mixed_;
    std::map<PlanId, GridMesh> solved_;
    std::vector<Leaf> leaves_;
    std::vector<Term> terms_;
    bool whole_ = true;
    std::uint64_t booleans_ = 0;
    ArrangeStats work_;
};

}  // namespace

Result<Parts> combine_plan(const Plan& plan, PlanId root, std::span<const std::uint32_t> uses, const CombineOptions& options, MeshControl& control,
                           MeshStats& stats) {
    Combiner combiner(plan, uses, options, control);
    const int most = tbb::info::default_concurrency();  // asking for more only makes TBB print a warning
    tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, most) : most);
    return arena.execute([&] { return combiner.run(root, stats); });
}

}  // namespace whittle
