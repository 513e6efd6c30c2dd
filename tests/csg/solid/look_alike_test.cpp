// Solids that look the same, and those that do not.
#include <catch2/catch.hpp>

#include "csg/solid/look_alike.h"

using namespace whittle;

namespace {

Solid two_balls(double radius, std::uint32_t line, const char* preset, double x) {
    SolidBuilder b;
    Label label;
    label.material.preset = preset;
    label.place.line = line;
    Use ball;
    ball.node = b.shape(shape::Ellipsoid{Vec3(radius)});
    ball.label = b.label(label);
    Use other = ball;
    other.placement = Placement::translation({x, 0, 0});
    Use both;
    both.node = b.combine(SetOp::kUnion, {ball, other});
    return b.finish(both);
}

}  // namespace

TEST_CASE("solids look alike when only their places in the text differ") {
    const Solid solid = two_balls(1, 3, "gold", 5);
    CHECK(look_alike(solid, two_balls(1, 3, "gold", 5)));
    CHECK(look_alike(solid, two_balls(1, 9, "gold", 5)));
    CHECK_FALSE(look_alike(solid, two_balls(2, 3, "gold", 5)));
    CHECK_FALSE(look_alike(solid, two_balls(1, 3, "steel", 5)));
    CHECK_FALSE(look_alike(solid, two_balls(1, 3, "gold", 6)));
    CHECK_FALSE(look_alike(solid, Solid{}));
}
