// test_sections.cpp — projection(cut = true) of solids that stand askew, through the program: areas in closed form, and no mesh.
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "run_program.h"

namespace {

constexpr double kPi = std::numbers::pi;
double rad(double degrees) { return degrees * kPi / 180; }

// The area of the section, and that no mesh was needed for it.
double area_of_section(const std::string& solid) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "linear_extrude(1) projection(cut = true) " + solid);
    const Outcome out = run_whittle({"measure", scene, "--json", "--stats", folder.name("counted.json")});
    INFO(solid << "\n" << out.err);
    REQUIRE(out.code == 0);
    CHECK(contains(folder.read("counted.json"), "\"mesh.fallback\": 0"));
    const std::string what = "\"volume\":{\"value\":";
    const std::size_t at = out.out.find(what);
    REQUIRE(at != std::string::npos);
    return std::strtod(out.out.c_str() + at + what.size(), nullptr);
}

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
