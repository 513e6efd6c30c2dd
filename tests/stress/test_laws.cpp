// test_laws.cpp — the laws of sets hold border by border on every ray, for every kind of shape, with the second operand written in another way.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/random_shape.h"
#include "tests/support/random_solid.h"
#include "tests/support/seed.h"
#include "tests/support/reduce.h"
#include "tests/support/use.h"
#include "tracer/engine/engine.h"

using namespace whittle;
using namespace whittle::support;

namespace {

constexpr SolidPasses kAsWritten{false, false, false};

// How the second operand stands to the first.
enum class Relation : std::uint8_t { kRandom, kCoincident, kTangent, kNested };

// Two operands and the doubles of both: the same set through two turns of 30 degrees against one of 60.
struct Operands {
    SolidBuilder builder{kAsWritten};
    Use a, b, a_again, b_again, box;
    std::vector<Vec3> points;

    explicit Operands(std::uint64_t seed) {
        Dice dice(seed);
        dice.pool(dice.one_in(2));
        place(random_shape(builder, dice, Repertoire::kAll), Placement::translation(dice.vector()), a, a_again);
        place(random_shape(builder, dice, Repertoire::kAll), Placement::translation(dice.vector()), b, b_again);
        bound();
    }

    Operands(ShapeKind kind, Relation relation, std::uint64_t seed) {
        Dice dice(seed);
        dice.pool(true);
        const Sketch s = random_shape_of(kind, builder, dice);
        const Placement inner = Placement::translation(dice.vector());
        place(s, inner, a, a_again);
        place(s, inner * related(relation, builder.bounds(builder.shape(s.shape)), dice), b, b_again);
        bound();
    }

    // The second operand's placement in the first one's frame: nothing; beside it, touching where it reaches furthest; shrunk inside it.
    static Placement related(Relation relation, const Bounds& box, Dice& dice) {
        const int axis = dice.integer(0, 2);
        if (relation == Relation::kTangent) {
            const double width = box.hi[axis] - box.lo[axis];
            Vec3 step(0);
            if (std::isfinite(width)) step[axis] = width;
            return Placement::translation(step);
        }
        Placement p;
        if (relation != Relation::kNested) return p;
        for (int i = 0; i < 3; ++i) {
            const double centre = 0.5 * (box.lo[i] + box.hi[i]);
            p.m[static_cast<std::size_t>(5 * i)] = 0.5;
            p.m[static_cast<std::size_t>(4 * i + 3)] = std::isfinite(centre) ? 0.5 * centre : 0;
        }
        return p;
    }

    void place(const Sketch& s, const Placement& inner, Use& first, Use& again) {
        const NodeId placed = builder.combine(SetOp::kUnion, {use(builder.shape(s.shape), inner)});
        first = use(placed, turned_about_z(60));
        again = use(builder.combine(SetOp::kUnion, {use(placed, turned_about_z(30))}), turned_about_z(30));
        for (const Vec3& p : s.points) points.push_back(apply_to_point(first.placement, apply_to_point(inner, p)));
    }

    void bound() {
        box = use(builder.shape(shape::Box{{-7, -7, -7}, {7, 7, 7}}), turned_about_z(60));
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
    bool of_one = false;                        // of A alone
};

const std::vector<Law>& laws() {
    static const std::vector<Law> list{
        {"A - A' is empty", [](Operands& o) { return o.less(o.a, o.a_again); }, [](Operands&) { return use(kEmptyNode); }, true},
        {"A' - A is empty", [](Operands& o) { return o.less(o.a_again, o.a); }, [](Operands&) { return use(kEmptyNode); }, true},
        {"A | A' = A", [](Operands& o) { return o.either(o.a, o.a_again); }, [](Operands& o) { return o.a; }, true},
        {"A & A' = A", [](Operands& o) { return o.both(o.a, o.a_again); }, [](Operands& o) { return o.a; }, true},
        {"A - (A' - B) = A & B", [](Operands& o) { return o.less(o.a, o.less(o.a_again, o.b)); }, [](Operands& o) { return o.both(o.a, o.b); }},
        {"(A - B) | (A' & B') = A", [](Operands& o) { return o.either(o.less(o.a, o.b), o.both(o.a_again, o.b_again)); }, [](Operands& o) { return o.a; }},
        {"not (A | B) = not A & not B", [](Operands& o) { return o.outside(o.either(o.a, o.b)); },
         [](Operands& o) { return o.both(o.outside(o.a_again), o.outside(o.b_again)); }},
        {"A | (B | A') = (A | B) | A'", [](Operands& o) { return o.either(o.a, o.either(o.b, o.a_again)); }, [](Operands& o) { return o.either(o.either(o.a, o.b), o.a_again); }},
        {"A & (B & A') = B & A", [](Operands& o) { return o.both(o.a, o.both(o.b, o.a_again)); }, [](Operands& o) { return o.both(o.b_again, o.a); }},
        {"not (A & B) = not A | not B", [](Operands& o) { return o.outside(o.both(o.a, o.b)); },
         [](Operands& o) { return o.either(o.outside(o.a_again), o.outside(o.b_again)); }},
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

// Operands that touch overlap by the rounding of their placements: intervals shorter than that say nothing.
std::vector<std::pair<double, bool>> without_slivers(const std::vector<std::pair<double, bool>>& borders, double least) {
    std::vector<std::pair<double, bool>> r;
    for (const auto& b : borders) {
        if (!r.empty() && b.first - r.back().first < least) r.pop_back();
        else r.push_back(b);
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

constexpr double kRoundingOfPlaces = 0x1p-44;  // some units of the largest coordinates

struct Count {
    std::size_t met = 0, rays = 0, masked = 0;
};

// Compares both sides of a law on rays at the operands that `fresh()` makes, the same each time.
template <class Fresh>
void check_law(const Law& law, const Fresh& fresh, int rays, double sliver, std::mt19937_64& random, Count& count) {
    Operands o = fresh(), other = fresh();
    const Solid left = o.builder.finish(law.left(o)), right = other.builder.finish(law.right(other));
    const auto p = compile(left), q = compile(right);
    if (!p || !q) return;
    RandomSolid at;
    at.points = o.points;
    at.directions = {{1, 0, 0}, {0, 0, 1}, apply_to_direction(turned_about_z(60), {1, 0, 0}), apply_to_direction(turned_about_z(60), {0, 1, 0})};
    at.size = 3;
    Scratch scratch;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = random_ray(at, random);
        const auto x = without_slivers(borders(**p, ray, scratch), sliver), y = without_slivers(borders(**q, ray, scratch), sliver);
        count.met += y.size();
        ++count.rays;
        if (alike(x, y)) continue;
        ++count.masked;
        // A that touches B where one of them bends has a film there as thick as the roundings in which two writings of B differ, for all rays around.
        const double film = kRoundingOfPlaces / length(ray.direction);
        if (!law.of_one && alike(without_slivers(x, film), without_slivers(y, film))) continue;
        INFO(law.name << ", ray " << to_text(ray) << "\n  " << to_code(left) << "\n  " << to_code(right));
        CHECK((is_masked(**p, ray, scratch, random) || is_masked(**q, ray, scratch, random)));
    }
}

}  // namespace

TEST_CASE("the laws of sets hold on every ray") {
    const std::uint64_t first_seed = fresh_seed();
    WARN("WHITTLE_SEED=" << first_seed);
    std::mt19937_64 random(first_seed);
    Count count;
    for (std::size_t round = 0; round < 165; ++round) {
        const std::uint64_t seed = random();
        INFO("seed " << seed << "u");
        check_law(laws()[round % laws().size()], [&] { return Operands(seed); }, 12, 0, random, count);
    }
    CHECK(count.met > 300);
    CHECK(count.masked * 50 < count.rays);
}

TEST_CASE("the laws of sets hold for every kind of shape, coincident, tangent and nested") {
    const std::uint64_t first_seed = fresh_seed();
    INFO("WHITTLE_SEED=" << first_seed);
    std::mt19937_64 random(first_seed);
    for (int kind = 0; kind < kShapeKinds; ++kind) {
        Count count;
        for (const Relation relation : {Relation::kCoincident, Relation::kTangent, Relation::kNested})
            for (const Law& law : laws()) {
                const std::uint64_t seed = random();
                INFO(name_of(static_cast<ShapeKind>(kind)) << ", relation " << static_cast<int>(relation) << ", seed " << seed << "u");
                check_law(law, [&] { return Operands(static_cast<ShapeKind>(kind), relation, seed); }, 10, relation == Relation::kTangent ? 1e-7 : 0, random, count);
            }
        INFO(name_of(static_cast<ShapeKind>(kind)) << ": " << count.met << " borders, " << count.masked << " of " << count.rays << " rays masked");
        CHECK(count.met > count.rays / 8);
        CHECK(count.masked * 10 < count.rays);
    }
}

TEST_CASE("coincident operands show the label of the one that comes first") {
    std::mt19937_64 random(fresh_seed());
    for (int kind = 0; kind < kShapeKinds; ++kind) {
        const std::uint64_t seed = random();
        Operands o(static_cast<ShapeKind>(kind), Relation::kCoincident, seed);
        Label red, blue;
        red.material.color = Vec4(1, 0, 0, 1);
        blue.material.color = Vec4(0, 0, 1, 1);
        Use first = o.a, second = o.b;  // of one placement: polyhedra are never snapped
        first.label = o.builder.label(red);
        second.label = o.builder.label(blue);
        const auto program = compile(o.builder.finish(o.either(first, second)));
        REQUIRE(program);
        RandomSolid at;
        at.points = o.points;
        at.size = 3;
        Scratch scratch;
        Spans spans;
        for (int i = 0; i < 30; ++i) {
            all_spans(**program, random_ray(at, random), scratch, spans);
            for (const Span& s : spans)
                for (const auto& end : {s.in, s.out})
                    if (end) {
                        INFO(name_of(static_cast<ShapeKind>(kind)) << " seed " << seed);
                        CHECK(leaf_uses(**program)[end->use].material == leaf_uses(**program)[0].material);
                    }
        }
    }
}
