// What versions after 2021.01 add to the language: objects, JSON, measures of text. The answers are those of the development version 2025.01.19 where it
// has them (echo, member access, loops over objects, JSON), else of its documentation (object(), has_key(), methods).
#include <catch2/catch.hpp>

#include "csg/eval/json_value.h"
#include "tests/csg/eval/memory_files.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// What `echo(expression)` says after the text, without its "ECHO: ".
std::string value_of(const std::string& expression, const std::string& text = {}, std::map<std::string, std::string> files = {}) {
    const std::string said = echo_of(text + "echo(" + expression + ");", {}, std::move(files));
    INFO(said);
    REQUIRE(said.rfind("ECHO: ", 0) == 0);
    return said.substr(6, said.find('\n') - 6);
}

const std::string kObject = "o = object(a = 1, b = [1, 2], c = \"x\");\n";

// Fonts of a fixed measure, which know what they were asked.
class SquareFonts : public MemoryFiles {
public:
    Result<TextOutline> text(const TextRequest& request, GlyphGrid grid) override {
        asked = request;
        CHECK(grid == GlyphGrid::kOpenScad);
        TextOutline out;
        out.metrics = {{1, 2}, {3, 4}, {5, 6}, {7, 0}, 8, -1};
        out.font = "Square:style=Plain";
        out.substituted = request.font == "Absent";
        return out;
    }
    Result<FontMetrics> font_metrics(const std::string& font, double size) override {
        if (font == "Broken") return fail(Fault::kWorld, "no such font");
        return FontMetrics{size, -1, 2 * size, -2, 3 * size, "Square", "Plain"};
    }
    void add_font(const std::string& path) override { added.push_back(path); }
    TextRequest asked;
    std::vector<std::string> added;
};

std::string echo_with_fonts(SquareFonts& fonts, const std::string& text) {
    EvaluateInput input;
    input.path = "main.scad";
    input.text = text;
    const Evaluated made = *evaluate(input, fonts);
    return echo_text(made.diagnostics, made.sources);
}

}  // namespace

TEST_CASE("an object is shown with its members in the order of their making") {
    CHECK(value_of("o", kObject) == "{ a = 1; b = [1, 2]; c = \"x\"; }");
    CHECK(value_of("str(o)", kObject) == "\"{ a = 1; b = [1, 2]; c = \"x\"; }\"");
    CHECK(value_of("object()") == "{ }");
    CHECK(value_of("[object(x = object(y = 1))]") == "[{ x = { y = 1; }; }]");
}

TEST_CASE("members are reached by name and by text, and those that are missing are undef") {
    CHECK(value_of("[o.a, o[\"b\"], o.zz, o[\"zz\"], o[0], o.a.b]", kObject) == "[1, [1, 2], undef, undef, undef, undef]");
    CHECK(value_of("[o.x, o.y, o.z]", "o = object(y = 2, x = 1);") == "[1, 2, undef]");
    CHECK(value_of("[has_key(o, \"a\"), has_key(o, \"q\"), is_object(o), is_object([1]), len(o)]", kObject) == "[true, false, true, false, 3]");
}

TEST_CASE("an object is made of others, of entries, and of names") {
    CHECK(value_of("object(o, d = 4, a = undef)", kObject) == "{ a = undef; b = [1, 2]; c = \"x\"; d = 4; }");
    CHECK(value_of("object(o, [[\"a\"], [\"e\", 5]])", kObject) == "{ b = [1, 2]; c = \"x\"; e = 5; }");
    CHECK(value_of("object([[\"bad name\", 1]])[\"bad name\"]") == "1");
    CHECK(value_of("object(o, [[\"c\"], [\"a\"], [\"c\", 7]])", kObject) == "{ b = [1, 2]; c = 7; }");
    CHECK(echo_of("x = object(1);") == "WARNING: object() argument 0 is neither name = value nor an object nor a list of entries, it is of type number in file main.scad, line 1\n");
    CHECK(echo_of("x = object([5]);") == "WARNING: object() entry 0 is no list of one or two elements in file main.scad, line 1\n");
    CHECK(echo_of("x = object([[5, 5]]);") == "WARNING: object() entry 0 has a name of type number in file main.scad, line 1\n");
}

TEST_CASE("loops over an object give its names") {
    CHECK(value_of("[for (k = o) [k, o[k]]]", kObject) == "[[\"a\", 1], [\"b\", [1, 2]], [\"c\", \"x\"]]");
    CHECK(echo_of(kObject + "for (k = o) echo(k);") == "ECHO: \"a\"\nECHO: \"b\"\nECHO: \"c\"\n");
    CHECK(value_of("[each o]", kObject) == "[{ a = 1; b = [1, 2]; c = \"x\"; }]");
}

TEST_CASE("objects are true, equal by their members, and have no order") {
    CHECK(value_of("[o == object(c = \"x\", b = [1, 2], a = 1), o == object(a = 1), o != 1, object() ? 1 : 2]", kObject) == "[true, false, true, 1]");
    CHECK(echo_of("x = object() < object();") == "WARNING: operation undefined (object < object) in file main.scad, line 1\n");
    CHECK(echo_of("x = -object();") == "WARNING: undefined operation (-object) in file main.scad, line 1\n");
}

TEST_CASE("a member function with a parameter this is a method of the object it is read from") {
    const std::string text = "m = object(n = 3, f = function(this, x) this.n * x);\n";
    CHECK(value_of("[m.f(4), m[\"f\"](5), object(m, n = 10).f(4), m.f(this = object(n = 1), x = 9)]", text) == "[12, 15, 40, 9]");
    CHECK(value_of("[g(5), m.f == m.f]", text + "g = m.f;") == "[15, true]");
    CHECK(value_of("m.f", text) == "function(this, x) (this.n * x)");
    CHECK(value_of("o.up(5)", "o = object(up = function(n, this) n > 0 ? this.up(n - 1) + 1 : 0);") == "5");
}

TEST_CASE("a variable of the name of a built-in does not hide it, named arguments included") {
    CHECK(value_of("[object.a, object(b = 3).b]", "object = object(a = 2);") == "[2, 3]");
}

TEST_CASE("a function literal that calls itself last goes round a million times") {
    CHECK(value_of("f(900000)", "f = function(n, s = 0) n == 0 ? s : f(n - 1, s + 1);") == "900000");
    CHECK(echo_of("f = function(n) f(n + 1); echo(f(0));").find("ERROR: Recursion detected calling function 'f'") == 0);
}

TEST_CASE("import of a JSON file gives what it holds, names sorted") {
    const std::map<std::string, std::string> files{{"d.json", R"({"n": -2.5e3, "a": [1, true, null, {"é": "\u00e9\ud83d\ude00\n"}], "": ""})"}, {"bad.json", "[1,\n 2,,]"}};
    CHECK(value_of("str(import(\"d.json\"))", {}, files) == "\"{  = \"\"; a = [1, true, undef, { é = \"é😀");
    CHECK(value_of("import(file = \"d.json\").a[3][\"é\"][0]", {}, files) == "\"é\"");
    CHECK(echo_of("x = import(\"bad.json\");", {}, files) == "WARNING: Failed to parse file 'bad.json' in file main.scad, line 1\n");
    CHECK(run("x = import(\"bad.json\");", {}, files).diagnostics.all()[0].hint == "line 2, column 4: expected a value");
    CHECK(echo_of("x = import(\"none.json\");", {}, files) == "WARNING: Could not read file 'none.json' in file main.scad, line 1\n");
    CHECK(echo_of("x = import(\"part.stl\");", {}, files) == "WARNING: Unsupported file type while trying to import 'part.stl' in file main.scad, line 1\n");
    CHECK(run("x = import(\"d.json\");", {}, files).files_read == std::vector<std::string>{"main.scad", "d.json"});
}

TEST_CASE("broken JSON is told with line and column") {
    Heap heap;
    const auto complaint = [&heap](const std::string& text) {
        const auto value = json_value(heap, text);
        REQUIRE_FALSE(value);
        return value.error().message;
    };
    CHECK(complaint("") == "line 1, column 1: expected a value");
    CHECK(complaint("{\"a\" 1}") == "line 1, column 6: expected ':' after the name");
    CHECK(complaint("{a: 1}") == "line 1, column 2: expected a name in quotes");
    CHECK(complaint("[1 2]") == "line 1, column 4: expected ',' or ']'");
    CHECK(complaint("01") == "line 1, column 1: expected a value");
    CHECK(complaint("[1.]") == "line 1, column 2: expected digits after '.'");
    CHECK(complaint("1e999") == "line 1, column 1: a number too large or too small");
    CHECK(complaint("\"\\x\"") == "line 1, column 4: unknown escape in a string");
    CHECK(complaint("\"\\ud800\"") == "line 1, column 8: half of a surrogate pair");
    CHECK(complaint("\"a") == "line 1, column 3: a string without end");
    CHECK(complaint("true false") == "line 1, column 6: more text behind the value");
    CHECK(complaint(std::string(100000, '[')) == "line 1, column 1002: nested more than 1000 deep");
}

TEST_CASE("textmetrics and fontmetrics are objects of what the fonts say") {
    SquareFonts fonts;
    CHECK(echo_with_fonts(fonts, "use <own.ttf>\necho(textmetrics(\"ab\", 20, valign=\"top\", spacing=2));").find(
              "ECHO: { position = [1, 2]; size = [3, 4]; ascent = 8; descent = -1; offset = [5, 6]; advance = [7, 0]; }") != std::string::npos);
    CHECK(fonts.asked.text == "ab");
    CHECK(fonts.asked.size == 20);
    CHECK(fonts.asked.valign == "top");
    CHECK(fonts.asked.spacing == 2);
    CHECK(echo_with_fonts(fonts, "echo(fontmetrics(2));") ==
          "ECHO: { nominal = { ascent = 2; descent = -1; }; max = { ascent = 4; descent = -2; }; interline = 6; font = { family = \"Square\"; style = \"Plain\"; }; }\n");
    CHECK(echo_with_fonts(fonts, "x = textmetrics(5);") == "WARNING: textmetrics(..., text=5) Invalid type: expected string, found number in file main.scad, line 1\n");
    CHECK(echo_with_fonts(fonts, "x = textmetrics(\"a\", zz = 1);") == "WARNING: variable zz not specified as parameter in file main.scad, line 1\n");
    CHECK(echo_with_fonts(fonts, "x = fontmetrics(1, \"a\", 3);") == "WARNING: Too many unnamed arguments supplied in file main.scad, line 1\n");
    CHECK(echo_with_fonts(fonts, "x = textmetrics(\"a\", font = \"Absent\");") ==
          "WARNING: Font 'Absent' is not installed, 'Square:style=Plain' stands in for it in file main.scad, line 1\n");
    CHECK(echo_with_fonts(fonts, "echo(fontmetrics(font = \"Broken\"));") == "WARNING: fontmetrics() cannot be measured in file main.scad, line 1\nECHO: undef\n");
}

TEST_CASE("letters of axes and colours make lists of elements") {
    CHECK(value_of("[[1, 2, 3, 4].xyzw, [1, 2, 3].rgb, [1, 2, 3].xz, [1, 2, 3, 4].bgra, [1, 2].a, [1, 2, 3].xr, [1, 2, 3].xxyyz]") ==
          "[[1, 2, 3, 4], [1, 2, 3], [1, 3], [3, 2, 1, 4], undef, undef, undef]");
}

TEST_CASE("linear_extrude takes the positions of later versions where the second is a vector") {
    CHECK(csg_of("linear_extrude(10, [0, 0, 5], 2, true, 90, 20, 40) square(1);") ==
          csg_of("linear_extrude(height = 10, v = [0, 0, 5], scale = 2, center = true, twist = 90, slices = 20, segments = 40) square(1);"));
    CHECK(csg_of("linear_extrude(10, [3, 0, 4], scale = 2, slices = 5) square(1);") == csg_of("linear_extrude(h = 10, v = [3, 0, 4], scale = 2, slices = 5) square(1);"));
    CHECK(csg_of("linear_extrude(10, true, 7) square(1);") == csg_of("linear_extrude(height = 7) square(1);"));
}

TEST_CASE("segments stand in a .csg where they are given") {
    CHECK(csg_of("linear_extrude(h = 3, twist = 9, slices = 4, segments = 12) square(1);").find(", slices = 4, segments = 12, scale = [1, 1])") != std::string::npos);
    CHECK(csg_of("linear_extrude(h = 3, segments = 0) square(1);").find("segments") == std::string::npos);
}

TEST_CASE("import takes the id of what is meant of a drawing") {
    CHECK(csg_of("import(\"a.svg\", id = \"lid\");").find("layer = \"lid\"") != std::string::npos);
    CHECK(csg_of("import(\"a.svg\", layer = \"top\", id = \"lid\");").find("layer = \"top\"") != std::string::npos);
}
