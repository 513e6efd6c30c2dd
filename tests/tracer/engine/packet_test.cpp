// packet_test.cpp — packets give what single rays give, to the bit, on every instruction set this machine has.
#include <catch2/catch.hpp>

#include <hwy/targets.h>

#include "tests/support/random_solid.h"
#include "tests/tracer/engine/packets.h"

using namespace whittle;
using namespace whittle::support;
using namespace whittle::testing;

namespace {

constexpr double k_light = 1;

}  // namespace

TEST_CASE("packets give the hits of single rays, to the bit, on every instruction set") {
    const std::uint64_t seed = Catch::rngSeed() == 0 ? 1 : Catch::rngSeed();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        Tally tally;
        for (int theme = 0; theme < kThemes; ++theme)
            for (std::uint64_t i = 0; i < 12; ++i) {
                const RandomSolid solid = random_solid(static_cast<Theme>(theme), seed * 1000 + i);
                const auto program = compile(solid.solid);
                if (!program) continue;
                std::mt19937_64 random(i);
                for (int k = 0; k < 4; ++k) {
                    const std::vector<Ray> rays = tile_around(random_ray(solid, random), 1 + static_cast<int>(random() % 256), k % 2 == 0 ? 1e-3 : 0x1p-7);
                    const double t_max = k == 3 ? 1.0 : HUGE_VAL;
                    INFO(hwy::TargetName(target) << " " << name_of(static_cast<Theme>(theme)) << " " << seed * 1000 + i << " ray " << to_text(rays.front()));
                    CHECK(differing(**program, rays, t_max, tally) == 0);
                }
            }
        CHECK(tally.hits > 5000);
        CHECK(tally.in_packets > 10000);
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST_CASE("a tile's rays along an axis, and rays that do not go together, have the hits of single rays") {
    SolidBuilder b;
    const NodeId plate = b.shape(shape::Box{Vec3(-2, -2, 0), Vec3(2, 2, 1)}), drill = b.shape(shape::Frustum{-1, 2, 0.5, 0.5});
    const auto at = [](NodeId node, double x) { return Use{node, kNoLabel, 0, Placement::translation({x, 0, 0})}; };
    const auto program = compiled(b.finish(at(b.combine(SetOp::kDifference, {at(plate, 0), at(drill, -1), at(drill, 1)}), 0)));
    std::vector<Ray> down, anyhow;
    Random random(3);
    for (int i = 0; i < 256; ++i) {
        Ray ray;
        ray.origin = {-2.5 + 5.0 * (i % 16) / 15, -2.5 + 5.0 * (i / 16) / 15, 5};
        ray.direction = {0, 0, -1};
        down.push_back(ray);
        anyhow.push_back(random.ray_through({Vec3(-2), Vec3(2)}));
    }
    Tally tally;
    CHECK(differing(*program, down, HUGE_VAL, tally) == 0);
    CHECK(differing(*program, anyhow, HUGE_VAL, tally) == 0);
    CHECK(tally.hits > 200);
    CHECK(tally.in_packets > 300);
}

TEST_CASE("a tile's rays meet prisms, convex and not, placed anyhow, as single rays do") {
    using Ring = std::vector<Vec2>;
    const std::vector<Ring> rings{{{-3, -2}, {3, -2}, {4, 0}, {3, 2}, {-3, 2}},           // convex
                                  {{-3, 2}, {3, 2}, {4, 0}, {3, -2}, {-3, -2}},           // the other way round
                                  {{-3, -2}, {3, -2}, {0, -0.5}, {3, 2}, {-3, 2}},        // not convex
                                  {{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}}};          // a star that goes around twice
    const std::vector<Placement> placements{Placement(), {{0, 1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 0}}, {{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}}, {{0.8, -0.6, 0, 0, 0.48, 0.64, -0.6, 0, 0.36, 0.48, 0.8, 0}}};
    Tally tally;
    for (const Ring& ring : rings)
        for (const Placement& placement : placements) {
            SolidBuilder b;
            const NodeId flat = b.shape(shape::Polygon{std::make_shared<const std::vector<Ring>>(std::vector<Ring>{ring})});
            const NodeId prism = b.shape(shape::Extrusion{flat, -1, 1, 0, Vec2(1), 0}), gon = b.shape(shape::FacetedFrustum{-2, 2, 0.7, 0.7, 9});
            const auto use = [](NodeId node, const Placement& at) { return Use{node, kNoLabel, 0, at}; };
            const auto program = compiled(b.finish(use(b.combine(SetOp::kDifference, {use(prism, Placement()), use(gon, Placement())}), placement)));
            Random random(9);
            for (int k = 0; k < 20; ++k) {
                Ray ray = random.ray_through({Vec3(-3), Vec3(3)});
                INFO(to_text(ray));
                CHECK(differing(*program, tile_around(ray, 256, 0x1p-7), HUGE_VAL, tally) == 0);
            }
        }
    CHECK(tally.hits > 10000);
    CHECK(tally.in_packets > 20000);
}

TEST_CASE("a tile's rays meet a union of many turned parts, whole and half behind a window, as single rays do") {
    constexpr int kSide = 5;  // 125 parts of five leaves: more than are looked at in one window
    SolidBuilder b;
    const auto use = [](NodeId node, const Placement& at) { return Use{node, kNoLabel, 0, at}; };
    const NodeId drill = b.shape(shape::Frustum{-1.1, 1.1, 0.75, 0.75});
    const Placement to_x{{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}}, to_y{{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0}};
    const NodeId part = b.combine(SetOp::kDifference, {use(b.shape(shape::Box{Vec3(-1), Vec3(1)}), Placement()), use(b.shape(shape::Ellipsoid{Vec3(1.2)}), Placement()),
                                                       use(drill, to_x), use(drill, to_y), use(drill, Placement())});
    Random random(6);
    std::vector<Use> parts;
    for (int k = 0; k < kSide * kSide * kSide; ++k) {
        Vec3 x, y;
        do x = random.ray_through({Vec3(-1), Vec3(1)}).direction, y = glm::cross(x, Vec3(0.3, 0.5, 0.8));
        while (glm::length(x) == 0 || glm::length(y) < 0.1 * glm::length(x));
        x = glm::normalize(x), y = glm::normalize(y);
        const Vec3 z = glm::cross(x, y), at = Vec3(k % kSide, k / kSide % kSide, k / kSide / kSide) * 3.0;
        parts.push_back(use(part, {{x.x, y.x, z.x, at.x, x.y, y.y, z.y, at.y, x.z, y.z, z.z, at.z}}));
    }
    const auto program = compiled(b.finish(use(b.combine(SetOp::kUnion, std::move(parts)), Placement())));
    Tally tally;
    for (int i = 0; i < 60; ++i) {
        Ray ray;
        ray.origin = {30, 25, 40};
        const Ray target = random.ray_through({Vec3(0), Vec3(12)});
        ray.direction = glm::normalize(target.origin + target.direction - ray.origin);
        INFO(i);
        CHECK(differing(*program, tile_around(ray, 256, 4e-3 * (1 + i % 3)), HUGE_VAL, tally) == 0);
    }
    CHECK(tally.hits > 2000);
    CHECK(tally.in_packets > 5000);
}

TEST_CASE("a tile's rays meet a deep tree, cut up by an octree, as single rays do") {
    SolidBuilder b;
    Random random(5);
    const auto use = [](NodeId node, const Placement& at) { return Use{node, kNoLabel, 0, at}; };
    const auto tree = [&](const auto& self, int depth) -> NodeId {
        if (depth == 9) {
            const Ray r = random.ray_through({Vec3(-0.5), Vec3(0.5)});
            const Vec3 at = r.origin + r.direction;
            return b.combine(SetOp::kUnion, {use(b.shape(shape::Ellipsoid{Vec3(0.9 + 0.2 * at.x)}), Placement::translation(at))});
        }
        constexpr SetOp kOps[] = {SetOp::kUnion, SetOp::kDifference, SetOp::kIntersection};
        const NodeId left = self(self, depth + 1), right = self(self, depth + 1);
        return b.combine(kOps[depth % 3], {use(left, Placement()), use(right, Placement())});
    };
    const auto program = compiled(b.finish(use(tree(tree, 0), Placement())));
    Tally tally;
    for (int i = 0; i < 40; ++i) {
        Ray ray = random.ray_through({Vec3(-0.6), Vec3(0.6)});
        ray.origin *= 4 / glm::length(ray.origin);
        ray.direction = glm::normalize(-ray.origin);
        INFO(to_text(ray));
        CHECK(differing(*program, tile_around(ray, 256, 4e-3), HUGE_VAL, tally) == 0);
    }
    CHECK(tally.hits > 1000);
    CHECK(tally.in_packets > 5000);
}

TEST_CASE("shadow rays in packets are blocked where single rays are, on every instruction set") {
    const std::uint64_t seed = Catch::rngSeed() == 0 ? 1 : Catch::rngSeed();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        int blocked_rays = 0, free_rays = 0;
        std::uint64_t in_packets = 0;
        for (int theme = 0; theme < kThemes; ++theme)
            for (std::uint64_t i = 0; i < 8; ++i) {
                const RandomSolid solid = random_solid(static_cast<Theme>(theme), seed * 1000 + i);
                const auto program = compile(solid.solid);
                if (!program) continue;
                std::mt19937_64 random(i);
                Scratch scratch, alone;
                std::vector<Ray> rays = tile_around(random_ray(solid, random), 256, 1e-2), shadows;
                std::vector<Hit> hits(rays.size());
                const auto found = std::make_unique<bool[]>(rays.size());
                first_hits(**program, rays.data(), 256, HUGE_VAL, scratch, hits.data(), found.get());
                const Vec3 light = rays.front().origin + Vec3(3, 5, 7) * glm::length(rays.front().direction);
                for (std::size_t k = 0; k < rays.size(); ++k) {
                    if (!found[k]) continue;
                    Ray shadow;
                    shadow.origin = hits[k].point;
                    shadow.direction = light - hits[k].point;
                    shadow.departure = &hits[k].departure;
                    shadows.push_back(shadow);
                }
                std::vector<double> t_max(shadows.size(), k_light);
                const auto blocked = std::make_unique<bool[]>(shadows.size());
                any_hits(**program, shadows.data(), t_max.data(), static_cast<int>(shadows.size()), scratch, blocked.get());
                in_packets += scratch.counters.packet_rays;
                int wrong = 0;
                for (std::size_t k = 0; k < shadows.size(); ++k) {
                    wrong += blocked[k] != any_hit(**program, shadows[k], t_max[k], alone);
                    ++(blocked[k] ? blocked_rays : free_rays);
                }
                INFO(hwy::TargetName(target) << " " << name_of(static_cast<Theme>(theme)) << " " << seed * 1000 + i);
                CHECK(wrong == 0);
            }
        CHECK(blocked_rays > 300);
        CHECK(free_rays > 300);
        CHECK(in_packets > 1000);
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST_CASE("packets tell whose face a plane shows that several bodies share") {
    for (int which = 0; which < 3; ++which) {
        SolidBuilder b;
        const auto use = [](NodeId node, const Vec3& at) { return Use{node, kNoLabel, 0, Placement::translation({at.x, at.y, at.z})}; };
        const auto bar = [&](double r0, double r1, double h) { return b.shape(shape::FacetedFrustum{0, h, r0, r1, 40}); };
        const NodeId turned = b.combine(SetOp::kUnion, {use(bar(25, 25, 16), Vec3(0)), use(bar(28, 26, 2), Vec3(0)), use(bar(26, 28, 2), {0, 0, 14})});
        const NodeId boxes = b.combine(SetOp::kUnion, {use(b.shape(shape::Box{Vec3(-20, -20, 0), Vec3(20, 20, 16)}), Vec3(0)), use(turned, Vec3(0))});
        const NodeId drilled = b.combine(SetOp::kDifference, {use(boxes, Vec3(0)), use(bar(4, 4, 20), {5, 0, -1}), use(bar(4, 4, 3), {-9, 0, 13})});
        const auto program = compiled(b.finish(use(which == 0 ? turned : which == 1 ? boxes : drilled, Vec3(0))));
        Tally tally;
        Random random(8);
        for (int k = 0; k < 20; ++k) {
            Ray ray = random.ray_through({Vec3(-25, -25, 0), Vec3(25, 25, 16)});
            ray.origin.z = 60 + std::abs(ray.origin.z);
            ray.direction = random.point({Vec3(-20, -20, 16), Vec3(20, 20, 16)}) - ray.origin;
            INFO(to_text(ray));
            CHECK(differing(*program, tile_around(ray, 256, 0x1p-10), HUGE_VAL, tally) == 0);
        }
        CHECK(tally.hits > 4000);
        CHECK(tally.in_packets > 5000);
    }
}

TEST_CASE("packets know cones, ellipsoids, tubes and other quadrics, and shadow rays that leave them") {
    const std::vector<Shape> shapes{shape::Frustum{-1, 1, 1, 0.4}, shape::Frustum{-1, 1, 0, 1.2}, shape::Ellipsoid{{1, 0.6, 1.3}},
                                    shape::Capsule{{-0.7, -0.2, 0.1}, {0.6, 0.5, -0.4}, 0.5}, shape::Quadric{{1, 1, -0.5, 0.1, 0, 0.2, 0, 0, 0, -0.4}}};
    const std::vector<Placement> placements{Placement(), {{0, -1.5, 0, 1, 1, 0, 0, 2, 0, 0, 1, 0}}, {{0.8, -0.6, 0, 0, 0.48, 0.64, -0.6, 0, 0.36, 0.48, 0.8, 0}},
                                            {{1, 0.3, 0, 0, 0, 1, 0.2, 0, 0.1, 0, -1, 0}}};
    std::uint64_t asked = 0, in_packets = 0, shadow_rays = 0, shadows_in_packets = 0;
    int blocked_rays = 0;
    for (const Shape& shape : shapes)
        for (const Placement& placement : placements) {
            SolidBuilder b;
            const auto use = [](NodeId node, const Placement& at) { return Use{node, kNoLabel, 0, at}; };
            const NodeId box = b.shape(shape::Box{Vec3(-1), Vec3(1)}), floor = b.shape(shape::Box{Vec3(-4, -4, -2), Vec3(4, 4, -1.5)});
            const NodeId part = b.combine(SetOp::kIntersection, {use(box, Placement()), use(b.shape(shape), Placement())});
            const auto program = compiled(b.finish(use(b.combine(SetOp::kUnion, {use(part, Placement()), use(floor, Placement())}), placement)));
            const Bounds bounds = program_bounds(*program);
            Random random(9);
            for (int k = 0; k < 8; ++k) {
                const std::vector<Ray> rays = tile_around(random.ray_through(bounds), 256, 0x1p-9);
                Tally tally;
                INFO("shape " << shape.index() << " " << to_text(rays.front()));
                CHECK(differing(*program, rays, HUGE_VAL, tally) == 0);
                asked += rays.size();
                in_packets += tally.in_packets;
                Scratch scratch, many, alone;
                for (const Ray& ray : rays) {
                    Hit hit;
                    if (!first_hit(*program, ray, HUGE_VAL, scratch, hit)) continue;
                    Ray shadow;
                    shadow.origin = hit.point;
                    shadow.direction = bounds.hi + Vec3(3, 4, 5) - hit.point;
                    shadow.departure = &hit.departure;
                    bool one = false;
                    any_hits(*program, &shadow, &k_light, 1, many, &one);
                    CHECK(one == any_hit(*program, shadow, k_light, alone));
                    blocked_rays += one;
                    ++shadow_rays;
                }
                shadows_in_packets += many.counters.packet_rays;
            }
        }
    CHECK(in_packets > asked * 95 / 100);
    CHECK(shadow_rays > 5000);
    CHECK(blocked_rays > 500);
    CHECK(shadows_in_packets > shadow_rays * 9 / 10);
}
