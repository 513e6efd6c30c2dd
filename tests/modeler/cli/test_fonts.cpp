// test_fonts.cpp — the program and fonts: opened by text() only, a missing one is named with what stands in for it.
#include <catch2/catch.hpp>

#include "run_program.h"

TEST_CASE("fonts are opened by scenes with text only") {
    const TemporaryFolder folder;
    const std::vector<std::string> ray{"--ray=-5,5,1,1,0,0", "--json", "--stats", folder.name("s.json")};
    const auto spans = [&](const std::string& scene) {
        std::vector<std::string> words{"spans", folder.file("part.scad", scene)};
        words.insert(words.end(), ray.begin(), ray.end());
        return run_whittle(words);
    };
    CHECK(spans("cube(10);").code == 0);
    CHECK(contains(folder.read("s.json"), "\"loaded.font\": 0"));
    const Outcome letter = spans("linear_extrude(2) text(\"H\", size = 10);");
    CHECK(letter.code == 0);
    CHECK(contains(folder.read("s.json"), "\"loaded.font\": 1"));
    CHECK(contains(letter.out, "\"in\""));
}

TEST_CASE("a font that is not installed is a warning that names the one that stands in for it") {
    const TemporaryFolder folder;
    const Outcome out = run_whittle({"spans", folder.file("part.scad", "linear_extrude(2) text(\"H\", font = \"No Such Font\");"), "--ray=-5,5,1,1,0,0"});
    CHECK(out.code == 0);
    CHECK(contains(out.err, "WARNING: Font 'No Such Font' is not installed, '"));
    CHECK(contains(out.err, "' stands in for it in file part.scad, line 1"));
}

TEST_CASE("what has no exact form is said once and counted") {
    const TemporaryFolder folder;
    const std::string bent = "hull() { rotate([90, 0, 0]) cylinder(h = 2, r = 1); translate([5, 0, 0]) cylinder(h = 1, r1 = 2, r2 = 1); }\n";
    const std::string scene = folder.file("part.scad", bent + "translate([0, 9, 0]) " + bent);
    const Outcome out = run_whittle({"spans", scene, "--ray=-5,0,0.5,1,0,0", "--stats", folder.name("s.json")});
    CHECK(out.code == 0);
    const std::size_t first = out.err.find("hull() has no exact form here");
    REQUIRE(first != std::string::npos);
    CHECK(out.err.find("hull() has no exact form here", first + 1) == std::string::npos);
    CHECK(contains(folder.read("s.json"), "\"mesh.fallback\": 2"));  // the second hull finds the meshes of the first
}
