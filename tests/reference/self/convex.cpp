// convex.cpp — the reference's convex bodies are the shapes they are, and nothing parts a point that is in one from it.
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "csg/solid/convex_body.h"
#include "tests/reference/convex.h"
#include "tests/reference/self/solids.h"
#include "tests/support/random_shape.h"
#include "tests/support/seed.h"

using namespace whittle;
using namespace whittle::reference;

namespace {

BallImage ball(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, r}}; }
BallImage disc(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, 0}}; }
Solid body(ConvexParts parts) { return single(shape::ConvexBody{std::make_shared<const ConvexHullBody>(std::move(parts))}); }

ConvexParts at_corners(const Vec3& lo, const Vec3& hi, const std::vector<BallImage>& images) {
    ConvexParts parts;
    for (int i = 0; i < 8; ++i) parts.push_back({{i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z}, images});
    return parts;
}

Solid union_of(const std::vector<std::pair<Shape, Placement>>& shapes) {
    SolidBuilder b({false, false, false});
    std::vector<Use> uses;
    for (const auto& [shape, at] : shapes) uses.push_back(use_of(b.shape(shape), at));
    return b.finish(use_of(b.combine(SetOp::kUnion, uses)));
}

std::string described(const ConvexParts& parts) {
    std::string text;
    for (const ConvexPart& p : parts) {
        text += fmt::format("({:a}, {:a}, {:a})", p.centre.x, p.centre.y, p.centre.z);
        for (const BallImage& i : p.images) text += fmt::format(" + {} {:a}", i.w == Vec3(0) ? "disc" : "ball", i.u.x);
        text += "; ";
    }
    return text;
}

// Half the rays have coarse numbers, so that they run in planes of symmetry, through corners and along faces.
void check_same(const Solid& a, const Solid& b, int rays) {
    std::mt19937_64 random(Catch::rngSeed());
    std::uniform_real_distribution<double> uniform(-3, 3);
    std::uniform_int_distribution<int> coarse(-6, 6), kind(0, 3), way(-2, 2);
    const Evaluator left(a), right(b);
    int met = 0;
    for (int i = 0; i < rays; ++i) {
        Ray r;
        do {
            for (int k = 0; k < 3; ++k) {
                r.origin[k] = kind(random) == 0 ? uniform(random) : coarse(random) / 2.0;
                r.direction[k] = kind(random) == 0 ? uniform(random) : way(random);
            }
        } while (r.direction == Vec3(0));
        const Borders x = left.borders(r), y = right.borders(r);
        met += !x.borders.empty();
        INFO("ray " << r.origin.x << " " << r.origin.y << " " << r.origin.z << "  " << r.direction.x << " " << r.direction.y << " " << r.direction.z);
        REQUIRE(same_borders(x, y));
    }
    CHECK(met * 100 > rays);
}

}  // namespace

TEST_CASE("hulls and sums of round parts have the borders of the shapes they are") {
    SECTION("two balls and a capsule") {
        check_same(single(shape::Capsule{{-1, 0, 0.5}, {1, 1, 0}, 0.75}), body({{{-1, 0, 0.5}, {ball(0.75)}}, {{1, 1, 0}, {ball(0.5), ball(0.25)}}}), 300);
    }
    SECTION("corners and a box") { check_same(single(shape::Box{{-1, -1, -0.5}, {1, 2, 1}}), body(at_corners({-1, -1, -0.5}, {1, 2, 1}, {})), 60); }
    SECTION("four balls and corners, and a polyhedron grown") {
        auto tetrahedron = std::make_shared<FacetList>();
        tetrahedron->points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
        tetrahedron->facets = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        check_same(single(shape::Polyhedron{tetrahedron}), body({{{0, 0, 0}, {}}, {{2, 0, 0}, {}}, {{0, 2, 0}, {}}, {{0, 0, 2}, {}}}), 300);
    }
    SECTION("balls at the corners of a box, and a rounded box") { check_same(single(shape::RoundBox{{-1, -1, -0.5}, {1, 2, 1}, 0.25}), body(at_corners({-0.75, -0.75, -0.25}, {0.75, 1.75, 0.75}, {ball(0.25)})), 30); }
    SECTION("two rings and a frustum") {
        const Solid frustum = single(shape::Frustum{-1, 2, 1.5, 0.5});
        check_same(frustum, body({{{0, 0, -1}, {disc(1.5)}}, {{0, 0, 2}, {disc(0.5)}}}), 300);
        // As a hull of upright discs, beside the axis.
        const Solid beside = single(shape::Frustum{-1, 2, 1.5, 0.5}, Placement::translation({0.5, -0.25, 0}));
        check_same(beside, body({{{0.5, -0.25, -1}, {disc(1.5)}}, {{0.5, -0.25, 2}, {disc(0.5)}}}), 300);
    }
    SECTION("a cylinder and a ball") {
        check_same(union_of({{shape::Frustum{-1.25, 1.25, 1, 1}, {}}, {shape::Frustum{-1, 1, 1.25, 1.25}, {}}, {shape::Torus{1, 0.25}, Placement::translation({0, 0, 1})},
                             {shape::Torus{1, 0.25}, Placement::translation({0, 0, -1})}}),
                   body({{{0, 0, -1}, {disc(1), ball(0.25)}}, {{0, 0, 1}, {disc(1), ball(0.25)}}}), 200);
    }
    SECTION("the hull of a torus") { check_same(union_of({{shape::Torus{1.5, 0.5}, {}}, {shape::Frustum{-0.5, 0.5, 1.5, 1.5}, {}}}), body({{{0, 0, 0}, {disc(1.5), ball(0.5)}}}), 300); }
    SECTION("a ball and a corner on the axis, once turned, once not") {
        const Solid cone = union_of({{shape::Ellipsoid{{1.25, 1.25, 1.25}}, {}}, {shape::Frustum{0.75, 2.0833333333333335, 1, 0}, {}}});
        const Solid tip = body({{{0, 0, 0}, {ball(1.25)}}, {{0, 0, 2.0833333333333335}, {}}}), leaning = body({{{0, 0, 0}, {ball(1.25)}}, {{0, 0, 2.0833333333333335}, {}}, {{0, 0.25, 0}, {}}});
        check_same(tip, leaning, 200);
        CHECK(ts(Evaluator(tip).borders([] {
            Ray r;
            r.origin = {0, 0, -4}, r.direction = {0, 0, 1};
            return r;
        }())) == ts(Evaluator(cone).borders([] {
            Ray r;
            r.origin = {0, 0, -4}, r.direction = {0, 0, 1};
            return r;
        }())));
    }
    SECTION("a box and a disc") {
        const auto box = [](double x, double y) { return shape::Box{{-x, -y, -1}, {x, y, 1}}; };
        std::vector<std::pair<Shape, Placement>> shapes{{box(1.5, 1), {}}, {box(1, 1.5), {}}};
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) shapes.push_back({shape::Frustum{-1, 1, 0.5, 0.5}, Placement::translation({x, y, 0})});
        check_same(union_of(shapes), body(at_corners({-1, -1, -1}, {1, 1, 1}, {disc(0.5)})), 20);
    }
}

// Independent of families: where the borders are, the plane that touches the body along some direction is at least as far, and one is almost there.
TEST_CASE("random hulls and sums reach as far as their parts") {
    std::mt19937_64 random(support::fresh_seed());
    std::uniform_real_distribution<double> uniform(-1, 1);
    int met = 0;
    for (int round = 0; round < 60; ++round) {
        support::Dice dice(random());
        dice.pool(true);
        const auto sketch = support::random_convex(dice);
        const ConvexHullBody& hull = *std::get<shape::ConvexBody>(sketch.shape).hull;
        REQUIRE(has_convex_formula(hull.parts));
        const Evaluator exact(single(sketch.shape));
        for (int i = 0; i < 8; ++i) {
            // Towards a point inside the parts' hull: then the ray meets the body.
            Vec3 n(uniform(random), uniform(random), uniform(random));
            const Vec3 inside = hull.middle + (farthest_point(hull.parts, n) - hull.middle) * (0.99 * std::abs(uniform(random)));
            Ray r;
            r.origin = hull.middle + 5 * hull.size * glm::normalize(Vec3(uniform(random), uniform(random), uniform(random)));
            r.direction = inside - r.origin;
            const Borders b = exact.borders(r);
            INFO(described(hull.parts));
            REQUIRE(b.borders.size() == 2);
            ++met;
            CHECK(b.borders[0].lo.to_double() < 1);
            CHECK(b.borders[1].lo.to_double() > 1);
            for (const Border& border : b.borders) {
                const Vec3 p = point_at(r, border.lo.to_double());
                double least = HUGE_VAL;
                for (int start = 0; start < 20; ++start) {  // there are lesser hollows beside the deepest
                    double here = HUGE_VAL, step = 1;
                    Vec3 best(0);
                    for (int k = 0; k < 500; ++k) {
                        const Vec3 m = glm::normalize(best + step * Vec3(uniform(random), uniform(random), uniform(random)));
                        const double room = reach(hull.parts, m) - dot(m, p);
                        step = k < 5 ? 1 : step * (room < here ? 1.5 : 0.95);
                        if (room < here) here = room, best = m;
                    }
                    least = std::min(least, here);
                }
                CHECK(least > -1e-12 * hull.size);
                CHECK(least < 1e-2 * hull.size);
            }
        }
    }
    CHECK(met == 480);
}
