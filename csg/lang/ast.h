// ast.h — the syntax of a program as the parser found it: flat arrays, ids instead of pointers.
//
// One Ast holds one file with everything it includes; a `use`d file has its own. Nothing here is resolved: names are NameIds. Every node knows its
// depth (one more than its deepest child), which the parser bounds, so that a walk over the tree may recurse.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/lang/names.h"
#include "csg/lang/source.h"

namespace whittle::ast {

using ExprId = std::uint32_t;
using ScopeId = std::uint32_t;
inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

enum class ExprKind : std::uint8_t {
    kUndef, kTrue, kFalse,
    kNumber,    // number
    kString,    // a: index into strings
    kName,      // a: NameId
    kUnary,     // op, a
    kBinary,    // op, a, b
    kTernary,   // a ? b : c
    kCall,      // a: callee expression (kName for a plain call), b: first argument, c: count
    kIndex,     // a [ b ]
    kMember,    // a . b (NameId)
    kVector,    // a: first of `items`, b: count
    kRange,     // a: begin, b: end, c: step or kNone
    kLet,       // a: body, b: first argument, c: count
    kAssert,    // a: body or kNone, b, c: arguments
    kEcho,      // likewise
    kFunction,  // a: body, b, c: parameters
    // Elements of a vector only:
    kFor,       // a: body, b, c: arguments
    kForC,      // a: index into `for_c`
    kIfElement, // a: condition, b: then, c: else or kNone
    kEach,      // a
    kLetElement // a: body, b, c: arguments
};

enum class Op : std::uint8_t {
    kNot, kNegate, kPlus, kBitNot,
    kOr, kAnd, kEqual, kNotEqual, kLess, kLessEqual, kGreater, kGreaterEqual,
    kBitOr, kBitAnd, kShiftLeft, kShiftRight, kAdd, kSubtract, kMultiply, kDivide, kModulo, kPower
};

struct Expr {
    ExprKind kind = ExprKind::kUndef;
    Op op = Op::kNot;
    std::uint32_t a = kNone, b = 0, c = 0;
    std::uint32_t depth = 1;
    SourcePlace place;
    double number = 0;
};

// `name = value`, `value` or (in a parameter list) `name`.
struct Argument {
    NameId name = kNoName;
    ExprId value = kNone;
    SourcePlace place;
};

struct ArgumentRange {
    std::uint32_t first = 0, count = 0;
};

// C-style for: init; condition; step; body.
struct ForC {
    ArgumentRange init;
    ExprId condition = kNone;
    ArgumentRange step;
    ExprId body = kNone;
};

struct Assignment {
    NameId name = kNoName;
    ExprId value = kNone;
    SourcePlace place;        // of the assignment that won
};

struct Function {
    NameId name = kNoName;
    ArgumentRange parameters;
    ExprId body = kNone;
    SourcePlace place;
};

struct Module {
    NameId name = kNoName;
    ArgumentRange parameters;
    ScopeId body = kNone;
    SourcePlace place;
};

enum ModifierBit : std::uint8_t { kModBackground = 1, kModHighlight = 2, kModRoot = 4 };  // %, #, !

struct Instantiation {
    NameId name = kNoName;
    ArgumentRange arguments;
    ScopeId children = kNone;   // kNone: written with ';'
    ScopeId otherwise = kNone;  // else of an if
    std::uint8_t modifiers = 0;
    bool has_else = false;      // even `else ;`
    SourcePlace place;
};

// Assignments in order of the first one of each name, each with the value of the last.
struct Scope {
    std::vector<Assignment> assignments;
    std::vector<Function> functions;
    std::vector<Module> modules;
    std::vector<Instantiation> instantiations;
    std::uint32_t depth = 1;
};

struct Ast {
    std::vector<Expr> exprs;
    std::vector<Argument> arguments;
    std::vector<ExprId> items;
    std::vector<ForC> for_c;
    std::vector<Scope> scopes;
    std::vector<std::string> strings;
    std::vector<std::string> uses;  // resolved paths of used files, in order; those not found are absent
    ScopeId root = kNone;
};

}  // namespace whittle::ast
