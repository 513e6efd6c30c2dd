// test_flat.cpp — the border of 2D sets: arcs stay arcs, areas and boxes are those of the set, files read back to the same set.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "csg/eval/imports.h"
#include "modeler/export/flat_files.h"
#include "modeler/io/dxf.h"
#include "modeler/io/svg.h"

using namespace whittle;

namespace {

constexpr double kPi = 3.14159265358979323846;

Use at(NodeId node, double x, double y) {
    Use use;
    use.node = node;
    use.placement = Placement::translation({x, y, 0});
    return use;
}

Solid set_of(SolidBuilder& b, SetOp op, std::vector<Use> operands) {
    Use root;
    root.node = b.combine(op, std::move(operands));
    return b.finish(root);
}

// A plate with rounded corner, a slot that cuts its edge, and a hole.
Solid plate() {
    SolidBuilder b;
    const NodeId sheet = b.shape(shape::Rectangle{{0, 0}, {30, 20}}), disc = b.shape(shape::Disc{4});
    Use oval = at(b.shape(shape::Disc{1}), 22, 12);
    oval.placement = {{3, 0, 0, 22, 1, 2, 0, 12, 0, 0, 1, 0}};
    return set_of(b, SetOp::kDifference, {at(sheet, 0, 0), at(disc, 0, 10), at(disc, 12, 10), oval});
}
const double kPlateArea = 600 - kPi * 8 - kPi * 16 - kPi * 6;

Solid drawn(const Drawing& drawing) {
    SolidBuilder builder;
    const Use root = drawn_set(builder, drawing, [](double) { return 0; });
    return builder.finish(root);
}

std::size_t curved(const std::vector<Outline>& outlines) {
    std::size_t n = 0;
    for (const auto& o : outlines)
        for (const auto& s : o.sides) n += s.curved;
    return n;
}

}  // namespace

TEST_CASE("a set's outline has its area, its box and its arcs") {
    const auto outlines = outlines_of(plate());
    REQUIRE(outlines.size() == 3);
    CHECK(area_of(outlines) == Approx(kPlateArea).epsilon(1e-12));
    CHECK(curved(outlines) == 3);
    const OutlineBox box = box_of(outlines);
    CHECK(box.lo == Vec2(0, 0));
    CHECK(box.hi == Vec2(30, 20));
}

TEST_CASE("shapes that share a side become one outline; those that touch in a point stay two") {
    SolidBuilder b;
    const NodeId square = b.shape(shape::Rectangle{{0, 0}, {10, 10}});
    const auto joined = outlines_of(set_of(b, SetOp::kUnion, {at(square, 0, 0), at(square, 10, 0)}));
    REQUIRE(joined.size() == 1);
    CHECK(joined[0].sides.size() == 4);
    SolidBuilder c;
    const NodeId other = c.shape(shape::Rectangle{{0, 0}, {10, 10}});
    const auto corner = outlines_of(set_of(c, SetOp::kUnion, {at(other, 0, 0), at(other, 10, 10)}));
    CHECK(corner.size() == 2);
    CHECK(area_of(corner) == 200);
}

TEST_CASE("a lens of two discs has the area of two segments") {
    SolidBuilder b;
    const NodeId disc = b.shape(shape::Disc{5});
    const auto lens = outlines_of(set_of(b, SetOp::kIntersection, {at(disc, 0, 0), at(disc, 6, 0)}));
    REQUIRE(lens.size() == 1);
    CHECK(lens[0].sides.size() == 2);
    CHECK(area_of(lens) == Approx(2 * (25 * std::acos(0.6) - 12)).epsilon(1e-13));
}

TEST_CASE("a disc is one side, and one CIRCLE of a DXF") {
    SolidBuilder b;
    Use disc;
    disc.node = b.shape(shape::Disc{7});
    const auto outlines = outlines_of(b.finish(disc));
    REQUIRE(outlines.size() == 1);
    CHECK(outlines[0].sides.size() == 1);
    CHECK(area_of(outlines) == Approx(49 * kPi).epsilon(1e-14));
    const std::string text = dxf_text(outlines);
    CHECK(text.find("CIRCLE") != std::string::npos);
    CHECK(text.find("LINE") == std::string::npos);
}

TEST_CASE("SVG and DXF read back to the same set") {
    const auto outlines = outlines_of(plate());
    const auto svg = read_svg(svg_text(outlines), {});
    REQUIRE(svg);
    const auto from_svg = outlines_of(drawn(*svg));
    // The ellipse became chords within 2^-17 of the drawing's size.
    const double room = 16 * std::hypot(30, 20) * 0x1p-17;
    CHECK(std::fabs(area_of(from_svg) - kPlateArea) < room);
    const auto dxf = read_dxf(dxf_text(outlines), {});
    REQUIRE(dxf);
    CHECK(dxf->remarks.empty());
    CHECK(std::fabs(area_of(outlines_of(drawn(*dxf))) - kPlateArea) < room);
    CHECK(svg_text(outlines) == svg_text(outlines_of(plate())));
}

TEST_CASE("a drawing with arcs only reads back without loss") {
    SolidBuilder b;
    const NodeId disc = b.shape(shape::Disc{4}), bar = b.shape(shape::Rectangle{{0, -4}, {20, 4}});
    const auto slot = outlines_of(set_of(b, SetOp::kUnion, {at(bar, 0, 0), at(disc, 0, 0), at(disc, 20, 0)}));
    REQUIRE(slot.size() == 1);
    CHECK(slot[0].sides.size() == 4);
    const double area = 160 + 16 * kPi;
    CHECK(area_of(slot) == Approx(area).epsilon(1e-14));
    for (const auto& drawing : {read_svg(svg_text(slot), {}), read_dxf(dxf_text(slot), {})}) {
        REQUIRE(drawing);
        const auto again = outlines_of(drawn(*drawing));
        CHECK(area_of(again) == Approx(area).epsilon(1e-12));
        CHECK(curved(again) >= 2);
    }
}

TEST_CASE("quadratic curves go out as what they are and come back to the same area") {
    const auto curve = [](Vec2 control, Vec2 to) { return DrawnSide{2, {control, to, {}}, 0}; };
    // A round bowl with a hollow flank, a hole of curves in it, and a bar that crosses two of the curves.
    const DrawnContour outer{{0, 0}, {curve({5, -3}, {10, 0}), curve({14, 5}, {9, 9}), curve({5, 6}, {1, 10}), DrawnSide::line({0, 0})}};
    const DrawnContour inner{{3, 3}, {curve({3, 6}, {6, 5}), curve({8, 2}, {3, 3})}};
    const auto green = [](const DrawnContour& c) {
        double twice = 0;
        Vec2 at = c.start;
        for (const DrawnSide& s : c.sides) {
            twice += at.x * s.end().y - at.y * s.end().x;
            if (s.degree == 2) twice += 2.0 / 3 * ((s.p[0].x - at.x) * (s.end().y - at.y) - (s.p[0].y - at.y) * (s.end().x - at.x));
            at = s.end();
        }
        return std::fabs(twice) / 2;
    };
    const auto outlines = outlines_of(drawn({{{{outer, inner}}}, {}}));
    REQUIRE(outlines.size() == 2);
    const double area = green(outer) - green(inner);
    CHECK(area_of(outlines) == Approx(area).epsilon(1e-12));
    const std::string svg = svg_text(outlines), dxf = dxf_text(outlines);
    CHECK(svg.find(" Q ") != std::string::npos);
    CHECK(dxf.find("SPLINE") != std::string::npos);
    for (const auto& drawing : {read_svg(svg, {}), read_dxf(dxf, {})}) {
        REQUIRE(drawing);
        CHECK(drawing->remarks.empty());
        CHECK(area_of(outlines_of(drawn(*drawing))) == Approx(area).epsilon(1e-12));
    }
    // What a bar leaves of it, and the rest, are all of it.
    SolidBuilder b;
    const Use whole = drawn_set(b, {{{{outer, inner}}}, {}}, [](double) { return 0; }), bar = at(b.shape(shape::Rectangle{{-5, 2}, {20, 4.5}}), 0, 0), oval = at(b.shape(shape::Disc{3}), 9, 4);
    for (const Use& other : {bar, oval}) {
        double sum = 0;
        for (const SetOp op : {SetOp::kDifference, SetOp::kIntersection}) {
            SolidBuilder each;
            const Use again = drawn_set(each, {{{{outer, inner}}}, {}}, [](double) { return 0; });
            Use cutter = other;
            cutter.node = each.shape(std::get<Shape>(b.node(other.node)));
            const auto part = outlines_of(set_of(each, op, {again, cutter}));
            for (const Outline& o : part) CHECK(!o.sides.empty());
            sum += area_of(part);
        }
        CHECK(sum == Approx(area).epsilon(1e-10));
    }
    CHECK(whole.node != kEmptyNode);
}

TEST_CASE("contours with arcs that reach over each other's chords are drawn right") {
    // A thin C: outer arc of radius 10, inner of 9, both through 300 degrees, and its ends.
    const double k = std::tan(300 * kPi / 180 / 4), c = std::cos(kPi / 6), s = std::sin(kPi / 6);
    Drawing drawing;
    drawing.figures.push_back({{{Vec2(10 * c, 10 * s), {DrawnSide::arc({10 * c, -10 * s}, k), DrawnSide::line({9 * c, -9 * s}), DrawnSide::arc({9 * c, 9 * s}, -k), DrawnSide::line({10 * c, 10 * s})}}}});
    const auto outlines = outlines_of(drawn(drawing));
    CHECK(area_of(outlines) == Approx(kPi * 19 * 300 / 360).epsilon(1e-9));
}

TEST_CASE("a PDF has its length where it says, and the same bytes each time") {
    const std::string pdf = pdf_text(outlines_of(plate()));
    CHECK(pdf.substr(0, 8) == "%PDF-1.4");
    const std::size_t start = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
    CHECK(pdf.substr(start, 4) == "xref");
    CHECK(pdf == pdf_text(outlines_of(plate())));
}
