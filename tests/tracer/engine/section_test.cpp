// section_test.cpp — polygons that are the section of a solid, swept: against membership of points in the plane, in 113-bit arithmetic.
#include <functional>

#include "csg/solid/convex_body.h"
#include "tests/support/seed.h"
#include "tests/support/use.h"
#include "tests/tracer/engine/membership.h"

using namespace whittle;
using namespace whittle::support;
using namespace whittle::testing;

namespace {

struct QuadPoint {
    Quad x, y, z;
};

// Where the placement takes the point from.
QuadPoint taken_back(const Placement& p, const QuadPoint& at) {
    const auto a = [&](std::size_t r, std::size_t c) { return Quad(p.m[4 * (r % 3) + c % 3]); };
    const auto minor = [&](std::size_t r, std::size_t c) { return a(r + 1, c + 1) * a(r + 2, c + 2) - a(r + 1, c + 2) * a(r + 2, c + 1); };
    const Quad det = a(0, 0) * minor(0, 0) + a(0, 1) * minor(0, 1) + a(0, 2) * minor(0, 2);
    const Quad x = at.x - p.offset(0), y = at.y - p.offset(1), z = at.z - p.offset(2);
    const auto row = [&](std::size_t i) { return (minor(0, i) * x + minor(1, i) * y + minor(2, i) * z) / det; };
    return {row(0), row(1), row(2)};
}

// A solid and who is in it.
struct Body {
    NodeId node = kEmptyNode;
    std::function<bool(const QuadPoint&)> inside;
};

constexpr int kBodies = 6;

Body body(SolidBuilder& b, int which) {
    switch (which) {
        case 0: return {b.shape(shape::Torus{3, 1}), [](const QuadPoint& p) {
                            const Quad k = p.x * p.x + p.y * p.y + p.z * p.z + 8;
                            return k * k < 36 * (p.x * p.x + p.y * p.y);
                        }};
        case 1: return {b.shape(shape::Frustum{-2, 3, 3, 0.5}), [](const QuadPoint& p) {
                            const Quad r = 3 - (p.z + 2) / 2;
                            return p.z > -2 && p.z < 3 && p.x * p.x + p.y * p.y < r * r;
                        }};
        case 2: {  // a square that turns once
            const NodeId square = b.shape(shape::Rectangle{{-2, -2}, {2, 2}});
            return {b.shape(shape::Extrusion{square, -4, 4, 360, Vec2(1), 0}), [](const QuadPoint& p) {
                        constexpr Quad kPi = Quad(0x1.921fb54442d18p+1) + Quad(0x1.1a62633145c07p-53);
                        const Turn t = turn_by((p.z + 4) / 4 * kPi);
                        const Quad u = t.c * p.x - t.s * p.y, v = t.s * p.x + t.c * p.y;
                        return p.z > -4 && p.z < 4 && u > -2 && u < 2 && v > -2 && v < 2;
                    }};
        }
        case 3: {  // discs of two heights, the upper one aside
            ConvexParts discs{{{0, 0, -2}, {{{3, 0, 0}, {0, 3, 0}, {0, 0, 0}}}}, {{1, 0, 2}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}}};
            return {b.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(discs)}), [](const QuadPoint& p) {
                        const Quad share = (p.z + 2) / 4, r = 3 - 2 * share, x = p.x - share;
                        return p.z > -2 && p.z < 2 && x * x + p.y * p.y < r * r;
                    }};
        }
        case 4: {  // turned by a quarter
            const Placement right = moved(1, 0, 0);
            const NodeId profile = b.combine(SetOp::kUnion, {use(b.shape(shape::Rectangle{{0, -2}, {2, 2}}), right)});
            return {b.shape(shape::Revolution{profile, 0, 90, 0}), [](const QuadPoint& p) {
                        const Quad rho2 = p.x * p.x + p.y * p.y;
                        return p.x > 0 && p.y > 0 && rho2 > 1 && rho2 < 9 && p.z > -2 && p.z < 2;
                    }};
        }
        default: {  // shrinks more one way than the other
            const NodeId square = b.shape(shape::Rectangle{{-3, -3}, {3, 3}});
            return {b.shape(shape::Extrusion{square, -2, 2, 0, {0.5, 0.25}, 0}), [](const QuadPoint& p) {
                        const Quad share = (p.z + 2) / 4, x = 3 * (1 - share / 2), y = 3 * (1 - share * Quad(0.75));
                        return p.z > -2 && p.z < 2 && p.x > -x && p.x < x && p.y > -y && p.y < y;
                    }};
        }
    }
}

// Numbers that need no rounding: turns by the angle of the triangle 3, 4, 5 with a scale of 1.25.
const std::array<Placement, 5> kStands{{{{1, 0, 0, 0, 0, 0.75, -1, 0.25, 0, 1, 0.75, 0.375}},
                                        {{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0.75}},
                                        {{0.75, 0, 1, 0, 0, -1.25, 0, 0, -1, 0, 0.75, -0.25}},
                                        {{1, 0.5, 0, 3, 0, 1.5, -2, 0.25, 0, 2, 1.5, 0.125}},
                                        {{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}}}};

constexpr double kHeight = 2;

struct Swept {
    Solid solid;
    std::function<bool(const QuadPoint&)> inside;
};

Swept swept(int which, const Placement& stand, const Placement& outer) {
    SolidBuilder b;
    const Body made = body(b, which);
    const Use placed = use(made.node, stand);
    const Bounds box = b.bounds(placed);
    auto contours = std::make_shared<const std::vector<std::vector<Vec2>>>(std::vector<std::vector<Vec2>>{{{box.lo.x, box.lo.y}, {box.hi.x, box.lo.y}, {box.hi.x, box.hi.y}}});
    const NodeId polygon = b.shape(shape::Polygon{contours, b.combine(SetOp::kUnion, {placed})});
    const Solid solid = b.finish(use(b.shape(shape::Extrusion{polygon, 0, kHeight, 0, Vec2(1), 0}), outer));
    return {solid, [=](const QuadPoint& p) {
                const QuadPoint q = taken_back(outer, p);
                return q.z > 0 && q.z < kHeight && made.inside(taken_back(stand, {q.x, q.y, 0x1p-100}));  // what is just above counts
            }};
}

std::string difference_on(const Program& program, const Swept& s, const Ray& ray, Scratch& scratch, Random& random, double far = 2) {
    Spans spans;
    all_spans(program, ray, scratch, spans);
    const auto inside = [&](Quad t) { return s.inside({Quad(ray.origin.x) + t * ray.direction.x, Quad(ray.origin.y) + t * ray.direction.y, Quad(ray.origin.z) + t * ray.direction.z}); };
    return difference(inside, spans, random, far);
}

}  // namespace

TEST_CASE("a section that stands below a polygon is swept as it is, on every ray") {
    const std::uint64_t seed = fresh_seed();
    CAPTURE(seed);
    Random random(seed);
    Scratch scratch;
    const Placement aside{{0.75, -1, 0, 10, 1, 0.75, 0, -4, 0, 0, 1.25, 8}};
    for (int which = 0; which < kBodies; ++which)
        for (std::size_t stand = 0; stand < kStands.size(); ++stand)
            for (const Placement& outer : {Placement{}, aside}) {
                CAPTURE(which, stand, outer.is_identity());
                const Swept s = swept(which, kStands[stand], outer);
                const auto program = compiled(s.solid);
                for (int i = 0; i < 100; ++i) CHECK(difference_on(*program, s, random.ray_through(program_bounds(*program)), scratch, random) == "");
            }
    CHECK(scratch.counters.uncertified == 0);
}

TEST_CASE("rays along the way that a section is swept, and nearly, meet its ends alone") {
    const std::uint64_t seed = fresh_seed();
    CAPTURE(seed);
    Random random(seed);
    Scratch scratch;
    const Placement tilted{{1, 0, 0, 3, 0, 0.75, -1, 0, 0, 1, 0.75, 7}};
    int met = 0;
    for (int which = 0; which < kBodies; ++which)
        for (std::size_t stand = 0; stand < kStands.size(); ++stand)
            for (const Placement& outer : {Placement{}, tilted}) {
                CAPTURE(which, stand, outer.is_identity());
                const Swept s = swept(which, kStands[stand], outer);
                const auto program = compiled(s.solid);
                const Vec3 way(outer.linear(0, 2), outer.linear(1, 2), outer.linear(2, 2));
                for (int i = 0; i < 100; ++i)
                    for (const double lean : {0.0, 1e-300, 1e-30, 1e-12}) {
                        Ray ray;
                        ray.origin = random.point(program_bounds(*program)) - 4.0 * way;
                        ray.direction = way + Vec3(lean, -lean / 2, 0);
                        CAPTURE(ray.origin.x, ray.origin.y, ray.origin.z, lean);
                        CHECK(difference_on(*program, s, ray, scratch, random, 8) == "");
                        Hit hit;
                        const bool hits = first_hit(*program, ray, HUGE_VAL, scratch, hit);
                        CHECK(any_hit(*program, ray, HUGE_VAL, scratch) == hits);
                        met += hits;
                    }
            }
    CHECK(met > 5000);
}

TEST_CASE("where a face lies in the section's plane, what is just above counts") {
    Scratch scratch;
    const auto meets = [&](double side, double z) {
        // A quarter turn from +x on, lying on its first face or hanging from it.
        SolidBuilder b;
        const NodeId profile = b.combine(SetOp::kUnion, {use(b.shape(shape::Rectangle{{0, -2}, {2, 2}}), moved(1, 0, 0))});
        const Use lying = use(b.shape(shape::Revolution{profile, 0, 90, 0}), {{1, 0, 0, 0, 0, 0, -side, 0, 0, side, 0, z}});
        auto contours = std::make_shared<const std::vector<std::vector<Vec2>>>(std::vector<std::vector<Vec2>>{{{1, -2}, {3, -2}, {3, 2}, {1, 2}}});
        const NodeId polygon = b.shape(shape::Polygon{contours, b.combine(SetOp::kUnion, {lying})});
        const auto program = compiled(b.finish(use(b.shape(shape::Extrusion{polygon, 0, 1, 0, Vec2(1), 0}))));
        Ray ray;
        ray.origin = {2, 0.5, 5};
        ray.direction = {0, 0, -1};
        return any_hit(*program, ray, HUGE_VAL, scratch);
    };
    CHECK(meets(1, 0));
    CHECK(meets(1, -0x1p-40));
    CHECK_FALSE(meets(1, 0x1p-40));
    CHECK_FALSE(meets(-1, 0));
    CHECK(meets(-1, 0x1p-40));
}

TEST_CASE("a ring's section less the same, placed in other words, is nothing") {
    Random random(7);
    Scratch scratch;
    SolidBuilder b;
    const Use ring = use(b.shape(shape::Torus{3, 1}), kStands[0]);
    auto contours = std::make_shared<const std::vector<std::vector<Vec2>>>(std::vector<std::vector<Vec2>>{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}});
    const NodeId tube = b.shape(shape::Extrusion{b.shape(shape::Polygon{contours, b.combine(SetOp::kUnion, {ring})}), 0, kHeight, 0, Vec2(1), 0});
    const NodeId half = b.combine(SetOp::kUnion, {use(tube, turned_about_z(30))});
    const Use once = use(tube, turned_about_z(60)), twice = use(b.combine(SetOp::kUnion, {use(half, turned_about_z(30))}));
    const auto nothing = compiled(b.finish(use(b.combine(SetOp::kDifference, {once, twice}))));
    const Swept whole = swept(0, kStands[0], turned_about_z(60));
    const auto something = compiled(whole.solid);
    int met = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = random.ray_through(program_bounds(*something));
        met += any_hit(*something, ray, HUGE_VAL, scratch);
        CHECK_FALSE(any_hit(*nothing, ray, HUGE_VAL, scratch));
    }
    CHECK(met > 100);
}
