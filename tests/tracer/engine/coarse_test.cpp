// coarse_test.cpp — what packets in float find is what single rays find, to the bit, where surfaces stand as close as float can hardly tell apart.
#include <catch2/catch.hpp>

#include "csg/base/passes.h"
#include "tests/tracer/engine/packets.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kPi = 3.14159265358979323846;

Use use_of(NodeId node, const Placement& at = Placement()) { return {node, kNoLabel, 0, at}; }

Placement scaled_turn(Random& random, double scale, const Vec3& at, bool sheared) {
    const double a = random.between(0, 2 * kPi), b = random.between(0, 2 * kPi), ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
    const Vec3 x{ca * cb, sa * cb, -sb}, y{-sa, ca, 0}, z{ca * sb, sa * sb, cb};
    const double k = scale * (sheared ? random.between(0.3, 1) : 1), h = sheared ? random.between(-0.5, 0.5) : 0;
    return {{scale * x.x, k * y.x + h * scale * x.x, scale * z.x, at.x, scale * x.y, k * y.y + h * scale * x.y, scale * z.y, at.y, scale * x.z, k * y.z + h * scale * x.z,
             scale * z.z, at.z}};
}

// A body of size 1 with surfaces `gap` apart: steps in a face, a shell, a thin cap of a ball that just shows, a hole that grazes another.
NodeId close_call(SolidBuilder& b, Random& random, double gap) {
    const NodeId cube = b.shape(shape::Box{Vec3(-0.5), Vec3(0.5)});
    const auto moved = [](NodeId node, const Vec3& at) { return use_of(node, Placement::translation(at)); };
    switch (static_cast<int>(random.between(0, 6))) {
        case 0: return b.combine(SetOp::kDifference, {use_of(cube), moved(b.shape(shape::Box{Vec3(-0.3), Vec3(0.3)}), {0.1, 0, 0.8 - gap})});
        case 1: return b.combine(SetOp::kUnion, {use_of(cube), moved(b.shape(shape::Ellipsoid{Vec3(0.5 + gap)}), Vec3(0))});
        case 2: return b.combine(SetOp::kDifference, {use_of(b.shape(shape::Ellipsoid{Vec3(0.5)})), use_of(b.shape(shape::Ellipsoid{Vec3(0.5 - gap)})), moved(cube, {0, 0, 0.6})});
        case 3: return b.combine(SetOp::kDifference, {use_of(cube), use_of(b.shape(shape::Frustum{-1, 1, 0.3, 0.3})), moved(b.shape(shape::Frustum{-1, 1, 0.1, 0.1}), {0.2 + gap, 0, 0})});
        case 4: return b.combine(SetOp::kIntersection, {use_of(cube), moved(b.shape(shape::Frustum{-1, 1, 0.7, 0.7}), {gap, 0, 0}), use_of(b.shape(shape::FacetedFrustum{-1, 1, 0.6, 0.6, 7}))});
        default: return b.combine(SetOp::kUnion, {use_of(b.shape(shape::Frustum{-0.5, 0.5, 0.4, 0.4})), moved(b.shape(shape::Frustum{-0.5, 0.5 + gap, 0.4, 0.4}), {gap, 0, 0})});
    }
}

// Turns the ray until it is next to where what rays hit changes, half of the times as close as double gets there: most of a tile around it is as nearly
// decided one way as the other.
void aim_at_edge(const Program& program, Ray& ray, Random& random) {
    Scratch scratch;
    const auto met = [&](const Vec3& direction) {
        Ray r = ray;
        r.direction = direction;
        Hit hit;
        return first_hit(program, r, HUGE_VAL, scratch, hit) ? hit.end.surface : kNoClass;
    };
    const Vec3 turn = 0.3 * random.point({Vec3(-1), Vec3(1)});
    Vec3 a = ray.direction, b = a + turn;
    const ClassId first = met(a);
    if (met(b) == first) return;
    const int steps = random.between(0, 1) < 0.5 ? 50 : static_cast<int>(random.between(4, 30));
    for (int k = 0; k < steps; ++k) {
        const Vec3 middle = 0.5 * (a + b);
        (met(middle) == first ? a : b) = middle;
    }
    ray.direction = a;
}

}  // namespace

TEST_CASE("float finds the hits of single rays, to the bit, among surfaces at all distances from each other") {
    const std::uint64_t seed = Catch::rngSeed() == 0 ? 1 : Catch::rngSeed();
    Random random(seed);
    Tally tally;
    EngineCounters counters;
    for (int i = 0; i < 1500; ++i) {
        const double scale = std::exp2(random.between(-12, 12)), gap = std::exp2(random.between(-40, -2));
        const Vec3 at = random.between(0, 1) < 0.5 ? Vec3(0) : random.point({Vec3(-20 * scale), Vec3(20 * scale)});
        SolidBuilder b;
        std::vector<Use> parts;
        const int count = 1 + static_cast<int>(random.between(0, 8));
        for (int k = 0; k < count; ++k) {
            const NodeId node = close_call(b, random, gap);
            const Vec3 aside = count == 1 ? at : at + scale * random.point({Vec3(-1), Vec3(1)});
            parts.push_back(use_of(node, random.between(0, 1) < 0.5 ? Placement::translation(aside) : scaled_turn(random, count == 1 ? scale : 0.4 * scale, aside, k % 3 == 2)));
        }
        const auto program = compiled(b.finish(use_of(b.combine(SetOp::kUnion, std::move(parts)))));
        Ray ray;
        const double distance = scale * std::exp2(random.between(0.8, 6));
        Vec3 way = random.point({Vec3(-1), Vec3(1)});
        while (glm::length(way) < 0.1) way = random.point({Vec3(-1), Vec3(1)});
        ray.origin = at + glm::normalize(way) * distance;
        ray.direction = (at + scale * random.point({Vec3(-0.6), Vec3(0.6)}) - ray.origin) / distance;
        INFO("solid " << i << ", seed " << seed);
        const double step = std::exp2(random.between(-18, -8));
        aim_at_edge(*program, ray, random);
        std::vector<Ray> rays = tile_around(ray, 256, step);
        // One may lie along a coordinate plane, or as good as that.
        Vec3& still = rays[static_cast<std::size_t>(random.between(0, 256))].direction;
        if (const int axis = static_cast<int>(random.between(0, 9)); axis < 3 && std::abs(still[axis]) < 0.5 * glm::length(still))
            still[axis] = random.between(0, 1) < 0.5 ? 0 : 0x1p-1030;
        Scratch scratch;
        Hit hit;
        // Some look as far as just to what one of them hits.
        const double t_max = random.between(0, 1) < 0.5 && first_hit(*program, rays[100], HUGE_VAL, scratch, hit) ? hit.end.t : HUGE_VAL;
        CHECK(differing(*program, rays, t_max, tally) == 0);
        std::vector<Hit> hits(rays.size());
        const auto found = std::make_unique<bool[]>(rays.size());
        first_hits(*program, rays.data(), 256, HUGE_VAL, scratch, hits.data(), found.get());
        counters += scratch.counters;
    }
    CHECK(tally.hits > 100000);
    CHECK(counters.skipped_by(EnginePass::kCoarse) > 100000);  // float found a good part of them
    CHECK(counters.packet_deferred > 1000);                    // and left some open
}

TEST_CASE("hits are the same where float looks for none") {
    SolidBuilder b;
    const NodeId drill = b.shape(shape::Frustum{-1, 1, 0.2, 0.2});
    std::vector<Use> uses{use_of(b.shape(shape::Box{Vec3(-2, -2, -0.3), Vec3(2, 2, 0.3)}))};
    for (int i = 0; i < 25; ++i) uses.push_back(use_of(drill, Placement::translation({-1.6 + 0.8 * (i % 5), -1.6 + 0.8 * (i / 5), 0})));
    const Solid plate = b.finish(use_of(b.combine(SetOp::kDifference, std::move(uses))));
    EngineOptions without;
    without.disabled_passes = {name_of(EnginePass::kCoarse)};
    const auto coarse = compiled(plate), fine = compiled(plate, without);
    Scratch a, c;
    std::uint64_t met = 0;
    for (int tile = 0; tile < 64; ++tile) {
        std::vector<Ray> rays;
        for (int i = 0; i < 256; ++i) {
            Ray ray;
            ray.origin = {1, -3, 6};
            ray.direction = Vec3(-2.2 + 4.4 * (tile % 8 * 16 + i % 16) / 127, -2.2 + 4.4 * (tile / 8 * 16 + i / 16) / 127, 0) - ray.origin;
            rays.push_back(ray);
        }
        std::vector<Hit> x(256), y(256);
        std::array<bool, 256> fx{}, fy{};
        first_hits(*coarse, rays.data(), 256, HUGE_VAL, a, x.data(), fx.data());
        first_hits(*fine, rays.data(), 256, HUGE_VAL, c, y.data(), fy.data());
        for (std::size_t i = 0; i < 256; ++i) {
            met += fx[i];
            CHECK((fx[i] == fy[i] && (!fx[i] || same_bits(x[i], y[i]))));
        }
    }
    CHECK(met > 8000);
    CHECK(a.counters.skipped_by(EnginePass::kCoarse) > 12000);
    CHECK(c.counters.skipped_by(EnginePass::kCoarse) == 0);
}

TEST_CASE("float is not asked where it has no numbers for the rays") {
    SolidBuilder b;
    const auto program = compiled(b.finish(use_of(b.shape(shape::Box{Vec3(-1), Vec3(1)}))));
    const auto found_in_float = [&](const Vec3& eye, double length, double spread) {
        std::vector<Ray> rays;
        for (int i = 0; i < 256; ++i) {
            Ray ray;
            ray.origin = eye + Vec3(spread * i, 0, 0);
            ray.direction = length * (Vec3(-0.01 + 0.02 * (i % 16) / 15, -0.01 + 0.02 * (i / 16) / 15, 0) - eye);
            rays.push_back(ray);
        }
        Scratch scratch;
        Tally tally;
        CHECK(differing(*program, rays, HUGE_VAL, tally) == 0);
        std::vector<Hit> hits(256);
        std::array<bool, 256> found{};
        first_hits(*program, rays.data(), 256, HUGE_VAL, scratch, hits.data(), found.data());
        return scratch.counters.skipped_by(EnginePass::kCoarse);
    };
    CHECK(found_in_float({2, 3, 5}, 1, 0) > 240);
    CHECK(found_in_float({2, 3, 5}, 1, 1e-9) == 0);   // rays of more than one origin
    CHECK(found_in_float({2, 3, 5}, 1e-30, 0) == 0);  // directions whose squares are none of float's
    CHECK(found_in_float({2, 3, 5}, 1e30, 0) == 0);
    CHECK(found_in_float({2e9, 3e9, 5e9}, 1e-9, 0) == 0);  // so far that a product of lengths is none
    CHECK(found_in_float({0.1, 0.2, 0.3}, 1, 0) == 0);     // inside
}
