// test_program.cpp — the program as a person uses it: each verb on a small scene.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "run_program.h"

namespace {

constexpr const char* kScene = "color([1, 0, 0]) difference() {\n    cube(10, center = true);\n    cylinder(h = 20, r = 3, center = true);\n}\n";

const std::vector<std::string> kSmall{"--imgsize", "48,32", "--samples", "1"};

std::vector<std::string> with_small(std::vector<std::string> words) {
    words.insert(words.end(), kSmall.begin(), kSmall.end());
    return words;
}

}  // namespace

TEST_CASE("spans tells what a ray meets") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", kScene);
    const Outcome through = run_whittle({"spans", scene, "--ray=-20,0,0,2,0,0", "--json"});
    REQUIRE(through.code == 0);
    CHECK(through.out.rfind(R"({"spans":[{"in":{"t":7.5,"t_error":)", 0) == 0);
    CHECK(contains(through.out, R"("point":[-5,0,0],"normal":[-1,0,0],"color":[1,0,0],"surface":)"));
    CHECK(contains(through.out, R"("out":{"t":8.5,)"));
    CHECK(contains(through.out, R"("file":"part.scad","line":3,"certified":true)"));
    CHECK(contains(through.out, R"("interfaces":[]})"));
    CHECK(contains(run_whittle({"spans", scene, "--ray=0,0,-20,0,0,1", "--json"}).out, R"({"spans":[],)"));
    CHECK(contains(run_whittle({"spans", scene, "--ray=4,0,0,0,0,1", "--json"}).out, R"({"spans":[{"in":null,"out":{"t":5,)"));
    CHECK(contains(run_whittle({"spans", scene, "--ray=4,0,0,0,0,1"}).out, "part.scad:2"));
}

TEST_CASE("spans lists the places inside where one matter meets another") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("two.scad", "color([1, 0, 0]) cube(4);\ntranslate([4, 0, 0]) color([0, 0, 1]) cube(4);\ntranslate([8, 0, 0]) color([0, 0, 1]) cube(4);\n");
    const Outcome through = run_whittle({"spans", scene, "--ray=-1,1,2,1,0,0", "--json"});
    REQUIRE(through.code == 0);
    CHECK(contains(through.out, R"("out":{"t":13,)"));
    CHECK(contains(through.out, R"("interfaces":[{"t":5,"t_error":)"));
    CHECK(contains(through.out, R"("point":[4,1,2],"normal":[-1,0,0],"surface":)"));
    CHECK(contains(through.out, R"("from":{"color":[1,0,0],"solid":0,"file":"two.scad","line":1},"to":{"color":[0,0,1],"solid":1,"file":"two.scad","line":2},"certified":true}]})"));
    CHECK(contains(run_whittle({"spans", scene, "--ray=-1,1,2,1,0,0"}).out, "at (4, 1, 2)  matter of two.scad:1 to two.scad:2"));
    CHECK(contains(run_whittle({"spans", scene, "--ray=6,1,2,1,0,0", "--json"}).out, R"("interfaces":[]})"));
}

TEST_CASE("passes switched off change counters and no answer") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("work.scad", "difference() { cube(10); translate([50, 0, 0]) cube(1); }\ncube(10);\ntranslate([3, 3, 3]) sphere(1);\n"
                                                       "difference() { cylinder(3, 2, 1); cylinder(3, 2, 1); }\n");
    const std::vector<std::string> asked{"spans", scene, "--ray=-20,1.5,1.25,1,0,0", "--ray=5,-7,3,0,1,0", "--json"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), asked.begin(), asked.end());
        return run_whittle(more);
    };
    const Outcome all = with({"--stats", folder.file("all.json", "")});
    const Outcome none = with({"--stats", folder.file("none.json", ""), "--disable", "equal,disjoint", "--disable", "buried"});
    CHECK(all.code == 0);
    CHECK(none.code == 0);
    CHECK(all.out == none.out);
    for (const char* name : {"equal", "disjoint", "buried"}) {
        const std::string zero = std::string("\"skip.") + name + "\": 0";
        CHECK_FALSE(contains(folder.read("all.json"), zero));
        CHECK(contains(folder.read("none.json"), zero));
    }
    const Outcome unknown = with({"--disable", "equal,burried"});
    CHECK(unknown.code == 2);
    CHECK(contains(unknown.err, "--disable knows no pass 'burried'; did you mean buried?"));
    CHECK(unknown.out.empty());
}

TEST_CASE("spans answers many rays in order, by the same bytes on any number of threads") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", kScene);
    std::string rays;
    for (int i = 0; i < 5000; ++i) rays += std::to_string(-6 + 0.0024 * i) + " 1 -20 0 0 1\n";
    const Outcome one = run_whittle({"spans", scene, "--rays", "-", "--json", "--threads", "1"}, {rays, "", 0, ""});
    const Outcome four = run_whittle({"spans", scene, "--rays", folder.file("rays.txt", rays), "--json", "--threads", "4"});
    CHECK(one.code == 0);
    CHECK(std::count(one.out.begin(), one.out.end(), '\n') == 5000);
    CHECK(one.out == four.out);
}

TEST_CASE("render writes a picture of the format its name says") {
    const TemporaryFolder folder;
    folder.file("part.scad", kScene);
    const RunOptions there{"", folder.path().string(), 0, ""};
    CHECK(run_whittle(with_small({"part.scad"}), there).code == 0);
    CHECK(folder.read("part.png").substr(1, 3) == "PNG");
    const Outcome several = run_whittle(with_small({"render", "part.scad", "-o", "a.jpg", "-o", "a.exr", "-o", "a.tif", "--json"}), there);
    CHECK(several.code == 0);
    CHECK(several.out.rfind(R"({"file":"a.jpg",)", 0) == 0);
    CHECK(contains(several.out, R"("seconds":)"));
    CHECK(folder.read("a.jpg").substr(0, 3) == "\xFF\xD8\xFF");
    CHECK(folder.read("a.exr").substr(0, 4) == "\x76\x2f\x31\x01");
    CHECK(folder.names() == std::vector<std::string>{"a.exr", "a.jpg", "a.tif", "part.png", "part.scad"});
}

TEST_CASE("shards put together have the bytes of the whole") {
    const TemporaryFolder folder;
    folder.file("part.scad", kScene);
    const RunOptions there{"", folder.path().string(), 0, ""};
    const std::vector<std::string> draw{"render", "part.scad", "--imgsize", "100,80", "--samples", "2"};
    const auto render = [&](std::vector<std::string> more) {
        std::vector<std::string> words = draw;
        words.insert(words.end(), more.begin(), more.end());
        return run_whittle(words, there).code;
    };
    REQUIRE(render({"-o", "whole.exr"}) == 0);
    REQUIRE(render({"-o", "a.exr", "--shard", "1/2"}) == 0);
    REQUIRE(render({"-o", "b.exr", "--shard", "2/2"}) == 0);
    const Outcome merged = run_whittle({"merge", "a.exr", "b.exr", "-o", "ab.exr"}, there);
    INFO(merged.err);
    CHECK(merged.code == 0);
    CHECK(folder.read("a.exr") != folder.read("whole.exr"));
    CHECK(folder.read("ab.exr") == folder.read("whole.exr"));
}

TEST_CASE("measure gives values with their errors") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("box.scad", "cube([2, 3, 4]);\n");
    const Outcome outcome = run_whittle({"measure", scene, "--json"});
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.out, R"({"volume":{"value":)"));
    CHECK(contains(outcome.out, R"("method":")"));
    CHECK(contains(outcome.out, R"("uncertified":0})"));
    CHECK(contains(run_whittle({"measure", scene}).out, "volume"));
}

TEST_CASE("the bounds of a solid with edges that curve askew are found, however slowly they climb") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", R"(
rotate([0, 0, 270]) translate([-1, -1, -0.5]) rotate([270, 0, 0]) intersection() {
    translate([0, 0, 1.5]) rotate([0, 270, 0]) cylinder(h = 1, r = 2, center = true);
    translate([-0.5, 0.5, -1]) rotate([180, 0, 0]) difference() {
        translate([2, -0.5, -2]) rotate([90, 0, 0]) sphere(2.5);
        translate([-0.5, 1, -0.5]) rotate([180, 0, 0]) linear_extrude(2) offset(r = 0.5) square([1, 3]);
    }
}
)");
    CHECK(run_whittle({"measure", scene, "--limit-time", "60"}).code == 0);
}

TEST_CASE("measure says where facets stand for a smooth surface") {
    const TemporaryFolder folder;
    const Outcome twisted = run_whittle({"measure", folder.file("t.scad", "linear_extrude(10, twist = 90, slices = 4) translate([3, 0]) circle(2);\n")});
    CHECK(twisted.code == 0);
    CHECK(contains(twisted.out, "the errors leave out how far those stray"));
    CHECK_FALSE(contains(run_whittle({"measure", folder.file("b.scad", "cylinder(h = 2, r = 1);\n")}).out, "stray"));
}

TEST_CASE("definitions, parameter sets and standard input reach the scene") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("p.scad", "w = 1;\ncube(w);\n");
    const std::string sets = folder.file("p.json", R"({"parameterSets":{"big":{"w":"7"}},"fileFormatVersion":"1"})");
    const auto exit_t = [](const std::string& out) { return out.substr(out.find(R"("out":{"t":)"), 13); };
    const std::string ray = "--ray=.5,.5,-1,0,0,1";
    CHECK(exit_t(run_whittle({"spans", scene, ray, "--json"}).out) == R"("out":{"t":2,)");
    CHECK(exit_t(run_whittle({"spans", scene, ray, "--json", "-D", "w=3"}).out) == R"("out":{"t":4,)");
    CHECK(exit_t(run_whittle({"spans", scene, ray, "--json", "-D", "w=3", "-p", sets, "-P", "big"}).out) == R"("out":{"t":8,)");
    CHECK(exit_t(run_whittle({"spans", "-", ray, "--json"}, {"cube(5);", "", 0, ""}).out) == R"("out":{"t":6,)");
}

TEST_CASE("--clip keeps one side and closes the cut") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("ball.scad", "sphere(5);\n");
    const auto picture = [&](std::vector<std::string> more) {
        std::vector<std::string> words = with_small({"render", scene, "-o", folder.name("a.png")});
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(run_whittle(words).code == 0);
        return folder.read("a.png");
    };
    CHECK(picture({}) != picture({"--clip", "0,-1,0,0"}));
    CHECK(picture({}) == picture({"--clip", "0,-1,0,6"}));
}

TEST_CASE("OpenSCAD's form makes the job that the suffix names") {
    const TemporaryFolder folder;
    folder.file("part.scad", "echo(w = 3);\n" + std::string(kScene));
    const RunOptions there{"", folder.path().string(), 0, ""};
    CHECK(run_whittle({"-o", "a.echo", "part.scad"}, there).code == 0);
    CHECK(folder.read("a.echo") == "ECHO: w = 3\n");
    CHECK(run_whittle({"-o", "a.csg", "-d", "a.d", "part.scad"}, there).code == 0);
    CHECK(contains(folder.read("a.csg"), "cube(size = [10, 10, 10], center = true);"));
    CHECK(contains(folder.read("a.d"), "a.csg: \\\n\tpart.scad"));
    CHECK(run_whittle(with_small({"-o", "a.png", "part.scad"}), there).code == 0);
    CHECK(folder.read("a.png").substr(1, 3) == "PNG");
    const Outcome out = run_whittle({"-o", "-", "--export-format", "echo", "part.scad"}, there);
    CHECK(out.out == "ECHO: w = 3\n");
}

TEST_CASE("$preview is true only for a picture by OpenSCAD's form without --render") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("p.scad", "echo($preview); cube(1);\n");
    const std::string picture = folder.name("a.png");
    CHECK(contains(run_whittle(with_small({"-o", picture, scene})).err, "ECHO: true"));
    CHECK(contains(run_whittle(with_small({"-o", picture, "--render", scene})).err, "ECHO: false"));
    CHECK(contains(run_whittle(with_small({"render", scene, "-o", picture})).err, "ECHO: false"));
}

TEST_CASE("warnings are told, counted when hard, and silent when quiet") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("w.scad", "x = nothere;\ncube(1);\n");
    const std::string ray = "--ray=0,0,-5,0,0,1";
    const Outcome told = run_whittle({"spans", scene, ray});
    CHECK(told.code == 0);
    CHECK(contains(told.err, "WARNING: Ignoring unknown variable 'nothere' in file w.scad, line 1"));
    CHECK(run_whittle({"spans", scene, ray, "-q"}).err.empty());
    CHECK(run_whittle({"spans", scene, ray, "--hardwarnings"}).code == 1);
}

TEST_CASE("what is not supported yet is left out with a warning, exit code 1 unless allowed") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("s.scad", "cube(5);\nsurface(file = \"x.dat\");\n");
    const std::string picture = folder.name("a.png");
    const Outcome left_out = run_whittle(with_small({"render", scene, "-o", picture}));
    CHECK(left_out.code == 1);
    CHECK(contains(left_out.err, "surface"));
    CHECK(folder.names() == std::vector<std::string>{"a.png", "s.scad"});
    CHECK(run_whittle(with_small({"render", scene, "-o", picture, "--allow-missing"})).code == 0);
    CHECK(run_whittle({"measure", scene}).code == 1);
    CHECK(run_whittle({"measure", scene, "--allow-missing"}).code == 0);
}

TEST_CASE("counters are written under their fixed names") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", kScene);
    CHECK(run_whittle({"spans", scene, "--ray=0,0,-20,0,0,1", "--stats", folder.name("s.json")}).code == 0);
    const std::string stats = folder.read("s.json");
    CHECK(contains(stats, "\"solids.in_scene\": 2"));
    CHECK(contains(stats, "\"loaded.image\": 0"));
    CHECK(contains(stats, "\"rays.camera\": 0"));
    CHECK(run_whittle(with_small({"render", scene, "-o", folder.name("a.tif"), "--stats", folder.name("r.json")})).code == 0);
    CHECK(contains(folder.read("r.json"), "\"loaded.image\": 1"));
    CHECK_FALSE(contains(folder.read("r.json"), "\"rays.camera\": 0"));
}

TEST_CASE("bench says which program it needs when that is not there") {
    const TemporaryFolder folder;
    const std::string copy = folder.name("whittle");
    std::filesystem::copy_file(WHITTLE_PROGRAM, copy);
    const Outcome outcome = run_program(copy, {"bench"});
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.err, "whittle-bench"));
}

TEST_CASE("--watch draws at once and ends by an interrupt") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", kScene);
    const Outcome outcome = run_whittle(with_small({"render", scene, "-o", folder.name("a.png"), "--watch"}), {"", "", 2, ""});
    CHECK(outcome.code == 130);
    CHECK(folder.read("a.png").substr(1, 3) == "PNG");
}

TEST_CASE("whittle.scad is an empty file to Whittle and gives OpenSCAD every addition, where it is installed") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("additions.scad",
                                          "include <whittle.scad>\n"
                                          "torus(10, 3); ellipsoid([1, 2, 3]); capsule([0, 0, 0], [0, 5, 5], 1); roundcube(4, 1, center = true);\n"
                                          "intersection() { cube(5); halfspace([1, 1, 1], 3); }\n"
                                          "material(\"gold\") part(\"x\") cube(1); light(p = [1, 2, 3]); sun([0, 0, -1]); area_light(); environment(\"white\");\n"
                                          "camera([9, 9, 9], [0, 0, 0]); moving(translate = [1, 2, 3]) cube(1);\n");
    const Outcome own = run_whittle({"spans", scene, "--ray=-50,0,0,1,0,0"});
    INFO(own.err);
    CHECK(own.code == 0);
    CHECK_FALSE(contains(own.err, "WARNING"));
    if (!std::filesystem::exists("/usr/bin/openscad")) return;
    std::filesystem::copy_file(std::string(WHITTLE_SOURCE_DIR) + "/share/whittle.scad", folder.name("whittle.scad"));
    const Outcome other = run_program("/usr/bin/openscad", {"-o", folder.name("a.csg"), scene});
    INFO(other.err);
    CHECK(other.code == 0);
    CHECK_FALSE(contains(other.err, "WARNING"));
    CHECK(contains(folder.read("a.csg"), "rotate_extrude("));
}

TEST_CASE("an animation is one numbered output a frame, each at its own time") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("turn.scad", "cube([1 + $t, 2, 3]);\n");
    const Outcome made = run_whittle({"-o", folder.name("turn.stl"), "--animate", "4", scene});
    REQUIRE(made.code == 0);
    CHECK(folder.names() == std::vector<std::string>{"turn.scad", "turn00000.stl", "turn00001.stl", "turn00002.stl", "turn00003.stl"});
    CHECK(contains(folder.read("turn00003.stl"), "vertex 1.75 2 3"));
    CHECK(!contains(folder.read("turn00000.stl"), "vertex 1.75"));
    RunOptions there;
    there.folder = folder.path().string();
    CHECK(run_whittle(with_small({"--animate", "2", "turn.scad"}), there).code == 0);
    CHECK(!folder.read("turn00001.png").empty());
}

TEST_CASE("$preview is true where nothing is made of the scene, false for meshes, as in OpenSCAD") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("s.scad", "echo($preview); cube(1);");
    CHECK(run_whittle({"-o", folder.name("a.echo"), scene}).code == 0);
    CHECK(folder.read("a.echo") == "ECHO: true\n");
    CHECK(contains(run_whittle({"-o", folder.name("a.csg"), scene}).err, "ECHO: true"));
    CHECK(contains(run_whittle({"-o", folder.name("a.stl"), scene}).err, "ECHO: false"));
    CHECK(contains(run_whittle({"mesh", scene, "-o", folder.name("b.stl")}).err, "ECHO: false"));
    CHECK(contains(run_whittle({"-o", folder.name("a.png"), "--imgsize=8,8", scene}).err, "ECHO: true"));
    CHECK(contains(run_whittle({"-o", folder.name("a.png"), "--imgsize=8,8", "--render", scene}).err, "ECHO: false"));
}
