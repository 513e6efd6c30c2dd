// Broken and hostile texts: a clear message, never a crash.
#include <filesystem>
#include <random>

#include <catch2/catch.hpp>

#include "csg/eval/large_stack.h"
#include "csg/lang/lexer.h"
#include "tests/csg/eval/memory_files.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// A text that meets most of the grammar.
const char* const kSample = R"(include <part.scad>
use <lib.scad>
$fn = 8; a = [1, "two", [3:4], undef];
function f(x, y=2) = x > 0 ? let (z = x - 1) f(z, y=y) : assert(y == 2, "y") echo("f", x) [for (i=[0:2]) if (i != 1) i else each [i, i]];
module m(s=1, $q=3) { t = s * 2; if (t > 1) cube([t, t, 1], center=true); else sphere(r=t); children(); for (k=[0:1]) translate([k, 0, 0]) children(0); }
%m(2) { #cylinder(h=3, r1=1, r2=0); g = function(p) p ^ 2 % 7; echo(g(3), a[1][0], a.x, -a[0], !true || false && 1); }
difference() { *cube(9); intersection_for(n=[1:2]) rotate([0, 0, n * 30]) square([4, 1]); linear_extrude(height=2, twist=30) circle(1); }
echo([for (i=0, j=1; i < 3; i = i + 1, j = j * 2) j], f(2), str("a\n", 1e3, .5, PI)); // end
)";

Evaluated tried(const std::string& text) {
    EvaluateInput input;
    input.limits.seconds = 5;
    return run(text, input, {{"part.scad", "b = 4;\n"}, {"lib.scad", "function q() = 1;\n"}});
}

bool has(const Evaluated& made, const std::string& part) {
    for (const Diagnostic& d : made.diagnostics.all())
        if (d.text.find(part) != std::string::npos) return true;
    return false;
}

// In a run that stopped, an error says why; a place points into a text that was read.
void check_sound(const Evaluated& made) {
    if (made.stopped()) CHECK(made.diagnostics.has_errors());
    REQUIRE(made.scene.root < made.scene.nodes.size());
    for (const Diagnostic& d : made.diagnostics.all()) {
        if (d.place.line > 0) REQUIRE(d.place.file < made.sources.files.size());
        CHECK_FALSE(format_line(d, made.sources).empty());
        format_caret(d, made.sources);
    }
}

}  // namespace

TEST_CASE("the sample of the grammar is right") {
    const Evaluated made = tried(kSample);
    INFO(echo_text(made.diagnostics, made.sources));
    CHECK(made.stop == Stop::kNone);
    CHECK(made.diagnostics.count(Severity::kWarning) == 0);
}

TEST_CASE("a text cut at any token gives a message or a scene") {
    const std::string text = kSample;
    Names names;
    StringPool strings;
    std::size_t start = 0, line = 1;
    for (const Token& token : lex(text, 0, names, strings)) {
        while (line < token.place.line) start = text.find('\n', start) + 1, ++line;
        const std::string cut = text.substr(0, start + token.place.column - 1);
        INFO(cut);
        check_sound(tried(cut));
    }
}

TEST_CASE("a text without any one token, or with it twice, gives a message or a scene") {
    const std::string text = kSample;
    Names names;
    StringPool strings;
    std::vector<std::size_t> starts;
    std::size_t start = 0, line = 1;
    for (const Token& token : lex(text, 0, names, strings)) {
        while (line < token.place.line) start = text.find('\n', start) + 1, ++line;
        starts.push_back(start + token.place.column - 1);
    }
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        const std::string before = text.substr(0, starts[i]), token = text.substr(starts[i], starts[i + 1] - starts[i]), after = text.substr(starts[i + 1]);
        INFO(before + "<<" + token + ">>");
        check_sound(tried(before + after));
        check_sound(tried(before + token + " " + token + after));
    }
}

TEST_CASE("texts with random bytes changed give a message or a scene") {
    const unsigned seed = std::random_device{}();
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const std::string pieces = "()[]{};,=<>+-*/%^!&|?:.\"#$ \n09azexfor\\\x01\x80\xC3";
    for (int round = 0; round < 300; ++round) {
        std::string text = kSample;
        for (int change = 0; change < 1 + round % 4; ++change) {
            const std::size_t at = random() % text.size();
            const char piece = pieces[random() % pieces.size()];
            if (random() % 3 == 0) text.erase(at, 1 + random() % 5);
            else if (random() % 2 == 0) text.insert(at, 1, piece);
            else text[at] = piece;
        }
        INFO(text);
        check_sound(tried(text));
    }
}

TEST_CASE("a hundred thousand brackets are too deep, and said so") {
    for (const char* opening : {"(", "[", "-", "!", "f(", "a[", "[for(i=", "let(a=1) ", "function() ", "[each ", "1?", "x?1:"}) {
        std::string text = "x = ";
        for (int i = 0; i < 100000; ++i) text += opening;
        const Evaluated made = run(text + "1;");
        INFO(opening);
        CHECK(made.stop == Stop::kSyntax);
        CHECK(has(made, "memory exhausted"));
    }
    for (const char* opening : {"{", "union() ", "union() {", "if(1) ", "if(1) ; else ", "module m() ", "#!", "for(i=0) {"}) {
        std::string text;
        for (int i = 0; i < 100000; ++i) text += opening;
        const Evaluated made = run(text + "cube();");
        INFO(opening);
        CHECK((made.stop == Stop::kSyntax || std::string(opening) == "#!"));
    }
}

TEST_CASE("long chains that need no nesting are read and run") {
    std::string sum = "x = 0", ors = "y = false", calls = "f = function() f; z = f";
    for (int i = 0; i < 5000; ++i) sum += "+1", ors += "||false", calls += "()";
    CHECK(echo_of(sum + ";echo(x);" + ors + ";echo(y);" + calls + ";echo(is_function(z));") == "ECHO: 5000\nECHO: false\nECHO: true\n");
    std::string list = "v=[0";
    for (int i = 1; i < 200000; ++i) list += "," + std::to_string(i);
    CHECK(echo_of(list + "]; echo(len(v), v[199999]);") == "ECHO: 200000, 199999\n");
}

TEST_CASE("endless recursion ends with OpenSCAD's message") {
    CHECK(has(run("function f(n) = 1 + f(n + 1); echo(f(0));"), "Recursion detected calling function 'f'"));
    CHECK(has(run("module m() m(); m();"), "Recursion detected calling module 'm'"));
    CHECK(has(run("module m() { union() m(); } m();"), "Recursion detected calling module 'm'"));
    CHECK(has(run("function a() = [b()]; function b() = [a()]; echo(a());"), "Recursion detected calling function"));
    CHECK(has(run("f = function(n) [f(n)]; echo(f(1));"), "Recursion detected calling function 'f'"));
    CHECK(has(run("function f(n) = f(n); echo(f(1));"), "Recursion detected calling function 'f'"));
    CHECK(has(run("function f(n, d=f(1)) = d; echo(f(1));"), "Recursion detected calling function 'f'"));
    CHECK(has(run("module m() { for (i=[0:1]) m() children(); } m() cube();"), "Recursion detected calling module 'm'"));
}

TEST_CASE("recursion of fifty thousand levels is not endless") {
    const std::string levels = kLargeStackBytes >= (std::size_t{1} << 30) ? "50000" : "2000";  // fewer under the address sanitizer
    CHECK(echo_of("function f(n) = n == 0 ? 0 : 1 + f(n - 1); echo(f(" + levels + "));") == "ECHO: " + levels + "\n");
    CHECK(echo_of("function f(n) = n == 0 ? 0 : f(n - 1); echo(f(999999));") == "ECHO: 0\n");
}

TEST_CASE("files that include or use each other end") {
    const std::map<std::string, std::string> circle{{"a.scad", "include <b.scad>\nx=1;"}, {"b.scad", "include <a.scad>\ny=2;"}, {"main.scad", "include <a.scad>"}};
    const Evaluated made = run("include <a.scad>\necho(x, y);", {}, circle);
    CHECK(has(made, "1, 2"));
    CHECK(has(made, "Can't open include file 'a.scad'."));
    CHECK(has(run("include <main.scad>\necho(1);", {}, {{"main.scad", "include <main.scad>"}}), "Can't open include file 'main.scad'."));
    const Evaluated used = run("use <p.scad>\necho(p(3));", {}, {{"p.scad", "use <q.scad>\nfunction p(n)=n<1?0:q(n-1);"}, {"q.scad", "use <p.scad>\nfunction q(n)=p(n);"}});
    CHECK(has(used, "0"));
    CHECK(used.stop == Stop::kNone);
    const Evaluated itself = run("use <main.scad>\nfunction f()=1; echo(f());", {}, {{"main.scad", "function f()=2;"}});
    CHECK(itself.stop == Stop::kNone);
}

TEST_CASE("includes that double themselves end") {
    std::map<std::string, std::string> files;
    for (int i = 0; i < 30; ++i) files["d" + std::to_string(i) + ".scad"] = "include <d" + std::to_string(i + 1) + ".scad>\ninclude <d" + std::to_string(i + 1) + ".scad>\n";
    files["d30.scad"] = "x=1;";
    const Evaluated made = run("include <d0.scad>", {}, files);
    CHECK(has(made, "Too many include files"));
    CHECK(made.stopped());
}

TEST_CASE("a used file with an error gives nothing, and its error is said") {
    const Evaluated made = run("use <bad.scad>\necho(1); cube();", {}, {{"bad.scad", "function f( = 1;"}});
    CHECK(has(made, "Parser error: syntax error"));
    CHECK(made.stop == Stop::kNone);
    CHECK(has(made, "1"));
}

TEST_CASE("limits of time and memory stop a run") {
    EvaluateInput input;
    input.limits.seconds = 0.2;
    CHECK(run("function f(n) = n < 1 ? 0 : f(n-1) + f(n-1); echo(f(60));", input).stop == Stop::kTime);
    CHECK(run("for (i=[0:9000]) for (j=[0:9000]) for (k=[0:9000]) let (x = i) if (x < 0) cube();", input).stop == Stop::kTime);
    input.limits = {};
    input.limits.memory_bytes = 50 << 20;
    CHECK(run("function f(n, v) = n < 1 ? v : f(n-1, concat(v, v)); echo(len(f(40, [1,2,3])));", input).stop == Stop::kMemory);
    CHECK(run("function f(n, s) = n < 1 ? s : f(n-1, str(s, s)); echo(len(f(60, \"abc\")));", input).stop == Stop::kMemory);
    CHECK(run("for (i=[0:999]) for (j=[0:999]) translate([i,j,0]) cube();", input).stop == Stop::kMemory);
}

TEST_CASE("a cancelled run stops") {
    const std::atomic<bool> cancel{true};
    EvaluateInput input;
    input.cancel = &cancel;
    CHECK(run("for (i=[0:5000]) cube(i);", input).stop == Stop::kCancelled);
}

TEST_CASE("lists nested a hundred thousand deep are refused or let go, not crashed on") {
    const Evaluated made = run("function f(n, v) = n < 1 ? v : f(n-1, [v]); x = f(100000, [1]); echo(len(x), x == x, str(x));");
    CHECK(made.stopped());
    CHECK(has(made, "nested too deeply"));
}

TEST_CASE("hard warnings stop at the first warning") {
    EvaluateInput input;
    input.hard_warnings = true;
    const Evaluated made = run("echo(nope); echo(2);", input);
    CHECK(made.stop == Stop::kScene);
    CHECK(made.diagnostics.all().size() == 1);
}

TEST_CASE("function values that hold themselves are let go") {
    CHECK(echo_of("module m() { f = function(n) n < 1 ? 0 : f(n-1); v = [f, function() v]; echo(f(3), len(v)); } for (i=[0:50]) m();").size() == 51 * std::string("ECHO: 0, 2\n").size());
}

TEST_CASE("the main file may be missing") {
    MemoryFiles none;
    EvaluateInput input;
    input.path = "nowhere.scad";
    const Result<Evaluated> made = evaluate(input, none);
    REQUIRE_FALSE(made);
    CHECK(made.error().fault == Fault::kWorld);
}
