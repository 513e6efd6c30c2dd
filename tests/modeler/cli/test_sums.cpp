// test_sums.cpp — minkowski() of solids that are not both convex, through the program: volumes in closed form, bounds, and no sum that grows without end.
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "run_program.h"

namespace {

// A number of what `measure --json` says, by the text before it.
double number_after(const std::string& text, const std::string& what) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return std::strtod(text.c_str() + at + what.size(), nullptr);
}

double volume_of(const std::string& scene_text, const std::vector<std::string>& more = {}) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"measure", folder.file("part.scad", scene_text), "--json", "--limit-memory", "2000"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome out = run_whittle(words);
    REQUIRE(out.code == 0);
    return number_after(out.out, "\"volume\":{\"value\":");
}

constexpr double kPi = std::numbers::pi;

}  // namespace

TEST_CASE("a box with a pocket, rounded by a ball, has the volume of the round box less the smaller pocket") {
    // Round box 20 x 20 x 5 by 1; the pocket keeps 8 x 8 down to z = 2, and its rim is a quarter round: along its sides, and in its corners a piece that turns inward.
    const double round_box = 2000 + 1200 + kPi / 4 * 180 + 4 * kPi / 3;
    const double a = 8, rim = [&] {
        // At height h over z = 5 the opening is a square of side a + 2 (1 - sqrt(1 - h^2)): exact for slabs and capsules along the rim.
        double sum = 0;
        const int n = 200000;
        for (int i = 0; i < n; ++i) {
            const double h = (i + 0.5) / n, side = a + 2 * (1 - std::sqrt(1 - h * h));
            sum += side * side / n;
        }
        return sum;
    }();
    const double volume = volume_of("minkowski() { difference() { cube([20, 20, 5]); translate([5, 5, 1]) cube([10, 10, 10]); } sphere(1); }\n");
    CHECK(volume == Approx(round_box - a * a * 3 - rim).epsilon(5e-5));
}

TEST_CASE("a sum distributes over unions, and stays true") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "minkowski() { union() { cube([20, 5, 5]); translate([10, 0, 20]) rotate([0, 30, 0]) cylinder(r = 2, h = 9); } scale([1, 2, 1]) sphere(1); }\n");
    const Outcome out = run_whittle({"spans", scene, "--ray=-10,2.5,2.5,1,0,0", "--json"});
    CHECK(out.code == 0);
    CHECK_FALSE(contains(out.err, "no exact form"));
    CHECK(number_after(out.out, "\"t\":") == Approx(9).epsilon(1e-12));
}

TEST_CASE("a ring and a ball add up to a thicker ring") {
    const double volume = volume_of("minkowski() { torus(r1 = 10, r2 = 2); translate([1, 2, 3]) sphere(1); }\n");
    CHECK(volume == Approx(2 * kPi * kPi * 10 * 9).epsilon(1e-4));
}

TEST_CASE("a ring and an ellipsoid, which grew beyond all memory once, are met by rays") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "minkowski() { torus(r1 = 10, r2 = 3); ellipsoid(r = [1, 2, 3]); }\n");
    const Outcome out = run_whittle({"spans", scene, "--ray=-30,0,0,1,0,0", "--json", "--limit-memory", "1500"});
    CHECK(out.code == 0);
    CHECK(contains(out.err, "no exact form"));
    CHECK(number_after(out.out, "\"t\":") == Approx(16).margin(0.05));
}

TEST_CASE("a ring and an ellipsoid are measured by as many lines as their facets leave time for") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "minkowski() { rotate_extrude() translate([10, 0]) circle(3); scale([1, 2, 0.5]) sphere(2); }\n");
    const Outcome out = run_whittle({"measure", scene, "--json", "--limit-memory", "2000"});
    REQUIRE(out.code == 0);
    CHECK(number_after(out.out, "\"rays\":") < 400000);  // 1.5 million where every test of a piece counted as one of a ball
    const double error = number_after(out.out.substr(out.out.find("\"volume\"")), "\"error\":");
    CHECK(error < 10);
    // By 1,557,758 lines: 4926.17 +- 0.13 (ci99).
    CHECK(std::fabs(number_after(out.out, "\"volume\":{\"value\":") - 4926.17) < 2 * error + 0.2);
}

TEST_CASE("a sum that is asked for twice is made once") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad",
                                          "module sum() minkowski() { rotate_extrude() translate([10, 0]) circle(3); scale([1, 2, 0.5]) sphere(2); }\n"
                                          "sum();\ntranslate([60, 0, 0]) rotate(30) color(\"red\") sum();\n");
    const Outcome out = run_whittle({"spans", scene, "--ray=-30,0,0,1,0,0", "--stats", folder.name("counted.json"), "--limit-memory", "1500"});
    REQUIRE(out.code == 0);
    CHECK(number_after(folder.read("counted.json"), "\"mesh.fallback\":") == 1);
    CHECK(contains(out.err, "minkowski() has no exact form here: 1 operand"));
}

TEST_CASE("two rings that stand across each other have a sum") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "minkowski() { torus(r1 = 10, r2 = 3); rotate([90, 0, 0]) torus(r1 = 5, r2 = 1); }\n");
    const Outcome out = run_whittle({"spans", scene, "--ray=-30,0,0,1,0,0", "--json", "--limit-memory", "1500"});
    CHECK(out.code == 0);
    CHECK(number_after(out.out, "\"t\":") == Approx(11).margin(0.05));
}

TEST_CASE("two unions whose parts would make too many sums are refused at once") {
    const TemporaryFolder folder;
    const std::string many = "for (i = [0:199]) translate([3 * i, i * i, 0]) ";
    const std::string scene = folder.file("part.scad", "minkowski() { union() { " + many + "cube(1); } union() { " + many + "sphere(1); } }\n");
    const Outcome out = run_whittle({"spans", scene, "--ray=-30,0,0,1,0,0", "--limit-time", "60"});
    CHECK(out.code == 1);
    CHECK(contains(out.err, "too many parts"));
}
