// test_strokes.cpp — open lines of an SVG are as wide as their strokes: closed forms, which are openscad 2021.01's areas too, but for the two it does not read.
#include <cmath>

#include <catch2/catch.hpp>

#include "run_program.h"

namespace {

constexpr double kPi = 3.14159265358979323846;

// Of `elements` on a sheet of 100 x 100 units, a millimetre each, extruded by 1.
std::string measured(const std::string& elements) {
    const TemporaryFolder folder;
    folder.file("a.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">)" + elements + "</svg>");
    const Outcome out = run_whittle({"measure", "--json", folder.file("a.scad", "linear_extrude(1) import(\"a.svg\");\n")});
    INFO(out.err);
    CHECK(out.code == 0);
    return out.out;
}

double number_behind(const std::string& text, const std::string& name) {
    const std::size_t at = text.find(name);
    REQUIRE(at != std::string::npos);
    return std::strtod(text.c_str() + at + name.size(), nullptr);
}

double area_of(const std::string& elements) { return number_behind(measured(elements), "\"volume\":{\"value\":"); }

std::string corner(const std::string& attributes) { return "<path d=\"M10 10 L50 10 L50 50\" " + attributes + "/>"; }

}  // namespace

TEST_CASE("what a path leaves open is as wide as its stroke, with its caps and joins") {
    struct Stroke { const char* attributes; double area; };
    const double cut = 8 * std::tan(kPi / 8);  // of a corner of half width 2 that is cut off 2 from its middle
    for (const auto& [attributes, area] : {Stroke{"", 81}, {"fill='none'", 81}, {"stroke-width='4'", 336}, {"style='stroke:red;stroke-width:4;stroke-linecap:butt'", 320},
                                           {"stroke-width='4' stroke-linecap='butt' stroke-linejoin='bevel'", 316 + cut}, {"stroke-width='4' stroke-linecap='butt' stroke-linejoin='round'", 316 + kPi},
                                           {"stroke-width='4' stroke-linecap='round'", 320 + 4 * kPi}, {"stroke-width='8' style='stroke-width:2'", 704}, {"stroke-width='0'", 81},
                                           {"style='fill:none; stroke-width: 4px'", 336}}) {
        CAPTURE(attributes);
        CHECK(area_of(corner(attributes)) == Approx(area).epsilon(1e-4));
    }
}

TEST_CASE("lines and polylines are strokes, what is closed is filled, each under its transform") {
    struct Drawing { const char* elements; double area; };
    const double slanted = std::hypot(30, 30) + 4;
    for (const auto& [elements, area] : {Drawing{"<line x1='10' y1='10' x2='40' y2='10' stroke-width='2'/>", 64}, {"<polyline points='10,10 40,10 40,40' stroke-width='2'/>", 124},
                                         {"<polygon points='10,10 40,10 40,40' stroke-width='2'/>", 450}, {"<path d='M10 10 L50 10 L50 50 Z' stroke-width='4' fill='none'/>", 800},
                                         {"<path d='M10 10 L50 10 L50 50 L10 10' stroke-width='4'/>", 800}, {"<g transform='scale(2,1)'><line x1='10' y1='10' x2='40' y2='40' stroke-width='4'/></g>", 8 * slanted},
                                         {"<path d='M10 10 L30 10 M40 40 L60 40 L60 60 Z M70 70 l5 0' stroke-width='2'/>", 44 + 200 + 14}, {"<path d='M5 5 M10 10 l0 0 l10 0 l-5 0' stroke-width='2'/>", 24}}) {
        CAPTURE(elements);
        CHECK(area_of(elements) == Approx(area).epsilon(1e-4));
    }
}

TEST_CASE("a corner sharper than a mitre of its width is cut off where OpenSCAD cuts it") {
    const std::string text = measured("<polyline points='10,10 40,10 40,40 10,10' stroke-width='2'/>");
    CHECK(number_behind(text, "\"volume\":{\"value\":") == Approx(203.2894).epsilon(1e-4));
}

TEST_CASE("a stroke that bends follows its curve within a 128th of its width") {
    // Half a turn about (50, 50) on radius 20, 4 wide.
    const double area = area_of("<path d='M30 50 A20 20 0 0 1 70 50' stroke-width='4' stroke-linecap='butt'/>");
    CHECK(area == Approx(80 * kPi).epsilon(1e-2));
    CHECK(area_of("<path d='M10 10 C20 0 30 20 40 10' stroke-width='2'/>") == Approx(69.49).epsilon(2e-3));
}
