#include <catch2/catch.hpp>

#include "csg/lang/lexer.h"
#include "csg/lang/parser.h"
#include "csg/lang/print_ast.h"

using namespace whittle;

namespace {

struct Tree {
    Names names;
    SourceTable sources;
    Diagnostics diagnostics;
    ast::Ast ast;
    bool good = false;
    explicit Tree(const std::string& text) {
        sources.files.push_back({"t.scad", "t.scad", text});
        StringPool strings;
        const std::vector<Token> tokens = lex(text, 0, names, strings);
        ParseOptions options;
        options.sources = &sources;
        good = parse_tokens(tokens, std::move(strings), names, options, diagnostics, ast);
    }
    const ast::Scope& root() const { return ast.scopes[ast.root]; }
};

void short_number(std::string& out, double x) { out += std::to_string(static_cast<int>(x)); }

std::string grouped(const std::string& expression) {
    const Tree tree("x = " + expression + ";");
    REQUIRE(tree.good);
    std::string out;
    print_expression(out, tree.ast, tree.root().assignments[0].value, tree.names, short_number);
    return out;
}

}  // namespace

TEST_CASE("operators bind as in OpenSCAD") {
    CHECK(grouped("1+2*3") == "(1 + (2 * 3))");
    CHECK(grouped("1-2-3") == "((1 - 2) - 3)");
    CHECK(grouped("2^3^2") == "(2 ^ (3 ^ 2))");
    CHECK(grouped("-2^2") == "-(2 ^ 2)");
    CHECK(grouped("2^-1") == "(2 ^ -1)");
    CHECK(grouped("a||b&&c==d<e+f") == "(a || (b && (c == (d < (e + f)))))");
    CHECK(grouped("1|2&3<<4") == "(1 | (2 & (3 << 4)))");
    CHECK(grouped("a?b:c?d:e") == "(a ? b : (c ? d : e))");
    CHECK(grouped("!a.b[1](2)") == "!(a.b[1])(2)");
    CHECK(grouped("let(a=1) a+2") == "let(a = 1) (a + 2)");
}

TEST_CASE("the last assignment takes the place of the first") {
    const Tree tree("a = 1; b = 2; a = 3;");
    REQUIRE(tree.root().assignments.size() == 2);
    CHECK(tree.ast.exprs[tree.root().assignments[0].value].number == 3);
    CHECK(tree.diagnostics.all()[0].text == "a was assigned on line 1 but was overwritten");
}

TEST_CASE("each of several errors is said, with its place") {
    const Tree tree("x = 1 +;\ncube(1);\ny = [1, 2;\nmodule m() { z = ; cube(); }\nsphere(;\nw = 2;\n");
    CHECK_FALSE(tree.good);
    REQUIRE(tree.diagnostics.all().size() == 4);
    CHECK(tree.diagnostics.all()[0].place == SourcePlace{0, 1, 8});
    CHECK(tree.diagnostics.all()[1].place == SourcePlace{0, 3, 10});
    CHECK(tree.diagnostics.all()[2].place == SourcePlace{0, 4, 18});
    CHECK(tree.diagnostics.all()[3].place == SourcePlace{0, 5, 8});
    CHECK(tree.root().modules.size() == 1);
}

TEST_CASE("a caret stands under the place, also behind letters of several bytes") {
    const Tree tree("echo(\"\xC3\xA4\xC3\xB6\") cube(1;\n");
    REQUIRE(tree.diagnostics.all().size() == 1);
    const Diagnostic& d = tree.diagnostics.all()[0];
    CHECK(format_line(d, tree.sources) == "ERROR: Parser error: syntax error in file t.scad, line 1");
    CHECK(format_caret(d, tree.sources) == "echo(\"\xC3\xA4\xC3\xB6\") cube(1;\n                 ^");
    CHECK(d.hint == "expected ')' after the arguments, found ';'");
}

TEST_CASE("errors stop being said after twenty") {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "x = ;\n";
    CHECK(Tree(text).diagnostics.all().size() == kMaxSyntaxErrors);
}

TEST_CASE("disabled instantiations are read and dropped") {
    CHECK(Tree("*cube(1); sphere(1);").root().instantiations.size() == 1);
    CHECK_FALSE(Tree("*cube(1;").good);
}
