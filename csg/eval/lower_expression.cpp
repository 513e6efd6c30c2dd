#include <algorithm>

#include "csg/eval/builtin.h"
#include "csg/eval/builtin_arguments.h"
#include "csg/eval/lower_state.h"

namespace whittle {

using namespace code;
using ast::Expr;
using ast::ExprKind;

TermId Lowering::node(Op op, SourcePlace place, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out_.terms.push_back({op, a, b, c});
    out_.places.push_back(place);
    return static_cast<TermId>(out_.terms.size() - 1);
}

TermId Lowering::constant(Value value, SourcePlace place) {
    out_.constants.push_back(std::move(value));
    return node(Op::kConstant, place, static_cast<std::uint32_t>(out_.constants.size() - 1));
}

// Does evaluating it do nothing but give a value, whatever the variables hold?
bool Lowering::is_effectless(TermId id) const { return id == code::kNone || out_.terms[id].op == Op::kConstant; }

TermId Lowering::lower_name(NameId name, const LexicalScope* from, SourcePlace place, std::uint32_t up, bool deferred) {
    if (names_.is_dynamic(name)) return node(Op::kDynamic, place, dynamic(name), name);
    for (const LexicalScope* s = from; s; s = s->parent) {
        const auto it = s->locals.find(name);
        const bool passed_boundary = deferred;
        if (it != s->locals.end()) {
            const LexicalScope::Local& local = it->second;
            const bool always = local.order == LexicalScope::kAlways;
            const bool ready = always || (!passed_boundary && local.order < s->assigned);
            if (ready && !local.maybe) return up == 0 ? node(Op::kSlot, place, local.slot) : node(Op::kOuter, place, up, local.slot);
            if (local.maybe || passed_boundary) {
                const std::uint32_t next_up = up + (s->own_frame ? 1 : 0);
                const TermId otherwise = lower_name(name, s->parent, place, next_up, deferred || s->deferred);
                // The fallback is evaluated in the same frame as the node, so its depth counts from here.
                return node(Op::kMaybe, place, up, local.slot, otherwise);
            }
        }
        if (s->own_frame) ++up;
        deferred = deferred || s->deferred;
    }
    if (names_.text(name) == "PI") return constant(Value(3.14159265358979323846), place);
    return node(Op::kUnknown, place, name);
}

TermId Lowering::lower(ast::ExprId id, LexicalScope& scope, bool tail) {
    const Expr& e = ast_->exprs[id];
    switch (e.kind) {
        case ExprKind::kUndef: return constant(Value(), e.place);
        case ExprKind::kTrue: return constant(Value(true), e.place);
        case ExprKind::kFalse: return constant(Value(false), e.place);
        case ExprKind::kNumber: return constant(Value(e.number), e.place);
        case ExprKind::kString: return constant(heap_.string(ast_->strings[e.a]), e.place);
        case ExprKind::kName: return lower_name(e.a, &scope, e.place);
        case ExprKind::kUnary: {
            const TermId operand = lower(e.a, scope);
            const Term& under = out_.terms[operand];
            if (e.op == ast::Op::kNegate && under.op == Op::kConstant && out_.constants[under.a].is_number())
                return constant(Value(-out_.constants[under.a].number()), e.place);
            return node(Op::kUnary, e.place, operand, static_cast<std::uint32_t>(e.op));
        }
        case ExprKind::kBinary: return lower_binary(e, scope);
        case ExprKind::kTernary: {
            const TermId condition = lower(e.a, scope);
            const TermId yes = lower(e.b, scope, tail);
            return node(Op::kTernary, e.place, condition, yes, lower(e.c, scope, tail));
        }
        case ExprKind::kCall: return lower_call(e, scope, tail);
        case ExprKind::kIndex: {
            const TermId list = lower(e.a, scope);
            return node(Op::kIndex, e.place, list, lower(e.b, scope));
        }
        case ExprKind::kMember: {
            const std::string& name = names_.text(e.b);
            const bool axis = name.size() == 1 && name[0] >= 'x' && name[0] <= 'z';
            const TermId whole = lower(e.a, scope);
            return axis ? node(Op::kElement, e.place, whole, static_cast<std::uint32_t>(name[0] - 'x')) : node(Op::kMember, e.place, whole, e.b);
        }
        case ExprKind::kVector: return lower_vector(e, scope);
        case ExprKind::kRange: {
            const TermId begin = lower(e.a, scope);
            const TermId step = e.c == ast::kNone ? code::kNone : lower(e.c, scope);
            return node(Op::kRange, e.place, begin, step, lower(e.b, scope));
        }
        case ExprKind::kLet: return lower_let(e, scope, tail, Op::kLet);
        case ExprKind::kLetElement: return lower_let(e, scope, false, Op::kLet);
        case ExprKind::kFor: return lower_let(e, scope, false, Op::kFor);
        case ExprKind::kForC: return lower_for_c(e, scope);
        case ExprKind::kAssert:
        case ExprKind::kEcho: return lower_with_arguments(e, scope, tail);
        case ExprKind::kFunction: return lower_literal(id, scope);
        case ExprKind::kIfElement: {
            const TermId condition = lower(e.a, scope);
            const TermId yes = lower(e.b, scope);
            return node(Op::kIf, e.place, condition, yes, e.c == ast::kNone ? code::kNone : lower(e.c, scope));
        }
        case ExprKind::kEach: return node(Op::kEach, e.place, lower(e.a, scope));
    }
    return constant(Value(), e.place);
}

TermId Lowering::lower_binary(const Expr& e, LexicalScope& scope) {
    const TermId left = lower(e.a, scope);
    const TermId right = lower(e.b, scope);
    switch (e.op) {
        case ast::Op::kOr: return node(Op::kOr, e.place, left, right);
        case ast::Op::kAnd: return node(Op::kAnd, e.place, left, right);
        case ast::Op::kAdd: return node(Op::kAdd, e.place, left, right);
        case ast::Op::kSubtract: return node(Op::kSubtract, e.place, left, right);
        case ast::Op::kMultiply: return node(Op::kMultiply, e.place, left, right);
        case ast::Op::kDivide: return node(Op::kDivide, e.place, left, right);
        case ast::Op::kModulo: return node(Op::kModulo, e.place, left, right);
        case ast::Op::kLess: return node(Op::kLess, e.place, left, right);
        case ast::Op::kLessEqual: return node(Op::kLessEqual, e.place, left, right);
        case ast::Op::kGreater: return node(Op::kGreater, e.place, left, right);
        case ast::Op::kGreaterEqual: return node(Op::kGreaterEqual, e.place, left, right);
        case ast::Op::kEqual: return node(Op::kEqual, e.place, left, right);
        case ast::Op::kNotEqual: return node(Op::kNotEqual, e.place, left, right);
        default: return node(Op::kBinary, e.place, left, right, static_cast<std::uint32_t>(e.op));
    }
}

TermId Lowering::lower_vector(const Expr& e, LexicalScope& scope) {
    std::vector<TermId> elements;
    bool plain = true, constants = true;
    for (std::uint32_t i = 0; i < e.b; ++i) {
        const ast::ExprId item = ast_->items[e.a + i];
        const ExprKind kind = ast_->exprs[item].kind;
        plain = plain && kind != ExprKind::kFor && kind != ExprKind::kForC && kind != ExprKind::kIfElement && kind != ExprKind::kEach && kind != ExprKind::kLetElement;
        elements.push_back(lower(item, scope));
        constants = constants && out_.terms[elements.back()].op == Op::kConstant;
    }
    if (constants) {  // made once
        std::vector<Value> values;
        for (const TermId id : elements) values.push_back(out_.constants[out_.terms[id].a]);
        return constant(heap_.vector(std::move(values)), e.place);
    }
    const std::uint32_t first = static_cast<std::uint32_t>(out_.lists.size());
    out_.lists.insert(out_.lists.end(), elements.begin(), elements.end());
    return node(plain ? Op::kVector : Op::kElements, e.place, first, static_cast<std::uint32_t>(elements.size()));
}

// Variables of let or for. Each becomes visible to the ones after it; a name given twice is bound once.
std::vector<Bind> Lowering::lower_binds(ast::ArgumentRange range, LexicalScope& inner, bool sequential) {
    std::vector<Bind> out;
    std::vector<std::pair<NameId, LexicalScope::Local>> later;
    for (std::uint32_t i = 0; i < range.count; ++i) {
        const ast::Argument& a = argument(range, i);
        Bind bind;
        bind.name = a.name;
        bind.place = a.place;
        bind.value = lower(a.value, inner);
        const auto same = [&](const Bind& b) { return b.name == a.name; };
        const auto first = std::find_if(out.begin(), out.end(), same);
        if (a.name == kNoName) {
            bind.kind = BindKind::kNameless;
        } else if (first != out.end()) {
            bind.kind = BindKind::kDuplicate;
            bind.target = first->target;
        } else if (names_.is_dynamic(a.name)) {
            bind.kind = BindKind::kDynamic;
            bind.target = dynamic(a.name);
        } else {
            bind.target = inner.layout->slots++;
            const LexicalScope::Local local{bind.target, LexicalScope::kAlways, false};
            if (sequential) inner.locals[a.name] = local;
            else later.emplace_back(a.name, local);
        }
        out.push_back(bind);
    }
    for (const auto& [name, local] : later) inner.locals[name] = local;
    return out;
}

TermId Lowering::lower_let(const Expr& e, LexicalScope& scope, bool tail, Op op) {
    const ast::ArgumentRange range{e.b, e.c};
    const bool own = frames_for_all_ || expr_has_literal_[file_][e.a] || any_literal(range);
    Layout layout;
    LexicalScope inside = inner_scope(scope, own, own ? layout : *scope.layout);
    const std::vector<Bind> binds = lower_binds(range, inside, true);
    const bool dynamic_bound = std::any_of(binds.begin(), binds.end(), [](const Bind& b) { return b.kind == BindKind::kDynamic; });
    const TermId body = lower(e.a, inside, tail && !dynamic_bound);
    if (op == Op::kLet && dynamic_bound) op = Op::kLetDynamic;
    const std::uint32_t first = static_cast<std::uint32_t>(out_.binds.size());
    out_.binds.insert(out_.binds.end(), binds.begin(), binds.end());
    const TermId made = node(op, e.place, body, first, static_cast<std::uint32_t>(binds.size()));
    if (!own) return made;
    out_.frame_sizes.push_back(layout.slots);
    return node(Op::kFrame, e.place, made, static_cast<std::uint32_t>(out_.frame_sizes.size() - 1));
}

TermId Lowering::lower_for_c(const Expr& e, LexicalScope& scope) {
    const ast::ForC loop = ast_->for_c[e.a];
    const bool own = frames_for_all_ || any_literal(loop.init) || any_literal(loop.step) || expr_has_literal_[file_][loop.body] ||
                     expr_has_literal_[file_][loop.condition];
    Layout layout;
    LexicalScope inside = inner_scope(scope, own, own ? layout : *scope.layout);
    const std::vector<Bind> init = lower_binds(loop.init, inside, true);
    Loop out;
    // A variable that only the step sets is unset in the first round.
    for (std::uint32_t i = 0; i < loop.step.count; ++i) {
        const NameId name = argument(loop.step, i).name;
        if (name == kNoName || names_.is_dynamic(name) || inside.locals.count(name)) continue;
        out.unset.push_back(inside.layout->slots);
        inside.locals[name] = {inside.layout->slots++, LexicalScope::kAlways, true};
    }
    std::vector<Bind> steps;
    for (std::uint32_t i = 0; i < loop.step.count; ++i) {
        const ast::Argument& a = argument(loop.step, i);
        Bind bind;
        bind.name = a.name;
        bind.place = a.place;
        bind.value = lower(a.value, inside);
        const bool again = std::any_of(steps.begin(), steps.end(), [&](const Bind& b) { return b.name == a.name; });
        if (a.name == kNoName) bind.kind = BindKind::kNameless;
        else if (again) bind.kind = BindKind::kDuplicate;
        else if (names_.is_dynamic(a.name)) bind.kind = BindKind::kDynamic, bind.target = dynamic(a.name);
        else bind.target = inside.locals.at(a.name).slot;
        steps.push_back(bind);
    }
    out.condition = lower(loop.condition, inside);
    out.body = lower(loop.body, inside);
    out.first_init = static_cast<std::uint32_t>(out_.binds.size());
    out.inits = static_cast<std::uint32_t>(init.size());
    out_.binds.insert(out_.binds.end(), init.begin(), init.end());
    out.first_step = static_cast<std::uint32_t>(out_.binds.size());
    out.steps = static_cast<std::uint32_t>(steps.size());
    out_.binds.insert(out_.binds.end(), steps.begin(), steps.end());
    out_.loops.push_back(std::move(out));
    const TermId made = node(Op::kForC, e.place, static_cast<std::uint32_t>(out_.loops.size() - 1));
    if (!own) return made;
    out_.frame_sizes.push_back(layout.slots);
    return node(Op::kFrame, e.place, made, static_cast<std::uint32_t>(out_.frame_sizes.size() - 1));
}

TermId Lowering::lower_with_arguments(const Expr& e, LexicalScope& scope, bool tail) {
    const std::vector<Argument> list = lower_argument_list({e.b, e.c}, scope);
    const TermId body = e.a == ast::kNone ? code::kNone : lower(e.a, scope, tail);
    const std::uint32_t first = static_cast<std::uint32_t>(out_.arguments.size());
    out_.arguments.insert(out_.arguments.end(), list.begin(), list.end());
    return node(e.kind == ExprKind::kAssert ? Op::kAssert : Op::kEcho, e.place, body, first, static_cast<std::uint32_t>(list.size()));
}

TermId Lowering::lower_literal(ast::ExprId id, LexicalScope& scope) {
    const Expr& e = ast_->exprs[id];
    const std::uint32_t index = static_cast<std::uint32_t>(out_.functions.size());
    out_.functions.emplace_back();
    Layout layout;
    std::vector<Parameter> parameters = declare_parameters({e.b, e.c}, layout, value_arguments_);
    lower_defaults({e.b, e.c}, parameters, scope);
    LexicalScope inside = inner_scope(scope, true, layout);
    inside.deferred = true;
    open_parameters(parameters, layout, inside);
    const std::uint32_t before = std::exchange(function_, index);
    const bool frames = std::exchange(frames_for_all_, false);
    const TermId body = lower(e.a, inside, true);
    function_ = before;
    frames_for_all_ = frames;
    Function& made = out_.functions[index];
    for (std::uint32_t i = 0; i < parameters.size(); ++i)
        if (names_.text(parameters[i].name) == "this") made.self = i;
    made.parameters = std::move(parameters);
    made.layout = std::move(layout);
    made.body = body;
    made.depth = ast_->exprs[e.a].depth;
    made.ast = ast_;
    made.literal = id;
    made.place = e.place;
    return node(Op::kFunction, e.place, index);
}

TermId Lowering::lower_call(const Expr& e, LexicalScope& scope, bool tail) {
    const Expr& callee = ast_->exprs[e.a];
    if (callee.kind == ExprKind::kName) {
        const TermId variable = lower_name(callee.a, &scope, callee.place);
        const Op op = out_.terms[variable].op;
        if (op == Op::kUnknown || op == Op::kConstant) return lower_named_call(e, callee.a, scope, tail);
        return lower_value_call(e, variable, callee.a, scope, tail);
    }
    return lower_value_call(e, lower(e.a, scope), kNoName, scope, false);
}

// A variable of that name hides the function only where it holds a function: which, is seen when it runs.
TermId Lowering::lower_value_call(const Expr& e, TermId callee, NameId name, LexicalScope& scope, bool tail) {
    ValueCall call;
    call.name = name;
    call.callee = callee;
    call.arguments = lower_argument_list({e.b, e.c}, scope);
    for (const Argument& a : call.arguments)
        if (names_.is_dynamic(a.name)) dynamic(a.name);
    silence(callee);
    if (name != kNoName) {
        if (const std::optional<Found> found = find_definition(name, scope, false)) {
            call.otherwise = ValueCall::Otherwise::kFunction;
            call.target = found->index;
            call.home = found->home;
        } else if (const auto it = builtin_functions_.find(name); it != builtin_functions_.end()) {
            call.otherwise = ValueCall::Otherwise::kBuiltin;
            call.target = it->second;
        }
    }
    out_.value_calls.push_back(std::move(call));
    const std::uint32_t which = static_cast<std::uint32_t>(out_.value_calls.size() - 1);
    const bool own = tail && function_ != code::kNone && out_.functions[function_].name == kNoName;
    return own ? node(Op::kTailCallValue, e.place, which, function_) : node(Op::kCallValue, e.place, which);
}

// Makes reading a variable that may be unknown say nothing.
void Lowering::silence(TermId id) {
    while (out_.terms[id].op == Op::kMaybe) id = out_.terms[id].c;
    Term& read = out_.terms[id];
    if (read.op == Op::kDynamic) read.c = 1;
    if (read.op == Op::kUnknown) read.b = 1;
}

TermId Lowering::lower_named_call(const Expr& e, NameId name, LexicalScope& scope, bool tail) {
    const ast::ArgumentRange range{e.b, e.c};
    if (const std::optional<Found> found = find_definition(name, scope, false)) {
        Call call;
        call.name = name;
        call.function = found->index;
        call.home = found->home;
        // Copies: lowering the arguments may add functions and move the arrays.
        const std::vector<Parameter> parameters = out_.functions[found->index].parameters;
        const Layout layout = out_.functions[found->index].layout;
        call.matched = match(range, parameters, layout, parameters.size(), scope);
        const bool itself = tail && found->index == function_ && found->home.library == code::kNone;
        out_.calls.push_back(std::move(call));
        return node(itself ? Op::kTailCall : Op::kCall, e.place, static_cast<std::uint32_t>(out_.calls.size() - 1));
    }
    const auto builtin = builtin_functions_.find(name);
    if (builtin == builtin_functions_.end()) return node(Op::kUnknownFunction, e.place, name);
    // is_undef(name) asks about a variable without a warning.
    std::vector<TermId> values;
    for (std::uint32_t i = 0; i < range.count; ++i) {
        values.push_back(lower(argument(range, i).value, scope));
        if (builtin_functions()[builtin->second].name == "is_undef") silence(values.back());
    }
    std::vector<NameId> given;
    for (std::uint32_t i = 0; i < range.count; ++i) given.push_back(argument(range, i).name);
    const auto made = [&](std::string_view text) { return constant(text.empty() ? Value() : heap_.string(text), e.place); };
    values = arranged_arguments<TermId>(builtin_functions()[builtin->second], given, std::move(values), names_, made);
    const std::uint32_t first = static_cast<std::uint32_t>(out_.lists.size());
    out_.lists.insert(out_.lists.end(), values.begin(), values.end());
    const bool of_number = values.size() == 1 && builtin_functions()[builtin->second].of_number;
    return node(of_number ? Op::kNumberFunction : Op::kBuiltin, e.place, builtin->second, first, static_cast<std::uint32_t>(values.size()));
}

}  // namespace whittle
