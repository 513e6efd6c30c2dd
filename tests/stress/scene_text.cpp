// scene_text.cpp — see scene_text.h.
#include "tests/stress/scene_text.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"
#include "tests/csg/eval/memory_files.h"

namespace whittle::stress {

Solid solid_of(const std::string& text) {
    test::MemoryFiles files;
    EvaluateInput input;
    input.path = "scene.scad";
    input.text = text;
    auto evaluated = evaluate(input, files);
    REQUIRE(evaluated);
    INFO(text);
    REQUIRE_FALSE(evaluated->stopped());
    Canonical canonical = canonicalise(evaluated->scene, {}, &files, evaluated->diagnostics);
    for (const Diagnostic& d : evaluated->diagnostics.all()) UNSCOPED_INFO(format_line(d, evaluated->sources));
    REQUIRE_FALSE(canonical.something_left_out);
    return std::move(canonical.solid);
}

const std::vector<TextScene>& text_scenes() {
    static const std::vector<TextScene> list{
        {"plate", "difference() { cube([10, 8, 2], center = true); for (i = [-3:3:3]) translate([i, 1, 0]) cylinder(r = 0.7, h = 2, center = true); }"},
        {"carved cube", "difference() { intersection() { cube(8, center = true); sphere(5.4); } for (a = [[0, 0, 0], [90, 0, 0], [0, 90, 0]]) rotate(a) cylinder(r = 2.4, h = 8, center = true); }"},
        {"cut torus", "difference() { rotate_extrude() translate([3.5, 0]) circle(1.2); cube(6); }"},
        {"prism", "difference() { linear_extrude(4) polygon([[-5, -4], [5, -4], [5, 0], [0, 0], [0, 5], [-5, 5]]); translate([-3, -2, 0]) cylinder(r = 1.5, h = 4); }"},
        {"octahedron", "difference() { polyhedron([[5, 0, 0], [-5, 0, 0], [0, 5, 0], [0, -5, 0], [0, 0, 5], [0, 0, -5]], [[4, 2, 0], [4, 1, 2], [4, 3, 1], [4, 0, 3], [5, 0, 2], [5, 2, 1], [5, 1, 3], [5, 3, 0]]); cube(2); }"},
        {"stack", "union() { for (i = [-4:4]) translate([i, 0, 0]) cube(1); for (i = [-4:4]) translate([0, i + 0.5, 0]) cylinder(r = 0.5, h = 1); translate([0, 0, 1]) sphere(2); }"},
        {"cones", "difference() { cylinder(r1 = 5, r2 = 1, h = 6); translate([0, 0, 1]) cylinder(r1 = 4, r2 = 0, h = 6); rotate([90, 0, 0]) cylinder(r1 = 1, r2 = 2, h = 9); }"},
        {"menger", "translate([-4, -4, -4]) m(2, 8);",
         "module m(n, s) if (n == 0) cube(s); else for (x = [0:2], y = [0:2], z = [0:2]) if ((x == 1 ? 1 : 0) + (y == 1 ? 1 : 0) + (z == 1 ? 1 : 0) < 2) translate([x, y, z] * s / 3) m(n - 1, s / 3); "},
        {"wedge", "difference() { cube(6, center = true); rotate([0, 0.006, 0]) translate([-5, -5, 1]) cube(10); rotate([0, 45, 0]) cube([2, 9, 2], center = true); }"},
        {"shell", "difference() { scale([1, 0.8, 0.6]) sphere(5); scale([1, 0.8, 0.6]) sphere(4.999); translate([0, 0, -6]) cube(6); }"},
        {"vase", "difference() { rotate_extrude() polygon([[0, 0], [4, 0], [2, 3], [3, 6], [2.5, 6], [1.5, 3], [3, 0.5], [0, 0.5]]); translate([0, 0, 2]) cube([9, 1, 1], center = true); }"},
        {"twist", "intersection() { linear_extrude(height = 5, twist = 60, slices = 8) square(4, center = true); translate([0, 0, 2]) sphere(3); }"}};
    return list;
}

std::string literal(double x) { return fmt::format("{:.17g}", x); }

}  // namespace whittle::stress
