// code.h — a program after its names were resolved: what the evaluator walks.
//
// Every variable is a slot of a frame some frames up; every call of a known function or module already has its arguments matched to parameters.
// A name that an enclosing scope may or may not have set yet is read with a check (kMaybe), since OpenSCAD then looks further out.
// Scopes that no function value can outlive (let, for, blocks of children) have their slots in the frame around them; only a scope that holds a function
// literal gets a frame of its own, so that every iteration keeps its own variables.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/eval/value.h"
#include "csg/lang/ast.h"
#include "csg/lang/names.h"
#include "csg/lang/source.h"

namespace whittle::code {

using TermId = std::uint32_t;
inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

enum class Op : std::uint8_t {
    kConstant,  // a: index into constants
    kSlot,      // a: slot of the current frame
    kOuter,     // a: frames up, b: slot
    kMaybe,     // a: frames up, b: slot, c: what to evaluate when it is unset
    kDynamic,   // a: $-variable, b: NameId, c: 1 where an unknown one is no mistake
    kUnknown,   // a: NameId of a variable nobody defines, b: likewise
    kOr, kAnd, kTernary,
    kUnary,     // a, b: ast::Op
    kBinary,    // a, b, c: ast::Op
    kAdd, kSubtract, kMultiply, kDivide, kModulo, kLess, kLessEqual, kGreater, kGreaterEqual, kEqual, kNotEqual,  // a, b: the common ones of kBinary
    kIndex,
    kElement,   // a, b: index 0 to 2: .x .y .z
    kMember,    // a, b: NameId
    kVector,    // a: first of `lists`, b: count; elements are plain
    kElements,  // likewise; elements may be generators
    kRange,     // a: begin, b: step or kNone, c: end
    kLet,       // a: body, b: first of `binds`, c: count
    kLetDynamic,  // likewise, where a $-variable is among them
    kFrame,     // a: body, b: index into frame_sizes: a scope with a frame of its own
    kAssert, kEcho,  // a: body or kNone, b: first of `arguments`, c: count
    kFunction,  // a: function
    kCall,      // a: call
    kTailCall,  // a: call of the function itself, in tail position: ends the evaluation of the body
    kCallValue, // a: value call
    kTailCallValue,  // likewise, in tail position of function b: where that is what it calls, ends the evaluation of the body
    kBuiltin,   // a: builtin, b: first of `lists`, c: count
    kNumberFunction,  // likewise, of one argument: a built-in that makes a number of a number
    kUnknownFunction,  // a: NameId
    // Generators: push any number of values.
    kFor,       // a: body, b: first of `binds`, c: count
    kForC,      // a: index into loops
    kIf,        // a: condition, b: then, c: else or kNone
    kEach       // a
};

struct Term {
    Op op = Op::kConstant;
    std::uint32_t a = kNone, b = 0, c = 0;
};

enum class BindKind : std::uint8_t { kSlot, kDynamic, kDuplicate, kNameless };

// One variable of let, for or a block of assignments.
struct Bind {
    BindKind kind = BindKind::kSlot;
    std::uint32_t target = 0;  // slot or $-variable
    NameId name = kNoName;
    TermId value = kNone;
    SourcePlace place;
};

struct Argument {
    NameId name = kNoName;
    TermId value = kNone;
    ast::ExprId text = ast::kNone;  // in `tree`: how the author wrote it
    const ast::Ast* tree = nullptr;
};

struct Parameter {
    NameId name = kNoName;
    bool dynamic = false;
    std::uint32_t target = 0;  // slot or $-variable
    TermId value = kNone;      // default
    bool constant = true;      // the default has no effect but its value
};

// Frames of a file, function or module.
struct Layout {
    std::uint32_t slots = 0;
    struct Extra { NameId name; std::uint32_t slot; };
    std::vector<Extra> extras;  // names that a call may set although they are no parameters
};

struct Function {
    NameId name = kNoName;
    std::vector<Parameter> parameters;
    Layout layout;
    TermId body = kNone;
    std::uint32_t depth = 1;  // of the body
    const ast::Ast* ast = nullptr;
    ast::ExprId literal = ast::kNone;
    std::uint32_t self = kNone;  // which parameter is `this`
    SourcePlace place;
};

// Where the argument of a call goes.
struct Passed {
    enum class To : std::uint8_t { kParameter, kSlot, kDynamic, kNowhere } to = To::kNowhere;
    std::uint32_t target = 0;     // slot or $-variable
    std::uint32_t parameter = 0;  // index, for kParameter
    TermId value = kNone;
};

// What is wrong with the arguments of a call, in OpenSCAD's words; `unknown` is a name that is no parameter's.
struct Complaint {
    std::string text;
    NameId unknown = kNoName;
};

struct Matched {
    std::vector<Passed> passed;            // in the order of evaluation
    std::vector<Complaint> complaints;
    struct Default { std::uint32_t slot; TermId value; };
    std::vector<Default> defaults;         // of a plain match: the parameters that are not given
    std::uint64_t given = 0;               // which of the first 64 parameters
    bool plain = false;                    // neither complaints nor $-variables nor defaults that do something: `passed` and `defaults` are all
};

// Activation in which a callee is defined: some frames up, or a fresh one of a used file.
struct Home {
    std::uint32_t frames_up = 0;
    std::uint32_t library = kNone;
};

struct Call {
    NameId name = kNoName;
    std::uint32_t function = 0;
    Home home;
    Matched matched;
    bool plain = false;  // the match is, and the function is not a used file's
};

// Call of whatever value the callee has. Where that is no function, the name may still be that of a function or a built-in.
struct ValueCall {
    enum class Otherwise : std::uint8_t { kNothing, kFunction, kBuiltin };
    NameId name = kNoName;
    TermId callee = kNone;
    std::vector<Argument> arguments;
    Otherwise otherwise = Otherwise::kNothing;
    std::uint32_t target = 0;
    Home home;
};

struct Loop {  // C-style
    std::uint32_t first_init = 0, inits = 0;  // binds
    TermId condition = kNone;
    std::uint32_t first_step = 0, steps = 0;
    TermId body = kNone;
    std::vector<std::uint32_t> unset;         // slots that only the step sets
};

using ScopeId = std::uint32_t;
using InstId = std::uint32_t;

// Assignments, then instantiations.
struct Scope {
    std::vector<Bind> binds;
    std::vector<InstId> insts;
    std::uint32_t frame_size = kNone;  // index into frame_sizes: has a frame of its own
};

struct Module {
    NameId name = kNoName;
    std::vector<Parameter> parameters;
    Layout layout;
    ScopeId body = kNone;
    std::uint32_t children_slot = 0;
    std::vector<std::pair<NameId, SourcePlace>> overwritten;  // parameters that the body sets to a literal
    SourcePlace place;
};

enum class InstKind : std::uint8_t { kBuiltin, kUser, kUnknown, kFor, kIntersectionFor, kIf, kLet, kAssign, kEcho, kAssert, kEach, kChildren };

struct Inst {
    InstKind kind = InstKind::kUnknown;
    NameId name = kNoName;
    std::uint32_t target = 0;  // builtin or module
    Home home;
    Matched matched;           // kBuiltin, kUser
    std::uint32_t parameters = 0;  // kBuiltin: how many it has
    bool refuses_children = false, clamps_facets = false;  // kBuiltin: what OpenSCAD says of its use
    std::vector<Bind> binds;   // for, let
    std::vector<Argument> arguments;  // if, echo, assert, children
    std::uint32_t frame_size = kNone;  // for, let: a frame for each iteration
    ScopeId children = kNone, otherwise = kNone;
    std::uint8_t modifiers = 0;
    bool has_else = false;     // even an empty one
    SourcePlace place;
};

struct File {
    Layout layout;
    ScopeId body = kNone;
};

struct Program {
    std::vector<Term> terms;
    std::vector<SourcePlace> places;  // of nodes
    std::vector<Value> constants;
    std::vector<std::uint32_t> lists;
    std::vector<Bind> binds;
    std::vector<Argument> arguments;
    std::vector<std::uint32_t> frame_sizes;
    std::vector<Function> functions;
    std::vector<Module> modules;
    std::vector<Call> calls;
    std::vector<ValueCall> value_calls;
    std::vector<Loop> loops;
    std::vector<Scope> scopes;
    std::vector<Inst> insts;
    std::vector<File> files;          // [0] is the main file
    std::vector<NameId> dynamics;     // names of $-variables; the first kWellKnown are Dynamic's
    std::vector<const ast::Ast*> syntax;  // of files
    bool sees_lights = false;         // names a module that asks where it stands: light, sun, camera ...
};

// $-variables that the program itself reads.
enum Dynamic : std::uint32_t { kFn, kFa, kFs, kT, kPreview, kVpr, kVpt, kVpd, kVpf, kParentModules, kFe, kWellKnown };

}  // namespace whittle::code
