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

namespace {

// Every form of the grammar at least once, on one line a token apart, so that a column tells a token.
const std::string kEveryForm =
    "x = 1 ; y = - x * ( 2 + 3 ) ^ 2 % 5 ; z = [ 1 , [ 2 , 3 ] , \"s\" ] ; r = [ 0 : 2 : 10 ] ; "
    "t = x > 1 && y <= 2 || ! true ? undef : false ; f = function ( a , b = 2 ) a + b ; g = let ( q = 1 ) q ; "
    "c = [ for ( i = r ) if ( i != 2 ) each [ i ] else i ] ; d = [ for ( i = 0 ; i < 3 ; i = i + 1 ) i ] ; e = assert ( x == 1 ) echo ( x ) z [ 0 ] ; h = z . x ; "
    "function k ( n ) = n < 2 ? n : k ( n - 1 ) / 2 ; module m ( a , b = [ 1 ] ) { cube ( a ) ; translate ( b ) { children ( ) ; } } "
    "m ( 1 , b = 2 ) ; # m ( ) sphere ( r = 1 ) ; if ( x ) { cube ( 1 ) ; } else sphere ( 2 ) ; for ( i = [ 1 , 2 ] ) ! cube ( i ) ; ; { cube ( 3 ) ; } ";

struct Word {
    std::size_t begin = 0, end = 0;
    bool ends_statement = false;  // at the top level; a text cut behind it is whole
};

std::vector<Word> words_of(const std::string& text) {
    std::vector<Word> words;
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == ' ') continue;
        Word w{at, std::min(text.find(' ', at), text.size()), false};
        const char c = text[at];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        w.ends_statement = depth == 0 && (c == ';' || c == '}');
        at = w.end;
        words.push_back(w);
    }
    return words;
}

// A refused text says where and what, within the text.
bool says_where(const Tree& tree, const std::string& text) {
    if (tree.diagnostics.all().empty()) return false;
    for (const Diagnostic& d : tree.diagnostics.all())
        if (d.place.line != 1 || d.place.column < 1 || d.place.column > text.size() + 1 || d.hint.empty() || d.text.empty()) return false;
    return true;
}

}  // namespace

TEST_CASE("a text cut at any token boundary is whole exactly where a statement ends, and else says where it breaks off") {
    REQUIRE(Tree(kEveryForm).good);
    int whole = 0;
    for (const Word& word : words_of(kEveryForm)) {
        const std::string text = kEveryForm.substr(0, word.end);
        const Tree tree(text);
        INFO(text);
        CHECK(tree.good == word.ends_statement);
        CHECK((tree.good || says_where(tree, text)));
        whole += tree.good;
    }
    CHECK(whole > 15);
}

TEST_CASE("a word too much, too little or twice at any token boundary is read or told with its place") {
    int refused = 0;
    for (const Word& word : words_of(kEveryForm)) {
        const std::string before = kEveryForm.substr(0, word.begin), own = kEveryForm.substr(word.begin, word.end - word.begin), behind = kEveryForm.substr(word.end);
        for (const std::string& middle : {std::string(), own + " " + own, std::string("@"), std::string("= "), ") " + own, own + " ]", own + " }", "\"" + own}) {
            const std::string text = before + middle + behind;
            const Tree tree(text);
            INFO(text);
            CHECK((tree.good || says_where(tree, text)));
            refused += !tree.good;
        }
    }
    CHECK(refused > 1000);
}
