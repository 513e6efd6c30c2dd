// labels_test.cpp — whose surface a border shows and whose matter fills a place, against the rule of docs/numerics.md evaluated on intervals.
//
// Trees of boxes that are intervals along x with whole ends, so that most faces coincide: the rule is evaluated half a unit before and behind each.
#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "tests/support/seed.h"
#include "tests/tracer/engine/rays.h"
#include "tracer/engine/interfaces.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr int kEnd = 8;  // intervals lie in [0, kEnd]
constexpr std::uint32_t kNone = 0xFFFFFFFF;

struct Tree {
    bool leaf = false;
    int from = 0, to = 0;
    std::uint32_t line = 0;  // of a leaf: author's order, from 1
    Material material;       // of a leaf
    SetOp op = SetOp::kUnion;
    std::vector<Tree> children;
    int subtractions = 0;  // above it
    int cut_order = 0;     // of cutters: at each difference what it subtracts comes before what it is subtracted from
};

// How the tree is built: as it is, or each leaf in the company of boxes far from the rays, or each operand turned to and fro so that nothing is flattened.
enum class Build { kPlain, kCrowded, kWrapped };

class Author {
public:
    explicit Author(std::uint64_t seed) : random_(seed) {}

    Tree tree(int depth, int subtractions) {
        Tree t;
        t.subtractions = subtractions;
        if (depth == 0 || one_in(4)) return interval(std::move(t));
        t.op = one_in(2) ? SetOp::kDifference : one_in(3) ? SetOp::kIntersection : SetOp::kUnion;
        const int count = 2 + static_cast<int>(one_in(3));
        for (int i = 0; i < count; ++i) {
            t.children.push_back(tree(depth - 1, subtractions + (t.op == SetOp::kDifference && i > 0 ? 1 : 0)));
        }
        return t;
    }

private:
    bool one_in(int n) { return random_.between(0, n) < 1; }

    Tree interval(Tree t) {
        t.leaf = true;
        t.from = static_cast<int>(random_.between(0, kEnd - 1));
        t.to = t.from + 1 + static_cast<int>(random_.between(0, kEnd - t.from - 1));
        t.line = ++lines_;
        if (!one_in(3)) t.material.color = Vec4(t.line / 256.0, 0, 0, 1);
        if (one_in(8)) t.material.priority = 1;
        return t;
    }

    Random random_;
    std::uint32_t lines_ = 0;
};

void number_cutters(Tree& t, int& next) {
    if (t.leaf) t.cut_order = next++;
    const bool difference = t.op == SetOp::kDifference;
    for (std::size_t i = difference ? 1 : 0; i < t.children.size(); ++i) number_cutters(t.children[i], next);
    if (difference && !t.leaf) number_cutters(t.children[0], next);
}

bool holds(const Tree& t, double x) {
    if (t.leaf) return t.from < x && x < t.to;
    const auto in = [x](const Tree& child) { return holds(child, x); };
    if (t.op == SetOp::kUnion) return std::any_of(t.children.begin(), t.children.end(), in);
    if (t.op == SetOp::kIntersection) return std::all_of(t.children.begin(), t.children.end(), in);
    return in(t.children[0]) && std::none_of(t.children.begin() + 1, t.children.end(), in);
}

// Leaves that change in the tree's stead at x: from the root down, the operands that change.
void changing(const Tree& t, double x, std::vector<const Tree*>& out) {
    if (holds(t, x - 0.5) == holds(t, x + 0.5)) return;
    if (t.leaf) out.push_back(&t);
    for (const Tree& child : t.children) changing(child, x, out);
}

// The line whose matter fills x.
const Tree* owner(const Tree& t, double x) {
    if (!holds(t, x)) return nullptr;
    if (t.leaf) return t.subtractions > 0 ? nullptr : &t;
    const Tree* best = nullptr;
    for (const Tree& child : t.children) {
        const Tree* c = owner(child, x);
        if (c && (!best || c->material.priority.value_or(0) > best->material.priority.value_or(0))) best = c;
    }
    return best;
}

const Tree* shown(const Tree& root, double x) {
    std::vector<const Tree*> leaves;
    changing(root, x, leaves);
    const Tree *first = nullptr, *named = nullptr;
    for (const Tree* l : leaves)
        if (!first || l->subtractions < first->subtractions) first = l;
    for (const Tree* l : leaves)
        if (l->subtractions == first->subtractions && l->material.names_surface() && (!named || l->cut_order < named->cut_order)) named = l;
    if (first->subtractions == 0) return first;
    return named ? named : owner(root, holds(root, x + 0.5) ? x + 0.5 : x - 0.5);
}

std::string to_text(const Tree& t) {
    if (t.leaf)
        return fmt::format("{}:[{},{}]{}{}", t.line, t.from, t.to, t.material.color ? "c" : "", t.material.priority ? "p" : "");
    std::string text = t.op == SetOp::kUnion ? "or(" : t.op == SetOp::kIntersection ? "and(" : "less(";
    for (const Tree& child : t.children) text += to_text(child) + " ";
    return text + ")";
}

Use made(const Tree& t, Build how, SolidBuilder& builder) {
    Use use;
    if (t.leaf) {
        use.node = builder.shape(shape::Box{{double(t.from), 0, 0}, {double(t.to), 1, 1}});
        use = builder.labelled({t.material, {0, t.line, 1}, {}}, use);
        if (how != Build::kCrowded || t.subtractions > 0) return use;
        std::vector<Use> crowd{use};
        for (int i = 0; i < 5; ++i) {
            Use far;
            far.node = builder.shape(shape::Box{{double(t.from), 20.0 + 2 * i, 0}, {double(t.to), 21.0 + 2 * i, 1}});
            crowd.push_back(builder.labelled({t.material, {0, t.line, 1}, {}}, far));
        }
        use = Use{};
        use.node = builder.combine(SetOp::kUnion, crowd);
        return use;
    }
    std::vector<Use> operands;
    for (const Tree& child : t.children) operands.push_back(made(child, how, builder));
    use.node = builder.combine(t.op, operands);
    if (how == Build::kWrapped && use.node != kEmptyNode) use = builder.labelled({{}, {}, "part"}, use);
    return use;
}

Solid solid_of(const Tree& t, Build how) {
    SolidBuilder builder;
    Use root;
    root.node = builder.combine(SetOp::kUnion, {made(t, how, builder)});
    return builder.finish(root);
}

Ray ray_from(double x, double direction) {
    Ray ray;
    ray.origin = {x, 0.375, 0.625};
    ray.direction = {direction, 0, 0};
    return ray;
}

std::uint32_t line_of(const Program& program, std::uint32_t use) { return use < leaf_uses(program).size() ? leaf_uses(program)[use].place.line : kNone; }

int wrong_borders(const Tree& t, const Program& program, double direction) {
    const double start = direction > 0 ? -1 : kEnd + 1;
    Scratch scratch;
    Spans spans;
    all_spans(program, ray_from(start, direction), scratch, spans);
    std::vector<End> ends;
    for (const Span& s : spans) {
        ends.push_back(s.in.value());
        ends.push_back(s.out.value());
    }
    int wrong = 0;
    std::size_t next = 0;
    for (int k = 0; k <= kEnd; ++k) {
        const double x = direction > 0 ? k : kEnd - k;
        if (holds(t, x - 0.5) == holds(t, x + 0.5)) continue;
        if (next == ends.size()) return wrong + 1;
        const End& end = ends[next++];
        // Of one matter buried in its like either may stay, so matter is compared, not lines.
        wrong += end.t != std::abs(x - start) || !(leaf_uses(program)[end.use].material == shown(t, x)->material);
        // The same border as the first hit of a ray from just before it, alone and in a packet.
        const Ray near = ray_from(x - direction / 4, direction);
        std::vector<Ray> rays(64, near);
        Hit one, many[64];
        bool found[64];
        wrong += !first_hit(program, near, HUGE_VAL, scratch, one) || one.end.use != end.use;
        first_hits(program, rays.data(), 64, HUGE_VAL, scratch, many, found);
        for (int i = 0; i < 64; ++i) wrong += !found[i] || many[i].end.use != end.use;
    }
    return wrong + static_cast<int>(next != ends.size());
}

int wrong_interfaces(const Tree& t, const Program& program, double direction) {
    const double start = direction > 0 ? -1 : kEnd + 1;
    Scratch scratch;
    Spans spans;
    Interfaces interfaces;
    all_spans(program, ray_from(start, direction), scratch, spans, interfaces);
    int wrong = 0;
    std::size_t next = 0;
    for (int k = 0; k <= kEnd; ++k) {
        const double x = direction > 0 ? k : kEnd - k;
        const Tree *before = owner(t, x - direction / 2), *behind = owner(t, x + direction / 2);
        if (!before || !behind || before->material == behind->material) continue;
        if (next == interfaces.size()) return wrong + 1;
        const Interface& i = interfaces[next++];
        const auto& uses = leaf_uses(program);
        wrong += i.at.t != std::abs(x - start) || !(uses[i.from].material == before->material) || !(uses[i.at.use].material == behind->material);
        wrong += !i.at.certified || i.at.normal != Vec3(-direction, 0, 0);
    }
    return wrong + static_cast<int>(next != interfaces.size());
}

// A box along x, coloured where `red` is not 0.
Use box(SolidBuilder& builder, double from, double to, double red, std::uint32_t line) {
    Use use;
    use.node = builder.shape(shape::Box{{from, 0, 0}, {to, 1, 1}});
    Material material;
    if (red > 0) material.color = Vec4(red, 0, 0, 1);
    return builder.labelled({material, {0, line, 1}, {}}, use);
}

std::vector<std::uint32_t> lines_along(const Solid& solid) {
    const auto program = compiled(solid);
    Scratch scratch;
    Spans spans;
    all_spans(*program, ray_from(-1, 1), scratch, spans);
    std::vector<std::uint32_t> lines;
    for (const Span& s : spans) {
        lines.push_back(line_of(*program, s.in->use));
        lines.push_back(line_of(*program, s.out->use));
    }
    return lines;
}

}  // namespace

TEST_CASE("borders show and interfaces divide what the rule says, however the tree is built and whichever query asks") {
    const std::uint64_t seed = support::fresh_seed();
    CAPTURE(seed);
    int borders = 0;
    for (std::uint64_t n = 0; n < 1500; ++n) {
        Author author(seed + n);
        Tree t = author.tree(1 + static_cast<int>(n % 4), 0);
        int cutters = 0;
        number_cutters(t, cutters);
        for (const Build how : {Build::kPlain, Build::kCrowded, Build::kWrapped}) {
            const auto program = compiled(solid_of(t, how));
            for (const double direction : {1.0, -1.0}) {
                const int wrong = wrong_borders(t, *program, direction) + wrong_interfaces(t, *program, direction);
                CAPTURE(n, to_text(t), static_cast<int>(how), direction);
                REQUIRE(wrong == 0);
            }
            for (int x = 0; x <= kEnd; ++x) borders += holds(t, x - 0.5) != holds(t, x + 0.5);
        }
    }
    CHECK(borders > 5000);
}

TEST_CASE("a face cut by what was cut from the cutter shows that where it names a colour, else the matter that is left") {
    for (const double red : {0.0, 0.5}) {
        SolidBuilder builder;
        Use ring;
        ring.node = builder.combine(SetOp::kDifference, {box(builder, 2, 8, 0, 2), box(builder, 4, 6, red, 3)});
        Use root;
        root.node = builder.combine(SetOp::kDifference, {box(builder, 0, 10, 0.25, 1), ring});
        const std::uint32_t core = red > 0 ? 3 : 1;
        CHECK(lines_along(builder.finish(root)) == std::vector<std::uint32_t>{1, 1, core, core, 1, 1});
    }
}

TEST_CASE("of two cutters that share a face the one of the outermost difference shows, then the first") {
    SolidBuilder nested;
    Use inner;
    inner.node = nested.combine(SetOp::kDifference, {box(nested, 0, 10, 0, 1), box(nested, 4, 6, 0.25, 2)});
    Use root;
    root.node = nested.combine(SetOp::kDifference, {inner, box(nested, 4, 5, 0.5, 3)});
    CHECK(lines_along(nested.finish(root)) == std::vector<std::uint32_t>{1, 3, 2, 1});
    SolidBuilder flat;
    root.node = flat.combine(SetOp::kDifference, {box(flat, 0, 10, 0, 1), box(flat, 4, 6, 0.25, 2), box(flat, 4, 5, 0.5, 3)});
    CHECK(lines_along(flat.finish(root)) == std::vector<std::uint32_t>{1, 2, 2, 1});
}

TEST_CASE("parts that abut are one span with an interface where their matter differs, and none where it does not") {
    for (const double red : {0.25, 0.5}) {
        SolidBuilder builder;
        Use root;
        root.node = builder.combine(SetOp::kUnion, {box(builder, 0, 4, 0.25, 1), box(builder, 4, 8, red, 2)});
        const auto program = compiled(builder.finish(root));
        Scratch scratch;
        Spans spans;
        Interfaces interfaces;
        all_spans(*program, ray_from(-1, 1), scratch, spans, interfaces);
        REQUIRE(spans.size() == 1);
        CHECK(spans[0].out->t == 9);
        REQUIRE(interfaces.size() == (red == 0.25 ? 0 : 1));
        if (interfaces.empty()) continue;
        CHECK(interfaces[0].at.t == 5);
        CHECK(line_of(*program, interfaces[0].from) == 1);
        CHECK(line_of(*program, interfaces[0].at.use) == 2);
        all_spans(*program, ray_from(6, 1), scratch, spans, interfaces);
        CHECK(interfaces.empty());
    }
}
