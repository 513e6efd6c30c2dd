// parser_state.h — what the halves of the parser (statements, expressions) share. Internal to csg/lang.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/lang/parser.h"

namespace whittle {

// Thrown to the enclosing statement, never out of parse_tokens.
struct SyntaxError {};
struct TooManyErrors {};

class Parser {
public:
    Parser(const std::vector<Token>& tokens, const Names& names, const ParseOptions& options, Diagnostics& diagnostics, ast::Ast& out)
        : tokens_(tokens), names_(names), options_(options), diagnostics_(diagnostics), ast_(out) {}

    bool run();

private:
    // Words.
    const Token& now() const { return tokens_[position_]; }
    Tok kind() const { return tokens_[position_].kind; }
    Tok next_kind() const { return position_ + 1 < tokens_.size() ? tokens_[position_ + 1].kind : Tok::kEnd; }
    const Token& take() {
        const Token& token = tokens_[position_];
        if (token.kind != Tok::kEnd) ++position_;
        return token;
    }
    bool take_if(Tok wanted) {
        if (kind() != wanted) return false;
        take();
        return true;
    }
    void expect(Tok wanted, const char* where);
    // Says what is wrong with the current word: `hint`, and behind it what the author may have meant.
    [[noreturn]] void syntax_error(std::string hint);
    [[noreturn]] void too_deep(const std::string& limit);

    // What the author may have meant (lessons.cpp).
    std::string found() const;   // how the current word is written: "'width'", "a number", "';'"
    std::string lesson() const;  // a sentence, or empty
    std::string_view name_before(std::size_t back) const;
    Tok kind_before(std::size_t back) const;

    // Statements (parser.cpp).
    void recover();
    void statements(ast::ScopeId scope, Tok end);
    void statement(ast::ScopeId scope);
    void assignment(ast::ScopeId scope);
    void add_assignment(ast::ScopeId scope, const ast::Assignment& assignment);
    void warn_of_overwriting(const ast::Assignment& old, const ast::Assignment& added);
    void function_definition(ast::ScopeId scope);
    void module_definition(ast::ScopeId scope);
    void instantiation(ast::ScopeId scope);
    ast::Instantiation instantiation_head(std::uint8_t modifiers);
    [[noreturn]] void loop_of_another_language();
    ast::ScopeId child_scope();
    void child_statement(ast::ScopeId scope);
    ast::ScopeId new_scope();
    bool names_module(Tok kind) const;

    // Expressions (parse_expression.cpp).
    ast::ExprId expression();
    ast::ExprId binary(int level);
    ast::ExprId unary();
    ast::ExprId power();
    ast::ExprId postfix();
    ast::ExprId primary();
    ast::ExprId vector_or_range(SourcePlace place);
    ast::ExprId element();
    ast::ExprId for_element();
    ast::ExprId if_element();
    ast::ArgumentRange arguments();
    ast::ArgumentRange assignments_until(Tok end);
    ast::ArgumentRange parameters();
    ast::ExprId make(ast::ExprKind kind, SourcePlace place, std::uint32_t a = ast::kNone, std::uint32_t b = 0, std::uint32_t c = 0);
    void deepen(ast::ExprId id, std::uint32_t depth);
    std::uint32_t depth_of(ast::ExprId id) const { return id == ast::kNone ? 0 : ast_.exprs[id].depth; }
    std::uint32_t depth_of(ast::ArgumentRange range) const;
    bool starts_element(Tok kind) const;
    SourcePlace infix_place(ast::ExprId left, SourcePlace sign) const;
    ast::ArgumentRange store(const std::vector<ast::Argument>& list);

    // One level of nesting for as long as it lives.
    struct Level {
        explicit Level(Parser& p) : parser(p) {
            if (++parser.level_ > kMaxNesting) parser.too_deep("nested more than " + std::to_string(kMaxNesting) + " levels deep");
        }
        ~Level() { --parser.level_; }
        Parser& parser;
    };

    const std::vector<Token>& tokens_;
    const Names& names_;
    const ParseOptions& options_;
    Diagnostics& diagnostics_;
    ast::Ast& ast_;
    std::size_t position_ = 0;
    std::uint32_t level_ = 0;
    int errors_ = 0;
};

}  // namespace whittle
