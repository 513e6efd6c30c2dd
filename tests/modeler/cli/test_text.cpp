// test_text.cpp — numbers, JSON and make rules as text.
#include <cmath>
#include <cstdlib>
#include <limits>

#include <catch2/catch.hpp>

#include "modeler/cli/answers.h"
#include "modeler/cli/dependencies.h"
#include "modeler/cli/json.h"
#include "modeler/cli/nearest.h"
#include "modeler/cli/numbers.h"
#include "modeler/cli/stats.h"

using namespace whittle;

namespace {

std::string number_text(double value) {
    json::Buffer out;
    json::number(out, value);
    return fmt::to_string(out);
}

std::string string_text(std::string_view text) {
    json::Buffer out;
    json::string(out, text);
    return fmt::to_string(out);
}

}  // namespace

TEST_CASE("a number is read whole or not at all") {
    CHECK(number_in("1.5") == 1.5);
    CHECK(number_in(" +2e3 ") == 2000.0);
    CHECK(number_in("-.5") == -0.5);
    for (const char* wrong : {"", "-", "1x", "1 2", "1,2", "nan", "inf", "1e999", "0x10", "+-1"}) {
        INFO(wrong);
        CHECK_FALSE(number_in(wrong));
    }
    CHECK(numbers_in("1, 2,-3") == std::vector<double>{1, 2, -3});
    CHECK_FALSE(numbers_in("1,,2"));
    CHECK_FALSE(numbers_in(""));
}

TEST_CASE("a JSON number reads back to the same double, and what is not finite is null") {
    for (const double value : {0.1, 1.0 / 3, 1e300, 5e-324, -123456789.125, 1e22}) CHECK(std::strtod(number_text(value).c_str(), nullptr) == value);
    CHECK(number_text(2) == "2");
    CHECK(number_text(std::numeric_limits<double>::infinity()) == "null");
    CHECK(number_text(std::nan("")) == "null");
}

TEST_CASE("a JSON string is escaped and always UTF-8") {
    CHECK(string_text("a\"b\\c\nd\x01") == "\"a\\\"b\\\\c\\nd\\u0001\"");
    CHECK(string_text("grün") == "\"grün\"");
    CHECK(string_text("\xFF" "a\xE2\x82") == "\"\xEF\xBF\xBD" "a\xEF\xBF\xBD\xEF\xBF\xBD\"");
    CHECK(string_text("\xED\xA0\x80").find('\xED') == std::string::npos);  // a lone surrogate
}

TEST_CASE("a JSON object keeps its members' order") {
    json::Object object;
    object.number("a", 1.5).boolean("b", true).strings("c", {"x", "y"}).numbers("d", {1, 2}).triple("e", {1, 2, 3}).count("f", 18446744073709551615ull);
    CHECK(object.str() == R"({"a":1.5,"b":true,"c":["x","y"],"d":[1,2],"e":[1,2,3],"f":18446744073709551615})");
    CHECK(json::of(Measured{2, 0.5, ErrorKind::kConfidence99}) == R"({"value":2,"error":0.5,"kind":"ci99"})");
}

TEST_CASE("the nearest known word is near, or none") {
    const std::vector<std::string> known{"--imgsize", "--samples", "-o"};
    CHECK(nearest("--imgsiz", known) == "--imgsize");
    CHECK(nearest("--smaples", known) == "--samples");
    CHECK_FALSE(nearest("--xyzzy", known));
}

TEST_CASE("a make rule names every file once a line, blanks escaped") {
    CHECK(dependency_rule({"a.png", "my part.stl"}, {"a.scad", "lib/b$.scad"}) == "a.png my\\ part.stl: \\\n\ta.scad \\\n\tlib/b$$.scad\n");
}

TEST_CASE("counters have their fixed names from the start") {
    Stats stats;
    for (const char* name : {"rays.camera", "primitives.tests", "spans.uncertified", "mesh.booleans", "bytes.peak", "seconds.parse"})
        CHECK(stats.text().find('"' + std::string(name) + "\": 0") != std::string::npos);
    EngineCounters counters;
    counters.primitive_tests = 7;
    stats.add(counters);
    stats.add(counters);
    CHECK(stats.get("primitives.tests") == 14);
}
