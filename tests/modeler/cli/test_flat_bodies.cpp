// test_flat_bodies.cpp — hulls and sums of convex curved 2D shapes are the true sets: places on rays and areas in closed form; what goes by chords says so.
#include <cmath>
#include <numbers>
#include <string>

#include "measured_area.h"

namespace {

constexpr double kPi = std::numbers::pi;

// Where the ray along +x from (-10, y) enters the set, swept by 1.
double entry(const std::string& flat, double y) {
    const TemporaryFolder folder;
    const Outcome out = run_whittle({"spans", folder.file("part.scad", "linear_extrude(1) " + flat), "--ray=-10," + std::to_string(y) + ",0.5,1,0,0", "--json"});
    INFO(flat << "\n" << out.err);
    REQUIRE(out.code == 0);
    const std::string what = "\"in\":{\"t\":";
    const std::size_t at = out.out.find(what);
    REQUIRE(at != std::string::npos);
    return std::strtod(out.out.c_str() + at + what.size(), nullptr) - 10;
}

const std::string ellipse = "scale([1, 2]) circle(2);";  // x^2 / 4 + y^2 / 16 <= 1

}  // namespace

TEST_CASE("the hull of ellipses keeps their curves") {
    const std::string hull = "hull() { " + ellipse + " translate([9, 0]) " + ellipse + " }";
    CHECK(measured_area(hull) == Approx(8 * kPi + 9 * 8).epsilon(1e-4));
    CHECK(std::fabs(entry(hull, 2) + std::sqrt(3.0)) < 1e-11);
}

TEST_CASE("the sum of an ellipse and a square is as large as its mixed areas say") {
    const std::string sum = "minkowski() { " + ellipse + " square(3); }";
    CHECK(measured_area(sum) == Approx(8 * kPi + 3 * (4 + 8) + 9).epsilon(1e-4));
    CHECK(std::fabs(entry(sum, 5) + std::sqrt(3.0)) < 1e-11);  // above the square's upper side, as 2 is above 0
}

TEST_CASE("hulls of letters and sums of what is not convex go by chords, and say so") {
    const TemporaryFolder folder;
    for (const char* flat : {"hull() { text(\"O\"); circle(3); }", "minkowski() { difference() { square(9); circle(3); } scale([1, 2]) circle(0.5); }"}) {
        const Outcome out = run_whittle({"measure", folder.file("part.scad", std::string("linear_extrude(1) ") + flat), "--stats", folder.name("counted.json")});
        CHECK(out.code == 0);
        CHECK(contains(out.err, "has no exact form here: 1 operand"));
        CHECK(contains(folder.read("counted.json"), "\"mesh.fallback\": 1"));
    }
}
