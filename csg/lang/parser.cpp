#include "csg/lang/parser.h"

#include <algorithm>

#include "csg/lang/parser_state.h"

namespace whittle {

using namespace ast;

bool parse_tokens(const std::vector<Token>& tokens, std::vector<std::string> strings, const Names& names, const ParseOptions& options,
                  Diagnostics& diagnostics, Ast& out) {
    out.strings = std::move(strings);
    return Parser(tokens, names, options, diagnostics, out).run();
}

bool Parser::run() {
    ast_.exprs.reserve(tokens_.size());
    ast_.root = new_scope();
    try {
        statements(ast_.root, Tok::kEnd);
    } catch (const TooManyErrors&) {
    }
    return errors_ == 0;
}

void Parser::syntax_error(std::string hint) {
    std::string what = "syntax error";
    if (kind() == Tok::kBad) {  // the lexer's complaint: what, then a hint
        const std::string& complaint = ast_.strings[now().text];
        const std::size_t bar = complaint.find('|');
        what = complaint.substr(0, bar);
        hint = complaint.substr(bar + 1);
    } else if (const std::string meant = lesson(); !meant.empty()) {
        hint += "; " + meant;
    }
    diagnostics_.add(Severity::kError, now().place, "Parser error: " + what, std::move(hint));
    if (++errors_ >= kMaxSyntaxErrors) throw TooManyErrors{};
    throw SyntaxError{};
}

void Parser::too_deep(const std::string& limit) {
    diagnostics_.add(Severity::kError, now().place, "Parser error: memory exhausted", limit);
    ++errors_;
    throw TooManyErrors{};
}

void Parser::expect(Tok wanted, const char* where) {
    if (take_if(wanted)) return;
    std::string hint = std::string("expected ") + spelling(wanted) + " " + where + ", found " + found();
    const SourcePlace before = position_ > 0 ? tokens_[position_ - 1].place : now().place;
    if (wanted == Tok::kSemicolon && kind() != Tok::kBad && before.file == now().place.file && before.line < now().place.line)
        hint += "; line " + std::to_string(before.line) + " ends without it";
    if (wanted == Tok::kCloseParen && (kind() == Tok::kNumber || kind() == Tok::kString || (kind() == Tok::kIdentifier && next_kind() == Tok::kAssign)))
        hint += "; is a ',' missing before it?";
    syntax_error(std::move(hint));
}

// Skips to behind the ';' or the '}' that ends the broken statement; a '}' of an outer block and the end of the file are left alone.
void Parser::recover() {
    int depth = 0;
    while (kind() != Tok::kEnd) {
        if (kind() == Tok::kCloseBrace && depth == 0) return;
        if (kind() == Tok::kModule || (kind() == Tok::kFunction && next_kind() == Tok::kIdentifier)) return;
        const Tok taken = take().kind;
        if (taken == Tok::kOpenBrace) ++depth;
        if (taken == Tok::kCloseBrace && --depth == 0) return;
        if (taken == Tok::kSemicolon && depth == 0) return;
    }
}

ScopeId Parser::new_scope() {
    ast_.scopes.emplace_back();
    return static_cast<ScopeId>(ast_.scopes.size() - 1);
}

void Parser::statements(ScopeId scope, Tok end) {
    while (kind() != end && kind() != Tok::kEnd) {
        const std::size_t before = position_;
        const bool stray = kind() == Tok::kCloseBrace;
        try {
            if (stray) syntax_error("this '}' closes nothing");
            statement(scope);
        } catch (const SyntaxError&) {
            if (position_ == before) take();
            if (!stray) recover();
        }
    }
}

void Parser::statement(ScopeId scope) {
    const Level level(*this);
    switch (kind()) {
        case Tok::kSemicolon: take(); return;
        case Tok::kOpenBrace:
            take();
            statements(scope, Tok::kCloseBrace);
            return expect(Tok::kCloseBrace, "to end the block");
        case Tok::kModule: return module_definition(scope);
        case Tok::kFunction:
            return function_definition(scope);
        case Tok::kUse:
            if (scope != ast_.root) syntax_error("'use' belongs at the top of a file");
            take();
            return;
        case Tok::kIdentifier:
            if (next_kind() == Tok::kAssign) return assignment(scope);
            return instantiation(scope);
        default: return instantiation(scope);
    }
}

void Parser::assignment(ScopeId scope) {
    const Token& name = take();
    take();
    const ExprId value = expression();
    expect(Tok::kSemicolon, "after the value");
    add_assignment(scope, {name.text, value, name.place});
}

// The last value wins and takes the place of the first.
void Parser::add_assignment(ScopeId scope, const Assignment& added) {
    std::vector<Assignment>& all = ast_.scopes[scope].assignments;
    const auto old = std::find_if(all.begin(), all.end(), [&](const Assignment& a) { return a.name == added.name; });
    if (old == all.end()) return all.push_back(added);
    warn_of_overwriting(*old, added);
    *old = added;
}

// Said within one file, and where an include overwrites the main file; not where the main file or -D overwrites, nor for a file read twice.
void Parser::warn_of_overwriting(const Assignment& old, const Assignment& added) {
    if (added.place.file == options_.definitions_file || !options_.sources) return;
    const std::vector<SourceFile>& files = options_.sources->files;
    const SourceFile &before = files[old.place.file], &now_in = files[added.place.file];
    const std::string& main_path = files[options_.main_file].path;
    const bool was_main = before.path == main_path, is_main = now_in.path == main_path;
    std::string text = names_.text(added.name) + " was assigned on line " + std::to_string(old.place.line);
    if (was_main && is_main) text += " but was overwritten";
    else if ((before.path == now_in.path && old.place.line != added.place.line) || (was_main && !is_main)) text += " of \"" + before.name + "\" but was overwritten";
    else return;
    diagnostics_.add(Severity::kWarning, added.place, std::move(text));
}

void Parser::function_definition(ScopeId scope) {
    const SourcePlace place = take().place;
    if (kind() != Tok::kIdentifier) syntax_error("expected the function's name");
    Function f;
    f.name = take().text;
    f.place = place;
    expect(Tok::kOpenParen, "before the parameters");
    f.parameters = parameters();
    expect(Tok::kCloseParen, "after the parameters");
    if (kind() == Tok::kOpenBrace) syntax_error("expected '=' before the function's value, found '{'; a function is one expression: function name(x) = value;");
    expect(Tok::kAssign, "before the function's value");
    f.body = expression();
    expect(Tok::kSemicolon, "after the function");
    ast_.scopes[scope].functions.push_back(f);
}

void Parser::module_definition(ScopeId scope) {
    const SourcePlace place = take().place;
    if (kind() != Tok::kIdentifier) syntax_error("expected the module's name");
    Module m;
    m.name = take().text;
    m.place = place;
    expect(Tok::kOpenParen, "before the parameters");
    m.parameters = parameters();
    expect(Tok::kCloseParen, "after the parameters");
    m.body = new_scope();
    statement(m.body);
    ast_.scopes[scope].modules.push_back(m);
}

bool Parser::names_module(Tok k) const {
    return k == Tok::kIdentifier || k == Tok::kFor || k == Tok::kLet || k == Tok::kAssert || k == Tok::kEcho || k == Tok::kEach;
}

Instantiation Parser::instantiation_head(std::uint8_t modifiers) {
    Instantiation inst;
    inst.place = now().place;
    inst.modifiers = modifiers;
    const bool is_if = kind() == Tok::kIf;
    if (!is_if && !names_module(kind())) syntax_error("expected a statement, found " + found());
    inst.name = take().text;
    expect(Tok::kOpenParen, is_if ? "before the condition" : "after the module's name");
    if (is_if) {
        const SourcePlace place = now().place;
        const ExprId condition = expression();
        inst.arguments = store({{kNoName, condition, place}});
    } else {
        const bool is_for = tokens_[position_ - 2].kind == Tok::kFor;
        inst.arguments = arguments();
        if (is_for && kind() == Tok::kSemicolon) loop_of_another_language();
    }
    expect(Tok::kCloseParen, is_if ? "after the condition" : "after the arguments");
    return inst;
}

// for (i = 0; i < 9; i++), which lists have and modules do not: one message, however much is wrong up to the ')'.
void Parser::loop_of_another_language() {
    const SourcePlace place = now().place;
    for (int depth = 1; kind() != Tok::kEnd && depth > 0;) {
        const Tok taken = take().kind;
        depth += (taken == Tok::kOpenParen) - (taken == Tok::kCloseParen);
    }
    diagnostics_.add(Severity::kError, place, "Parser error: syntax error", "expected ')' after the arguments, found ';'; a loop of modules goes through a list or a range: for (i = [0 : 9])");
    if (++errors_ >= kMaxSyntaxErrors) throw TooManyErrors{};
    throw SyntaxError{};
}

// [!#%*]* name(args) child, or if (...) child [else child]; `*` reads and drops it.
void Parser::instantiation(ScopeId scope) {
    const Level level(*this);
    std::uint8_t modifiers = 0;
    bool disabled = false;
    for (;; take()) {
        if (kind() == Tok::kNot) modifiers |= kModRoot;
        else if (kind() == Tok::kHash) modifiers |= kModHighlight;
        else if (kind() == Tok::kPercent) modifiers |= kModBackground;
        else if (kind() == Tok::kStar) disabled = true;
        else break;
    }
    const bool is_if = kind() == Tok::kIf;
    Instantiation inst = instantiation_head(modifiers);
    inst.children = child_scope();
    inst.has_else = is_if && take_if(Tok::kElse);
    if (inst.has_else) inst.otherwise = child_scope();
    if (!disabled) ast_.scopes[scope].instantiations.push_back(inst);
}

// What a module is applied to: ';' (kNone), one instantiation, or a block of instantiations and assignments.
ScopeId Parser::child_scope() {
    if (take_if(Tok::kSemicolon)) return kNone;
    const ScopeId scope = new_scope();
    if (!take_if(Tok::kOpenBrace)) {
        instantiation(scope);
        return scope;
    }
    while (kind() != Tok::kCloseBrace) {
        if (kind() == Tok::kEnd) syntax_error("a block is not closed: expected '}'");
        const std::size_t before = position_;
        try {
            child_statement(scope);
        } catch (const SyntaxError&) {
            if (position_ == before && kind() != Tok::kCloseBrace) take();
            recover();
        }
    }
    take();
    return scope;
}

void Parser::child_statement(ScopeId scope) {
    if (take_if(Tok::kSemicolon)) return;
    if (kind() == Tok::kModule || kind() == Tok::kFunction) syntax_error("definitions belong at file level or in a module's body, not in a block of children");
    if (kind() == Tok::kIdentifier && next_kind() == Tok::kAssign) return assignment(scope);
    if (kind() == Tok::kOpenBrace) {
        const Level level(*this);
        take();
        while (kind() != Tok::kCloseBrace) {
            if (kind() == Tok::kEnd) syntax_error("a block is not closed: expected '}'");
            child_statement(scope);
        }
        take();
        return;
    }
    instantiation(scope);
}

}  // namespace whittle
