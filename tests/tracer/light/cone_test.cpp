// Cone tracing: one cone a pixel against many rays.
#include "scenes.h"

#include <cmath>

#include "tracer/engine/cone.h"
#include "tracer/light/scattering.h"

using namespace whittle;
using namespace whittle::test;

namespace {

double rms_difference(const Film& a, const Film& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Vec3 d = a.color(i) - b.color(i);
        sum += glm::dot(d, d) / 3;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

RenderOptions picture_options(Integrator integrator, int samples) {
    RenderOptions o = small_options();
    o.width = 48;
    o.height = 36;
    o.samples = samples;
    o.integrator = integrator;
    o.filter = FilterKind::kBox;
    return o;
}

struct Errors {
    double cone = 0, ray = 0;
    std::uint64_t cone_rays = 0;
};

// Of one cone and of one ray a pixel, against `samples` rays.
Errors errors(const Solid& solid, const RenderScene& scene, Integrator plain, Integrator converged, int samples) {
    const Film reference = drawn(solid, scene, picture_options(converged, samples)).film;
    const RenderResult cone = drawn(solid, scene, picture_options(Integrator::kCone, 1));
    CHECK(cone.integrator == Integrator::kCone);
    CHECK(all_finite(cone.film));
    return {rms_difference(cone.film, reference), rms_difference(drawn(solid, scene, picture_options(plain, 1)).film, reference), cone.counters.camera};
}

RenderScene from_the_side(std::vector<Light> lights) {
    RenderScene scene;
    scene.camera = looking(Vec3(60, -80, 60), Vec3(0, 0, 2), 24);
    scene.lights = std::move(lights);
    return scene;
}

}  // namespace

TEST_CASE("a disc cut through its middle has two halves, cut at its rim nothing is cut off") {
    CHECK(cut_disc(0).share == Approx(0.5));
    CHECK(cut_disc(0).centroid == Approx(4 / (3 * kPi)));
    CHECK(cut_disc(1).share == 0);
    // At half the radius: (acos 1/2 - 1/2 sqrt 3/4) / pi.
    CHECK(cut_disc(0.5).share == Approx((kPi / 3 - 0.5 * std::sqrt(0.75)) / kPi));
    CHECK(cut_disc(0.5).centroid > 0.5);
}

TEST_CASE("a cone that passes a box's edge is cut where the edge is, one that passes far is not") {
    SceneBuilder b;
    b.add(b.box(Vec3(-10, -10, -10), Vec3(0, 10, 10)));
    const auto program = compile(b.finish());
    REQUIRE(program);
    ConeSplitter splitter;
    Cone cone;
    cone.start = 2;
    cone.axis.direction = Vec3(0, 0, -1);
    for (double x : {-0.6, -0.1, 0.3, 0.9}) {
        cone.axis.origin = Vec3(2 * x, 0, 50);
        const ConeParts parts = splitter.split(**program, cone, x < 0 ? 40 : HUGE_VAL);
        INFO("x = " << x);
        REQUIRE(parts.count == 2);
        const ConePart &less = parts.part[x < 0 ? 1 : 0], &more = parts.part[x < 0 ? 0 : 1];
        CHECK(more.share == Approx(1 - cut_disc(std::abs(x)).share));
        CHECK(less.share == Approx(cut_disc(std::abs(x)).share));
        CHECK(less.off.x == Approx((x < 0 ? 2 : -2) * cut_disc(std::abs(x)).centroid));
        CHECK(less.off.y == Approx(0).margin(1e-12));
        CHECK(parts.part[0].t == Approx(40));
        // Both parts together have their middle on the axis.
        CHECK(glm::length(parts.part[0].share * parts.part[0].off + parts.part[1].share * parts.part[1].off) < 1e-12);
    }
    cone.axis.origin = Vec3(3, 0, 50);
    CHECK(!splitter.split(**program, cone, HUGE_VAL).divided());
    cone.axis.origin = Vec3(-5, 0, 50);
    CHECK(!splitter.split(**program, cone, 40).divided());
}

TEST_CASE("a ball's silhouette and a drilled hole's rim cut cones") {
    SceneBuilder b;
    b.add(b.combined(SetOp::kDifference, {b.ball(10), b.rod(-20, 20, 4)}));
    const auto program = compile(b.finish());
    REQUIRE(program);
    ConeSplitter splitter;
    Cone cone;
    cone.start = 0.5;
    cone.axis.direction = Vec3(0, 0, -1);
    const auto share_at = [&](double x, double t_hit) {
        cone.axis.origin = Vec3(x, 0, 50);
        const ConeParts parts = splitter.split(**program, cone, t_hit);
        return parts.divided() ? parts.part[0].share : 0;
    };
    CHECK(share_at(10.2, HUGE_VAL) == Approx(cut_disc(0.4).share).epsilon(0.03));
    CHECK(share_at(9.9, 50 - std::sqrt(100 - 9.9 * 9.9)) == Approx(1 - cut_disc(0.2).share).epsilon(0.03));
    CHECK(share_at(3.8, HUGE_VAL) == Approx(cut_disc(0.4).share).margin(0.03));
    CHECK(share_at(7, 50 - std::sqrt(51.0)) == 0);
}

TEST_CASE("a box's corner parts a cone in two areas whose shares are those of its quadrants") {
    SceneBuilder b;
    b.add(b.box(Vec3(-10, -10, -10), Vec3(0, 0, 10)));
    const auto program = compile(b.finish());
    REQUIRE(program);
    ConeSplitter splitter;
    Cone cone;
    cone.start = 1;
    cone.axis.direction = Vec3(0, 0, -1);
    cone.axis.origin = Vec3(0.1, 0.05, 50);
    const ConeParts parts = splitter.split(**program, cone, HUGE_VAL);
    double sum = 0, inside = 0;
    for (const ConePart& p : parts) {
        sum += p.share;
        const Vec3 at = cone.axis.origin + p.off;
        if (at.x < 0 && at.y < 0) inside += p.share;
    }
    CHECK(sum == Approx(1));
    // The quadrant's area less the strips of 0.1 and 0.05 along its sides, 1 / pi of the disc each.
    CHECK(inside == Approx(0.25 - (0.1 + 0.05) / kPi + 0.005 / kPi).margin(0.03));
}

TEST_CASE("a side that the axis never crosses parts nothing, however far the cone goes") {
    // The axis runs along the box's side, 0.1 beside it, and meets neither it nor anything else.
    SceneBuilder b;
    b.add(b.box(Vec3(-10, -10, -10), Vec3(0, 10, 10)));
    const auto program = compile(b.finish());
    REQUIRE(program);
    ConeSplitter splitter;
    for (double spread : {0.0, 0.01}) {
        Cone cone;
        cone.start = 0.2;
        cone.spread = spread;
        cone.axis.direction = Vec3(0, 0, -1);
        cone.axis.origin = Vec3(0.1, 0, 50);
        for (const ConePart& p : splitter.split(**program, cone, HUGE_VAL)) {
            CHECK(std::isfinite(p.t));
            CHECK(std::isfinite(p.off.x + p.off.y + p.off.z));
        }
    }
}

TEST_CASE("where a cone's rays come from widens it near, what they go to widens it far") {
    SceneBuilder b;
    b.add(b.box(Vec3(0, -50, 0), Vec3(50, 50, 1)));
    const auto program = compile(b.finish());
    REQUIRE(program);
    ConeSplitter splitter;
    Cone cone;
    cone.axis.direction = Vec3(0, 0, -1);
    cone.near_u = Vec3(2, 0, 0);
    cone.near_v = Vec3(0, 1e-9, 0);
    cone.far_u = Vec3(0, 4, 0);
    cone.far_v = Vec3(1, 0, 0);
    cone.reach = 100;
    // At a quarter of the way the halves are 1.5 and 0.25 along x.
    cone.axis.origin = Vec3(-0.5, 0, 26);
    const double half = std::sqrt(1.5 * 1.5 + 0.25 * 0.25);
    const ConeParts parts = splitter.split(**program, cone, HUGE_VAL);
    REQUIRE(parts.count == 2);
    CHECK(parts.part[0].share == Approx(cut_disc(0.5 / half).share));
    CHECK(parts.part[0].off.x == Approx(half * cut_disc(0.5 / half).centroid));
}

TEST_CASE("one cone a pixel smooths edges that one ray leaves jagged") {
    const Solid solid = classic();
    PointLight p;
    p.p = Vec3(40, -30, 90);
    const Errors e = errors(solid, from_the_side({lamp(p), around(Vec3(0.3))}), Integrator::kWhitted, Integrator::kWhitted, 64);
    CHECK(e.cone_rays == 48 * 36);
    CHECK(e.cone < 0.5 * e.ray);
}

TEST_CASE("one cone to a lamp draws its soft shadow") {
    SceneBuilder b;
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), matte(1, 1, 1)));
    b.add(b.box(Vec3(-4, -4, 0), Vec3(4, 4, 14), matte(0.6, 0.2, 0.2)));
    PointLight p;
    p.p = Vec3(30, 30, 60);
    p.radius = 8;
    const Errors e = errors(b.finish(), from_the_side({lamp(p), around(Vec3(0.2))}), Integrator::kWhitted, Integrator::kDistributed, 100);
    CHECK(e.cone < 0.6 * e.ray);
}

TEST_CASE("one cone in a rough mirror blurs its image") {
    SceneBuilder b;
    Material floor = preset("steel");
    floor.roughness = 0.25;
    b.add(b.box(Vec3(-60, -60, -1), Vec3(60, 60, 0), floor));
    b.add(b.box(Vec3(-4, -4, 0), Vec3(4, 4, 14), matte(0.8, 0.2, 0.1)));
    const Errors e = errors(b.finish(), from_the_side({around(Vec3(1))}), Integrator::kWhitted, Integrator::kDistributed, 100);
    CHECK(e.cone < e.ray);
}
