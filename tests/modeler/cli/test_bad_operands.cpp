// test_bad_operands.cpp — meshes that are not what a solid is bounded by, as operands: mended and said, or refused with the place named; never a crash, never
// half a file.
#include <catch2/catch.hpp>

#include "modeler/mesh/mesh_files.h"
#include "tests/modeler/cli/run_program.h"

using namespace whittle;

namespace {

const std::string kCorners = "0 0 0\n10 0 0\n10 10 0\n0 10 0\n0 0 10\n10 0 10\n10 10 10\n0 10 10\n";
const std::string kBottom = "4 0 3 2 1\n", kSides = "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n", kTop = "4 4 5 6 7\n";

std::string off(int points, int facets, const std::string& body) { return "OFF\n" + std::to_string(points) + " " + std::to_string(facets) + " 0\n" + body; }

struct Operand {
    const char* what;
    std::string text;
    const char* said;  // part of a warning or an error; "": nothing need be said
};

// Of a cube of side 10, in the ways files are bad.
std::vector<Operand> operands() {
    std::string inverted = "4 1 2 3 0\n4 4 5 1 0\n4 5 6 2 1\n4 6 7 3 2\n4 7 4 0 3\n4 7 6 5 4\n", again;
    for (int i = 0; i < 3; ++i) again += kTop;
    const std::string nan = "0 0 0\n10 0 nan\n10 10 0\n0 10 0\n0 0 10\n10 0 10\n10 10 10\n0 10 10\n";
    const std::string huge = "0 0 0\n1e300 0 0\n1e300 1e300 0\n0 1e300 0\n0 0 1e300\n1e300 0 1e300\n1e300 1e300 1e300\n0 1e300 1e300\n";
    const std::string bow = "0 0 0\n10 10 0\n10 0 0\n0 10 0\n0 0 10\n10 10 10\n10 0 10\n0 10 10\n";
    return {{"whole", off(8, 6, kCorners + kBottom + kSides + kTop), ""},
            {"open", off(8, 5, kCorners + kBottom + kSides), "open"},
            {"facets twice", off(8, 8, kCorners + kBottom + kSides + again), "twice"},
            {"inside out", off(8, 6, kCorners + inverted), ""},
            {"crossing itself", off(8, 6, bow + kBottom + kSides + kTop), ""},
            {"empty", off(0, 0, ""), ""},
            {"a number that is none", off(8, 6, nan + kBottom + kSides + kTop), "point"},
            {"huge", off(8, 6, huge + kBottom + kSides + kTop), ""},
            {"an index that is none", off(8, 6, kCorners + kBottom + kSides + "4 4 5 6 99\n"), ""},
            {"a facet alone", off(3, 1, "0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n"), ""}};
}

}  // namespace

TEST_CASE("booleans with meshes that bound nothing end in a closed mesh or in a message") {
    for (const Operand& operand : operands())
        for (const std::string op : {"difference", "intersection", "union"}) {
            INFO(operand.what << " in " << op);
            const TemporaryFolder folder;
            folder.file("bad.off", operand.text);
            const std::string scene = folder.file("part.scad", op + "() { translate([-3, -3, -3]) cube(9); import(\"bad.off\"); }\n");
            const Outcome run = run_whittle({"mesh", scene, "-o", folder.name("out.off"), "--limit-memory", "2000"});
            INFO(run.err);
            CHECK(contains(run.err, operand.said));
            const bool written = folder.names() == std::vector<std::string>{"bad.off", "out.off", "part.scad"};
            CHECK((written || folder.names() == std::vector<std::string>{"bad.off", "part.scad"}));
            if (!written) {
                CHECK((run.code == 1 || run.code == 3));
                CHECK(contains(run.err, "ERROR"));
                continue;
            }
            const auto mesh = read_mesh(folder.read("out.off"), "out.off");
            REQUIRE(mesh);
            CHECK(report_mesh(*mesh).valid());
        }
}

TEST_CASE("an operand that is only inside out, twice listed or open is mended to the solid it means") {
    for (const Operand& operand : operands()) {
        const std::string what = operand.what;
        if (what != "whole" && what != "open" && what != "facets twice" && what != "inside out") continue;
        INFO(what);
        const TemporaryFolder folder;
        folder.file("bad.off", operand.text);
        const Outcome run = run_whittle({"measure", folder.file("part.scad", "difference() { import(\"bad.off\"); translate([2, 2, -1]) cube([3, 3, 20]); }\n")});
        CHECK(run.code == 0);
        CHECK(contains(run.out, "910"));
    }
}
