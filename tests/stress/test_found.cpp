// test_found.cpp — what random comparison has found, one small case each; kept so that it stays found.
#include <catch2/catch.hpp>

#include "tests/stress/compare.h"
#include "tests/support/random_solid.h"
#include "tests/support/use.h"

using namespace whittle;
using namespace whittle::support;
using namespace whittle::stress;

namespace {

Ray ray(Vec3 origin, Vec3 direction) {
    Ray r;
    r.origin = origin;
    r.direction = direction;
    return r;
}

// What differs from the reference on the ray, and on rays that leave its first border.
std::string fault(const Solid& solid, const Ray& r) {
    const Subject subject = subject_of(solid, true);
    if (!subject.program) return subject.failure;
    Scratch scratch;
    std::mt19937_64 random(1);
    Tally tally;
    std::string why = disagreement(subject, r, scratch, random, tally);
    for (int i = 0; i < 20 && why.empty(); ++i) why = continuation_disagreement(subject, r, scratch, random, tally);
    return why;
}

}  // namespace

TEST_CASE("a profile left of the axis turns into nothing") {
    SolidBuilder b({false, false, false});
    const NodeId left = b.combine(SetOp::kUnion, {use(b.shape(shape::Rectangle{{0, -1.75}, {1.75, 1.75}}), moved(-1.75, 1.75, 0))});
    const NodeId turned = b.shape(shape::Revolution{left, 0, 360, 0});
    const auto program = compile(b.finish(use(b.combine(SetOp::kUnion, {use(turned), use(b.shape(shape::Box{{5, 5, 5}, {6, 6, 6}}))}))));
    REQUIRE(program);
    Scratch scratch;
    Spans spans;
    all_spans(**program, ray({-4, 0.1, 1}, {1, 0, 0}), scratch, spans);
    CHECK(spans.empty());
}

TEST_CASE("a border at the origin has t = 0, never less") {
    SolidBuilder b;
    const Solid solid = b.finish(use(b.shape(shape::Torus{1, 1}), Placement{{1.1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}));
    CHECK(fault(solid, ray({0x1.199999999999ap+0, 0, 1}, {1, 0, -1})).empty());
}

TEST_CASE("a ray that leaves the solid at its origin still meets what comes later") {
    SolidBuilder b;
    const NodeId above = b.shape(shape::HalfSpace{{0, 0, -1}, 0}), ball = b.shape(shape::Ellipsoid{{1.25, 1.25, 1.25}});
    const Solid solid = b.finish(use(b.combine(SetOp::kDifference, {use(above, moved(0, 0, -0.25)), use(ball)})));
    CHECK(fault(solid, ray({0, 0, 1.25}, {-1.25, 0, -1.25})).empty());
}

TEST_CASE("the ends of a span shorter than rounding are in order") {
    SolidBuilder b;
    const Solid solid = b.finish(use(b.shape(shape::Box{{-3, -3, -3}, {3, 3, 3}})));
    const auto program = compile(solid);
    REQUIRE(program);
    Scratch scratch;
    Spans spans;
    all_spans(**program, ray({0x1.c062ffebcf212p+1, -0x1.2946fc9508675p+1, -0x1.cb734eda5dfe2p+0}, {-0x1.018bffaf3c848p-1, 0x1.54a37e4a8433ap+2, 0x1.32dcd3b6977f8p+2}),
              scratch, spans);
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].in->t <= spans[0].out->t);
}

TEST_CASE("a scaled extrusion of nothing is nothing") {
    SolidBuilder b({false, false, false});
    const NodeId nothing = b.combine(SetOp::kDifference, {use(b.shape(shape::Rectangle{{0, 0}, {1, 1}})), use(b.shape(shape::Rectangle{{-1, -1}, {2, 2}}))});
    const NodeId extruded = b.shape(shape::Extrusion{nothing, 0, 1, 0, {0.5, 0.5}, 0});
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(extruded), use(b.shape(shape::Box{{-2, -2, -2}, {2, 2, 2}}))})));
    CHECK(fault(solid, ray({0.3, 0.3, -5}, {0.01, 0.02, 1})).empty());
}

// Known to fail where the engine still culls by boxes that do not contain the snap's displacement.
TEST_CASE("what the snap moves is not cut off by boxes") {
    SolidBuilder b;
    const NodeId profile = b.combine(SetOp::kUnion, {use(b.shape(shape::Rectangle{{0, -1.5}, {0.5, 1.5}}), moved(1.5, -1.5, 0))});
    const NodeId part = b.shape(shape::Revolution{profile, -45, 270, 0});
    constexpr double kNearlyOne = 0x1.fffffffffffc9p-1;
    const Placement nearly{{kNearlyOne, 0, 0, 0, 0, kNearlyOne, 0, 0, 0, 0, kNearlyOne, -0x1.b65eb45b6f084p-48}};
    const Solid solid = b.finish(use(b.combine(SetOp::kDifference, {use(part), use(part, nearly)}), moved(0.5, -1.5, 1.5)));
    CHECK(fault(solid, ray({0.5, -2.5, -1.5}, {0, 1, 0})).empty());
}

TEST_CASE("the first hit is the first border, however close the next events are") {
    const support::RandomSolid solid = support::random_solid(support::Theme::kLadder, 822133728416405116u);
    CHECK(fault(solid.solid, ray({0x1.24dea8b300a54p+1, 0x1.14832dd40e1e8p+0, 0x1.b05e0096227b2p-4},
                                 {-0x1.e8937e9e44be9p+6, -0x1.2723e9a507388p+6, 0x1.0fba293f43d21p+6})).empty());
}

TEST_CASE("a ray that starts on an edge and runs along the face beside it is not blocked before it enters") {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{{0, -1.75, -0x1.6666666666667p+0}, {0.5, 1.75, 0x1.6666666666667p+0}});
    const Placement turned{{0x1.ffffffffffc83p-1, 0, 0x1.de3864a2f41fap-22, 0, 0, 1, 0, 0, -0x1.de3864a2f41fap-22, 0, 0x1.ffffffffffc83p-1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(box), use(box, turned)})));
    CHECK(fault(solid, ray({0x1.000014ec1118p-1, 0x1.cp+0, 0x1.666662a9f5762p+0}, {-0x1.000014ec1118p-1, -0x1.cp+1, 0x1.de387828p-23})).empty());
}

TEST_CASE("a facet whose class lies along the ray is crossed in its own plane") {
    SolidBuilder b;
    const Placement turned{{0x1.bb67ae8584caap-1, -0.5, 0, 0, 0.5, 0x1.bb67ae8584caap-1, 0, 0, 0, 0, 1, 0}};
    const auto corners = std::vector<Vec3>{{0, 0, 0}, {0x1.fa8cb5df05fe7p+0, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
    const NodeId corner = b.shape(shape::Polyhedron{std::make_shared<const FacetList>(FacetList{corners, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}})});
    const Placement placed{{0x1.b02e9d942a513p-1, 0x1.3a9788e14dc81p-3, 0x1.0703f56dc5747p-1, 0, 0, -0x1.ea89e230351f9p-1, 0x1.255da5a560bb9p-2, 0,
                            0x1.1285c6e714b09p-1, -0x1.ef4372ef102c8p-3, -0x1.9e1100353b69bp-1, 0}};
    const NodeId both = b.combine(SetOp::kUnion, {use(b.shape(shape::Frustum{0, 0x1.fb36ae6b0a591p+0, 0, 0.5})), use(corner, turned)});
    CHECK(fault(b.finish(use(both, placed)), ray({0, 0, 0}, {0x1.3a9788e14dc81p-3, -0x1.ea89e230351f9p-1, -0x1.ef4372ef102c8p-3})).empty());
    const support::RandomSolid solid = support::random_solid(support::Theme::kInstances, 7659062266628665452u);
    CHECK(fault(solid.solid, ray({-0x1p-2, 0x1.0f876ccdf6cdap-1, -0x1.0f876ccdf6cdap-1}, {0x1.8p+0, 0x1.6a09e667f3bcdp+0, 0x1.6a09e667f3bcdp+0})).empty());
}

TEST_CASE("a turned edge that passes the axis ends there") {
    for (const bool cut : {false, true}) {
        SolidBuilder b;
        NodeId profile = b.shape(shape::Polygon{std::make_shared<const std::vector<std::vector<Vec2>>>(1, std::vector<Vec2>{{-0.5, -1.3}, {0.75, -1.3}, {-0.5, 0.3}})});
        if (cut) profile = b.combine(SetOp::kDifference, {use(profile), use(b.shape(shape::Rectangle{{-5, -5}, {0, 5}}))});
        const auto program = compile(b.finish(use(b.shape(shape::Revolution{profile, 0, 360, 0}))));
        REQUIRE(program);
        Scratch scratch;
        Spans spans;
        all_spans(**program, ray({-4, 0.01, 0.1}, {1, 0, 0}), scratch, spans);
        CHECK(spans.empty());
        all_spans(**program, ray({-4, 0.01, -1}, {1, 0, 0}), scratch, spans);
        CHECK(spans.size() == 1);
    }
}

TEST_CASE("what stands for a turned ellipse is near it and not certified") {
    SolidBuilder b({false, false, false});
    Placement stretched = moved(10, 0, 0);
    stretched.m[5] = 2;
    const NodeId ellipse = b.combine(SetOp::kUnion, {use(b.shape(shape::Disc{3}), stretched)});
    const auto program = compile(b.finish(use(b.shape(shape::Revolution{ellipse, 0, 360, 0}))));
    REQUIRE(program);
    Scratch scratch;
    Spans spans;
    all_spans(**program, ray({-20, 0, 0}, {1, 0, 0}), scratch, spans);
    REQUIRE(spans.size() == 2);
    CHECK(spans[0].in->t == Approx(7).margin(3 * 0x1p-11));
    CHECK(spans[1].out->t == Approx(33).margin(3 * 0x1p-11));
    CHECK(!spans[0].in->certified);
    std::vector<Ray> rays(64, ray({-20, 0, 0}, {1, 0, 0}));
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].direction = {1, 0.01 * static_cast<double>(i % 8), 0.01 * static_cast<double>(i / 8)};
    std::vector<Hit> hits(rays.size());
    const auto found = std::make_unique<bool[]>(rays.size());
    first_hits(**program, rays.data(), static_cast<int>(rays.size()), HUGE_VAL, scratch, hits.data(), found.get());
    for (std::size_t i = 0; i < rays.size(); ++i) CHECK((!found[i] || !hits[i].end.certified));
    CHECK(found[0]);
}

TEST_CASE("a taper that ends in a line has no films beyond its ends") {
    SolidBuilder b;
    const std::vector<std::vector<Vec2>> holed{{{0, 0}, {2, 0}, {0, 2}}, {{0.5, 0.5}, {0.5, 1}, {1, 0.5}}};
    const NodeId profile = b.shape(shape::Polygon{std::make_shared<const std::vector<std::vector<Vec2>>>(holed)});
    const NodeId taper = b.shape(shape::Extrusion{profile, 0, 1.5, 0, {0.5, 0}, 0});
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(taper, moved(2, 2, -1.5))}), moved(1.75, 2, 2)));
    CHECK(fault(solid, ray({0.25, 4, 2}, {-3.5, -5.75, -1.5})).empty());
}

TEST_CASE("a taper of a curve that ends in a line has no film beyond its ends") {
    SolidBuilder b;
    const NodeId taper = b.shape(shape::Extrusion{b.shape(shape::ParabolicSegment{{0, 0}, {0.25, 0.5}, {0.5, 0}}), 0, 0.75, 0, {0.5, 0}, 0});
    const Placement squeezed{{1.1, 0, 0, 0, 0, 1.1, 0, 0, 0, 0, 0.5, 0}};
    const Placement leaned{{-0x1.3c5833fd52c9fp-1, -0x1.8fa73a1f97e82p-1, 0x1.839a1437ddcb3p-4, 0, -0x1.8b0bfad16aa69p-1, 0x1.40088484d543cp-1, 0x1.e408302b4c944p-4, 0,
                            -0x1.360c9c42e1dedp-3, 0, -0x1.fa1940f731606p-1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(taper, squeezed)}), leaned));
    const Ray beyond = ray({-0x1.0ebd98af7e584p+0, 0x1.f8eee5a16dd67p+2, -0x1.af6f2e67efa1ep-1}, {-0x1.03143b72bcb38p-5, -0x1.ff54fbd2eea39p-1, 0x1.4875313b2bab5p-5});
    CHECK(fault(solid, beyond).empty());
}

TEST_CASE("a ray that touches an unevenly tapered disc does not enter it") {
    SolidBuilder b;
    const NodeId profile = b.combine(SetOp::kUnion, {use(b.shape(shape::Disc{1.25}), moved(-1.25, 0, 0))});
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(b.shape(shape::Extrusion{profile, 0, 1.25, 0, {0.5, 1}, 0}))})));
    CHECK(fault(solid, ray({-2.5, -1.25, 0}, {1, 0, 0})).empty());
    CHECK(fault(solid, ray({-2.5, -1.25, 0.5}, {1, 0, 0})).empty());
}

TEST_CASE("flush tapers, turned there and back, leave the film that rounding leaves") {
    SolidBuilder b;
    const NodeId flat = b.shape(shape::Rectangle{{0, -1.25}, {1.9, 1.25}});
    const NodeId straight = b.shape(shape::Extrusion{flat, 0, 1.5, 0, {0.5, 0}, 0});
    const NodeId curved = b.shape(shape::Extrusion{b.combine(SetOp::kUnion, {use(b.shape(shape::Disc{0.75})), use(flat)}), 0, 1.5, 0, {0.5, 0}, 0});
    const double c = 0x1.bb67ae8584caap-1;
    const Placement there{{c, -0.5, 0, 0, 0.5, c, 0, 0, 0, 0, 1, 0}}, back{{c, 0.5, 0, 0, -0.5, c, 0, 0, 0, 0, 1, 0}};
    const Placement leaned{{0x1.e8bdcee0c5b03p-1, 0x1.bf4a795048279p-3, 0x1.9f249e9822394p-3, 0, -0x1.b588dd7abfap-3, 0x1.f3a3b96255f0fp-1, -0x1.73a5b87a1a1afp-5, 0,
                            -0x1.a969c4e34d05dp-3, 0, 0x1.f4d510a0e2df4p-1, 0}};
    const Placement turned{{-0x1.87f58e4c8ffffp-1, 0x1.49695cc23a2e8p-1, 0, 0, -0x1.742cfd36e23a2p-3, -0x1.bad7e22d32b0ep-3, -0x1.eb26d24bd011dp-1, 0,
                            -0x1.3bff8493230efp-1, -0x1.77ffb42dbce5cp-1, 0x1.213bdffc27101p-2, 0}};
    const Placement far{{1e-4, 0, 0, 0x1.6a59eedf7d141p-2, 0, 1e-4, 0, 0x1.4823a0607fd71p-13, 0, 0, 1e-4, 0x1.16c9e9666d5f1p+6}};
    const NodeId again = b.combine(SetOp::kUnion, {use(b.combine(SetOp::kUnion, {use(curved, leaned)}), there)});
    const NodeId film = b.combine(SetOp::kDifference, {use(straight, leaned), use(again, back)});
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(b.combine(SetOp::kUnion, {use(film)}), turned)}), far));
    CHECK(fault(solid, ray({0x1.6a4ae1c1db9f9p-2, -0x1.a3fb7669b8285p-11, 0x1.16c9e85f52fb1p+6}, {0, 0x1.a36e2eb1c432dp-14, 0})).empty());
}

TEST_CASE("a limit before the first border changes nothing of a ray along a prism's edge") {
    SolidBuilder b;
    const auto ell = [&](double w, double h) {
        const std::vector<std::vector<Vec2>> rings{{{0, 0}, {2 * w, 0}, {2 * w, h}, {w, h}, {w, 2 * h}, {0, 2 * h}}};
        return b.shape(shape::Polygon{std::make_shared<const std::vector<std::vector<Vec2>>>(rings)});
    };
    const NodeId profile = b.combine(SetOp::kUnion, {use(ell(1.25, 0.75)), use(ell(2, 1), moved(-1.5, -2, 0))});
    const double lean = 0x1.b116042278f0ep-35;
    const Solid solid = b.finish(use(b.shape(shape::Extrusion{profile, 0, 0.75, 0, {1, 1}, 0}), Placement{{1, 0, 0, 0, 0, 1, lean, 0, 0, -lean, 1, 0}}));
    CHECK(fault(solid, ray({-1.5, -0x1.fffffffebb2f8p-3, 0x1.800000001b116p-1}, {0, 3.5, -0x1.7af34p-33})).empty());
}

TEST_CASE("a ray along a tapered disc meets nothing where it leaves the heights far away") {
    SolidBuilder b;
    const NodeId taper = b.shape(shape::Extrusion{b.shape(shape::Disc{2}), 0, 0.25, 0, {0.5, 0.5}, 0});
    const Placement leaned{{0x1.101848d316b52p-3, 0x1.dabe819b29814p-3, -0x1.ed62fc3fc13bap-1, 0, 0x1.bc366f500622ep-1, -0x1.fd3129b18fb4ap-2, 0, 0, -0x1.eaae47ec0e1a5p-2,
                            -0x1.ac104b73f75c1p-1, -0x1.11986811a52cap-2, 0}};
    const Placement far{{1e-06, 0, 0, -0x1.3d5850ba4e3a6p-13, 0, 1e-06, 0, 0x1.c41ed9146a581p-12, 0, 0, 1e-06, -0x1.bf99bfc43ab5dp-6}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(taper, leaned)}), far));
    CHECK(fault(solid, ray({-0x1.3f734697612d7p-13, 0x1.c4591261e74edp-12, -0x1.bf96a6a897ac7p-6}, {0x1.495e7c140b311p-17, 0x1.0cdbb79d64ca3p-14, -0x1.28fba3cfce2ap-15})).empty());
}

TEST_CASE("a limit before the first border changes nothing of a ray along an edge of meshes that snap") {
    SolidBuilder b;
    FacetList ell;
    for (const double z : {0.0, 1.25})
        for (const Vec2& p : {Vec2{0, 0}, {2.5, 0}, {2.5, 1.25}, {1.25, 1.25}, {1.25, 2.5}, {0, 2.5}}) ell.points.push_back({p.x, p.y, z});
    ell.facets = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}, {0, 1, 7, 6}, {1, 2, 8, 7}, {2, 3, 9, 8}, {3, 4, 10, 9}, {4, 5, 11, 10}, {5, 0, 6, 11}};
    const NodeId mesh = b.shape(shape::Polyhedron{std::make_shared<const FacetList>(ell)});
    const double s = 0x1.0000000000005p+0, l = 0x1.0000000000013p+0;
    const Placement small{{s, 0, 0, 1.5e-15, 0, s, 0, 0, 0, 0, s, 1.5e-15}}, large{{l, 0, 0, 5.25e-15, 0, l, 0, 0, 0, 0, l, 5.25e-15}};
    const NodeId waist = b.shape(shape::Quadric{{1, 1, -1, 0, 0, 0, 0, 0, 0, -1.25}});
    const Solid solid = b.finish(use(b.combine(SetOp::kIntersection, {use(b.combine(SetOp::kUnion, {use(mesh, small), use(waist)})), use(mesh, large)})));
    CHECK(fault(solid, ray({0, 0, 0x1.400000000000ep+1}, {0x1.b05876e5b012p-49, 0, -0x1.4000000000001p+0})) == "");
}

TEST_CASE("where double hardly knows t a facet is as near its class as exact numbers say") {
    SolidBuilder b;
    const auto corners = std::vector<Vec3>{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1.5}, {0, 0, -1.5}};
    const NodeId eight = b.shape(shape::Polyhedron{std::make_shared<const FacetList>(FacetList{corners, {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}})});
    const Placement nearly{{0x1.ffffffffffac2p-1, 0, 0, 0, 0, 0x1.ffffffffffac2p-1, 0, 0, 0, 0, 0x1.ffffffffffac2p-1, 0x1.4f86725995bb5p-43}};
    const Solid solid = b.finish(use(b.combine(SetOp::kDifference, {use(eight), use(eight, nearly)}), {{1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0}}));
    const Ray r = ray({-0x1.ffffffffffac2p+0, 0x1p+0, 0x1.4f86725995bb5p-42}, {0x1.ffffffffffac2p-1, -0x1p+0, -0x1.4f86725995bb5p-43});
    CHECK(fault(solid, r).empty());
}

TEST_CASE("a border through whose point a plane leans along the ray stands where its other surfaces are") {
    SolidBuilder b;
    const NodeId box = b.shape(shape::RoundBox{{0, 0, 0}, {0.75, 0.25, 0.25}, 0.03125});
    const Placement leaning{{1, 0, 0, 0, 0, 1, 0x1.0356a633ec4afp-36, 0, 0, -0x1.0356a633ec4afp-36, 1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(box), use(box, leaning)})));
    const Ray up = ray({0x1.7p-1, 0x1.cp-3, -0x1.4p-3}, {0, 0, 0x1.8p-3});
    CHECK(fault(solid, up) == "");
    Scratch scratch;
    Hit hit;
    REQUIRE(first_hit(*subject_of(solid, true).program, up, HUGE_VAL, scratch, hit));
    CHECK(hit.end.t_error < 1e-14);
    CHECK(hit.end.normal.z < -0.99);
}

TEST_CASE("a ray along a parabola's cylinder meets it as far away as it does") {
    SolidBuilder b;
    const NodeId profile = b.combine(SetOp::kUnion, {use(b.shape(shape::ParabolicSegment{{0, 0}, {0.75, 1.5}, {1.5, 0}}), Placement{{0, -1, 0, -0.25, 1, 0, 0, 0, 0, 0, 1, 0}})});
    const NodeId part = b.combine(SetOp::kUnion, {use(b.shape(shape::Extrusion{profile, 0, 0.75, 0, {0, 0}, 0}), Placement{{2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.375, 0}})});
    const Placement turned{{-0x1.605ca9fa63179p-2, 0x1.be59fb9c169e2p-1, -0x1.6511b7066821bp-2, 0, 0, 0x1.7c4b047daa439p-2, 0x1.db61dc5d87fc5p-1, 0, 0x1.e0bba8d9e3fe2p-1,
                            0x1.472950e82e52bp-2, -0x1.05b866d1f0d9cp-3, 0}};
    const Placement far{{10000, 0, 0, -0x1.4ca4395f84a8cp+26, 0, 10000, 0, 0x1.d903c4334958cp+24, 0, 0, 10000, -0x1.5249dec2895e2p+22}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(part, turned)}), far));
    CHECK(fault(solid, ray({-0x1.4ce1ceed2c679p+26, 0x1.d90f51bb6a6ccp+24, -0x1.48800471121eep+22}, {0x1.d9246d3df68eep+12, 0x0p+0, -0x1.42c1fdfd49f24p+14})) == "");
}

TEST_CASE("a ray through the ridge that a profile shrinks to") {
    SolidBuilder b;
    const NodeId segment = b.shape(shape::ParabolicSegment{{0, 0}, {0x1.6d25eb4bd3201p-1, 0x1.6d25eb4bd3201p+0}, {0x1.6d25eb4bd3201p+0, 0}});
    const NodeId profile = b.combine(SetOp::kUnion, {use(segment), use(b.shape(shape::Disc{1.5})), use(b.shape(shape::Rectangle{{-0.75, -0.75}, {0.75, 0.75}}), moved(1.5, 1.5, 0))});
    const NodeId roof = b.shape(shape::Extrusion{profile, 0, 1.5, 0, {0.5, 0}, 0});
    const NodeId part = b.combine(SetOp::kUnion, {use(roof, Placement{{0, -1, 0, -1.25, 1, 0, 0, 1.1, 0, 0, 1, -1.25}})});
    const Placement turned{{-0x1.55741e7624568p-1, -0x1.7d83c1a291b11p-1, 0, 0, -0x1.67cea68031461p-1, 0x1.420689f43488ap-1, -0x1.547bdbe17a8b6p-2, 0, 0x1.fb6b9329b0aefp-3,
                            -0x1.c6236c869f977p-3, -0x1.e2de41deb9c29p-1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(part, turned)})));
    CHECK(fault(solid, ray({0x1.b9e714bc85e18p+0, 0x1.3e10567e2586ap+1, -0x1.0a5c8f4d88072p+1}, {0x1.10844a0340846p+1, -0x1.5d6d17a0dc8cfp+1, 0x1.765a177c1a6c1p+2})) == "");
}
