// test_colours.cpp — the colours of a mesh's triangles are those that rays see: where solids share faces, where cutters leave faces to what remains, in parts
// that are combined by themselves.
#include <random>

#include "modeler/mesh/paint.h"
#include "tests/modeler/check/check_solids.h"
#include "tests/support/seed.h"

using namespace whittle;
using namespace whittle::test;

namespace {

using Dice = std::mt19937_64;

int between(Dice& random, int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); }

// Boxes with whole corners from 0 to 5 in few colours, some of them of none, under set operations: most faces lie in planes that others have too.
Use random_boxes(SolidBuilder& b, Dice& random, int depth) {
    if (depth == 0) {
        Vec3 lo, hi;
        for (int k = 0; k < 3; ++k) {
            lo[k] = between(random, 0, 4);
            hi[k] = between(random, static_cast<int>(lo[k]) + 1, 5);
        }
        Use use = test::use(b.shape(shape::Box{lo, hi}));
        Material material;
        if (const int colour = between(random, 0, 3); colour > 0) material.color = Vec4(colour / 4.0, 0, 0, 1);
        use.label = b.label({material, {}, {}});
        return use;
    }
    std::vector<Use> operands;
    const int count = between(random, 2, 3);
    for (int i = 0; i < count; ++i) operands.push_back(random_boxes(b, random, depth - (i == 0 ? 1 : between(random, 1, depth))));
    constexpr SetOp kOps[] = {SetOp::kUnion, SetOp::kDifference, SetOp::kDifference, SetOp::kIntersection};
    return test::use(b.combine(kOps[between(random, 0, 3)], operands));
}

// Triangles whose colour is not the one that a ray sees which comes straight to a point of it.
std::uint64_t wrongly_painted(const Solid& solid, Dice& random) {
    MeshControl control;
    const auto made = mesh_solid(solid, {}, control);
    REQUIRE(made);
    const auto program = compiled(solid);
    const auto paint = painting_leaves(*made);
    const Mesh& mesh = made->mesh;
    Scratch scratch;
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 &a = mesh.points[mesh.triangles[i][0]], &b = mesh.points[mesh.triangles[i][1]], &c = mesh.points[mesh.triangles[i][2]];
        std::uniform_real_distribution<double> share(0.01, 0.49);
        const double s = share(random), t = share(random);
        constexpr double kAway = 0.125;
        Ray ray;
        ray.direction = -glm::normalize(glm::cross(b - a, c - a));
        ray.origin = a + s * (b - a) + t * (c - a) - kAway * ray.direction;
        Hit hit;
        REQUIRE(first_hit(*program, ray, HUGE_VAL, scratch, hit));
        if (std::fabs(hit.end.t - kAway) > 1e-9) continue;  // another face stands before it
        wrong += made->leaves[paint[i]].shown().color == leaf_uses(*program)[hit.end.use].material->color ? 0U : 1U;
    }
    return wrong;
}

}  // namespace

TEST_CASE("a mesh's triangles have the colours that rays see") {
    const std::uint64_t seed = support::fresh_seed();
    INFO("WHITTLE_SEED=" << seed);
    Dice random(seed);
    for (int i = 0; i < 60; ++i) {
        SolidBuilder b;
        const Use boxes = random_boxes(b, random, 1 + i % 3);
        CAPTURE(i);
        CHECK(wrongly_painted(b.finish(boxes), random) == 0);
    }
}

TEST_CASE("a bore through two colours has both, as rays see it, in a part that is turned and in parts that are used twice") {
    Dice random(1);
    for (const bool turned : {false, true})
        for (const bool twice : {false, true}) {
            SolidBuilder b;
            const NodeId box = b.shape(shape::Box{Vec3(0), Vec3(10)}), bore = b.shape(shape::Box{Vec3(-1, 3, 4), Vec3(21, 7, 6)});
            const auto coloured = [&](double red, Vec3 by) {
                Use use = test::use(box, Placement::translation(by));
                Material material;
                material.color = Vec4(red, 0, 0, 1);
                use.label = b.label({material, {}, {}});
                return use;
            };
            const NodeId both = b.combine(SetOp::kUnion, {coloured(1, {0, 0, 0}), coloured(0.5, {10, 0, 0})});
            const NodeId part = b.combine(SetOp::kDifference, {test::use(both), test::use(bore)});
            std::vector<Use> uses{test::use(part, turned ? tilted(30) : Placement())};
            if (twice) uses.push_back(test::use(part, turned ? tilted(30, {40, 0, 0}) : Placement::translation({40, 0, 0})));
            CAPTURE(turned, twice);
            CHECK(wrongly_painted(b.finish(test::use(b.combine(SetOp::kUnion, uses))), random) == 0);
        }
}
