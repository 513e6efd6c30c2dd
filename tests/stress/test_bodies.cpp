// test_bodies.cpp — convex bodies among other shapes against the exact reference: what random comparison has found, one small case each.
#include <catch2/catch.hpp>

#include "csg/solid/convex_body.h"
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

std::string fault(const Solid& solid, const Ray& r, bool snap = true) {
    const Subject subject = subject_of(solid, snap);
    if (!subject.program) return subject.failure;
    Scratch scratch;
    std::mt19937_64 random(1);
    Tally tally;
    std::string why = disagreement(subject, r, scratch, random, tally);
    for (int i = 0; i < 20 && why.empty(); ++i) why = continuation_disagreement(subject, r, scratch, random, tally);
    return why;
}

NodeId body(SolidBuilder& b, ConvexParts parts) { return b.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(std::move(parts))}); }
BallImage ball(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, r}}; }
BallImage disc(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, 0}}; }

}  // namespace

TEST_CASE("a ray in the plane of a flat face leaves the body where it ends, not where the plane does") {
    SolidBuilder b;
    const Placement inner{{0x1.4272cbc6c079ep-1, -0x1.8db50aeb30377p-1, 0, 0, -0x1.28a37a5a02699p-1, -0x1.e102a7d0acdf4p-2, 0x1.5509af8945a9dp-1, 0, -0x1.08e899ce5708ep-1,
                           -0x1.ad8f1c9248d9ep-2, -0x1.7de2e8c67055cp-1, 0}};
    const Placement outer{{-0x1.b29ce44c2bf7cp-1, -0x1.0ea867d1ab3c7p-1, 0, 0, 0x1.0ea867d1ab3c7p-1, -0x1.b29ce44c2bf7cp-1, 0, 0, 0, 0, 1, 0}};
    const NodeId leaning = body(b, {{{1, 0, 1.75}, {disc(1.75)}}, {{-1, 1, 2.75}, {disc(1)}}});
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(leaning, inner)}), outer));
    CHECK(fault(solid, ray({0x1.0b0df46eb3d9dp+0, -0x1.8ee6e6a3f50c3p+1, -0x1.d12783b2e20fdp+0}, {0x1.d0bba33408d8p-1, -0x1.857d8260dbc8p-7, -0x1.ad8f1c9248d9ep-2}), false) == "");
}

TEST_CASE("a plane that was rounded with its placement is where the body ends") {
    SolidBuilder b;
    const NodeId upright = body(b, {{{0, 0, -1.25}, {disc(0.625)}}, {{0, 0, -0x1.668p-2}, {disc(0.625)}}, {{-0x1.cccp-1, -1.75, -1.25}, {disc(0.625)}}, {{-0x1.cccp-1, -1.75, -0x1.668p-2}, {disc(0.625)}}});
    const Placement nearly{{1.0000003, 0, 0, 0, 0, 1.0000003, 0, -2.7e-07, 0, 0, 1.0000003, -2.7e-07}};
    CHECK(fault(b.finish(use(upright, nearly)), ray({0x0p+0, 0x1.5be4711d12792p-22, -0x1.667fe1cc74736p-2}, {0x0p+0, -0x1.cfdb417c18a19p-23, -0x1.4225d086p-22})) == "");
}

TEST_CASE("a body and a plane almost along the ray are told apart though double knows little of the plane's t") {
    const Ray r = ray({-0x1.7fffffffffffbp+0, 0x1.8000000000008p+0, -0x1.fffffffffffdap-3}, {-0x1p-50, -0x1.cp-50, 0x1.ffffffffffffp-2});
    for (int k = 0; k < 3; ++k) {
        SolidBuilder b;
        const NodeId profile = b.combine(SetOp::kUnion, {use(b.shape(shape::Rectangle{{0, 0}, {0.5, 0.5}}), moved(0, -0.5, 0))});
        const NodeId part = b.shape(shape::Revolution{profile, -45, 200, 0});
        const NodeId cut = body(b, {{{-0x1.35p-4, -1.5, 0.900390625}, {ball(0x1.35p-5)}}, {{-0.5, 1.5, -0x1.35p-4}, {ball(0.75)}}, {{-0x1.cdp-1, 0, -1.5}, {ball(0.75)}}});
        const Placement nearly{{1, 0, 0, 9e-16, 0, 1, 0, 0x1.d324256c3815p-50, 0, 0, 1, 9e-16}};
        std::vector<Use> uses{use(part, nearly), use(cut)};
        if (k > 0) uses.erase(uses.begin() + (k - 1));
        const Solid so = b.finish(use(b.combine(SetOp::kDifference, uses), moved(-1.5, 1.5, 0)));
        CHECK(fault(so, r, false) == "");
    }
}

TEST_CASE("the bound of a border holds where three corners of the search stand on one ridge") {
    SolidBuilder b;
    const NodeId grown = body(b, {{{1, 0, -0x1.e66p+0}, {ball(0.875)}}, {{0, 0, 0}, {ball(0.875)}}, {{0, 0, -0x1.e66p+0}, {ball(0.875)}}, {{0, 0, 0x1.e66p+0}, {ball(0.875)}}});
    const Placement turned{{1, 0, 0, 0, 0, -0x1.d8c83efaa2da8p-6, 0x1.ffc96ae6e2b96p-1, 0, 0, -0x1.ffc96ae6e2b96p-1, -0x1.d8c83efaa2da8p-6, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(grown, moved(0, 1.75, 0))}), turned));
    CHECK(fault(solid, ray({-0x1.40af58b1de2a6p+1, -0x1.2afd39eb6b5c2p-1, -0x1.541e3469ab715p+1}, {0x1.eff8aca258a52p+1, -0x1.c152fbe745e79p+0, 0x1.164aae0db5ab8p-2})) == "");
}

TEST_CASE("a body less itself a little further, along a ray in the film between, is near what it should be") {
    SolidBuilder b;
    const NodeId block = body(b, {{{1.25, 1.5, 1.75}, {disc(0.75)}}, {{1.25, 1.5, 3}, {disc(0.75)}}, {{0.25, 0, 1.75}, {disc(0.75)}}, {{0.25, 0, 3}, {disc(0.75)}}});
    const Placement tilted{{1, 0, 0, 0, 0, 0x1.bb67ae8584caap-1, 0.5, 0, 0, -0.5, 0x1.bb67ae8584caap-1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kDifference, {use(block), use(block, moved(0, 0, 3e-15))}), tilted));
    CHECK(fault(solid, ray({0x1.3p+2, 0x1.ae1f7b40a80bp+2, -0x1.dc05474b2bce8p+0}, {-0x1.cp+0, -0x1.f2d4a4563563dp+0, 0x1.2000000000003p+0}), false) == "");
}

TEST_CASE("a ray along a ridge of a body meets it where the rule moves it") {
    SolidBuilder b;
    const NodeId leaning = body(b, {{{-1.25, -1.25, 1.25}, {disc(1.25)}}, {{1.25, 1.25, 2.5}, {}}, {{0, 1.25, 2.5}, {}}});
    const Solid solid = b.finish(use(leaning, moved(0, -1.25, 0)));
    CHECK(fault(solid, ray({-0x1.bp+2, 0x0p+0, 0x1.4p+1}, {0x1.6204306ba0908p+6, 0x0p+0, 0x0p+0}), false) == "");
    const support::RandomSolid found = support::random_solid(support::Theme::kConvex, 9530342704977579889u);
    CHECK(fault(found.solid, ray({-0x1.bp+2, 0x0p+0, 0x1.4p+1}, {0x1.6204306ba0908p+6, 0x0p+0, 0x0p+0}), false) == "");
}

TEST_CASE("two bodies whose flat faces became one plane agree about a ray in that plane") {
    SolidBuilder b;
    const ConvexParts parts{{{-0.75, 0, 0}, {disc(1.5)}}, {{0x1.4cdp+0, 0.75, 0}, {disc(0x1.4cdp+0)}}, {{-0.75, 0, 0.75}, {disc(0.75)}}};
    const NodeId saddle = b.shape(shape::Quadric{{1, -1, 0, 0, 0, 0, 0, 0, -1, 0}}), box = b.shape(shape::Box{{-3, -3, -3}, {3, 3, 3}});
    const Placement little{{1, 0, 0, 4.95e-14, 0, 1, 0, -6.6e-14, 0, 0, 1, -6.6e-14}}, mirrored{{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    const NodeId rest = b.combine(SetOp::kDifference, {use(saddle), use(body(b, parts), little)});
    const NodeId both = b.combine(SetOp::kUnion, {use(rest, mirrored), use(body(b, parts))});
    const Solid solid = b.finish(use(b.combine(SetOp::kIntersection, {use(box), use(both)})));
    CHECK(fault(solid, ray({0x1.e65fffffffc88p-2, 0x1.7fffffffffb5bp-2, -0x1.293cd1bde90c6p-44}, {-0x1.c668p+1, 0x1.8p-1, 0x0p+0})) == "");
}

TEST_CASE("of two bodies that touch in a face one holds a ray in that face") {
    SolidBuilder b;
    const NodeId upper = body(b, {{{0, 0, 0}, {disc(1.75)}}, {{0, 0, 1.75}, {disc(1.75), ball(0.875)}}, {{0, 0, 0}, {}}});
    const NodeId lower = body(b, {{{0, 0, -1.75}, {disc(1.75)}}, {{0, 0, -1.75}, {disc(1.75)}}, {{-1.75, -1.75, 0}, {disc(1.75)}}, {{-1.75, 1.25, 0}, {}}});
    const NodeId both = b.combine(SetOp::kUnion, {use(upper), use(lower, moved(1.75, 1.75, 0))});
    const Placement tilted{{1, 0, 0, 0, 0, 0x1.bb67ae8584caap-1, -0.5, 0, 0, 0.5, 0x1.bb67ae8584caap-1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(both, moved(0, 1.75, 1.75))}), tilted));
    for (int ulps = -6; ulps <= 6; ++ulps)
        for (const double way : {-2.0, 2.0}) CHECK(fault(solid, ray({-2.125 * way, 0x1.47f57169a862ap-1, 0x1.31fd5c5a6a18ap+1 + ulps * 0x1p-51}, {way, 0, 0}), false) == "");
}

TEST_CASE("a ray in the flat face of a round body and along the edges of another") {
    SolidBuilder b;
    const NodeId sharp = body(b, {{{1, 0, 1}, {}}, {{1, 0, -0.5}, {}}, {{-1, -1, 1}, {ball(0.5)}}, {{1.5, 0, 1.5}, {}}});
    const NodeId pill = body(b, {{{0, 0, -0.5}, {disc(0.5), ball(0.5)}}});
    const Placement upside_down{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0}};
    const Solid solid = b.finish(use(b.combine(SetOp::kUnion, {use(sharp, upside_down), use(pill)})));
    CHECK(fault(solid, ray({-0x1.15dd71513fc98p+2, -0x1.d5dd71513fc98p+1, -1}, {0x1.727c9716ffb76p+0, 0x1.393e4b8b7fdbbp+0, 0}), false) == "");
}

TEST_CASE("a body less itself written differently, along a line in its side, is nothing") {
    SolidBuilder b;
    const NodeId post = body(b, {{{0, -1.25, -1.25}, {disc(0.375)}}, {{0, -1.25, -0.25}, {disc(0.375)}}});
    const double c = 0x1.bb67ae8584caap-1;
    const Placement mirrored{{-c, -0.5, 0, 0, -0.5, c, 0, 0, 0, 0, 1, 0}}, back{{c, 0.5, 0, 0, -0.5, c, 0, 0, 0, 0, 1, 0}}, off{{1, 0, 0, 0.75, 0, 1, 0, -1, 0, 0, 1, -1.25}};
    const NodeId other = b.combine(SetOp::kUnion, {use(post, mirrored)});
    const Solid solid = b.finish(use(b.combine(SetOp::kDifference, {use(post), use(other, back)}), off));
    for (const bool snap : {true, false}) CHECK(fault(solid, ray({1.125, -2.25, -3.25}, {0, 0, 0.75}), snap) == "");
}
