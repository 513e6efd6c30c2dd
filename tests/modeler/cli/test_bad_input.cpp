// test_bad_input.cpp — what is wrong is said with its place and an exit code, and leaves what was there before.
#include <catch2/catch.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include "run_program.h"

namespace {

// Text of a scene that ends with `code`; the message holds `part`.
struct BadScene {
    const char* name;
    const char* text;
    int code;
    const char* part;
};

}  // namespace

TEST_CASE("a file that is not there is named, with the system's reason") {
    for (const char* verb : {"render", "mesh", "check", "measure"}) {
        const Outcome outcome = run_whittle({verb, "/nowhere/a.scad"});
        INFO(verb);
        CHECK(outcome.code == 3);
        CHECK(contains(outcome.err, "/nowhere/a.scad"));
        CHECK(contains(outcome.err, "No such file or directory"));
    }
}

TEST_CASE("a scene that is wrong says so and writes nothing") {
    const BadScene scenes[] = {
        {"syntax error", "cube(10;\n", 1, "syntax error in file a.scad, line 1"},
        {"unfinished", "difference() { cube(1);\n", 1, "syntax error in file a.scad"},
        {"unreadable include", "include <nothere.scad>\ncube(1);\n", 0, "Can't open include file 'nothere.scad'"},
        {"unreadable library", "use <nothere.scad>\ncube(1);\n", 0, "Can't open library 'nothere.scad'"},
        {"failed assert", "assert(1 > 2, \"no\");\ncube(1);\n", 1, "Assertion '(1 > 2)' failed: \"no\""},
        {"recursion without end", "module m() { m(); }\nm();\n", 1, "Recursion detected calling module 'm' in file a.scad, line 1"},
        {"function recursion without end", "function f(x) = f(x + 1) + 1;\ncube(f(1));\n", 1, "Recursion detected calling function 'f' in file a.scad, line 1"},
        {"nothing", "", 1, "Current top level object is empty"},
        {"division by zero as a size", "cube(1 / 0);\n", 1, "cube() has size inf, left out in file a.scad, line 1"},
        {"not a number as a size", "sphere(r = 0 / 0);\n", 1, "nan, left out in file a.scad, line 1"},
        {"not a number in a list", "cube([1, 2, 0 / 0]);\n", 1, "nan, left out in file a.scad, line 1"},
        {"not a number in a placement", "translate([0 / 0, 0, 0]) cube(1);\n", 0, "WARNING: Unable to convert translate([nan, 0, 0])"},
        {"negative size", "cube([1, -2, 3]);\n", 1, "cube() has size -2, left out in file a.scad, line 1"},
        {"negative radius", "sphere(-3);\n", 1, "sphere() has radius -3, left out in file a.scad, line 1"},
        {"negative cylinder", "cylinder(h = 2, r = -1);\n", 1, "cylinder() has radius -1, left out in file a.scad, line 1"},
        {"negative tube", "torus(r1 = 5, r2 = -1);\n", 1, "torus() has tube radius -1, left out in file a.scad, line 1"},
        {"zero scale", "scale([1, 0, 1]) cube(1);\n", 1, "Scaling a 3D object with 0 - removing object in file a.scad, line 1"},
        {"unknown material", "material(\"glas\") cube(1);\n", 1, "did you mean \"glass\"?"},
        {"emission without end", "include <whittle.scad>\nmaterial(\"emissive\", emission = [1 / 0, 1, 1]) cube(1);\n", 0, "Unable to convert material(emission) = [inf, 1, 1] to a vec3 of numbers in file a.scad, line 2"},
        {"power without end", "include <whittle.scad>\ncube(1);\nlight(p = [9, 9, 9], power = 1 / 0);\n", 0, "Unable to convert light(power) = inf to a number in file a.scad, line 3"},
        {"a light at no place", "include <whittle.scad>\ncube(1);\nlight(p = [0 / 0, 9, 9]);\n", 0, "Unable to convert light(p) = [nan, 9, 9] to a vec3 of numbers in file a.scad, line 3"},
        {"no light at all", "include <whittle.scad>\ncube(1);\nenvironment(color = \"black\");\n", 0, "The lights of the scene are all black"},
        {"open polyhedron", "polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3]]);\n", 1,
         "polyhedron() is not closed (3 open edges), left out in file a.scad, line 1"},
    };
    for (const auto& scene : scenes) {
        const TemporaryFolder folder;
        folder.file("a.scad", scene.text);
        const Outcome outcome = run_whittle({"render", "a.scad", "--imgsize", "32,32", "--samples", "1"}, {"", folder.path().string(), 0, ""});
        INFO(scene.name << ": " << outcome.err);
        CHECK(outcome.code == scene.code);
        CHECK(contains(outcome.err, scene.part));
        if (scene.code != 0 && scene.name != std::string("unknown material")) CHECK(folder.names() == std::vector<std::string>{"a.scad"});
    }
}

TEST_CASE("an output whose folder is not there is said before the scene is read") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "echo(\"read\"); cube(1);\n");
    folder.file("file", "");
    for (const char* out : {"none/a.stl", "none/a.png", "none/a.echo", "file/a.off"}) {
        const Outcome outcome = run_whittle({"-o", folder.name(out), scene});
        INFO(out);
        CHECK(outcome.code == 3);
        CHECK(contains(outcome.err, std::string("ERROR: cannot write '") + folder.name(out) + "': "));
        CHECK_FALSE(contains(outcome.err, "read"));
    }
    CHECK(folder.names() == std::vector<std::string>{"a.scad", "file"});
}

TEST_CASE("what is flat has no mesh and no measure") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "square(3);\n");
    for (const char* verb : {"mesh", "check", "measure"}) {
        const Outcome outcome = run_whittle({verb, scene});
        INFO(verb);
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.err, "Current top level object is not a 3D object.\nlinear_extrude(height) makes a solid of it"));
        CHECK(outcome.out.empty());
    }
}

TEST_CASE("a syntax error is told with file, line and column as JSON") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "cube(1);\nsphere(2;\n");
    const Outcome outcome = run_whittle({"spans", scene, "--ray=0,0,0,0,0,1", "--diagnostics=json"});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, R"({"severity":"error","text":)"));
    CHECK(contains(outcome.err, R"("file":"a.scad","line":2,"column":)"));
    CHECK(outcome.out.empty());
}

TEST_CASE("every prefix of a scene ends in an answer or a message, never in a crash") {
    const std::string text = "module m(a=[1,2]) { for (i=a) translate([i,0,0]) cube(i); }\nm(); x = let(b=3) b > 2 ? \"y\" : [for(i=[0:2]) i];\n";
    const TemporaryFolder folder;
    for (std::size_t length = 0; length <= text.size(); length += 3) {
        const Outcome outcome = run_whittle({"spans", "-", "--ray=0,0,0,0,0,1"}, {text.substr(0, length), "", 0, ""});
        INFO(text.substr(0, length) << "\n" << outcome.err);
        CHECK((outcome.code == 0 || outcome.code == 1));
        if (outcome.code == 1) CHECK_FALSE(outcome.err.empty());
    }
}

TEST_CASE("an output that cannot be written is named and what was there stays") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "cube(1);\n");
    const Outcome nowhere = run_whittle({"render", scene, "-o", "/nowhere/a.png", "--imgsize", "16,16", "--samples", "1"});
    CHECK(nowhere.code == 3);
    CHECK(contains(nowhere.err, "/nowhere/a.png"));

    mkdir(folder.name("a.png").c_str(), 0755);
    const Outcome onto_folder = run_whittle({"render", scene, "-o", folder.name("a.png"), "--imgsize", "16,16", "--samples", "1"});
    CHECK(onto_folder.code == 3);
    CHECK(folder.names() == std::vector<std::string>{"a.png", "a.scad"});
}

TEST_CASE("a full disk is told and leaves no broken file") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "cube(1);\n");
    const Outcome picture = run_whittle({"-o", "/dev/full", "--export-format", "png", "--imgsize", "16,16", "--samples", "1", scene});
    CHECK(picture.code == 3);
    CHECK(contains(picture.err, "No space left on device"));
    const Outcome stats = run_whittle({"spans", scene, "--ray=0,0,-5,0,0,1", "--stats", "/dev/full"});
    CHECK(stats.code == 3);
    const Outcome answer = run_whittle({"spans", scene, "--ray=0,0,-5,0,0,1", "--json"}, {"", "", 0, "/dev/full"});
    CHECK(answer.code == 3);
    CHECK(contains(answer.err, "No space left on device"));
}

TEST_CASE("a file system that runs full while a picture is written keeps what was there") {
    const TemporaryFolder folder;
    // A file system of 48 kB, mounted for this shell alone; the picture needs 200 kB.
    const char* script = "mount -t tmpfs -o size=48k tmpfs \"$1/full\" 2>/dev/null || exit 77\n"
                         "cd \"$1/full\" && echo 'what was there' > a.exr || exit 77\n"
                         "\"$2\" render ../a.scad -o a.exr --imgsize 300,300 --samples 1 --aov depth,normal; echo \"exit $?\"; ls; cat a.exr\n"
                         "\"$2\" mesh ../fine.scad -o a.stl; echo \"exit $?\"; ls\n";
    folder.file("a.scad", "sphere(10);\n");
    folder.file("fine.scad", "sphere(10, $fn = 100);\n");
    std::filesystem::create_directory(folder.path() / "full");
    const Outcome outcome = run_program("/usr/bin/unshare", {"-rm", "sh", "-c", script, "sh", folder.path().string(), WHITTLE_PROGRAM});
    if (outcome.code == 77 || !contains(outcome.out, "exit ")) {
        WARN("no file system can be mounted here: " << outcome.err);
        return;
    }
    INFO(outcome.err);
    CHECK(outcome.out == "exit 3\na.exr\nwhat was there\nexit 3\na.exr\n");
    CHECK(contains(outcome.err, "No space left on device"));
}

TEST_CASE("the command line is wrong: exit code 2, before anything is read or written") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "cube(1);\n");
    const std::vector<std::vector<std::string>> lines{{}, {"render"}, {"render", scene, "--nonsense"}, {"render", scene, "-o", folder.name("a.xyz")},
                                                      {"-o", folder.name("a.xyz"), scene}, {"-o", folder.name("a.nef3"), scene}, {"mesh", scene, "-o", folder.name("a.png")},
                                                      {"spans", scene}, {"render", scene, "--camera", "1,2"}};
    for (const auto& line : lines) {
        const Outcome outcome = run_whittle(line);
        INFO((line.empty() ? std::string("no arguments") : line.back()) << ": " << outcome.err);
        CHECK(outcome.code == 2);
        CHECK_FALSE(outcome.err.empty());
        CHECK(outcome.out.empty());
    }
    CHECK(folder.names() == std::vector<std::string>{"a.scad"});
}

TEST_CASE("a suite of no scenes is no success") {
    const TemporaryFolder folder;
    const Outcome run = run_whittle({"check", "--suite", folder.path().string()});
    CHECK(run.code == 1);
    CHECK(contains(run.err, "no .scad file"));
}

TEST_CASE("a suite in a folder of folders names those that hold scenes") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "parts");
    std::filesystem::create_directories(folder.path() / "pictures");
    folder.file("parts/a.scad", "cube(1);\n");
    const Outcome run = run_whittle({"check", "--suite", folder.path().string()});
    CHECK(run.code == 1);
    CHECK(contains(run.err, (folder.path() / "parts").string()));
    CHECK_FALSE(contains(run.err, "pictures"));
}

TEST_CASE("a line that is no ray is named by its number") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "cube(1);\n");
    const Outcome outcome = run_whittle({"spans", scene, "--rays", "-", "--json"}, {"0 0 -5 0 0 1\n# a remark\n\n0 0 1\n", "", 0, ""});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "standard input, line 4"));
}

TEST_CASE("the time limit and the memory limit end the run with 3") {
    const TemporaryFolder folder;
    const std::string busy = folder.file("busy.scad", "function f(n) = n < 2 ? n : f(n - 1) + f(n - 2);\ncube(f(45));\n");
    const Outcome late = run_whittle({"render", busy, "-o", folder.name("a.png"), "--limit-time", "0.3"});
    CHECK(late.code == 3);
    CHECK(contains(late.err, "time limit"));
    const std::string large = folder.file("large.scad", "a = [for (i = [0:900000]) for (j = [0:50]) [i, j]];\ncube(len(a));\n");
    const Outcome heavy = run_whittle({"render", large, "-o", folder.name("a.png"), "--limit-memory", "150"});
    CHECK(heavy.code == 3);
    CHECK(contains(heavy.err, "memory limit"));
    CHECK(folder.names() == std::vector<std::string>{"busy.scad", "large.scad"});
}

TEST_CASE("an interrupted command writes nothing; an interrupted rendering writes its whole picture so far") {
    const TemporaryFolder folder;
    const std::string busy = folder.file("busy.scad", "function f(n) = n < 2 ? n : f(n - 1) + f(n - 2);\ncube(f(45));\n");
    const Outcome stopped = run_whittle({"measure", busy}, {"", "", 0.3, ""});
    CHECK(stopped.code == 130);
    CHECK(stopped.out.empty());
    CHECK(folder.names() == std::vector<std::string>{"busy.scad"});

    const std::string scene = folder.file("a.scad", "difference() { cube(10); sphere(9); }\n");
    const Outcome picture = run_whittle({"render", scene, "-o", folder.name("a.png"), "--samples", "100000", "--imgsize", "200,200"}, {"", "", 1.5, ""});
    CHECK(picture.code == 130);
    CHECK(folder.names() == std::vector<std::string>{"a.png", "a.png.part", "a.scad", "busy.scad"});
    CHECK(folder.read("a.png").substr(1, 3) == "PNG");
}
