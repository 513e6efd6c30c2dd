// test_laws.cpp — the laws of sets hold border by border on every ray, for every kind of shape, with the second operand written in another way.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "csg/base/degrees.h"
#include "tests/support/random_shape.h"
#include "tests/support/random_solid.h"
#include "tests/support/seed.h"
#include "tests/support/reduce.h"
#include "tracer/engine/engine.h"

using namespace whittle;
using namespace whittle::support;

namespace {

constexpr SolidPasses kAsWritten{false, false, false};

Use use(NodeId node, const Placement& placement = {}) {
    Use u;
    u.node = node;
    u.placement = placement;
    return u;
}

Placement turned(double deg) { return {{cosd(deg), -sind(deg), 0, 0, sind(deg), cosd(deg), 0, 0, 0, 0, 1, 0}}; }

// Two operands and the second's double: the same set through two turns of 30 degrees against one of 60.
struct Operands {
    SolidBuilder builder{kAsWritten};
    Use a, b, a_again, b_again, box;
    std::vector<Vec3> points;

    explicit Operands(std::uint64_t seed) {
        Dice dice(seed);
        dice.pool(dice.one_in(2));
        const auto one = [&](Use& first, Use& again) {
            const Sketch s = random_shape(builder, dice, Repertoire::kAll);
            const Placement inner = Placement::translation(dice.vector());
            const NodeId placed = builder.combine(SetOp::kUnion, {use(builder.shape(s.shape), inner)});
            first = use(placed, turned(60));
            again = use(builder.combine(SetOp::kUnion, {use(placed, turned(30))}), turned(30));
            for (const Vec3& p : s.points) points.push_back(apply_to_point(first.placement, apply_to_point(inner, p)));
        };
        one(a, a_again);
        one(b, b_again);
        box = use(builder.shape(shape::Box{{-7, -7, -7}, {7, 7, 7}}), turned(60));
        // Bounded operands: every query has an end.
        for (Use* u : {&a, &b, &a_again, &b_again}) *u = use(builder.combine(SetOp::kIntersection, {box, *u}));
    }
    Use join(SetOp op, std::vector<Use> operands) { return use(builder.combine(op, std::move(operands))); }
    Use either(const Use& x, const Use& y) { return join(SetOp::kUnion, {x, y}); }
    Use both(const Use& x, const Use& y) { return join(SetOp::kIntersection, {x, y}); }
    Use less(const Use& x, const Use& y) { return join(SetOp::kDifference, {x, y}); }
    Use outside(const Use& x) { return less(box, x); }
};

struct Law {
    const char* name;
    std::function<Use(Operands&)> left, right;  // equal sets
};

const std::vector<Law>& laws() {
    static const std::vector<Law> list{
        {"A - A' is empty", [](Operands& o) { return o.less(o.a, o.a_again); }, [](Operands&) { return use(kEmptyNode); }},
        {"A' - A is empty", [](Operands& o) { return o.less(o.a_again, o.a); }, [](Operands&) { return use(kEmptyNode); }},
        {"A | A' = A", [](Operands& o) { return o.either(o.a, o.a_again); }, [](Operands& o) { return o.a; }},
        {"A & A' = A", [](Operands& o) { return o.both(o.a, o.a_again); }, [](Operands& o) { return o.a; }},
        {"A - (A' - B) = A & B", [](Operands& o) { return o.less(o.a, o.less(o.a_again, o.b)); }, [](Operands& o) { return o.both(o.a, o.b); }},
        {"(A - B) | (A' & B') = A", [](Operands& o) { return o.either(o.less(o.a, o.b), o.both(o.a_again, o.b_again)); }, [](Operands& o) { return o.a; }},
        {"not (A | B) = not A & not B", [](Operands& o) { return o.outside(o.either(o.a, o.b)); },
         [](Operands& o) { return o.both(o.outside(o.a_again), o.outside(o.b_again)); }},
        {"A - B - B' = A - B", [](Operands& o) { return o.less(o.less(o.a, o.b), o.b_again); }, [](Operands& o) { return o.less(o.a, o.b); }},
    };
    return list;
}

std::vector<std::pair<double, bool>> borders(const Program& program, const Ray& ray, Scratch& scratch) {
    Spans spans;
    all_spans(program, ray, scratch, spans);
    std::vector<std::pair<double, bool>> r;
    for (const Span& s : spans) {
        if (s.in) r.push_back({s.in->t, true});
        if (s.out) r.push_back({s.out->t, false});
    }
    return r;
}

bool alike(const std::vector<std::pair<double, bool>>& x, const std::vector<std::pair<double, bool>>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const auto& a, const auto& b) {
        return a.second == b.second && std::abs(a.first - b.first) <= 1e-9 * (1 + std::abs(a.first));
    });
}

// The two sides of a law write some surfaces with other roundings: a ray whose answer changes when it moves by its own rounding says nothing.
bool is_masked(const Program& program, const Ray& ray, Scratch& scratch, std::mt19937_64& random) {
    const auto here = borders(program, ray, scratch);
    for (int i = 0; i < 64; ++i) {
        Ray moved = ray;
        const double step = std::pow(10.0, -13 - i % 5);
        std::uniform_real_distribution<double> little(-step, step);
        for (int k = 0; k < 3; ++k) {
            moved.origin[k] += little(random) * 10;
            moved.direction[k] += little(random) * length(ray.direction);
        }
        if (!alike(here, borders(program, moved, scratch))) return true;
    }
    return false;
}

Solid made(const std::function<Use(Operands&)>& recipe, std::uint64_t seed) {
    Operands o(seed);
    return o.builder.finish(recipe(o));
}

}  // namespace

TEST_CASE("the laws of sets hold on every ray") {
    const std::uint64_t first_seed = fresh_seed();
    WARN("WHITTLE_SEED=" << first_seed);
    std::mt19937_64 random(first_seed);
    std::size_t met = 0, rays = 0, masked = 0;
    for (int round = 0; round < 150; ++round) {
        const std::uint64_t seed = random();
        const Law& law = laws()[static_cast<std::size_t>(round) % laws().size()];
        const Solid left = made(law.left, seed), right = made(law.right, seed);
        const auto p = compile(left), q = compile(right);
        if (!p || !q) continue;
        RandomSolid at;
        at.points = Operands(seed).points;
        at.directions = {{1, 0, 0}, {0, 0, 1}, apply_to_direction(turned(60), {1, 0, 0}), apply_to_direction(turned(60), {0, 1, 0})};
        at.size = 3;
        Scratch scratch;
        for (int i = 0; i < 12; ++i) {
            const Ray ray = random_ray(at, random);
            const auto x = borders(**p, ray, scratch), y = borders(**q, ray, scratch);
            met += y.size();
            ++rays;
            INFO(law.name << ", seed " << seed << "u, ray " << to_text(ray) << "\n  " << to_code(left) << "\n  " << to_code(right));
            if (alike(x, y)) continue;
            CHECK((is_masked(**p, ray, scratch, random) || is_masked(**q, ray, scratch, random)));
            ++masked;
        }
    }
    CHECK(met > 300);
    CHECK(masked * 50 < rays);
}
