// test_sections.cpp — projection(cut = true) of solids that stand askew, through the program: areas in closed form, and no mesh.
#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "measured_area.h"

namespace {

constexpr double kPi = std::numbers::pi;
double rad(double degrees) { return degrees * kPi / 180; }

double area_of_section(const std::string& solid) { return measured_area("projection(cut = true) " + solid); }

// Of the middle strip of an ellipse of axes 1 and `long_axis`, `half` to each side of the short axis.
double strip_of_ellipse(double long_axis, double half) {
    const double y = half / long_axis;
    return 2 * long_axis * (y * std::sqrt(1 - y * y) + std::asin(y));
}

}  // namespace

TEST_CASE("the section of a cylinder that stands askew is an ellipse, cut off where the plane leaves by an end") {
    CHECK(area_of_section("rotate([10, 20]) cylinder(h = 5, r = 1, center = true);") == Approx(kPi / (std::cos(rad(10)) * std::cos(rad(20)))).epsilon(1e-4));
    CHECK(area_of_section("rotate([60, 0]) cylinder(h = 1, r = 1, center = true);") == Approx(strip_of_ellipse(2, 0.5 / std::sin(rad(60)))).epsilon(1e-4));
    CHECK(area_of_section("translate([7, -3, 0.1]) rotate([180 - 10, 20, 40]) mirror([1, 0, 0]) cylinder(h = 5, r = 1, center = true);") ==
          Approx(kPi / (std::cos(rad(10)) * std::cos(rad(20)))).epsilon(1e-4));
}

TEST_CASE("the section of a cylinder that lies is a rectangle") {
    CHECK(area_of_section("translate([0, 0, 0.5]) rotate([90, 0, 30]) cylinder(h = 4, r = 1);") == Approx(4 * std::sqrt(3.0)).epsilon(1e-4));
    CHECK(area_of_section("translate([1, 2, -0.6]) rotate([0, 90]) scale([1, 2, 3]) cylinder(h = 1, r = 1, center = true);") == Approx(3 * 4 * 0.8).epsilon(1e-4));
}

TEST_CASE("the section of an ellipsoid is an ellipse however it is placed") {
    // With the unit normal n in its own frame: pi a b c (1 - d^2 / q) / sqrt(q), q = (a n_x)^2 + (b n_y)^2 + (c n_z)^2.
    const double nx = -std::sin(rad(25)), ny = std::cos(rad(25)) * std::sin(rad(35)), nz = std::cos(rad(25)) * std::cos(rad(35));
    const double q = nx * nx + 4 * ny * ny + 9 * nz * nz;
    CHECK(area_of_section("translate([3, 4, 0.7]) rotate([35, 25, 15]) scale([1, 2, 3]) sphere(1);") == Approx(kPi * 6 * (1 - 0.49 / q) / std::sqrt(q)).epsilon(1e-4));
}

TEST_CASE("sections of extrusions and of what is cut out of them keep their curves") {
    const double slope = std::cos(rad(30));
    CHECK(area_of_section("rotate([30, 0]) linear_extrude(20, center = true) difference() { circle(3); translate([1, 0]) circle(1); }") == Approx(8 * kPi / slope).epsilon(1e-4));
    CHECK(area_of_section("difference() { cube(10, center = true); rotate([0, 30]) cylinder(h = 30, r = 2, center = true); }") == Approx(100 - 4 * kPi / slope).epsilon(1e-4));
}

TEST_CASE("a cone's section is an ellipse where the plane cuts all its lines, cut off by its ends") {
    // Of half angle g, its axis tilted by a and met by the plane at d from the apex: the longer semiaxis from where the plane meets the two outermost lines; the shorter from
    // the circle at the height of the ellipse's middle.
    const double g = std::atan(0.25), a = rad(20), d = 8;
    const double right = d * std::sin(g) / std::cos(a + g), left = d * std::sin(g) / std::cos(a - g);  // along the plane from the axis
    const double longer = (right + left) / 2, middle = (right - left) / 2;
    const double height = d + middle * std::sin(a), off = middle * std::cos(a);  // of the ellipse's middle, along the axis from the apex and across it
    const double shorter = std::sqrt(0.0625 * height * height - off * off);
    CHECK(area_of_section("rotate([0, 20]) translate([0, 0, -8]) cylinder(h = 20, r1 = 0, r2 = 5);") == Approx(kPi * longer * shorter).epsilon(1e-4));
    CHECK(area_of_section("translate([5, 7]) rotate([0, 0, 33]) rotate([0, 20]) translate([0, 0, -8]) cylinder(h = 20, r1 = 0, r2 = 5);") == Approx(kPi * longer * shorter).epsilon(1e-4));
    // Half of it: the other half is past the end.
    CHECK(area_of_section("intersection() { rotate([0, 20]) translate([0, 0, -8]) cylinder(h = 20, r1 = 0, r2 = 5); translate([-20, 0, -20]) cube(40); }") ==
          Approx(kPi * longer * shorter / 2).epsilon(1e-4));
}

TEST_CASE("what is turned about an axis in the plane is cut in its profile, on both sides") {
    CHECK(area_of_section("rotate([90, 0]) rotate_extrude() translate([5, 0]) circle(2);") == Approx(8 * kPi).epsilon(1e-4));
    CHECK(area_of_section("rotate([0, 90, 0]) rotate_extrude() translate([3, 1]) square([2, 5]);") == Approx(20).epsilon(1e-6));
    // Turned to one side only, and from the plane up or down.
    CHECK(area_of_section("rotate([90, 0]) rotate_extrude(angle = 100) translate([5, 0]) circle(2);") == Approx(4 * kPi).epsilon(1e-4));
    CHECK(area_of_section("union() { rotate([90, 0]) rotate_extrude(angle = -100) translate([5, 0]) circle(2); translate([9, 9, -1]) cube(2); }") == Approx(4).epsilon(1e-6));
    CHECK(area_of_section("translate([0, 0, 1]) mirror([0, 0, 1]) translate([0, 0, 1]) rotate([90, 0]) rotate_extrude(angle = -100) translate([5, 0]) circle(2);") ==
          Approx(4 * kPi).epsilon(1e-4));
}

TEST_CASE("what is turned about an axis square to the plane is cut in rings") {
    const double reach = 1.6;  // of the circle at 1.2 of its 2
    CHECK(area_of_section("translate([0, 0, -1.2]) rotate_extrude(angle = 90) translate([5, 0]) circle(2);") == Approx(kPi / 4 * 4 * 5 * reach).epsilon(1e-4));
    CHECK(area_of_section("translate([1, 2, -0.5]) rotate_extrude() difference() { square([4, 1]); translate([2, 0]) circle(1); }") ==
          Approx(kPi * (16 - (std::pow(2 + std::sqrt(0.75), 2) - std::pow(2 - std::sqrt(0.75), 2)))).epsilon(1e-4));
}

TEST_CASE("extrusions of curved profiles that lie in the plane are cut in strips") {
    CHECK(area_of_section("rotate([90, 0]) linear_extrude(7) difference() { circle(5); circle(3); }") == Approx(7 * 4).epsilon(1e-6));
    CHECK(area_of_section("translate([0, 0, 3]) rotate([90, 0, 20]) linear_extrude(7) union() { circle(5); translate([4, -4]) square(2); }") == Approx(7 * 10).epsilon(1e-5));
    CHECK(area_of_section("translate([0, 0, -1]) rotate([90, 0]) linear_extrude(2) offset(delta = 1) square([3, 4]);") == Approx(2 * 5).epsilon(1e-6));
}

TEST_CASE("upright twists and tapers are cut in their profile, turned and scaled") {
    CHECK(area_of_section("translate([0, 0, -3]) linear_extrude(10, twist = 100, scale = 2) translate([1, 0]) square([4, 2]);") == Approx(8 * 1.3 * 1.3).epsilon(1e-4));
    CHECK(area_of_section("intersection() { translate([0, 0, -5]) linear_extrude(10, twist = 90) translate([2, 0]) circle(1); rotate([0, 0, -45]) translate([0, -5, -5]) cube(10); }") ==
          Approx(kPi).epsilon(1e-4));
}

TEST_CASE("boxes with round edges and capsules are cut as what they are made of") {
    CHECK(area_of_section("translate([0, 0, -2]) minkowski() { cube([4, 3, 2]); sphere(1); }") == Approx(4 * 3 + 2 * (4 + 3) + kPi).epsilon(1e-4));
    CHECK(area_of_section("translate([0, 0, -2.6]) minkowski() { cube([4, 3, 2]); sphere(1); }") == Approx(4 * 3 + 2 * (4 + 3) * 0.8 + kPi * 0.64).epsilon(1e-4));
    CHECK(area_of_section("rotate([0, 90]) hull() { sphere(1); translate([0, 0, 5]) sphere(1); }") == Approx(10 + kPi).epsilon(1e-4));
    CHECK(area_of_section("rotate([10, 80, 20]) hull() { translate([0, 0, -9]) sphere(1); translate([0, 0, 9]) sphere(1); }") == Approx(kPi / (std::cos(rad(10)) * std::cos(rad(80)))).epsilon(1e-4));
}

TEST_CASE("a ring cut by a plane that touches it twice shows Villarceau's two circles") {
    // Of the ring's radius, their centres two tubes apart: the ring is what is in one of them alone.
    const double ring = 3, tube = 1, tilt = std::asin(tube / ring) * 180 / kPi;
    const double both = 2 * ring * ring * std::acos(tube / ring) - 2 * tube * std::sqrt(ring * ring - tube * tube);
    const std::string torus = "rotate_extrude() translate([3, 0]) circle(1);";
    CHECK(area_of_section("translate([7, 1]) rotate([" + std::to_string(tilt) + ", 0]) " + torus) == Approx(2 * kPi * ring * ring - 2 * both).epsilon(5e-4));
}

TEST_CASE("a cone's section is a parabola or a hyperbola where the plane says so") {
    // Of x^2 + y^2 <= (4 - z)^2, z >= 0: along z = x + 1, times the square root of two; and along y = 1.
    CHECK(area_of_section("translate([0, 0, -1 / sqrt(2)]) rotate([0, 45]) cylinder(h = 4, r1 = 4, r2 = 0);") ==
          Approx(std::sqrt(2.0) * 2 / 3 * 2 * std::sqrt(15.0) * 2.5).epsilon(1e-4));
    const double w = std::sqrt(15.0);
    CHECK(area_of_section("translate([0, 0, 1]) rotate([90, 0, 40]) cylinder(h = 4, r1 = 4, r2 = 0);") == Approx(4 * w - std::log(4 + w)).epsilon(1e-4));
}

TEST_CASE("twists that lie and what is turned, askew, are cut in their true outlines") {
    // Through the axis of a square that turns once: as wide as the square is, seen from its middle, on the mean.
    CHECK(area_of_section("rotate([90, 0, 0]) linear_extrude(10, twist = 360) square(2, center = true);") == Approx(20 * 4 / kPi * std::log(1 + std::sqrt(2.0))).epsilon(5e-4));
    // A tube is a cylinder less a cylinder, however it is written.
    const std::string tube = "rotate_extrude() translate([2, -9]) square([1, 18]);";
    CHECK(area_of_section("rotate([35, 20, 10]) " + tube) == Approx(kPi * 5 / (std::cos(rad(35)) * std::cos(rad(20)))).epsilon(5e-4));
}
