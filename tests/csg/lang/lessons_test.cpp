// lessons_test.cpp — what makers coming from other languages write, and what they are told: the first message's hint, one message each.
#include <catch2/catch.hpp>

#include "csg/lang/lexer.h"
#include "csg/lang/parser.h"

using namespace whittle;

namespace {

std::vector<Diagnostic> told(const std::string& text) {
    Names names;
    SourceTable sources;
    sources.files.push_back({"t.scad", "t.scad", text});
    StringPool strings;
    const std::vector<Token> tokens = lex(text, 0, names, strings);
    ParseOptions options;
    options.sources = &sources;
    Diagnostics diagnostics;
    ast::Ast tree;
    parse_tokens(tokens, std::move(strings), names, options, diagnostics, tree);
    return diagnostics.all();
}

struct Mistake { const char *text, *lesson; };

const Mistake kMistakes[] = {
    {"if (x=1) cube(1);", "expected ')' after the condition, found '='; '==' compares; a value is given by name = value;"},
    {"r == 5;", "expected '(' after the module's name, found '=='; a value is given with '=': name = value;"},
    {"r: 5;", "expected '(' after the module's name, found ':'; a value is given with '=': name = value;"},
    {"cube(size: 5);", "expected ')' after the arguments, found ':'; a value is given with '=': name = value;"},
    {"i++;", "expected '(' after the module's name, found '+'; a name has one value in its scope, which cannot be counted up or changed later"},
    {"x = i--;", "expected a value, found ';'; a name has one value in its scope, which cannot be counted up or changed later"},
    {"x += 1;", "expected '(' after the module's name, found '+'; a name has one value in its scope, which cannot be counted up or changed later"},
    {"a[0] = 5;", "expected '(' after the module's name, found '['; a name has one value in its scope, which cannot be counted up or changed later"},
    {"var x = 5;", "expected '(' after the module's name, found 'x'; no word stands before the name: name = value;"},
    {"let x = 5;", "expected '(' after the module's name, found 'x'; no word stands before the name: name = value;"},
    {"def f(x) = 3;", "expected '(' after the module's name, found 'f'; function name(x) = value; makes values, module name(x) { } makes bodies"},
    {"function f(x) { return x; }", "expected '=' before the function's value, found '{'; a function is one expression: function name(x) = value;"},
    {"return 5;", "expected '(' after the module's name, found a number; there is no return: function name(x) = value;"},
    {"if (a and b) cube(1);", "expected ')' after the condition, found 'and'; 'and' is written &&"},
    {"if (not a) cube(1);", "expected ')' after the condition, found 'a'; 'not' is written !"},
    {"y = 3 mod 2;", "expected ';' after the value, found 'mod'; 'mod' is written %"},
    {"for (i = 0; i < 5; i = i + 1) { cube(i); }", "expected ')' after the arguments, found ';'; a loop of modules goes through a list or a range: for (i = [0 : 9])"},
    {"a = 5\nb = 6;", "expected ';' after the value, found 'b'; line 1 ends without it"},
    {"sphere(r=5 $fn=50);", "expected ')' after the arguments, found '$fn'; is a ',' missing before it?"},
    {"translate([0,0,5]) { cube(1) }", "expected a statement, found '}'; is a ';' missing behind the ')'?"},
    {"cube(5)", "expected a statement, found the end of the file; is a ';' missing behind the ')'?"},
    {"if (a) cube(1); else cube(2); else cube(3);", "expected a statement, found 'else'; an 'else' stands right behind the one statement or block of its 'if'"},
    {"x = {1, 2};", "expected a value, found '{'; a list is written in brackets: [1, 2]"},
    {"use \"lib.scad\"\ncube(1);", "expected '(' after the module's name, found a string; files stand between < and >: use <file.scad>"},
    {"text('hello');", "the character ''' has no meaning here: strings stand in plain double quotes, \"text\""},
    {"text(\u201Chello\u201D);", "the character '\u201C' has no meaning here: strings stand in plain double quotes, \"text\""},
    {"x = 5 \u2212 3;", "the character '\u2212' has no meaning here: is a plain - meant?"},
    {"cube(1)\uFF1B", "the character '\uFF1B' has no meaning here: is a plain ; meant?"},
    {"function = 3;", "expected the function's name"},
    {"cube([1 2 3]);", "expected ',' or ']' after an element, found a number"},
    {"module wheel { }", "expected '(' before the parameters, found '{'"},
    {"translate([0,0,1] cube(2);", "expected ')' after the arguments, found 'cube'"},
};

}  // namespace

TEST_CASE("habits of other languages are answered with how it is written here") {
    for (const Mistake& mistake : kMistakes) {
        CAPTURE(mistake.text);
        const std::vector<Diagnostic> all = told(mistake.text);
        REQUIRE_FALSE(all.empty());
        CHECK(all[0].severity == Severity::kError);
        CHECK(all[0].text == "Parser error: syntax error");
        CHECK(all[0].hint == mistake.lesson);
    }
}

TEST_CASE("a loop of another language is one mistake, however much of it is wrong") {
    CHECK(told("for (i = 0; i < 5; i++) { cube(i); }\nsphere(1);").size() == 1);
    CHECK(told("for (i = 0; i < (5; i++) cube(i); sphere(1);").size() == 1);
    CHECK(told("x = [for (i = 0; i < 5; i = i + 1) i];").empty());
}

TEST_CASE("a broken sign of several bytes has no likeness") { CHECK(told("\xE2;")[0].hint == "the character '\xE2' has no meaning here"); }
