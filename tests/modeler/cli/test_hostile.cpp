// test_hostile.cpp — scenes and files made to hurt: a message, an exit code, within the limits; never a crash.
#include <catch2/catch.hpp>

#include "csg/eval/large_stack.h"
#include "run_program.h"

namespace {

Outcome echo_of(const TemporaryFolder& folder, const std::string& scene, const std::vector<std::string>& more = {}) {
    folder.file("a.scad", scene);
    std::vector<std::string> words{"-o", "a.echo", "a.scad"};
    words.insert(words.end(), more.begin(), more.end());
    return run_whittle(words, {"", folder.path().string(), 0, ""});
}

std::string repeated(const std::string& text, std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += text;
    return out;
}

}  // namespace

TEST_CASE("a hundred thousand brackets of any kind are refused with a place") {
    constexpr std::size_t kMany = 100000;
    const TemporaryFolder folder;
    for (const std::string& scene : {"a = " + repeated("(", kMany) + "1" + repeated(")", kMany) + ";", "a = " + repeated("[", kMany) + repeated("]", kMany) + ";",
                                    repeated("{", kMany) + repeated("}", kMany), repeated("union() ", kMany) + "cube();", repeated("f(", kMany), "a = " + repeated("-", kMany) + "1;",
                                    "a = " + repeated("1 ? 1 : ", kMany) + "1;", "a = 1" + repeated("[0]", kMany) + ";"}) {
        const Outcome outcome = echo_of(folder, scene);
        INFO(scene.substr(0, 20) << outcome.err);
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.err, "in file a.scad, line 1"));
    }
}

TEST_CASE("operators may be chained as long as generated texts chain them") {
    constexpr std::size_t kMany = whittle::kDeepestTree - 10;
    const TemporaryFolder folder;
    const std::string number = std::to_string(kMany + 1);
    CHECK(echo_of(folder, "echo(str(1" + repeated(" + 1", kMany) + "), true" + repeated(" && true", kMany) + ", ([1]" + repeated(" + [1]", kMany) + ")[0] / " + number + ");").code == 0);
    CHECK(folder.read("a.echo") == "ECHO: \"" + number + "\", true, 1\n");
    CHECK(echo_of(folder, "function f(x) = x < 1 ? 0 : f(x - 1)" + repeated(" + 1", kMany - 10) + "; echo(f(2));").code == 0);
    CHECK(folder.read("a.echo") == "ECHO: " + std::to_string(2 * (kMany - 10)) + "\n");
    const Outcome longer = echo_of(folder, "a = 1" + repeated(" + 1", kMany + 20) + ";");
    CHECK(longer.code == 1);
    CHECK(contains(longer.err, "more than " + std::to_string(whittle::kDeepestTree) + " operators within each other"));
}

TEST_CASE("vectors of a million elements are read and made") {
    const TemporaryFolder folder;
    const Outcome read = echo_of(folder, "a = [" + repeated("1,", 1000000) + "1]; echo(len(a));");
    INFO(read.err);
    CHECK(read.code == 0);
    CHECK(folder.read("a.echo") == "ECHO: 1e+6\n");
    CHECK(echo_of(folder, "a = [for (i = [1:999999]) i]; b = concat(a, [1]); echo(len(b), b[999998], len([each a, each b]));").code == 0);
    CHECK(folder.read("a.echo") == "ECHO: 1e+6, 999999, 2e+6\n");
}

TEST_CASE("recursion and loops without end are told, within the limit of time where they give no other sign") {
    struct Endless { const char* scene; int code; const char* part; };
    const Endless scenes[] = {
        {"function f(n) = 1 + f(n + 1);\necho(f(0));", 1, "Recursion detected calling function 'f' in file a.scad, line 1"},
        {"function f(n) = f(n + 1);\necho(f(0));", 1, "Recursion detected calling function 'f' in file a.scad, line 1"},
        {"f = function(n) 1 + f(n + 1);\necho(f(0));", 1, "Recursion detected calling function 'f'"},
        {"module m() m();\nm();", 1, "Recursion detected calling module 'm' in file a.scad, line 1"},
        {"module a() b();\nmodule b() a();\na();", 1, "Recursion detected calling module"},
        {"a = [for (i = 0; true; i = i) i];", 1, "For loop counter exceeded limit in file a.scad, line 1"},
        {"a = [for (i = [0:1e9]) i];", 0, "too many elements (1000000001)"},
        {"a = [for (i = [0:1/0]) i];", 0, "too many elements (4294967295)"},
        {"for (i = [0:1:1e5]) cube();", 0, "too many elements (100001)"},
        {"r = [0:1:900000]; a = [for (i = r, j = r) i];", 3, "time limit"},
        {"function f(n) = n < 2 ? 1 : f(n - 1) + f(n - 2);\necho(f(60));", 3, "time limit"},
    };
    for (const Endless& endless : scenes) {
        const TemporaryFolder folder;
        const Outcome outcome = echo_of(folder, endless.scene, {"--limit-time", endless.code == 3 ? "4" : "60", "--limit-memory", "3000"});
        INFO(endless.scene << "\n" << outcome.err);
        CHECK(outcome.code == endless.code);
        CHECK(contains(outcome.err, endless.part));
    }
}

TEST_CASE("what would fill the memory ends at the limit of memory") {
    for (const char* scene : {"function grow(v) = grow(concat(v, v));\na = grow([1, 2, 3]);", "function grow(s) = grow(str(s, s));\na = grow(\"abc\");",
                              "a = [for (i = [0:999998]) [for (j = [0:999]) i]];"}) {
        const TemporaryFolder folder;
        const Outcome outcome = echo_of(folder, scene, {"--limit-memory", "300", "--limit-time", "60"});
        INFO(scene << "\n" << outcome.err);
        CHECK(outcome.code == 3);
        CHECK(contains(outcome.err, "memory"));
        CHECK_FALSE(contains(outcome.err, "time limit"));
    }
}

TEST_CASE("files that include or use each other end, and say so") {
    const TemporaryFolder folder;
    folder.file("b.scad", "include <c.scad>\necho(\"b\");\n");
    folder.file("c.scad", "include <b.scad>\necho(\"c\");\n");
    const Outcome includes = echo_of(folder, "include <b.scad>\n");
    CHECK(includes.code == 0);
    CHECK(folder.read("a.echo") == "WARNING: Can't open include file 'b.scad'.\nECHO: \"c\"\nECHO: \"b\"\n");
    CHECK(contains(includes.err, "include <b.scad>\n^\nasked for in file c.scad, line 1; it is being read already: files include each other"));
    folder.file("d.scad", "use <e.scad>\nfunction d() = 1 + e();\nfunction one() = 1;\n");
    folder.file("e.scad", "use <d.scad>\nfunction e() = one();\n");
    CHECK(echo_of(folder, "use <d.scad>\necho(d());\n").code == 0);
    CHECK(folder.read("a.echo") == "ECHO: 2\n");
}

TEST_CASE("an STL whose header promises a gigabyte is not believed") {
    const TemporaryFolder folder;
    std::string stl(80, ' ');
    stl += std::string("\x80\xF0\xFA\x02", 4) + std::string(50, '\0');  // 50,000,000 triangles, one of them there
    folder.file("lies.stl", stl);
    folder.file("a.scad", "import(\"lies.stl\");\n");
    const Outcome outcome = run_whittle({"measure", "a.scad", "--limit-memory", "200"}, {"", folder.path().string(), 0, ""});
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "lies.stl"));
    CHECK(contains(outcome.err, "in file a.scad, line 1"));
}

TEST_CASE("a scene reads the files it names and no others, and runs nothing") {
    const TemporaryFolder folder;
    folder.file("b.scad", "b = 1;\n");
    folder.file("secret.scad", "s = 1;\n");
    folder.file("a.scad", "include <b.scad>\necho(\"$(touch ran)\", \"`touch ran`\"); cube(b);\n// include <secret.scad>\n");
    const Outcome outcome = run_whittle({"-o", "a.csg", "-d", "a.d", "a.scad"}, {"", folder.path().string(), 0, ""});
    CHECK(outcome.code == 0);
    CHECK(folder.names() == std::vector<std::string>{"a.csg", "a.d", "a.scad", "b.scad", "secret.scad"});
    CHECK(contains(folder.read("a.d"), "b.scad"));
    CHECK_FALSE(contains(folder.read("a.d"), "secret.scad"));
}
