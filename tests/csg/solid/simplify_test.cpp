#include <catch2/catch.hpp>

#include <random>

#include "csg/solid/solid.h"

using namespace whittle;

namespace {

// Is the point inside? Only for what random_node() makes: boxes and balls under translations. Points on a border are avoided by the caller.
bool is_inside(const Solid& solid, NodeId id, Vec3 p) {
    if (const auto* s = std::get_if<Shape>(&solid.node(id))) {
        if (const auto* box = std::get_if<shape::Box>(s))
            return glm::all(glm::lessThan(box->lo, p)) && glm::all(glm::lessThan(p, box->hi));
        return glm::length(p / std::get<shape::Ellipsoid>(*s).radii) < 1;
    }
    const auto& c = std::get<Combination>(solid.node(id));
    const auto holds = [&](const Use& use) {
        return is_inside(solid, use.node, p - Vec3(use.placement.offset(0), use.placement.offset(1), use.placement.offset(2)));
    };
    if (c.operands.empty()) return false;
    if (c.op == SetOp::kUnion) return std::any_of(c.operands.begin(), c.operands.end(), holds);
    if (c.op == SetOp::kIntersection) return std::all_of(c.operands.begin(), c.operands.end(), holds);
    return holds(c.operands[0]) && std::none_of(c.operands.begin() + 1, c.operands.end(), holds);
}

// Small whole numbers, so that operands coincide, touch, miss and bury each other all the time.
class RandomSolids {
public:
    explicit RandomSolids(std::uint64_t seed) : random_(seed) {}

    NodeId node(SolidBuilder& b, int depth) {
        if (depth == 0) {
            const double size = number(1, 4);
            return number(0, 2) == 0 ? b.shape(shape::Ellipsoid{Vec3(size)}) : b.shape(shape::Box{Vec3(0), Vec3(size, number(1, 4), size)});
        }
        std::vector<Use> operands;
        for (int n = number(1, 5); n > 0; --n) {
            Use use;
            use.node = node(b, depth - 1);
            use = b.placed(Placement::translation({1.0 * number(0, 3), 1.0 * number(0, 3), 0}), use);
            if (number(0, 3) == 0) use.label = b.label({{}, {0, static_cast<std::uint32_t>(number(1, 3)), 1}, ""});
            operands.push_back(use);
        }
        return b.combine(static_cast<SetOp>(number(0, 2)), operands);
    }
    Vec3 point() {
        std::uniform_real_distribution<double> coordinate(-3, 12);
        return {coordinate(random_), coordinate(random_), coordinate(random_)};
    }

private:
    int number(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
    std::mt19937_64 random_;
};

Solid random_solid(std::uint64_t seed, const SolidPasses& passes, SkipCounts& skipped) {
    RandomSolids random(seed);
    SolidBuilder b(passes);
    Use root;
    root.node = random.node(b, 3);
    skipped = b.skipped();
    return b.finish(root);
}

}  // namespace

TEST_CASE("what the passes drop changes no point's membership, and every pass drops something") {
    SkipCounts total, none;
    int inside = 0, differing = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        SkipCounts skipped;
        const Solid lean = random_solid(seed, {}, skipped);
        SolidPasses off;
        off.equal = off.disjoint = off.buried = false;
        const Solid full = random_solid(seed, off, none);
        total.equal += skipped.equal, total.disjoint += skipped.disjoint, total.buried += skipped.buried;
        RandomSolids points(seed + 1000);
        for (int i = 0; i < 200; ++i) {
            const Vec3 p = points.point();
            const bool in_full = is_inside(full, full.root().node, p);
            inside += in_full;
            differing += is_inside(lean, lean.root().node, p) != in_full;
            const Bounds box = lean.root_bounds();
            if (in_full) CHECK((glm::all(glm::lessThanEqual(box.lo, p)) && glm::all(glm::lessThanEqual(p, box.hi))));
        }
    }
    CHECK(differing == 0);
    CHECK(inside > 1000);
    CHECK(total.equal > 100);
    CHECK(total.disjoint > 100);
    CHECK(total.buried > 100);
    CHECK(none.equal + none.disjoint + none.buried == 0);
}
