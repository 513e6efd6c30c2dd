// test_writings.cpp — a solid is the same in whatever words it is written: its surfaces get the same classes, so the difference of two writings is empty.
#include <catch2/catch.hpp>

#include <random>

#include <fmt/format.h>

#include "tests/stress/scene_text.h"
#include "tests/support/seed.h"
#include "tracer/engine/engine.h"

using namespace whittle;
using namespace whittle::stress;

namespace {

struct Pair {
    const char *name, *first, *second;  // F stands for what is written
};

// Inner motions: F lies at the far end of them.
constexpr Pair kMotions[] = {
    {"two turns", "rotate(30) rotate(30) F", "rotate(60) F"},
    {"nine turns", "rotate(10) rotate(10) rotate(10) rotate(10) rotate(10) rotate(10) rotate(10) rotate(10) rotate(10) F", "rotate(90) F"},
    {"turns about an axis", "rotate([17, 0, 0]) rotate([26, 0, 0]) F", "rotate([43, 0, 0]) F"},
    {"there and back", "rotate([31, 17, 23]) rotate([-31, 0, 0]) rotate([0, -17, 0]) rotate([0, 0, -23]) F", "F"},
    {"Euler angles apart", "rotate([0, 0, 23]) rotate([0, 17, 0]) rotate([31, 0, 0]) F", "rotate([31, 17, 23]) F"},
    {"a chain of translations", "translate([0.1, 0, 0]) translate([0.1, 0, 0]) translate([0.1, 0, 0]) F", "translate([0.3, 0, 0]) F"},
    {"a sum", "translate([0.1 + 0.2, 0.7 + 0.1, 0]) F", "translate([0.3, 0.8, 0]) F"},
    {"scales", "scale(3) scale(1 / 3) F", "F"},
    {"mirrors", "mirror([1, 1, 0]) mirror([1, 1, 0]) F", "F"},
    {"a mirror as a turn", "mirror([1, 0, 0]) mirror([0, 1, 0]) F", "rotate(180) F"},
    {"a turned translation", "rotate(37) translate([2, 0, 0]) F", "translate([2 * cos(37), 2 * sin(37), 0]) rotate(37) F"},
};

// Set operations and numbers.
constexpr Pair kForms[] = {
    {"sum for literal", "cube([0.1 + 0.2, 1.1 - 0.2, 1])", "cube([0.3, 0.9, 1])"},
    {"halves", "union() { cube([1, 2, 3]); translate([1, 0, 0]) cube([1, 2, 3]); }", "cube([2, 2, 3])"},
    {"De Morgan", "difference() { cube(4, center = true); union() { sphere(1.7); translate([1, 1, 0]) cylinder(r = 0.7, h = 3); } }",
     "intersection() { difference() { cube(4, center = true); sphere(1.7); } difference() { cube(4, center = true); translate([1, 1, 0]) cylinder(r = 0.7, h = 3); } }"},
    {"intersection for difference", "difference() { cube(3, center = true); difference() { cube(3, center = true); sphere(1.8); } }",
     "intersection() { cube(3, center = true); sphere(1.8); }"},
    {"a loop for a literal", "union() for (i = [0:4]) translate([i * 0.1, 0, 0]) cube(0.1)", "cube([0.5, 0.1, 0.1])"},
    {"a prism for a box", "linear_extrude(2) square([1.1, 0.7])", "cube([1.1, 0.7, 2])"},
    {"a scaled ball", "scale([2, 2, 2]) sphere(0.7)", "sphere(1.4)"},
};

constexpr const char* kShapes[] = {"cube([1, 2, 3]);", "sphere(1.3);", "cylinder(r = 0.7, h = 2);", "cylinder(r1 = 1, r2 = 0.4, h = 2);", "rotate_extrude() translate([2, 0]) circle(0.6);",
                                   "linear_extrude(2) polygon([[0, 0], [2, 0.3], [1, 1.7]]);", "polyhedron([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]], [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);"};

std::string with(std::string text, const std::string& what) {
    const auto at = text.find('F');
    return at == std::string::npos ? text : text.replace(at, 1, what);
}

// How many of the rays meet anything of the difference of two writings, either way.
std::uint64_t rays_left(const std::string& first, const std::string& second, double reach, std::mt19937_64& random) {
    std::uint64_t left = 0;
    for (const auto& [a, b] : {std::pair(first, second), std::pair(second, first)}) {
        const auto program = compile(solid_of("difference() { union() { " + a + "; } union() { " + b + "; } }"));
        REQUIRE(program);
        const Bounds box = program_bounds(**program);
        if (box.empty()) continue;
        std::uniform_real_distribution<double> unit(0, 1);
        const auto point = [&](double room) { return box.lo - Vec3(room) + (box.hi - box.lo + Vec3(2 * room)) * Vec3(unit(random), unit(random), unit(random)); };
        Scratch scratch;
        Spans spans;
        for (int i = 0; i < 40; ++i) {
            Ray ray;
            ray.origin = point(reach);
            ray.direction = point(0) - ray.origin;
            all_spans(**program, ray, scratch, spans);
            left += !spans.empty();
        }
    }
    return left;
}

}  // namespace

TEST_CASE("a solid written in other words is the same up to a thousand sizes from the origin") {
    std::mt19937_64 random(support::fresh_seed());
    const double distance = GENERATE(0.0, 30.0, 3000.0);  // the shapes are about 3 large
    for (const Pair& p : kMotions)
        for (const char* shape : kShapes) {
            const std::string what = fmt::format("translate([{}, {}, {}]) {}", distance, distance / 3, -distance / 7, shape);
            INFO(p.name << ": " << what);
            CHECK(rays_left(with(p.first, what), with(p.second, what), 3, random) == 0);
        }
}

TEST_CASE("set operations written in other words are the same under an outer motion at any distance") {
    std::mt19937_64 random(support::fresh_seed());
    const double distance = GENERATE(0.0, 3000.0, 3e6, 3e9);
    for (const Pair& p : kForms) {
        const std::string outer = fmt::format("translate([{}, {}, 0]) rotate([31, 17, 23]) ", distance, distance / 3);
        INFO(p.name << " " << outer);
        CHECK(rays_left(outer + "{ " + p.first + "; }", outer + "{ " + p.second + "; }", 3, random) == 0);
    }
}

// What cannot be told from a real film is said, not hidden: the largest distance at which each inner motion still gives the same classes.
TEST_CASE("how far other words of a motion stay the same", "[.report]") {
    std::mt19937_64 random(1);
    for (const Pair& p : kMotions) {
        std::string text;
        for (const char* shape : kShapes) {
            double reached = 0;
            for (double distance = 3e3; distance < 1e13; distance *= 10) {
                const std::string what = fmt::format("translate([{}, {}, {}]) {}", distance, distance / 3, -distance / 7, shape);
                if (rays_left(with(p.first, what), with(p.second, what), 3, random) > 0) break;
                reached = distance / 3;
            }
            text += fmt::format(" {:.0e}", reached);
        }
        WARN(p.name << ":" << text);
    }
}
