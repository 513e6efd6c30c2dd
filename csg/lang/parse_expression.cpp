#include <algorithm>
#include <optional>

#include "csg/lang/parser_state.h"

namespace whittle {

using namespace ast;

namespace {

struct Infix { int level; Op op; };

// Binding strength, loosest first.
std::optional<Infix> infix(Tok kind) {
    switch (kind) {
        case Tok::kOr: return Infix{0, Op::kOr};
        case Tok::kAnd: return Infix{1, Op::kAnd};
        case Tok::kEqual: return Infix{2, Op::kEqual};
        case Tok::kNotEqual: return Infix{2, Op::kNotEqual};
        case Tok::kLess: return Infix{3, Op::kLess};
        case Tok::kLessEqual: return Infix{3, Op::kLessEqual};
        case Tok::kGreater: return Infix{3, Op::kGreater};
        case Tok::kGreaterEqual: return Infix{3, Op::kGreaterEqual};
        case Tok::kBitOr: return Infix{4, Op::kBitOr};
        case Tok::kBitAnd: return Infix{5, Op::kBitAnd};
        case Tok::kShiftLeft: return Infix{6, Op::kShiftLeft};
        case Tok::kShiftRight: return Infix{6, Op::kShiftRight};
        case Tok::kPlus: return Infix{7, Op::kAdd};
        case Tok::kMinus: return Infix{7, Op::kSubtract};
        case Tok::kStar: return Infix{8, Op::kMultiply};
        case Tok::kSlash: return Infix{8, Op::kDivide};
        case Tok::kPercent: return Infix{8, Op::kModulo};
        default: return std::nullopt;
    }
}

}  // namespace

ExprId Parser::make(ExprKind made, SourcePlace place, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Expr e;
    e.kind = made;
    e.place = place;
    e.a = a;
    e.b = b;
    e.c = c;
    ast_.exprs.push_back(e);
    return static_cast<ExprId>(ast_.exprs.size() - 1);
}

void Parser::deepen(ExprId id, std::uint32_t depth) {
    Expr& e = ast_.exprs[id];
    e.depth = std::max(e.depth, depth + 1);
    if (e.depth > options_.deepest) too_deep("more than " + std::to_string(options_.deepest) + " operators within each other");
}

// Messages name the line where an expression starts; on that line the caret stands under the operator.
SourcePlace Parser::infix_place(ExprId left, SourcePlace sign) const {
    const SourcePlace& start = ast_.exprs[left].place;
    return start.file == sign.file && start.line == sign.line ? sign : start;
}

std::uint32_t Parser::depth_of(ArgumentRange range) const {
    std::uint32_t depth = 0;
    for (std::uint32_t i = 0; i < range.count; ++i) depth = std::max(depth, depth_of(ast_.arguments[range.first + i].value));
    return depth;
}

ArgumentRange Parser::store(const std::vector<Argument>& list) {
    const ArgumentRange range{static_cast<std::uint32_t>(ast_.arguments.size()), static_cast<std::uint32_t>(list.size())};
    ast_.arguments.insert(ast_.arguments.end(), list.begin(), list.end());
    return range;
}

ExprId Parser::expression() {
    const Level level(*this);
    const Token& start = now();
    switch (start.kind) {
        case Tok::kFunction: {
            take();
            expect(Tok::kOpenParen, "before the parameters");
            const ArgumentRange list = parameters();
            expect(Tok::kCloseParen, "after the parameters");
            const ExprId body = expression();
            const ExprId id = make(ExprKind::kFunction, start.place, body, list.first, list.count);
            deepen(id, std::max(depth_of(body), depth_of(list)));
            return id;
        }
        case Tok::kLet:
        case Tok::kAssert:
        case Tok::kEcho: {
            take();
            expect(Tok::kOpenParen, "after the keyword");
            const ArgumentRange list = arguments();
            expect(Tok::kCloseParen, "after the arguments");
            const bool ends = kind() == Tok::kSemicolon || kind() == Tok::kComma || kind() == Tok::kCloseParen || kind() == Tok::kCloseBracket ||
                              kind() == Tok::kColon || kind() == Tok::kEnd;
            const ExprId body = start.kind != Tok::kLet && ends ? kNone : expression();
            const ExprKind made = start.kind == Tok::kLet ? ExprKind::kLet : start.kind == Tok::kAssert ? ExprKind::kAssert : ExprKind::kEcho;
            const ExprId id = make(made, start.place, body, list.first, list.count);
            deepen(id, std::max(depth_of(body), depth_of(list)));
            return id;
        }
        default: break;
    }
    const ExprId condition = binary(0);
    if (kind() != Tok::kQuestion) return condition;
    const SourcePlace place = infix_place(condition, take().place);
    const ExprId yes = expression();
    expect(Tok::kColon, "between the two values of '?'");
    const ExprId no = expression();
    const ExprId id = make(ExprKind::kTernary, place, condition, yes, no);
    deepen(id, std::max({depth_of(condition), depth_of(yes), depth_of(no)}));
    return id;
}

ExprId Parser::binary(int level) {
    ExprId left = unary();
    while (const std::optional<Infix> found = infix(kind())) {
        if (found->level < level) break;
        const SourcePlace place = infix_place(left, take().place);
        const ExprId right = binary(found->level + 1);
        const ExprId id = make(ExprKind::kBinary, place, left, right);
        ast_.exprs[id].op = found->op;
        deepen(id, std::max(depth_of(left), depth_of(right)));
        left = id;
    }
    return left;
}

ExprId Parser::unary() {
    const Level level(*this);
    const Token& sign = now();
    std::optional<Op> op;
    if (sign.kind == Tok::kNot) op = Op::kNot;
    if (sign.kind == Tok::kMinus) op = Op::kNegate;
    if (sign.kind == Tok::kPlus) op = Op::kPlus;
    if (sign.kind == Tok::kBitNot) op = Op::kBitNot;
    if (!op) return power();
    take();
    const ExprId operand = unary();
    if (op == Op::kPlus) return operand;
    const ExprId id = make(ExprKind::kUnary, sign.place, operand);
    ast_.exprs[id].op = *op;
    deepen(id, depth_of(operand));
    return id;
}

ExprId Parser::power() {
    const ExprId base = postfix();
    if (kind() != Tok::kCaret) return base;
    const SourcePlace place = infix_place(base, take().place);
    const ExprId exponent = unary();
    const ExprId id = make(ExprKind::kBinary, place, base, exponent);
    ast_.exprs[id].op = Op::kPower;
    deepen(id, std::max(depth_of(base), depth_of(exponent)));
    return id;
}

ExprId Parser::postfix() {
    ExprId value = primary();
    for (std::uint32_t links = 0;; ++links) {
        if (links > 2 * kMaxNesting) too_deep("a chain of more than " + std::to_string(2 * kMaxNesting) + " calls and indices");
        const SourcePlace place = infix_place(value, now().place);
        if (take_if(Tok::kOpenParen)) {
            const ArgumentRange list = arguments();
            expect(Tok::kCloseParen, "after the arguments");
            const ExprId id = make(ExprKind::kCall, ast_.exprs[value].place, value, list.first, list.count);
            deepen(id, std::max(depth_of(value), depth_of(list)));
            value = id;
        } else if (take_if(Tok::kOpenBracket)) {
            const ExprId index = expression();
            expect(Tok::kCloseBracket, "after the index");
            const ExprId id = make(ExprKind::kIndex, place, value, index);
            deepen(id, std::max(depth_of(value), depth_of(index)));
            value = id;
        } else if (take_if(Tok::kDot)) {
            if (kind() != Tok::kIdentifier) syntax_error("expected the member's name");
            const NameId name = take().text;
            const ExprId id = make(ExprKind::kMember, place, value, name);
            deepen(id, depth_of(value));
            value = id;
        } else {
            return value;
        }
    }
}

ExprId Parser::primary() {
    const Token& token = now();
    switch (token.kind) {
        case Tok::kUndef: take(); return make(ExprKind::kUndef, token.place);
        case Tok::kTrue: take(); return make(ExprKind::kTrue, token.place);
        case Tok::kFalse: take(); return make(ExprKind::kFalse, token.place);
        case Tok::kNumber: {
            take();
            const ExprId id = make(ExprKind::kNumber, token.place);
            ast_.exprs[id].number = token.number;
            return id;
        }
        case Tok::kString: take(); return make(ExprKind::kString, token.place, token.text);
        case Tok::kIdentifier: take(); return make(ExprKind::kName, token.place, token.text);
        case Tok::kOpenParen: {
            take();
            const ExprId inside = expression();
            expect(Tok::kCloseParen, "to match '('");
            return inside;
        }
        case Tok::kOpenBracket: take(); return vector_or_range(token.place);
        default: syntax_error("expected a value, found " + found());
    }
}

ExprId Parser::vector_or_range(SourcePlace place) {
    std::vector<ExprId> elements;
    std::uint32_t depth = 0;
    bool plain = true;
    while (take_if(Tok::kComma)) plain = false;
    while (kind() != Tok::kCloseBracket) {
        plain = plain && !starts_element(kind()) && elements.empty();
        const ExprId first = element();
        if (plain && kind() == Tok::kColon) {
            take();
            const ExprId second = expression();
            const ExprId third = take_if(Tok::kColon) ? expression() : kNone;
            expect(Tok::kCloseBracket, "to end the range");
            const ExprId id = third == kNone ? make(ExprKind::kRange, place, first, second, kNone) : make(ExprKind::kRange, place, first, third, second);
            deepen(id, std::max({depth_of(first), depth_of(second), depth_of(third)}));
            return id;
        }
        elements.push_back(first);
        depth = std::max(depth, depth_of(first));
        if (kind() == Tok::kCloseBracket) break;
        expect(Tok::kComma, "or ']' after an element");
        while (take_if(Tok::kComma)) {}
    }
    expect(Tok::kCloseBracket, "to end the vector");
    const std::uint32_t first = static_cast<std::uint32_t>(ast_.items.size());
    ast_.items.insert(ast_.items.end(), elements.begin(), elements.end());
    const ExprId id = make(ExprKind::kVector, place, first, static_cast<std::uint32_t>(elements.size()));
    deepen(id, depth);
    return id;
}

bool Parser::starts_element(Tok k) const { return k == Tok::kFor || k == Tok::kIf || k == Tok::kEach; }

// An element of a vector: an expression, or for, if, each, let, also in parentheses.
ExprId Parser::element() {
    const Level level(*this);
    const Token& start = now();
    if (start.kind == Tok::kOpenParen && starts_element(next_kind())) {
        take();
        const ExprId inside = element();
        expect(Tok::kCloseParen, "to match '('");
        return inside;
    }
    if (start.kind == Tok::kFor) return for_element();
    if (start.kind == Tok::kIf) return if_element();
    if (start.kind == Tok::kEach) {
        take();
        const ExprId inside = element();
        const ExprId id = make(ExprKind::kEach, start.place, inside);
        deepen(id, depth_of(inside));
        return id;
    }
    if (start.kind != Tok::kLet) return expression();
    // let (...) element or let (...) expression: decided by what follows the arguments.
    take();
    expect(Tok::kOpenParen, "after 'let'");
    const ArgumentRange list = arguments();
    expect(Tok::kCloseParen, "after the arguments");
    const ExprId inside = element();
    const ExprKind inner = ast_.exprs[inside].kind;
    const bool comprehension = inner == ExprKind::kFor || inner == ExprKind::kForC || inner == ExprKind::kIfElement || inner == ExprKind::kEach ||
                               inner == ExprKind::kLetElement;
    const ExprId id = make(comprehension ? ExprKind::kLetElement : ExprKind::kLet, start.place, inside, list.first, list.count);
    deepen(id, std::max(depth_of(inside), depth_of(list)));
    return id;
}

ExprId Parser::for_element() {
    const SourcePlace place = take().place;
    expect(Tok::kOpenParen, "after 'for'");
    const ArgumentRange first = assignments_until(Tok::kSemicolon);
    if (!take_if(Tok::kSemicolon)) {
        expect(Tok::kCloseParen, "after the loop's variables");
        const ExprId body = element();
        const ExprId id = make(ExprKind::kFor, place, body, first.first, first.count);
        deepen(id, std::max(depth_of(body), depth_of(first)));
        return id;
    }
    ForC loop;
    loop.init = first;
    loop.condition = expression();
    expect(Tok::kSemicolon, "after the loop's condition");
    loop.step = assignments_until(Tok::kCloseParen);
    expect(Tok::kCloseParen, "after the loop's step");
    loop.body = element();
    ast_.for_c.push_back(loop);
    const ExprId id = make(ExprKind::kForC, place, static_cast<std::uint32_t>(ast_.for_c.size() - 1));
    deepen(id, std::max({depth_of(loop.body), depth_of(loop.init), depth_of(loop.condition), depth_of(loop.step)}));
    return id;
}

ExprId Parser::if_element() {
    const SourcePlace place = take().place;
    expect(Tok::kOpenParen, "before the condition");
    const ExprId condition = expression();
    expect(Tok::kCloseParen, "after the condition");
    const ExprId yes = element();
    const ExprId no = take_if(Tok::kElse) ? element() : kNone;
    const ExprId id = make(ExprKind::kIfElement, place, condition, yes, no);
    deepen(id, std::max({depth_of(condition), depth_of(yes), depth_of(no)}));
    return id;
}

ArgumentRange Parser::assignments_until(Tok end) {
    std::vector<Argument> list;
    while (kind() != end && kind() != Tok::kCloseParen) {
        if (take_if(Tok::kComma)) continue;
        Argument argument;
        argument.place = now().place;
        if (kind() == Tok::kIdentifier && next_kind() == Tok::kAssign) {
            argument.name = take().text;
            take();
        }
        argument.value = expression();
        list.push_back(argument);
        if (kind() != Tok::kComma) break;
    }
    return store(list);
}

ArgumentRange Parser::arguments() { return assignments_until(Tok::kCloseParen); }

ArgumentRange Parser::parameters() {
    std::vector<Argument> list;
    while (kind() != Tok::kCloseParen) {
        if (take_if(Tok::kComma)) continue;
        if (kind() != Tok::kIdentifier) syntax_error("expected a parameter's name, found " + found());
        Argument parameter;
        parameter.place = now().place;
        parameter.name = take().text;
        if (take_if(Tok::kAssign)) parameter.value = expression();
        list.push_back(parameter);
        if (kind() != Tok::kComma) break;
    }
    return store(list);
}

}  // namespace whittle
