// packet_facts.cpp — what packets need to know of a finished program: which label a class shows, which items are balls, which groups hold matter.
#include <algorithm>
#include <cmath>

#include "tracer/engine/tile.h"

namespace whittle {

namespace {

bool holds(const Program& program, Ref ref) {
    return ref.is_leaf() ? program.leaves[ref.index()].fills : program.groups[ref.index()].holds;
}

bool is_mostly_turned(const Program& program) {
    // Or bodies known by how far they reach.
    const auto has_turned_sides = [&](const Leaf& leaf) {
        // They stand last.
        return leaf.kind == FormulaKind::kCell && leaf.count > 0 && !has_polynomial(program.classes[program.half_spaces[leaf.first + leaf.count - 1].id()].kind);
    };
    const auto turned = std::count_if(program.leaves.begin(), program.leaves.end(), has_turned_sides);
    return 2 * static_cast<std::size_t>(turned) > program.leaves.size();
}

// The leaves that have a class.
struct Users {
    std::uint32_t leaf = 0, count = 0;
    bool silent_cutters = true, of_facets = false, exact = true;
};

std::vector<Users> users_of_classes(const Program& program) {
    std::vector<Users> users(program.classes.size());
    const auto meet = [&](ClassId id, std::uint32_t leaf, bool countable) {
        if (id == kNoClass) return;
        Users& u = users[id];
        const LeafUse& use = program.uses[program.leaves[leaf].use];
        if (u.count == 0 || u.leaf != leaf) ++u.count;
        u.leaf = leaf;
        u.silent_cutters = u.silent_cutters && countable && use.subtracts && !use.material->names_surface();
        u.of_facets = u.of_facets || !countable;
        u.exact = u.exact && program.leaves[leaf].exact;
        if (!countable) u.count += 2;
    };
    const auto meet_facets = [&](const auto& data, std::uint32_t leaf, const std::vector<ClassId>& classes) {
        for (const ClassId id : classes) meet(id, leaf, false);
        for (const ClassId id : data.own) meet(id, leaf, false);
    };
    for (std::uint32_t i = 0; i < program.leaves.size(); ++i) {
        const Leaf& leaf = program.leaves[i];
        if (leaf.kind == FormulaKind::kCell)
            for (std::uint32_t k = 0; k < leaf.count; ++k) meet(program.half_spaces[leaf.first + k].id(), i, true);
        if (leaf.kind == FormulaKind::kPrism) meet_facets(program.prisms[leaf.first], i, program.prisms[leaf.first].edges);
        if (leaf.kind == FormulaKind::kMesh) meet_facets(program.meshes[leaf.first], i, program.meshes[leaf.first].facets);
    }
    return users;
}

void label_classes(Program& program) {
    for (const Users& u : users_of_classes(program)) {
        ClassLabel label;
        if (u.count > 0 && u.silent_cutters) {
            if (program.matter_by_author) label.kind = ClassLabel::Kind::kHeld;
        } else if (u.count == 1) {
            label = {ClassLabel::Kind::kUse, true, false, program.leaves[u.leaf].use};
        }
        label.of_facets = u.of_facets;
        label.exact = u.exact;
        program.some_depend = program.some_depend || label.kind == ClassLabel::Kind::kDepends;
        program.some_uncertified = program.some_uncertified || !label.exact;
        program.class_labels.push_back(label);
    }
}

ItemBall ball_of(const Program& program, Ref ref) {
    if (!ref.is_leaf() || program.leaves[ref.index()].kind != FormulaKind::kCell || program.leaves[ref.index()].count != 1 || !holds(program, ref)) return {};
    const HalfSpace h = program.half_spaces[program.leaves[ref.index()].first];
    const Support& s = program.classes[h.id()];
    if (s.kind != SupportKind::kBall || s.frame != 0 || h.inverted()) return {};
    return {s.p[0], s.p[1], s.p[2], s.p[3], h.id()};
}

// Are the leaves few, and do eight rays through the solid come by so many of them that looking which costs more than asking all? A convex body is met by that
// share of the lines through another around it that its surface is of the other's (Cauchy and Crofton).
bool is_met_whole(const Program& program) {
    constexpr std::size_t kFewLeaves = 8;
    constexpr int kRaysTogether = 8;
    if (program.leaves.size() > kFewLeaves || program.leaf_boxes.size() != program.leaves.size()) return false;
    const auto area = [](const Vec3& size) { return size.x * size.y + size.y * size.z + size.z * size.x; };
    const Bounds& whole = program.bounds;
    const double around = area(whole.hi - whole.lo);
    double met = 0;
    for (const FloatBox& box : program.leaf_boxes) {
        const Vec3 lo = glm::max(Vec3(box.lo[0], box.lo[1], box.lo[2]), whole.lo), hi = glm::min(Vec3(box.hi[0], box.hi[1], box.hi[2]), whole.hi);
        met += 1 - std::pow(1 - std::clamp(area(glm::max(hi - lo, Vec3(0))) / around, 0.0, 1.0), kRaysTogether);
    }
    return met >= 0.5 * static_cast<double>(program.leaves.size());
}

}  // namespace

void describe_for_packets(Program& program) {
    program.mostly_turned = is_mostly_turned(program);
    program.met_whole = is_met_whole(program);
    // Packets look for the least use; priorities are a single ray's work.
    program.matter_by_author = std::is_sorted(program.matter_order.begin(), program.matter_order.end());
    program.bodies_show = program.matter_by_author && std::none_of(program.uses.begin(), program.uses.end(), [](const LeafUse& u) { return u.subtracts && u.material->names_surface(); });
    label_classes(program);
    program.some_doubtful = std::any_of(program.leaves.begin(), program.leaves.end(), [](const Leaf& leaf) { return !leaf.exact; }) ||
                            std::any_of(program.classes.begin(), program.classes.end(), [](const Support& s) { return !has_polynomial(s.kind); });
    for (const Ref ref : program.refs) program.balls.push_back(ball_of(program, ref));
    // Children stand before their groups.
    for (Group& g : program.groups) {
        for (std::uint32_t i = 0; i < g.plain_count; ++i) g.holds = g.holds || holds(program, program.refs[g.first_plain + i]);
        for (std::uint32_t i = 0; i < g.item_count; ++i) g.holds = g.holds || holds(program, program.refs[g.first_item + i]);
    }
}

}  // namespace whittle
