// facets_test.cpp — cells of many planes: the tree over them drops only what no line feels; they are the solids that their corners span; packets know them.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

#include "csg/solid/facets.h"
#include "tests/support/random_solid.h"
#include "tests/support/use.h"
#include "tests/tracer/engine/rays.h"
#include "tracer/engine/facet_tree.h"

using namespace whittle;
using namespace whittle::support;
using namespace whittle::testing;

namespace {

std::vector<FacetPlane> random_polytope(Random& random, int count) {
    std::vector<FacetPlane> planes;
    for (int i = 0; i < count; ++i) {
        Vec3 n = random.point({Vec3(-1), Vec3(1)});
        if (i % 4 == 0) n.z = 0;                    // as a prism's
        if (i % 9 == 1) n = Vec3(0, 0, i % 2 ? 1 : -1);  // many of one direction
        n /= glm::length(n);
        planes.push_back({n, random.between(0.5, 2)});
    }
    return planes;
}

struct Narrowed {
    long double in = -HUGE_VALL, out = HUGE_VALL;
};

Narrowed narrowed(const std::vector<FacetPlane>& planes, const std::vector<std::uint32_t>& which, const Vec3& from, const Vec3& along) {
    Narrowed r;
    for (const std::uint32_t i : which) {
        const FacetPlane& p = planes[i];
        long double v = -p.d, s = 0;
        for (int k = 0; k < 3; ++k) v += static_cast<long double>(p.n[k]) * from[k], s += static_cast<long double>(p.n[k]) * along[k];
        if (s < 0) r.in = std::max(r.in, -v / s);
        if (s > 0) r.out = std::min(r.out, -v / s);
        if (s == 0 && v > 0) r.in = HUGE_VALL;
    }
    return r;
}

const std::vector<Placement> kPlacements{Placement(),
                                         {{0, -2, 0, 1, 0, 0, 3, 2, 1, 0, 0, 3}},                              // axes changed and stretched
                                         {{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}},                              // mirrored
                                         {{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1.5, 4}},                            // mirrored twice
                                         {{0.8, -0.6, 0, 0, 0.48, 0.64, -0.6, 0, 0.36, 0.48, 0.8, 0}},         // turned
                                         {{1, 0.3, 0, 0, 0, 1, 0.2, 0, 0.1, 0, -1, 0}}};                       // sheared and mirrored

const std::vector<Shape> kFaceted{shape::FacetedFrustum{-1, 2, 2, 1, 40}, shape::FacetedFrustum{-1, 2, 1, 2, 5}, shape::FacetedFrustum{-1, 2, 2, 0, 100},
                                  shape::FacetedFrustum{-1, 2, 0, 2, 17}, shape::FacetedFrustum{-1, 2, 2, 2, 64}, shape::FacetedBall{2, 4},
                                  shape::FacetedBall{2, 5}, shape::FacetedBall{2, 30}, shape::FacetedBall{2, 90}};

}  // namespace

TEST_CASE("the planes found for a line give the interval that all planes give, on every instruction set") {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        Random random(3);
        for (const int count : {1, 8, 12, 16, 17, 100, 1000}) {
            const std::vector<FacetPlane> planes = random_polytope(random, count);
            std::vector<std::uint32_t> all(planes.size());
            for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
            std::vector<FacetChunk> chunks;
            const Vec3 centre(5, -3, 1);
            const FacetTree tree = build_facet_tree(planes, centre, chunks);
            FacetSearch search;
            std::size_t asked = 0, inside = 0;
            for (int k = 0; k < 300; ++k) {
                Ray ray = random.ray_through({Vec3(-1), Vec3(1)});
                if (k % 5 == 0) ray.direction = {0, k % 2 ? 0.0 : -0.0, k % 10 ? 1.0 : -1.0};
                if (k % 7 == 0) ray.origin *= 1000;
                const FacetLines line = facet_line(tree, ray.origin + centre, ray.direction);
                const Narrowed expected = narrowed(planes, all, ray.origin, ray.direction);
                const bool met = search.run(chunks, tree, line);
                INFO(count << " planes, line " << k);
                if (!met) CHECK(expected.in > expected.out);
                if (!met || expected.in > expected.out) continue;
                ++inside;
                asked += search.found().size();
                const Narrowed found = narrowed(planes, search.found(), ray.origin, ray.direction);
                CHECK(found.in == expected.in);
                CHECK(found.out == expected.out);
            }
            CHECK(inside > 20);
            if (count == 1000) CHECK(asked < 60 * inside);
        }
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST_CASE("balls, cones and cylinders of facets are the solids that their corners span") {
    for (const Shape& shape : kFaceted)
        for (const Placement& placement : kPlacements) {
            SolidBuilder b, c;
            const Solid cell = b.finish(use(b.shape(shape), placement));
            const auto corners = facets_of(cell, cell.root().node);
            REQUIRE(corners);
            const Solid mesh = c.finish(use(c.shape(shape::Polyhedron{std::make_shared<const FacetList>(*corners)}), placement));
            const auto one = compiled(cell), other = compiled(mesh);
            Scratch scratch;
            Spans spans, expected;
            Random random(5);
            int met = 0;
            for (int k = 0; k < 60; ++k) {
                const Ray ray = random.ray_through(program_bounds(*one));
                all_spans(*one, ray, scratch, spans);
                all_spans(*other, ray, scratch, expected);
                INFO(support::to_text(ray));
                REQUIRE(spans.size() == expected.size());
                for (std::size_t i = 0; i < spans.size(); ++i) {
                    ++met;
                    CHECK(spans[i].in.has_value() == expected[i].in.has_value());
                    if (spans[i].in && expected[i].in) CHECK(spans[i].in->t == Approx(expected[i].in->t).epsilon(1e-9).margin(1e-9));
                    if (spans[i].out && expected[i].out) CHECK(spans[i].out->t == Approx(expected[i].out->t).epsilon(1e-9).margin(1e-9));
                }
            }
            CHECK(met > 10);
        }
}

TEST_CASE("packets know balls, cones and cylinders of facets") {
    for (const Shape& shape : kFaceted)
        for (const Placement& placement : kPlacements) {
            SolidBuilder b;
            const auto program = compiled(b.finish(use(b.shape(shape), placement)));
            std::vector<Ray> rays;
            const Bounds box = program_bounds(*program);
            const Vec3 middle = 0.5 * (box.lo + box.hi), eye = middle + Vec3(11, -13, 7.5);
            for (int i = 0; i < 256; ++i) {
                Ray ray;
                ray.origin = eye;
                ray.direction = middle + Vec3(-2 + 4.0 * (i % 16) / 15, -2 + 4.0 * (i / 16) / 15, 0.1) - eye;
                rays.push_back(ray);
            }
            Scratch many, single;
            std::vector<Hit> hits(rays.size());
            const auto found = std::make_unique<bool[]>(rays.size());
            first_hits(*program, rays.data(), 256, HUGE_VAL, many, hits.data(), found.get());
            int wrong = 0, met = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                Hit one;
                const bool is = first_hit(*program, rays[i], HUGE_VAL, single, one);
                met += is;
                wrong += is != found[i] || (is && (one.end.t != hits[i].end.t || one.end.surface != hits[i].end.surface || one.end.normal != hits[i].end.normal));
            }
            INFO("shape " << shape.index() << ", " << many.counters.packet_deferred << " alone");
            CHECK(wrong == 0);
            CHECK(met > 20);
            CHECK(many.counters.packet_rays > 240);
        }
}
