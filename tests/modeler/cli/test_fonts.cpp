// test_fonts.cpp — the program and fonts: opened by text() only, a missing one is named with what stands in for it.
#include <catch2/catch.hpp>

#include <cstdlib>

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
    const std::string bent = "hull() { intersection() { sphere(2); cube(3); } translate([5, 0, 0]) cylinder(h = 1, r1 = 2, r2 = 1); }\n";
    const std::string scene = folder.file("part.scad", bent + "translate([0, 9, 0]) " + bent);
    const Outcome out = run_whittle({"spans", scene, "--ray=-5,0,0.5,1,0,0", "--stats", folder.name("s.json")});
    CHECK(out.code == 0);
    const std::size_t first = out.err.find("hull() has no exact form here");
    REQUIRE(first != std::string::npos);
    CHECK(out.err.find("hull() has no exact form here", first + 1) == std::string::npos);
    CHECK(contains(folder.read("s.json"), "\"mesh.fallback\": 2"));  // the second hull finds the meshes of the first
}

TEST_CASE("hulls and sums of convex bodies that share no axis go through no mesh") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "hull() { sphere(5); translate([20, 0, 0]) cylinder(r = 3, h = 10); }\n"
                                                       "translate([0, 40, 0]) minkowski() { rotate([90, 0, 30]) cylinder(r = 3, h = 10); scale([1, 2, 3]) sphere(1); }\n");
    const Outcome out = run_whittle({"spans", scene, "--ray=-10,0.1,0.2,1,0,0", "--json", "--stats", folder.name("s.json")});
    CHECK(out.code == 0);
    CHECK_FALSE(contains(out.err, "no exact form"));
    CHECK(contains(folder.read("s.json"), "\"mesh.fallback\": 0"));
    CHECK(contains(out.out, "\"certified\":true"));
    CHECK_FALSE(contains(out.out, "\"certified\":false"));
    const Outcome checked = run_whittle({"check", scene});
    CHECK(checked.code == 0);
    CHECK(contains(checked.out, "genus 0, 2 shells"));
}

TEST_CASE("flat faces of sums of convex bodies are flat in the mesh too") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "minkowski() { cylinder(r = 5, h = 3); rotate([0, 90, 0]) cylinder(r = 1, h = 2); }\n");
    CHECK(run_whittle({"check", scene, "--lines", "4096"}).code == 0);
}

TEST_CASE("OPENSCAD_FONT_PATH names folders of fonts") {
    const TemporaryFolder folder;
    const std::string font = run_program("/usr/bin/fc-match", {"-f", "%{file}", "Liberation Sans"}).out;
    REQUIRE(contains(font, "Liberation"));
    std::filesystem::create_directory(folder.path() / "own");
    std::filesystem::create_directory(folder.path() / "none");
    std::filesystem::copy_file(font, folder.path() / "own" / std::filesystem::path(font).filename());
    // A machine without fonts.
    const std::string none = folder.name("none");
    const std::string bare = folder.file("fonts.conf", "<?xml version=\"1.0\"?><fontconfig><dir>" + none + "</dir><cachedir>" + none + "</cachedir></fontconfig>");
    const std::string scene = folder.file("part.scad", "linear_extrude(1) text(\"H\", font = \"Liberation Sans\");");
    const auto spans = [&](const std::string& path) {
        return run_program("/usr/bin/env", {"FONTCONFIG_FILE=" + bare, "OPENSCAD_FONT_PATH=" + path, WHITTLE_PROGRAM, "spans", scene, "--ray=-5,5,0.5,1,0,0"});
    };
    const Outcome without = spans(""), with = spans(folder.name("own"));
    CHECK(without.code == 1);
    CHECK(contains(without.err, "no font is installed"));
    CHECK(with.code == 0);
    CHECK(with.err.empty());
    CHECK(contains(with.out, "in  t 6.13"));
}

TEST_CASE("a letter is made of its font's curves, and of chords where facets are asked for") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "linear_extrude(2) text(\"o\", size = 10, font = \"Liberation Sans\");");
    const auto normal = [&](const std::string& curves) { return run_whittle({"spans", scene, "--curves=" + curves, "--ray=-5,4.3,1,1,0,0.001", "--json"}); };
    const Outcome curved = normal("auto"), faceted = normal("faceted");
    CHECK(curved.code == 0);
    CHECK(faceted.code == 0);
    CHECK(contains(curved.out, "\"certified\":true"));
    CHECK_FALSE(contains(curved.out, "\"certified\":false"));
    CHECK(curved.out != faceted.out);
    const Outcome agree = run_whittle({"check", scene});
    CHECK(agree.code == 0);
    CHECK(contains(agree.out, "genus 1, 1 shells"));
}
