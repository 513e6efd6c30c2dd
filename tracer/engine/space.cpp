// space.cpp — the octree: which leaves are constant in a box, and the formula that is left there.
#include "tracer/engine/space.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

constexpr std::uint32_t kFewLeaves = 6;    // a cell of so few is not divided
constexpr int kMostDepth = 6;
constexpr std::size_t kMostCells = 200000;
constexpr double kManyCrossed = 8;         // leaf boxes that a line through the bounds crosses on average; and
constexpr int kDeep = 3;                   // groups within groups: of less, a tile's own folding leaves as little, at less cost
constexpr std::size_t kMostLeaves = 20000; // every level asks all leaves that are left: more are better met by their hierarchy
constexpr double kDoubt = 0x1p-40;         // relative, far over what the bounds below round

constexpr std::uint32_t kNoUse = Group::kNoUse;

enum class Where : std::uint8_t { kOutside, kInside, kBorder };

// A box in a frame: centre and the three half edges, taken through the inverse.
struct LocalBox {
    std::array<double, 3> m{};
    std::array<std::array<double, 3>, 3> edge{};
};

LocalBox local_box(const Frame& frame, const Bounds& box) {
    LocalBox r;
    const Vec3 m = 0.5 * (box.lo + box.hi), h = 0.5 * (box.hi - box.lo);
    for (std::size_t i = 0; i < 3; ++i) {
        r.m[i] = frame.lift(i);
        for (std::size_t j = 0; j < 3; ++j) {
            const double k = frame.inverse[3 * i + j];
            r.m[i] += k * (m[static_cast<int>(j)] - frame.entry(static_cast<int>(j)));
            r.edge[j][i] = k * h[static_cast<int>(j)];
        }
    }
    return r;
}

// Values of a quadratic function over the box: its value, gradient and second derivatives at the centre give a first and a second order term.
struct Range {
    double lo = 0, hi = 0;
    Where where() const { return lo > 0 ? Where::kOutside : hi < 0 ? Where::kInside : Where::kBorder; }
};

// Sum over i of k_i (x_i - c_i)^2 - constant; a zero k_i leaves the coordinate out.
Range weighted_squares(const LocalBox& b, const std::array<double, 3>& c, const std::array<double, 3>& k, double constant) {
    double value = -constant, size = std::abs(constant), first = 0, second = 0;
    std::array<double, 3> from{};
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = b.m[i] - c[i];
        value += k[i] * from[i] * from[i];
        size += k[i] * (std::abs(b.m[i]) + std::abs(c[i])) * (std::abs(b.m[i]) + std::abs(c[i]));
    }
    for (std::size_t e = 0; e < 3; ++e) {
        double along = 0;
        for (std::size_t i = 0; i < 3; ++i) along += 2 * k[i] * from[i] * b.edge[e][i];
        first += std::abs(along);
        for (std::size_t f = 0; f < 3; ++f) {
            double cross = 0;
            for (std::size_t i = 0; i < 3; ++i) cross += k[i] * b.edge[e][i] * b.edge[f][i];
            second += std::abs(cross);
        }
    }
    const double doubt = kDoubt * (size + first + second);
    // The second order term is a sum of squares: never negative.
    return {value - first - doubt, value + first + second + doubt};
}

Range linear(const LocalBox& b, const std::array<double, 3>& n, const std::array<double, 3>& a, double d) {
    double value = -d, size = std::abs(d), first = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        value += n[i] * (b.m[i] - a[i]);
        size += std::abs(n[i]) * (std::abs(b.m[i]) + std::abs(a[i]));
    }
    for (std::size_t e = 0; e < 3; ++e) {
        double along = 0;
        for (std::size_t i = 0; i < 3; ++i) along += n[i] * b.edge[e][i];
        first += std::abs(along);
    }
    const double doubt = kDoubt * (size + first);
    return {value - first - doubt, value + first + doubt};
}

Where side_of(const Support& s, const Frame& frame, const Bounds& box) {
    const LocalBox b = local_box(frame, box);
    const auto& p = s.p;
    const std::size_t i = (s.axis + 1u) % 3, j = (s.axis + 2u) % 3;
    std::array<double, 3> n{}, c{}, k{1, 1, 1};
    switch (s.kind) {
        case SupportKind::kAxisPlane: n[s.axis] = 1; return linear(b, n, c, p[0]).where();
        case SupportKind::kPlane: return linear(b, {p[0], p[1], p[2]}, c, p[3]).where();
        case SupportKind::kEdgePlane:
            n[i] = p[3] - p[1], n[j] = p[0] - p[2];
            c[i] = p[0], c[j] = p[1];
            return linear(b, n, c, 0).where();
        case SupportKind::kPlanePoints: {
            const Vec3 a(p[0], p[1], p[2]), g = glm::cross(Vec3(p[3], p[4], p[5]) - a, Vec3(p[6], p[7], p[8]) - a);
            return linear(b, {g.x, g.y, g.z}, {a.x, a.y, a.z}, 0).where();
        }
        case SupportKind::kBall: return weighted_squares(b, {p[0], p[1], p[2]}, k, p[3] * p[3]).where();
        case SupportKind::kEllipsoid:
            for (std::size_t e = 0; e < 3; ++e) k[e] = 1 / (p[3 + e] * p[3 + e]);
            return weighted_squares(b, {p[0], p[1], p[2]}, k, 1).where();
        case SupportKind::kCylinder:
            c[i] = p[0], c[j] = p[1];
            k[s.axis] = 0;
            return weighted_squares(b, c, k, p[2] * p[2]).where();
        default: return Where::kBorder;
    }
}

bool apart(const Bounds& a, const FloatBox& b) {
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (a.hi[i] < b.lo[k] || a.lo[i] > b.hi[k]) return true;
    }
    return false;
}

// `box` is where the leaf's answer must hold. The leaf's `negated` is not applied.
Where leaf_in(const Program& program, std::uint32_t index, const Bounds& box) {
    const Leaf& leaf = program.leaves[index];
    if (apart(box, program.leaf_boxes[index])) return Where::kOutside;
    if (leaf.kind != FormulaKind::kCell) return Where::kBorder;
    Where all = Where::kInside;
    for (std::uint32_t k = 0; k < leaf.count; ++k) {
        const HalfSpace h = program.half_spaces[leaf.first + k];
        const Support& s = program.classes[h.id()];
        if (program.frames[s.frame].motion != 0) return Where::kBorder;
        Where w = side_of(s, program.frames[s.frame], box);
        if (w != Where::kBorder && h.inverted()) w = w == Where::kInside ? Where::kOutside : Where::kInside;
        if (w == Where::kOutside) return w;
        if (w == Where::kBorder) all = w;
    }
    return all;
}

// The formula as it is folded on the way down; children stand side by side in an arena.
struct Folded {
    enum class Kind : std::uint8_t { kTrue, kFalse, kLeaf, kAnd, kOr };
    Kind kind = Kind::kFalse;
    std::uint32_t leaf = 0, first = 0, count = 0, leaves = 0;
    std::uint32_t least_fill = kNoUse;  // of all uses below that are not subtracted
    // Of what was folded away as true here: the least use that is not subtracted, wherever the node is true; not known where `unclear`.
    std::uint32_t hold = kNoUse;
    bool unclear = false;
    bool always = false;  // an OR that is true throughout; what is left of it only tells who holds a place
};

class Divider {
public:
    explicit Divider(Program& program) : program_(program) {}

    void run() {
        const Folded whole = gather(program_.root);
        program_.space.emplace_back();
        divide(0, whole, whole, program_.bounds, 0);
        if (program_.space.size() > kMostCells) program_.space.clear();
    }

private:
    using Kind = Folded::Kind;

    Folded gather(Ref ref) {
        if (ref.is_leaf()) {
            const Leaf& leaf = program_.leaves[ref.index()];
            return {Kind::kLeaf, ref.index(), 0, 0, 1, leaf.fills ? leaf.use : kNoUse};
        }
        const Group g = program_.groups[ref.index()];
        std::vector<Folded> parts;
        for (std::uint32_t i = 0; i < g.plain_count; ++i) parts.push_back(gather(program_.refs[g.first_plain + i]));
        for (std::uint32_t i = 0; i < g.item_count; ++i) parts.push_back(gather(program_.refs[g.first_item + i]));
        return link(g.is_and ? Kind::kAnd : Kind::kOr, parts);
    }

    Folded link(Kind kind, const std::vector<Folded>& parts) {
        Folded r{kind, 0, static_cast<std::uint32_t>(arena_.size()), static_cast<std::uint32_t>(parts.size())};
        for (const Folded& p : parts) {
            r.leaves += p.leaves;
            r.least_fill = std::min(r.least_fill, p.least_fill);
        }
        arena_.insert(arena_.end(), parts.begin(), parts.end());
        return r;
    }

    // Here and below `f` is a copy: it often stands in the arena, which grows meanwhile.
    Folded fold(const Folded f, const Bounds& box) {
        if (f.kind == Kind::kAnd) return fold_all(f, box);
        if (f.kind == Kind::kOr) return fold_any(f, box);
        if (f.kind != Kind::kLeaf) return f;
        const Where where = leaf_in(program_, f.leaf, box);
        if (where == Where::kBorder) return f;
        Folded r;
        if ((where == Where::kInside) == program_.leaves[f.leaf].negated) return r;
        r.kind = Kind::kTrue;
        r.hold = r.least_fill = f.least_fill;
        return r;
    }

    Folded fold_all(const Folded f, const Bounds& box) {
        std::vector<Folded> parts;
        Folded held;
        held.kind = Kind::kTrue;
        held.hold = f.hold;
        held.unclear = f.unclear;
        for (std::uint32_t i = 0; i < f.count; ++i) {
            const Folded p = fold(arena_[f.first + i], box);
            if (p.kind == Kind::kFalse) return p;
            if (p.kind == Kind::kTrue || p.kind == Kind::kAnd) {
                held.hold = std::min(held.hold, p.hold);
                held.unclear = held.unclear || p.unclear;
            }
            if (p.kind == Kind::kAnd) {
                for (std::uint32_t k = 0; k < p.count; ++k) parts.push_back(arena_[p.first + k]);
            } else if (p.kind != Kind::kTrue) {
                parts.push_back(p);
            }
        }
        held.least_fill = held.hold;
        if (parts.empty()) return held;
        if (parts.size() == 1 && held.hold == kNoUse && !held.unclear) return parts[0];
        Folded r = link(Kind::kAnd, parts);
        r.hold = held.hold;
        r.unclear = held.unclear;
        r.least_fill = std::min(r.least_fill, r.hold);
        return r;
    }

    Folded fold_any(const Folded f, const Bounds& box) {
        std::vector<Folded> parts;
        Folded whole;
        for (std::uint32_t i = 0; i < f.count; ++i) {
            const Folded p = fold(arena_[f.first + i], box);
            if (p.kind == Kind::kFalse) continue;
            if (p.kind == Kind::kTrue) {
                whole.kind = Kind::kTrue;
                whole.hold = std::min(whole.hold, p.hold);
                whole.unclear = whole.unclear || p.unclear;
            } else if (p.kind == Kind::kOr) {
                for (std::uint32_t k = 0; k < p.count; ++k) parts.push_back(arena_[p.first + k]);
            } else {
                parts.push_back(p);
            }
        }
        if (whole.kind == Kind::kTrue) {
            // A part that comes and goes may hold the place before the one that is always there.
            for (const Folded& p : parts) whole.unclear = whole.unclear || p.least_fill < whole.hold;
            whole.least_fill = whole.hold;
            return whole;
        }
        if (parts.empty()) return whole;
        return parts.size() == 1 ? parts[0] : link(Kind::kOr, parts);
    }

    // As fold_all() and fold_any(), but what may hold a place stays, even where it makes no difference to the shape.
    Folded fold_labels(const Folded f, const Bounds& box) {
        if (f.kind != Kind::kAnd && f.kind != Kind::kOr) return fold(f, box);
        const bool all = f.kind == Kind::kAnd;
        std::vector<Folded> parts;
        Folded whole;
        whole.kind = all ? Kind::kTrue : Kind::kFalse;
        whole.hold = f.hold;
        whole.always = f.always;
        for (std::uint32_t i = 0; i < f.count; ++i) {
            const Folded p = fold_labels(arena_[f.first + i], box);
            if (p.kind == Kind::kFalse && all) return p;
            if (p.kind == Kind::kFalse) continue;
            const bool opened = p.kind == f.kind;
            if (p.kind == Kind::kTrue || opened) whole.hold = std::min(whole.hold, p.hold);
            if (!all && (p.kind == Kind::kTrue || (opened && p.always))) whole.always = true;
            if (opened) {
                for (std::uint32_t k = 0; k < p.count; ++k) parts.push_back(arena_[p.first + k]);
            } else if (p.kind != Kind::kTrue) {
                parts.push_back(p);
            }
        }
        if (whole.always) {
            whole.kind = Kind::kTrue;
            std::erase_if(parts, [&](const Folded& p) { return p.least_fill >= whole.hold; });
        }
        whole.least_fill = whole.hold;
        if (parts.empty()) return whole;
        if (parts.size() == 1 && whole.hold == kNoUse && !whole.always) return parts[0];
        Folded r = link(f.kind, parts);
        r.hold = whole.hold;
        r.always = whole.always;
        r.least_fill = std::min(r.least_fill, r.hold);
        return r;
    }

    bool unclear(const Folded& f) const {
        if (f.unclear) return true;
        if (f.kind != Kind::kAnd && f.kind != Kind::kOr) return false;
        for (std::uint32_t i = 0; i < f.count; ++i)
            if (unclear(arena_[f.first + i])) return true;
        return false;
    }

    Ref keep(const Folded& f) {
        if (f.kind == Kind::kLeaf) return Ref::leaf(f.leaf);
        std::vector<Ref> refs;
        for (std::uint32_t i = 0; i < f.count; ++i) refs.push_back(keep(arena_[f.first + i]));
        Group g;
        g.is_and = f.kind == Kind::kAnd;
        g.first_plain = static_cast<std::uint32_t>(program_.refs.size());
        g.plain_count = f.count;
        g.hold = f.hold;
        g.hold_unclear = f.unclear;
        g.always = f.always;
        g.holds = f.least_fill != kNoUse || f.unclear;
        program_.refs.insert(program_.refs.end(), refs.begin(), refs.end());
        program_.balls.resize(program_.refs.size());
        program_.groups.push_back(g);
        return Ref::group(static_cast<std::uint32_t>(program_.groups.size() - 1));
    }

    void divide(std::uint32_t at, const Folded& parent, const Folded& parent_labels, const Bounds& box, int depth) {
        const std::size_t mark = arena_.size();
        const Vec3 room = kSpaceGrowth * (box.hi - box.lo);
        const Folded here = fold(parent, {box.lo - room, box.hi + room}), labels = fold_labels(parent_labels, {box.lo - room, box.hi + room});
        SpaceNode node;
        node.kind = here.kind == Kind::kTrue ? SpaceNode::Kind::kInside : here.kind == Kind::kFalse ? SpaceNode::Kind::kOutside : SpaceNode::Kind::kBorder;
        const bool few = here.leaves <= kFewLeaves || depth >= kMostDepth || program_.space.size() > kMostCells;
        if (node.kind == SpaceNode::Kind::kBorder && !few) {
            node.kind = SpaceNode::Kind::kDivided;
            node.first = static_cast<std::uint32_t>(program_.space.size());
            program_.space.resize(program_.space.size() + 8);
            for (std::uint32_t k = 0; k < 8; ++k) divide(node.first + k, here, labels, octant(box, k), depth + 1);
        } else if (node.kind == SpaceNode::Kind::kBorder) {
            node.formula = node.labels = keep(here);
            if (unclear(here)) node.labels = keep(labels);
        }
        program_.space[at] = node;
        arena_.resize(mark);
    }

    Program& program_;
    std::vector<Folded> arena_;
};

double area(const Vec3& size) { return 2 * (size.x * size.y + size.y * size.z + size.z * size.x); }

// How many leaf boxes a line through the bounds crosses on average (Cauchy-Crofton: by the ratio of the areas).
double crossed_boxes(const Program& program) {
    const Vec3 size = program.bounds.hi - program.bounds.lo;
    double sum = 0;
    for (const FloatBox& b : program.leaf_boxes) {
        Vec3 part;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            part[i] = std::max(0.0, std::min<double>(b.hi[k], program.bounds.hi[i]) - std::max<double>(b.lo[k], program.bounds.lo[i]));
        }
        sum += area(part);
    }
    return sum / area(size);
}

int depth_of(const Program& program, Ref ref) {
    if (ref.is_leaf()) return 0;
    const Group& g = program.groups[ref.index()];
    int most = 0;
    for (std::uint32_t i = 0; i < g.plain_count; ++i) most = std::max(most, depth_of(program, program.refs[g.first_plain + i]));
    for (std::uint32_t i = 0; i < g.item_count; ++i) most = std::max(most, depth_of(program, program.refs[g.first_item + i]));
    return most + 1;
}

}  // namespace

Bounds octant(const Bounds& box, std::uint32_t k) {
    Bounds r = box;
    for (int i = 0; i < 3; ++i) {
        const double middle = 0.5 * (box.lo[i] + box.hi[i]);
        ((k >> i) & 1 ? r.lo[i] : r.hi[i]) = middle;
    }
    return r;
}

void divide_space(Program& program) {
    const Vec3 size = program.bounds.hi - program.bounds.lo;
    if (program.empty || program.everything || program.motions.size() > 1 || program.leaves.size() > kMostLeaves) return;
    if (!(size.x > 0 && size.y > 0 && size.z > 0 && area(size) < HUGE_VAL)) return;
    if (depth_of(program, program.root) >= kDeep && crossed_boxes(program) > kManyCrossed) Divider(program).run();
}

}  // namespace whittle
