// Scripts of letters, as text() tells them in .csg.
#include <catch2/catch.hpp>

#include "csg/eval/letter_scripts.h"

using namespace whittle;

TEST_CASE("a text's script is the one that all its letters have") {
    CHECK(script_of_letters("Hello, 42!") == "Latn");
    CHECK(script_of_letters("\u03bb\u03ad\u03be\u03b7") == "Grek");
    CHECK(script_of_letters("\u0448\u0430\u0440") == "Cyrl");
    CHECK(script_of_letters("\u05d0\u05d1") == "Hebr");
    CHECK(script_of_letters("\u0645\u0631") == "Arab");
    CHECK(script_of_letters("\u4e16\u754c") == "Hani");
    CHECK(script_of_letters("\U00020000") == "Hani");
    CHECK(script_of_letters("\uac00\u1100") == "Hang");
    CHECK(script_of_letters("\u2167") == "Latn");  // a Roman numeral
}

TEST_CASE("digits, blanks, marks and code points that stand for nothing have no script; letters of two have none together") {
    CHECK(script_of_letters("").empty());
    CHECK(script_of_letters("12 + 3 = \u20ac \u0301 \u00d7").empty());
    CHECK(script_of_letters("\u00e9 e\u0301") == "Latn");
    CHECK(script_of_letters("a\u03bb") == "Zzzz");
    CHECK(script_of_letters("a\u03bba") == "Zzzz");
    CHECK(script_of_letters("\xff\xfe").empty());
    CHECK(script_of_letters("\U0010ffff").empty());
}

TEST_CASE("scripts that are written from right to left") {
    CHECK(is_written_leftwards("Hebr"));
    CHECK(is_written_leftwards("Adlm"));
    CHECK(is_written_leftwards("Yezi"));
    CHECK_FALSE(is_written_leftwards("Latn"));
    CHECK_FALSE(is_written_leftwards("Zzzz"));
    CHECK_FALSE(is_written_leftwards(""));
}
