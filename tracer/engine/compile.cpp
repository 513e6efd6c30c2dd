// compile.cpp — formula → program.
#include <algorithm>
#include <map>
#include <numeric>

#include "csg/solid/placement.h"
#include "tracer/engine/certificates.h"
#include "tracer/engine/lower.h"
#include "tracer/engine/program.h"
#include "tracer/engine/space.h"
#include "tracer/engine/tile.h"
#include "tracer/engine/world_surface.h"

namespace whittle {

namespace {

constexpr std::uint32_t kFewItems = 3;     // fewer are asked in a row: a hierarchy of two nodes costs as much
constexpr double kItemCost = 4;            // an item's test against a node's, measured on the drilled plate
constexpr std::uint32_t kMostInLeaf = 2;
constexpr double kSnapRoom = 4;             // of the largest distance the snap measured: its samples may miss the worst place
constexpr double kTriangleCost = 1.5;
constexpr std::uint32_t kMostTriangles = 4;

// Whose matter wins where several uses hold a place: the highest priority, then the first in the author's order.
void rank_matters(Program& program) {
    const std::vector<LeafUse>& uses = program.uses;
    std::vector<std::uint32_t> ranked(uses.size());
    std::iota(ranked.begin(), ranked.end(), 0U);
    const auto priority = [&](std::uint32_t use) { return uses[use].material->priority.value_or(0); };
    std::stable_sort(ranked.begin(), ranked.end(), [&](std::uint32_t a, std::uint32_t b) { return priority(a) > priority(b); });
    program.matter_order.resize(uses.size());
    for (std::uint32_t rank = 0; rank < ranked.size(); ++rank) program.matter_order[ranked[rank]] = rank;
    const LeafUse* first = nullptr;
    for (const LeafUse& use : uses) {
        if (use.subtracts) continue;
        if (!first) first = &use;
        program.one_matter = program.one_matter && use.material == first->material;
    }
}

// All parts of an AND hold wherever it does, so whose matter is there is known beforehand.
void describe_flat(Program& program) {
    if (program.empty || program.everything || program.root.is_leaf()) return;
    const Group& g = program.groups[program.root.index()];
    program.flat = true;
    const auto look_at = [&](Ref ref) {
        program.flat = program.flat && ref.is_leaf();
        if (!ref.is_leaf() || !g.is_and || !program.leaves[ref.index()].fills) return;
        const std::uint32_t use = program.leaves[ref.index()].use;
        std::uint32_t& first = program.flat_matter;
        if (first == Group::kNoUse || program.matter_order[use] < program.matter_order[first]) first = use;
    };
    for (std::uint32_t i = 0; i < g.plain_count; ++i) look_at(program.refs[g.first_plain + i]);
    for (std::uint32_t i = 0; i < g.item_count; ++i) look_at(program.refs[g.first_item + i]);
}

// Does it say how it reflects, or lets through? What says nothing is plastic.
bool names_look(const LeafUse& use) {
    const Material& m = *use.material;
    return m.preset || m.roughness || m.metal || m.transmission;
}

// The leaf's box as wide as it would be at the origin: whoever aims by it is off by the placement's own rounding only.
Bounds without_room(const FormulaNode& n) {
    const Bounds less{n.box.lo + n.room, n.box.hi - n.room};
    return less.empty() ? n.box : less;
}

// Vectors that grew hold up to twice what they need.
void shrink(Program& program) {
    if (std::none_of(program.balls.begin(), program.balls.end(), [](const ItemBall& b) { return b.r > 0; })) program.balls.clear();
    const auto all = [](auto&... vectors) { (vectors.shrink_to_fit(), ...); };
    all(program.frames, program.motions, program.classes, program.half_spaces, program.cell_slabs, program.leaves, program.leaf_boxes, program.leaf_bounds, program.class_labels, program.groups,
        program.refs, program.balls, program.wide, program.space, program.facet_trees, program.facet_chunks, program.prisms, program.meshes, program.uses,
        program.matter_order);
}

class Compiler {
public:
    Compiler(Formula formula, const EngineOptions& options) : formula_(std::move(formula)), classes_(find_classes(formula_, options.snap)) {
        program_.passes = passes_made(options.disabled_passes);
        formula_.table.keep_frames();
    }

    std::shared_ptr<const Program> run() {
        program_.uses = std::move(formula_.uses);
        keeps_bounds_ = std::any_of(program_.uses.begin(), program_.uses.end(), names_look);
        rank_matters(program_);
        program_.motions = formula_.motions;
        for (const PrismData& p : formula_.prisms) add_prism(p);
        for (const MeshData& m : formula_.meshes) add_mesh(m);
        const FormulaNode& root = formula_.nodes[formula_.root];
        program_.empty = root.kind == FormulaKind::kNothing;
        program_.everything = root.kind == FormulaKind::kEverything;
        program_.bounds = root.outside_value ? everywhere() : program_.empty ? Bounds{} : grown(root.box);
        if (!program_.empty && !program_.everything) program_.root = add(formula_.root);
        program_.report.leaves = program_.uses.size();
        program_.report.kept = program_.leaves.size();
        program_.report.classes = classes_.supports.size();
        program_.report.snap_fused = classes_.fused;
        program_.report.snap_largest = classes_.largest;
        program_.report.largest_displacement = formula_.largest_displacement;
        program_.report.warnings = std::move(formula_.warnings);
        if (emptied_ > 0)
            program_.report.warnings.push_back(std::to_string(emptied_) + " parts are thinner than the snap and vanished; --no-snap keeps them");
        program_.classes = std::move(classes_.supports);
        program_.frames = std::move(formula_.table.frames);
        describe_flat(program_);
        describe_for_packets(program_);
        formula_ = {};
        if (program_.makes(EnginePass::kCells)) divide_space(program_);
        shrink(program_);
        return std::make_shared<const Program>(std::move(program_));
    }

private:
    Ref add(FormulaId id) {
        const FormulaNode& n = formula_.nodes[id];
        if (n.kind == FormulaKind::kAnd || n.kind == FormulaKind::kOr) return add_group(n);
        Leaf leaf;
        leaf.kind = n.kind;
        leaf.negated = n.negated;
        leaf.use = n.use;
        leaf.fills = !program_.uses[n.use].subtracts;
        leaf.first = n.data;
        leaf.exact = kCertifies && (n.kind == FormulaKind::kMesh ? formula_.meshes[n.data].exact : n.exact);
        if (n.kind == FormulaKind::kCell) add_cell(n, leaf);
        program_.leaves.push_back(leaf);
        program_.leaf_boxes.push_back(outward(n.box));
        if (keeps_bounds_) program_.leaf_bounds.push_back(without_room(n));
        return Ref::leaf(static_cast<std::uint32_t>(program_.leaves.size() - 1));
    }

    void add_cell(const FormulaNode& n, Leaf& leaf) {
        std::vector<HalfSpace> sides;
        bool none = false;
        for (const HalfSpaceRef& h : n.half_spaces) {
            const ClassOfSupport c = classes_.of[h.support];
            const HalfSpace side{(c.id << 1) | static_cast<std::uint32_t>(h.inverted != c.flipped)};
            bool known = false;
            for (const HalfSpace& s : sides) {
                known = known || s.packed == side.packed;
                none = none || s.packed == (side.packed ^ 1);
            }
            if (!known) sides.push_back(side);
        }
        if (none) ++emptied_;
        const auto cost = [&](const HalfSpace& h) { return classes_.supports[h.id()].kind; };
        std::stable_sort(sides.begin(), sides.end(), [&](const HalfSpace& a, const HalfSpace& b) { return cost(a) < cost(b); });
        leaf.first = static_cast<std::uint32_t>(program_.half_spaces.size());
        leaf.count = static_cast<std::uint32_t>(sides.size());
        program_.half_spaces.insert(program_.half_spaces.end(), sides.begin(), sides.end());
        add_slabs(sides, leaf);
        add_facets(n.box, sides, leaf);
    }

    // Of pairs of axis planes of the root frame that come first.
    void add_slabs(const std::vector<HalfSpace>& sides, Leaf& leaf) {
        CellSlabs slabs;
        slabs.at.fill({-HUGE_VAL, HUGE_VAL});
        for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
            const Support &a = classes_.supports[sides[i].id()], &b = classes_.supports[sides[i + 1].id()];
            if (!is_of_root(a) || !is_of_root(b) || a.axis != b.axis || sides[i].inverted() == sides[i + 1].inverted() || slabs.at[a.axis][0] != -HUGE_VAL) break;
            const std::size_t upper = sides[i].inverted() ? 1 : 0;
            slabs.at[a.axis] = {classes_.supports[sides[i + 1 - upper].id()].p[0], classes_.supports[sides[i + upper].id()].p[0]};
            slabs.id[a.axis] = {sides[i + 1 - upper].id(), sides[i + upper].id()};
            slabs.planes += 2;
        }
        if (slabs.planes == 0) return;
        leaf.slabs = static_cast<std::uint32_t>(program_.cell_slabs.size());
        program_.cell_slabs.push_back(slabs);
    }

    static bool is_of_root(const Support& s) { return s.kind == SupportKind::kAxisPlane && s.frame == 0; }

    // A tree over the planes of a cell that has many.
    void add_facets(const Bounds& box, const std::vector<HalfSpace>& sides, Leaf& leaf) {
        if (sides.size() < kManyFacets) return;
        const Vec3 centre = is_finite(box) ? 0.5 * (box.lo + box.hi) : Vec3(0);
        std::vector<FacetPlane> planes;
        for (const HalfSpace& h : sides) {
            const Support& s = classes_.supports[h.id()];
            if (!is_plane(s.kind)) break;
            if (formula_.table.frames[s.frame].motion != 0) return;
            const WorldSurface w = world_surface(s, formula_.table.frames[s.frame]);
            const Real sign = h.inverted() ? -1 : 1;
            FacetPlane p;
            Real d = -w.c;
            for (int i = 0; i < 3; ++i) {
                const Real n = w.b[static_cast<std::size_t>(i)];
                p.n[i] = static_cast<double>(sign * n);
                d -= n * centre[i];
            }
            p.d = static_cast<double>(sign * d);
            if (!std::isfinite(p.n.x + p.n.y + p.n.z + p.d)) return;
            planes.push_back(p);
        }
        if (planes.size() < kManyFacets) return;
        leaf.facets = static_cast<std::uint32_t>(program_.facet_trees.size());
        program_.facet_trees.push_back(build_facet_tree(planes, centre, program_.facet_chunks));
    }

    static bool is_finite(const Bounds& b) { return std::isfinite(b.lo.x + b.lo.y + b.lo.z + b.hi.x + b.hi.y + b.hi.z); }

    // A snapped face lies outside its own box by what the snap moved it, and is crossed a little further out by a ray almost in it.
    Bounds grown(const Bounds& box) const {
        const double room = kSnapRoom * classes_.largest + kFacetReach * longest_moved_;
        return box.empty() ? box : Bounds{box.lo - room, box.hi + room};
    }

    // What a leaf is outside its group's box makes no difference.
    void bound_leaf(Ref ref, const Bounds& box) {
        if (!ref.is_leaf()) return;
        FloatBox& own = program_.leaf_boxes[ref.index()];
        const FloatBox group = outward(box);
        for (std::size_t i = 0; i < 3; ++i) {
            own.lo[i] = std::max(own.lo[i], group.lo[i]);
            own.hi[i] = std::min(own.hi[i], group.hi[i]);
        }
        if (keeps_bounds_) program_.leaf_bounds[ref.index()] = common(program_.leaf_bounds[ref.index()], box);
    }

    Ref add_group(const FormulaNode& n) {
        Group g;
        g.is_and = n.kind == FormulaKind::kAnd;
        g.outside_value = n.outside_value;
        g.box = grown(n.box);
        g.bounded = is_finite(n.box);
        std::vector<Ref> plain, items;
        std::vector<Bounds> boxes;
        for (const FormulaId child : n.children) {
            const FormulaNode& c = formula_.nodes[child];
            const bool boxed = c.outside_value == g.is_and && is_finite(c.box);
            const Ref ref = add(child);
            (boxed ? items : plain).push_back(ref);
            if (boxed) boxes.push_back(grown(c.box));
        }
        if (items.size() <= kFewItems || !program_.makes(EnginePass::kHierarchy)) {
            plain.insert(plain.end(), items.begin(), items.end());
            items.clear();
        }
        g.first_plain = static_cast<std::uint32_t>(program_.refs.size());
        g.plain_count = static_cast<std::uint32_t>(plain.size());
        program_.refs.insert(program_.refs.end(), plain.begin(), plain.end());
        if (!items.empty()) {
            const Hierarchy h = build_hierarchy(boxes, kItemCost, kMostInLeaf);
            g.first_item = static_cast<std::uint32_t>(program_.refs.size());
            g.item_count = static_cast<std::uint32_t>(items.size());
            for (const std::uint32_t i : h.order) program_.refs.push_back(items[i]);
            std::vector<FloatBox> own;
            own.reserve(boxes.size());
            for (const std::uint32_t i : h.order) own.push_back(outward(boxes[i]));
            g.wide = widen(h, own, g.first_item, program_.wide);
        }
        if (g.bounded && g.outside_value != g.is_and)
            for (const auto* refs : {&plain, &items})
                for (const Ref ref : *refs) bound_leaf(ref, g.box);
        program_.groups.push_back(g);
        return Ref::group(static_cast<std::uint32_t>(program_.groups.size() - 1));
    }

    // As PrismLeaf::own.
    std::vector<ClassId> own_planes(const std::vector<SupportId>& facets) const {
        std::vector<ClassId> own;
        bool differ = false;
        for (const SupportId s : facets) {
            own.push_back(s == kNoSupport ? kNoClass : classes_.own[s]);
            differ = differ || (s != kNoSupport && classes_.own[s] != classes_.of[s].id);
        }
        return differ ? own : std::vector<ClassId>{};
    }

    // A side of a facet that the snap moved, in the coordinates of its frame.
    void keep_longest(FrameId frame, Vec3 side) {
        const Vec3 in_root = apply_to_direction(formula_.table.frames[frame].placement, side);
        longest_moved_ = std::max(longest_moved_, std::sqrt(dot(in_root, in_root)));
    }

    void add_prism(const PrismData& p) {
        PrismLeaf leaf;
        leaf.frame = p.frame;
        leaf.axis = p.axis;
        std::size_t edge = 0;
        for (const auto& contour : p.contours) {
            const auto start = static_cast<std::uint32_t>(leaf.points.size());
            for (std::size_t i = 0; i < contour.size(); ++i, ++edge) {
                leaf.points.push_back(contour[i]);
                leaf.next.push_back(i + 1 < contour.size() ? static_cast<std::uint32_t>(leaf.points.size()) : start);
                leaf.edges.push_back(p.edges[edge] == kNoSupport ? kNoClass : classes_.of[p.edges[edge]].id);
            }
        }
        leaf.own = own_planes(p.edges);
        const auto side = [&](std::size_t i) {
            const Vec2 v = leaf.points[leaf.next[i]] - leaf.points[i];
            Vec3 local(0);
            local[(p.axis + 1) % 3] = v.x;
            local[(p.axis + 2) % 3] = v.y;
            return local;
        };
        for (std::size_t i = 0; i < leaf.own.size(); ++i)
            if (leaf.own[i] != leaf.edges[i]) keep_longest(p.frame, side(i));
        program_.prisms.push_back(std::move(leaf));
    }

    void add_mesh(const MeshData& m) {
        auto& hierarchy = hierarchies_[m.mesh.get()];
        if (!hierarchy) {
            std::vector<Bounds> boxes;
            for (const auto& t : m.mesh->triangles) {
                const Vec3 &a = m.mesh->points[t[0]], &b = m.mesh->points[t[1]], &c = m.mesh->points[t[2]];
                boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
            }
            if (boxes.empty()) boxes.push_back({Vec3(0), Vec3(0)});
            auto built = std::make_shared<Hierarchy>(build_hierarchy(boxes, kTriangleCost, kMostTriangles));
            if (m.mesh->triangles.empty()) built->order.clear(), built->nodes[0].count = 0;
            hierarchy = std::move(built);
        }
        ParityMesh leaf{m.frame, m.mesh, hierarchy, {}, own_planes(m.facets)};
        for (const SupportId s : m.facets) leaf.facets.push_back(s == kNoSupport ? kNoClass : classes_.of[s].id);
        for (std::size_t i = 0; i < leaf.own.size(); ++i)
            for (std::size_t k = 0; leaf.own[i] != leaf.facets[i] && k < 3; ++k)
                keep_longest(m.frame, m.mesh->points[m.mesh->triangles[i][(k + 1) % 3]] - m.mesh->points[m.mesh->triangles[i][k]]);
        program_.meshes.push_back(std::move(leaf));
    }

    Formula formula_;
    Classes classes_;
    Program program_;
    std::map<const TriangleList*, std::shared_ptr<const Hierarchy>> hierarchies_;
    std::uint64_t emptied_ = 0;
    bool keeps_bounds_ = false;  // of leaves
    double longest_moved_ = 0;  // of the sides of facets that the snap moved
};

}  // namespace

Result<std::shared_ptr<const Program>> compile(const Solid& solid, const EngineOptions& options) {
    Result<Formula> formula = lower(solid);
    if (!formula) return tl::unexpected<Error>(formula.error());
    return Compiler(std::move(*formula), options).run();
}

const BuildReport& build_report(const Program& program) { return program.report; }
const std::vector<LeafUse>& leaf_uses(const Program& program) { return program.uses; }
Bounds program_bounds(const Program& program) { return program.bounds; }

}  // namespace whittle
