#include <catch2/catch.hpp>

#include "csg/lang/lexer.h"

using namespace whittle;

namespace {

struct Words {
    Names names;
    StringPool strings;
    std::vector<Token> tokens;
    explicit Words(const std::string& text) { tokens = lex(text, 0, names, strings); }
    std::string text(std::size_t i) const { return tokens[i].kind == Tok::kIdentifier ? names.text(tokens[i].text) : strings[tokens[i].text]; }
};

}  // namespace

TEST_CASE("the longer of a number and an identifier wins") {
    CHECK(Words("2d").text(0) == "2d");
    CHECK(Words("12e3").tokens[0].number == 12000);
    CHECK(Words("1e").text(0) == "1e");
    CHECK(Words(".5").tokens[0].number == 0.5);
    CHECK(Words("5.").tokens[0].number == 5);
    CHECK(Words("1E-2").tokens[0].number == 0.01);
    CHECK(Words("0x1F").tokens[0].number == 31);
    CHECK(Words("0xg").text(0) == "0xg");
    CHECK(Words("$fn").text(0) == "$fn");
}

TEST_CASE("strings drop raw newlines and read escapes") {
    CHECK(Words("\"a\nb\"").text(0) == "ab");
    CHECK(Words("\"\\n\\t\\\"\\\\\\x41\\u00e4\\U01f600\\q\"").text(0) == "\n\t\"\\A\xC3\xA4\xF0\x9F\x98\x80q");
    CHECK(Words("\"\\x00\"").text(0) == " ");
}

TEST_CASE("places count lines and columns from one") {
    const Words words("a\n  bc /* x\n */ d");
    CHECK(words.tokens[0].place == SourcePlace{0, 1, 1});
    CHECK(words.tokens[1].place == SourcePlace{0, 2, 3});
    CHECK(words.tokens[2].place == SourcePlace{0, 3, 5});
}

TEST_CASE("include and use are one word with their path") {
    const Words words("include <a b.scad>\nuse  <../c.scad> include");
    CHECK(words.tokens[0].kind == Tok::kInclude);
    CHECK(words.strings[words.tokens[0].text] == "a b.scad");
    CHECK(words.tokens[1].kind == Tok::kUse);
    CHECK(words.strings[words.tokens[1].text] == "../c.scad");
    CHECK(words.tokens[2].kind == Tok::kIdentifier);
}

TEST_CASE("byte 3 ends the text, a hard space is blank, a byte order mark is skipped") {
    CHECK(Words("a\x03 b").tokens.size() == 2);
    CHECK(Words("a\xC2\xA0" "b").tokens.size() == 3);
    CHECK(Words("\xEF\xBB\xBF" "a").tokens.size() == 2);
}

TEST_CASE("what is no word is a bad token with a reason") {
    CHECK(Words("@").tokens[0].kind == Tok::kBad);
    CHECK(Words("\"abc").text(0).rfind("Unterminated string", 0) == 0);
    CHECK(Words("/* abc").text(0).rfind("Unterminated comment", 0) == 0);
    CHECK(Words("use <abc").text(0).rfind("Unterminated use statement", 0) == 0);
}
