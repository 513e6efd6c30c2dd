// Placements over the shutter, and the boxes around all that they go through.
#include <catch2/catch.hpp>

#include <cmath>

#include "csg/solid/placement.h"
#include "tracer/engine/engine.h"
#include "tracer/engine/motion.h"

using namespace whittle;

namespace {

Placement turned_about_z(double degrees, double scale_x, double scale_y, Vec3 at) {
    const double a = degrees * std::acos(-1.0) / 180, c = std::cos(a), s = std::sin(a);
    return {{c * scale_x, -s * scale_y, 0, at.x, s * scale_x, c * scale_y, 0, at.y, 0, 0, 1, at.z}};
}

bool holds(const Bounds& box, Vec3 p) {
    return p.x >= box.lo.x && p.y >= box.lo.y && p.z >= box.lo.z && p.x <= box.hi.x && p.y <= box.hi.y && p.z <= box.hi.z;
}

const Bounds kBox{Vec3(18, -2, -1), Vec3(24, 3, 5)};

// Do both boxes hold every corner at every time?
void check_boxes(const Motion& motion) {
    const MotionPath path(motion);
    const Bounds near = path.swept(kBox), far = moved_bounds(kBox, motion);
    for (int k = 0; k <= 100; ++k)
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p{(corner & 1 ? kBox.hi : kBox.lo).x, (corner & 2 ? kBox.hi : kBox.lo).y, (corner & 4 ? kBox.hi : kBox.lo).z};
            const Vec3 at = apply_to_point(path.at(k / 100.0), p);
            CHECK(holds(near, at));
            CHECK(holds(far, at));
        }
}

}  // namespace

TEST_CASE("a rigid motion stays rigid, and is the given placement at its ends") {
    const Motion motion{{}, turned_about_z(130, 1, 1, {4, 5, 6})};
    const MotionPath path(motion);
    CHECK(path.at(0) == motion.start);
    CHECK(path.at(1) == motion.end);
    for (double time : {0.1, 0.5, 0.83}) {
        const Placement p = path.at(time);
        const Vec3 x = apply_to_direction(p, {1, 0, 0}), y = apply_to_direction(p, {0, 1, 0});
        CHECK(glm::dot(x, x) == Approx(1).epsilon(1e-14));
        CHECK(std::abs(glm::dot(x, y)) < 1e-14);
        CHECK(std::atan2(x.y, x.x) == Approx(time * 130 * std::acos(-1.0) / 180));
        CHECK(p.offset(0) == Approx(4 * time));
    }
}

TEST_CASE("the box of a motion holds all of its way, also of one that ends where it began") {
    check_boxes({{}, turned_about_z(90, 1, 1, {0, 0, 0})});
    check_boxes({{}, turned_about_z(180, 2, 0.5, {3, 0, 1})});
    check_boxes({turned_about_z(20, 1, 3, {0, 1, 0}), turned_about_z(-100, 2, 1, {9, 0, 0})});
    // Turned about the origin and carried back: the middle of the box ends where it was, and swings out in between.
    const Placement turn = turned_about_z(60, 1, 1, Vec3(0));
    const Vec3 middle = 0.5 * (kBox.lo + kBox.hi), away = middle - apply_to_point(turn, middle);
    check_boxes({{}, turned_about_z(60, 1, 1, away)});
    // Stretched so that the turn is undone for one corner.
    const double a = 30 * std::acos(-1.0) / 180, across = (std::cos(a) * 18 + std::sin(a) * -2) / 18, along = (-std::sin(a) * 18 + std::cos(a) * -2) / -2;
    check_boxes({{}, turned_about_z(30, across, along, Vec3(0))});
}

TEST_CASE("a solid that moves is bounded by its way, nested motions too") {
    SolidBuilder b;
    Use ball;
    ball.node = b.shape(shape::Ellipsoid{Vec3(1)});
    ball.placement = Placement::translation({10, 0, 0});
    Use inner;
    inner.node = b.combine(SetOp::kUnion, {ball});
    inner.motion = b.motion({{}, Placement::translation({5, 0, 0})});
    Use outer;
    outer.node = b.combine(SetOp::kUnion, {inner});
    outer.placement = Placement::translation({0, 0, 7});
    outer.motion = b.motion({{}, turned_about_z(90, 1, 1, Vec3(0))});
    const auto program = compile(b.finish(outer));
    REQUIRE(program);
    const Bounds box = program_bounds(**program);
    // The placement of a use stands outside of its motion.
    CHECK(holds(box, Vec3(9, 0, 6)));
    CHECK(holds(box, Vec3(9, 9, 7)));
    CHECK(holds(box, Vec3(0, 16, 8)));
    CHECK(glm::length(box.hi - box.lo) < 80);
}
