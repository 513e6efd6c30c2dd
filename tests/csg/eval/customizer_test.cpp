// What a customizer is told: `-o x.param` in the JSON of later versions (the development version 2025.01.19 answered these), `-o x.ast` in 2021.01's words.
#include <catch2/catch.hpp>

#include "tests/csg/eval/memory_files.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Parsed parsed(const std::string& text) {
    MemoryFiles outside;
    EvaluateInput input;
    input.path = "lid.scad";
    input.text = text;
    return *parse(input, outside);
}

// The one variable that the text declares, without the frame around it.
std::string parameter_of(const std::string& text) {
    const std::string whole = *parameters_text(parsed(text));
    const std::string head = "{\"parameters\":[", tail = "],\"title\":\"lid\"}\n";
    INFO(whole);
    REQUIRE(whole.size() >= head.size() + tail.size());
    CHECK(whole.substr(0, head.size()) == head);
    CHECK(whole.substr(whole.size() - tail.size()) == tail);
    return whole.substr(head.size(), whole.size() - head.size() - tail.size());
}

}  // namespace

TEST_CASE("numbers have ranges, steps and lists of values") {
    CHECK(parameter_of("// Length of it\nlen = 10; // [1:100]\n") ==
          R"({"caption":"Length of it","group":"Parameters","initial":10.0,"max":100.0,"min":1.0,"name":"len","step":1.0,"type":"number"})");
    CHECK(parameter_of("w = 5.5; // [0:0.5:10]\n") == R"({"group":"Parameters","initial":5.5,"max":10.0,"min":0.0,"name":"w","step":0.5,"type":"number"})");
    CHECK(parameter_of("s = 4; // [10]\n") == R"({"group":"Parameters","initial":4.0,"max":10.0,"min":0.0,"name":"s","step":1.0,"type":"number"})");
    CHECK(parameter_of("e = 9; // [1:7]\n") == R"({"group":"Parameters","initial":9.0,"max":9.0,"min":1.0,"name":"e","step":1.0,"type":"number"})");
    CHECK(parameter_of("n = 3; // [1:One, 3:Three]\n") ==
          R"({"group":"Parameters","initial":3.0,"name":"n","options":[{"name":"One","value":1.0},{"name":"Three","value":3.0}],"type":"number"})");
    CHECK(parameter_of("n = -3; // some [words\n") == R"({"group":"Parameters","initial":-3.0,"name":"n","type":"number"})");
}

TEST_CASE("texts have lists of values and a greatest length, lists of numbers ranges, truths nothing") {
    CHECK(parameter_of("k = \"b\"; // [a:Label A, \"c d\"]\n") ==
          R"({"group":"Parameters","initial":"b","name":"k","options":[{"name":"b","value":"b"},{"name":"Label A","value":"a"},{"name":"c d","value":"c d"}],"type":"string"})");
    CHECK(parameter_of("k = \"q\\\"\"; // 8\n") == R"({"group":"Parameters","initial":"q\"","maxLength":8,"name":"k","type":"string"})");
    CHECK(parameter_of("v = [1, -2]; // [0:10]\n") ==
          R"({"group":"Parameters","initial":[1.0,-2.0],"max":10.0,"min":-2.0,"name":"v","step":1.0,"type":"number"})");
    CHECK(parameter_of("f = true; // [true, false]\n") == R"({"group":"Parameters","initial":true,"name":"f","type":"boolean"})");
}

TEST_CASE("what is hidden, computed, no plain value or behind the first brace is no parameter") {
    CHECK(parameter_of("/* [Hidden] */\na = 1;\n") == "");
    CHECK(parameter_of("a = 1 + 2; b = undef; c = [1, 2, 3, 4, 5]; d = [\"x\"];\n") == "");
    CHECK(parameter_of("module m() {}\na = 1;\n") == "");
    CHECK(parameter_of("/* [Size] */\nb = \"{\"; // {\n/* {\n */ c = 2;\n/* [Shape] */ module m() {}\nd = 1;") ==
          R"({"group":"Size","initial":"{","name":"b","type":"string"},{"initial":2.0,"name":"c","type":"number"})");
}

TEST_CASE("modifiers and an empty else stay in the text of a program") {
    CHECK(*ast_text(parsed("!#cube(1); if (a) %sphere(); else ;\n")) == "!#cube(1);\nif(a) %sphere();\nelse;\n");
}
