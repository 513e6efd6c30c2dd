// convex_test.cpp — convex bodies known by how far they reach: against the same bodies made of planes, quadrics and tori, against polyhedra within them, and
// against Steiner's formula.
#include <cmath>
#include <numbers>

#include "csg/solid/convex_body.h"
#include "csg/solid/convex_hull.h"
#include "csg/solid/use_of.h"
#include "tests/support/seed.h"
#include "tests/tracer/engine/rays.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kPi = std::numbers::pi;

// A turn by angles of the triangle 3, 4, 5 about two axes, and a shift.
const Placement kAskew{{0.6, -0.64, 0.48, 3, 0.8, 0.48, -0.36, -7, 0, 0.6, 0.8, 11}};

ConvexParts placed_parts(const Shape& shape, const Placement& at) {
    SolidBuilder b;
    const NodeId node = b.shape(shape);
    const auto parts = convex_parts_of(b.so_far(), use_of(node, at));
    REQUIRE(parts);
    return *parts;
}

Solid body_of(ConvexParts parts, const Placement& at = {}) {
    SolidBuilder b;
    return b.finish(use_of(b.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(std::move(parts))}), at));
}

Solid shape_of(const Shape& shape, const Placement& at) {
    SolidBuilder b;
    return b.finish(use_of(b.shape(shape), at));
}

Spans spans_of(const Program& program, const Ray& ray, Scratch& scratch) {
    Spans spans;
    all_spans(program, ray, scratch, spans);
    return spans;
}

std::vector<Shape> plain_shapes() {
    return {shape::Box{{-1, -2, -3}, {4, 5, 6}},      shape::Ellipsoid{{3, 3, 3}},     shape::Ellipsoid{{1, 4, 2}},      shape::Frustum{-1, 5, 3, 3},
            shape::Frustum{0, 4, 3, 0.5},             shape::Frustum{0, 4, 0, 2},      shape::Capsule{{0, 1, 0}, {3, 4, 9}, 2}, shape::RoundBox{{0, 0, 0}, {9, 7, 5}, 1.5},
            shape::FacetedFrustum{0, 3, 2, 1, 7}};
}

ConvexParts random_parts(Random& random) {
    const auto vector = [&] { return Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)); };
    ConvexParts parts;
    const int count = 2 + static_cast<int>(random.between(0, 5));
    for (int i = 0; i < count; ++i) {
        ConvexPart& part = parts.emplace_back(ConvexPart{10.0 * vector(), {}});
        const double kind = random.between(0, 5);
        if (kind > 1) part.images.push_back({4.0 * vector(), 4.0 * vector(), kind > 3 ? 4.0 * vector() : Vec3(0)});
        if (kind > 4) part.images.push_back({2.0 * vector(), 2.0 * vector(), Vec3(0)});
    }
    parts.push_back({Vec3(0), {{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}});
    return parts;
}

// Of the solid by parallel rays through the cells of a grid, along z.
double volume_of(const Program& program, int n) {
    const Bounds box = program_bounds(program);
    Scratch scratch;
    double sum = 0;
    const double dx = (box.hi.x - box.lo.x) / n, dy = (box.hi.y - box.lo.y) / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            Ray ray;
            ray.origin = {box.lo.x + (i + 0.5) * dx, box.lo.y + (j + 0.5) * dy, box.lo.z - 1};
            ray.direction = {0, 0, 1};
            for (const Span& s : spans_of(program, ray, scratch)) sum += s.out->t - s.in->t;
        }
    return sum * dx * dy;
}

}  // namespace

TEST_CASE("a body known by how far it reaches has the ends of the shape it is") {
    const std::uint64_t seed = support::fresh_seed();
    CAPTURE(seed);
    Random random(seed);
    Scratch scratch;
    std::size_t ends = 0, certain = 0;
    for (const Shape& shape : plain_shapes())
        for (const Placement& at : {Placement{}, kAskew}) {
            CAPTURE(shape.index());
            const auto truth = compiled(shape_of(shape, at));
            // Once placed as a body, once as its parts.
            const auto placed = compiled(body_of(placed_parts(shape, {}), at)), parts = compiled(body_of(placed_parts(shape, at)));
            for (int i = 0; i < 150; ++i) {
                const Ray ray = random.ray_through(program_bounds(*truth));
                const Spans want = spans_of(*truth, ray, scratch);
                for (const Program* program : {placed.get(), parts.get()}) {
                    const Spans have = spans_of(*program, ray, scratch);
                    REQUIRE(have.size() == want.size());
                    for (std::size_t k = 0; k < want.size(); ++k) {
                        if (!want[k].in || !have[k].in) continue;
                        for (const auto& [a, b] : {std::pair(*want[k].in, *have[k].in), std::pair(*want[k].out, *have[k].out)}) {
                            ++ends;
                            certain += b.certified;
                            // Parts placed before are rounded once more each.
                            const double rounding = program == parts.get() ? 1e-13 / std::max(1e-4, std::abs(glm::dot(glm::normalize(ray.direction), a.normal))) : 0;
                            if (b.certified) CHECK(std::abs(a.t - b.t) <= a.t_error + b.t_error + rounding);
                            CHECK(glm::dot(a.normal, b.normal) > 0.999);
                        }
                    }
                }
            }
        }
    CHECK(ends > 4000);
    CHECK(100 * certain > 99 * ends);
}

TEST_CASE("the hull of random parts holds the hull of its points and no more than a little") {
    const std::uint64_t seed = support::fresh_seed();
    CAPTURE(seed);
    Random random(seed);
    Scratch scratch;
    int met = 0;
    for (int round = 0; round < 8; ++round) {
        const ConvexParts parts = random_parts(random);
        std::vector<Vec3> points;
        for (int i = 0; i < 1500; ++i) points.push_back(farthest_point(parts, {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}));
        auto hull = convex_hull_of(points);
        REQUIRE(hull);
        const double size = size_of(parts, middle_of(parts));
        const auto inner = compiled(shape_of(shape::Polyhedron{std::make_shared<const FacetList>(std::move(*hull))}, {}));
        const auto body = compiled(body_of(parts));
        for (int i = 0; i < 100; ++i) {
            const Ray ray = random.ray_through(program_bounds(*inner));
            const Spans within = spans_of(*inner, ray, scratch), whole = spans_of(*body, ray, scratch);
            REQUIRE(whole.size() <= 1);
            if (within.empty() || !within[0].in) continue;
            REQUIRE(whole.size() == 1);
            ++met;
            const End in = *whole[0].in, out = *whole[0].out;
            const double rounding = 1e-12 * size / glm::length(ray.direction);
            CHECK(in.t - in.t_error <= within[0].in->t + rounding);
            CHECK(out.t + out.t_error >= within[0].out->t - rounding);
            // An end is on the body: the plane across its normal touches it there.
            for (const End& end : {in, out}) {
                const Vec3 p = ray.origin + end.t * ray.direction;
                CHECK(std::abs(reach(parts, end.normal) - glm::dot(end.normal, p)) < 1e-9 * size);
            }
        }
    }
    CHECK(met > 300);
}

TEST_CASE("bodies grown by a ball have the volume of Steiner's formula") {
    const double r = 2, h = 5, grown = 1.5;
    const ConvexParts ball = placed_parts(shape::Ellipsoid{Vec3(grown)}, {});
    // A cylinder that leans, by its mean curvature pi h + pi^2 r.
    const double cylinder = kPi * r * r * h + (2 * kPi * r * r + 2 * kPi * r * h) * grown + (kPi * h + kPi * kPi * r) * grown * grown + 4 * kPi / 3 * grown * grown * grown;
    CHECK(volume_of(*compiled(body_of(sums_of(placed_parts(shape::Frustum{0, h, r, r}, kAskew), ball))), 200) == Approx(cylinder).epsilon(2e-4));
    // A box that leans: pi (a + b + c) over 1.
    const double box = 2.0 * 3 * 4 + 2 * (2.0 * 3 + 3 * 4 + 2 * 4) * grown + kPi * (2 + 3 + 4) * grown * grown + 4 * kPi / 3 * grown * grown * grown;
    CHECK(volume_of(*compiled(body_of(sums_of(placed_parts(shape::Box{{0, 0, 0}, {2, 3, 4}}, kAskew), ball))), 200) == Approx(box).epsilon(2e-4));
}

TEST_CASE("a flat face of a convex body is one face with what abuts") {
    const ConvexParts mixed = [] {
        ConvexParts parts = placed_parts(shape::Ellipsoid{Vec3(5)}, Placement::translation({0, 0, 5}));
        for (const ConvexPart& p : placed_parts(shape::Frustum{0, 10, 3, 3}, Placement::translation({20, 0, 0}))) parts.push_back(p);
        return parts;
    }();
    SolidBuilder b;
    const Use body = use_of(b.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(mixed)}));
    const Use below = use_of(b.shape(shape::Box{{17, -1, -4}, {23, 1, 0}})), beside = use_of(b.shape(shape::Box{{10, -30, 10}, {30, 30, 12}}));
    const auto program = compiled(b.finish(use_of(b.combine(SetOp::kUnion, {body, below, beside}))));
    Scratch scratch;
    for (const double x : {17.5, 20.0, 22.9}) {
        Ray ray;
        ray.origin = {x, 0.25, -10};
        ray.direction = {0, 0, 1};
        const Spans spans = spans_of(*program, ray, scratch);
        REQUIRE(spans.size() == 1);
        CHECK(spans[0].in->t == 6);
        CHECK(spans[0].out->t == 22);
        CHECK(spans[0].in->certified);
        CHECK(spans[0].out->certified);
    }
}

TEST_CASE("a ray that leaves a convex body meets it no more, and one beside it neither") {
    const std::uint64_t seed = support::fresh_seed();
    CAPTURE(seed);
    Random random(seed);
    Scratch scratch;
    int followed = 0;
    for (int round = 0; round < 6; ++round) {
        const auto program = compiled(body_of(random_parts(random), kAskew));
        for (int i = 0; i < 150; ++i) {
            Hit hit;
            const Ray ray = random.ray_through(program_bounds(*program));
            if (!first_hit(*program, ray, HUGE_VAL, scratch, hit) || hit.from_inside) continue;
            Ray on;
            on.origin = hit.point;
            on.direction = hit.end.normal + 0.9 * glm::normalize(Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
            on.departure = &hit.departure;
            ++followed;
            CHECK(spans_of(*program, on, scratch).empty());
            on.direction = -on.direction;
            const Spans through = spans_of(*program, on, scratch);
            REQUIRE(through.size() == 1);
            CHECK(through[0].out->t > 0);
        }
    }
    CHECK(followed > 200);
}

TEST_CASE("rays in the faces, edges and corners of a convex body are answered") {
    const auto box = compiled(body_of(placed_parts(shape::Box{{0, 0, 0}, {2, 2, 2}}, {}))), cone = compiled(body_of(placed_parts(shape::Frustum{0, 4, 3, 0}, {})));
    Scratch scratch;
    for (const Program* program : {box.get(), cone.get()})
        for (const Vec3 origin : {Vec3(0, 0, -5), Vec3(2, 2, -5), Vec3(1, 0, -5), Vec3(3, 0, -5), Vec3(0, 0, 9)})
            for (const Vec3 direction : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 1, 5), Vec3(0, 3, 9)}) {
                Ray ray;
                ray.origin = origin;
                ray.direction = direction;
                const Spans spans = spans_of(*program, ray, scratch);
                REQUIRE(spans.size() <= 1);
                for (const Span& s : spans) CHECK(s.in->t < s.out->t);
            }
}
