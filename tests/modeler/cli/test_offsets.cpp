// test_offsets.cpp — offset(r) of straight sides and arcs keeps true arcs: areas in closed form, and no chords.
#include <cmath>
#include <numbers>
#include <string>

#include "measured_area.h"

namespace {

constexpr double kPi = std::numbers::pi;

// Of two circles of radius r whose centres are d apart.
double lens_area(double r, double d) { return 2 * r * r * std::acos(d / (2 * r)) - d / 2 * std::sqrt(4 * r * r - d * d); }
double lens_perimeter(double r, double d) { return 4 * r * std::acos(d / (2 * r)); }

const std::string lens = "intersection() { circle(5); translate([6, 0]) circle(5); }";
const std::string ell = "polygon([[0, 0], [10, 0], [10, 4], [4, 4], [4, 10], [0, 10]])";

}  // namespace

TEST_CASE("a convex set of arcs grows as Steiner says, and shrinks to what its circles leave") {
    CHECK(measured_area("offset(r = 1) " + lens) == Approx(lens_area(5, 6) + lens_perimeter(5, 6) + kPi).epsilon(2e-4));
    CHECK(measured_area("offset(r = -0.5) " + lens) == Approx(lens_area(4.5, 6)).epsilon(2e-4));
    CHECK(measured_area("offset(r = 1) rotate(40) scale(2) " + lens) == Approx(lens_area(10, 12) + lens_perimeter(10, 12) + kPi).epsilon(2e-4));
}

TEST_CASE("a hole shrinks where its plate grows, and grows where it shrinks") {
    const std::string plate = "difference() { square(20, center = true); circle(3); }";
    CHECK(measured_area("offset(r = 1) " + plate) == Approx(400 + 80 + kPi - 4 * kPi).epsilon(2e-4));
    CHECK(measured_area("offset(r = -1) " + plate) == Approx(18 * 18 - 16 * kPi).epsilon(2e-4));
    CHECK(measured_area("offset(r = 4) " + plate) == Approx(400 + 320 + 16 * kPi).epsilon(2e-4));  // it is gone
}

TEST_CASE("opening rounds the convex corners and closing the reflex ones") {
    const double corner = 1 - kPi / 4;  // of radius 1
    CHECK(measured_area("offset(r = 1) offset(r = -1) " + ell + ";") == Approx(64 - 5 * corner).epsilon(2e-4));
    CHECK(measured_area("offset(r = -1) offset(r = 1) " + ell + ";") == Approx(64 + corner).epsilon(2e-4));
    CHECK(measured_area("offset(r = -1) offset(r = 2) offset(r = -1) " + ell + ";") == Approx(64 - 5 * corner + corner).epsilon(2e-4));
}

TEST_CASE("two circles in one grow to the union of the grown ones, and shrink with a disc in each of their corners") {
    const std::string both = "union() { circle(5); translate([6, 0]) circle(5); }";
    CHECK(measured_area("offset(r = 1) " + both) == Approx(2 * 36 * kPi - lens_area(6, 6)).epsilon(2e-4));
    // The circles of radius 4 and, between them, what the discs of radius 1 about the two corners leave of the rhombus of the centres and the corners.
    const double half = std::acos(3.0 / 5), height = 4;
    const double sectors = 2 * 16 * (kPi - half), rhombus = 2 * (3 * height) - 2 * (kPi / 2 - half);
    CHECK(measured_area("offset(r = -1) " + both) == Approx(sectors + rhombus).epsilon(2e-4));
}

TEST_CASE("shrinking by more than a set is wide leaves nothing") {
    const TemporaryFolder folder;
    const Outcome out = run_whittle({"measure", folder.file("part.scad", "linear_extrude(1) offset(r = -3) " + lens), "--json"});
    CHECK(out.code == 1);
    CHECK(contains(out.err, "empty"));
}
