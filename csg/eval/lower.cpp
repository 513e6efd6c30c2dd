#include "csg/eval/lower.h"

#include <algorithm>
#include <unordered_map>

#include "csg/eval/builtin.h"
#include "csg/eval/lower_state.h"
#include "csg/eval/match_arguments.h"

namespace whittle {

using namespace code;

Program lower(const std::vector<std::unique_ptr<FileSyntax>>& files, Names& names, Heap& heap) { return Lowering(files, names, heap).run(); }

Lowering::Lowering(const std::vector<std::unique_ptr<FileSyntax>>& files, Names& names, Heap& heap) : files_(files), names_(names), heap_(heap) {
    for (const BuiltinFunction& f : builtin_functions()) builtin_functions_.emplace(names_.intern(f.name), builtin_functions_.size());
    for (const BuiltinModule& m : builtin_modules()) builtin_modules_.emplace(names_.intern(m.name), builtin_modules_.size());
    for (const char* name : {"$fn", "$fa", "$fs", "$t", "$preview", "$vpr", "$vpt", "$vpd", "$vpf", "$parent_modules", "$fe"}) dynamic(names_.intern(name));
}

std::uint32_t Lowering::dynamic(NameId name) {
    const auto [it, added] = dynamics_.emplace(name, static_cast<std::uint32_t>(out_.dynamics.size()));
    if (added) out_.dynamics.push_back(name);
    return it->second;
}

Program Lowering::run() {
    scan_calls();
    file_functions_.resize(files_.size());
    file_modules_.resize(files_.size());
    out_.files.resize(files_.size());
    for (const auto& file : files_) {
        find_literals(file->ast);
        out_.syntax.push_back(&file->ast);
    }
    // Used files first: their definitions must be declared when the files that use them are lowered. Uses may go in circles, so all are declared first.
    std::vector<LexicalScope> scopes(files_.size());
    for (file_ = 0; file_ < files_.size(); ++file_) {
        ast_ = &files_[file_]->ast;
        scopes[file_].layout = &out_.files[file_].layout;
        scopes[file_].own_frame = true;
        scopes[file_].file = file_;
        declare(ast_->scopes[ast_->root], scopes[file_]);
        file_functions_[file_] = scopes[file_].functions;
        file_modules_[file_] = scopes[file_].modules;
    }
    for (file_ = 0; file_ < files_.size(); ++file_) {
        ast_ = &files_[file_]->ast;
        const ast::Scope& root = ast_->scopes[ast_->root];
        define(root, scopes[file_]);
        out_.files[file_].body = lower_body(root, scopes[file_]);
    }
    prepare_calls();
    return std::move(out_);
}

// Which names are given to which callee anywhere: a name that is no parameter is set in the callee all the same.
void Lowering::scan_calls() {
    for (const auto& file : files_) {
        const ast::Ast& tree = file->ast;
        const auto collect = [&](std::set<NameId>& into, ast::ArgumentRange range) {
            for (std::uint32_t i = 0; i < range.count; ++i)
                if (const NameId name = tree.arguments[range.first + i].name; name != kNoName && !names_.is_dynamic(name)) into.insert(name);
        };
        for (const ast::Expr& e : tree.exprs) {
            if (e.kind != ast::ExprKind::kCall || e.c == 0) continue;
            const ast::Expr& callee = tree.exprs[e.a];
            if (callee.kind == ast::ExprKind::kName) collect(function_arguments_[callee.a], {e.b, e.c});
            if (callee.kind != ast::ExprKind::kName || !builtin_functions_.count(callee.a)) collect(value_arguments_, {e.b, e.c});
        }
        for (const ast::Scope& scope : tree.scopes)
            for (const ast::Instantiation& inst : scope.instantiations) collect(module_arguments_[inst.name], inst.arguments);
    }
}

// Marks the expressions and scopes that hold a function literal. Children come before parents in the arrays of expressions, after them in those of scopes.
void Lowering::find_literals(const ast::Ast& tree) {
    std::vector<char> has(tree.exprs.size(), 0);
    const auto in_arguments = [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i)
            if (const ast::ExprId value = tree.arguments[first + i].value; value != ast::kNone && has[value]) return true;
        return false;
    };
    const auto in = [&](ast::ExprId id) { return id != ast::kNone && has[id]; };
    for (std::size_t i = 0; i < has.size(); ++i) {
        const ast::Expr& e = tree.exprs[i];
        switch (e.kind) {
            case ast::ExprKind::kFunction: has[i] = 1; break;
            case ast::ExprKind::kUnary:
            case ast::ExprKind::kMember:
            case ast::ExprKind::kEach: has[i] = in(e.a); break;
            case ast::ExprKind::kBinary:
            case ast::ExprKind::kIndex: has[i] = in(e.a) || in(e.b); break;
            case ast::ExprKind::kTernary:
            case ast::ExprKind::kRange:
            case ast::ExprKind::kIfElement: has[i] = in(e.a) || in(e.b) || in(e.c); break;
            case ast::ExprKind::kVector:
                for (std::uint32_t k = 0; k < e.b && !has[i]; ++k) has[i] = in(tree.items[e.a + k]);
                break;
            case ast::ExprKind::kCall:
            case ast::ExprKind::kLet:
            case ast::ExprKind::kAssert:
            case ast::ExprKind::kEcho:
            case ast::ExprKind::kFor:
            case ast::ExprKind::kLetElement: has[i] = in(e.a) || in_arguments(e.b, e.c); break;
            case ast::ExprKind::kForC: {
                const ast::ForC& loop = tree.for_c[e.a];
                has[i] = in(loop.condition) || in(loop.body) || in_arguments(loop.init.first, loop.init.count) ||
                         in_arguments(loop.step.first, loop.step.count);
                break;
            }
            default: break;
        }
    }
    std::vector<char> scopes(tree.scopes.size(), 0);
    for (std::size_t i = scopes.size(); i-- > 0;) {
        const ast::Scope& scope = tree.scopes[i];
        for (const ast::Assignment& a : scope.assignments) scopes[i] |= in(a.value);
        for (const ast::Instantiation& inst : scope.instantiations) {
            scopes[i] |= in_arguments(inst.arguments.first, inst.arguments.count);
            if (inst.children != ast::kNone) scopes[i] |= scopes[inst.children];
            if (inst.otherwise != ast::kNone) scopes[i] |= scopes[inst.otherwise];
        }
    }
    expr_has_literal_.push_back(std::move(has));
    scope_has_literal_.push_back(std::move(scopes));
}

// Makes the names of a scope known: variables, functions and modules, not yet what they hold.
void Lowering::declare(const ast::Scope& scope, LexicalScope& into) {
    std::uint32_t order = 0;
    for (const ast::Assignment& a : scope.assignments) {
        ++order;
        if (names_.is_dynamic(a.name)) {
            dynamic(a.name);
        } else if (!into.locals.count(a.name)) {
            into.locals.emplace(a.name, LexicalScope::Local{into.layout->slots++, order - 1, false});
        }
    }
    for (const ast::Function& f : scope.functions) {
        const std::uint32_t index = static_cast<std::uint32_t>(out_.functions.size());
        Function& made = out_.functions.emplace_back();
        made.name = f.name;
        made.ast = ast_;
        made.place = f.place;
        made.parameters = declare_parameters(f.parameters, made.layout, function_arguments_[f.name]);
        into.functions[f.name] = index;
    }
    for (const ast::Module& m : scope.modules) {
        const std::uint32_t index = static_cast<std::uint32_t>(out_.modules.size());
        Module& made = out_.modules.emplace_back();
        made.name = m.name;
        made.place = m.place;
        made.parameters = declare_parameters(m.parameters, made.layout, module_arguments_[m.name]);
        made.children_slot = made.layout.slots++;
        into.modules[m.name] = index;
    }
}

// Lowers the bodies of a scope's functions and modules.
void Lowering::define(const ast::Scope& scope, LexicalScope& into) {
    // A name defined twice has one entry of the last definition; the earlier ones are unreachable.
    for (const ast::Function& f : scope.functions) {
        const std::uint32_t index = into.functions.at(f.name);
        if (out_.functions[index].place == f.place) lower_function(index, f, into);
    }
    for (const ast::Module& m : scope.modules) {
        const std::uint32_t index = into.modules.at(m.name);
        if (out_.modules[index].place == m.place) lower_module(index, m, into);
    }
}

std::vector<Parameter> Lowering::declare_parameters(ast::ArgumentRange range, Layout& layout, const std::set<NameId>& named_in_calls) {
    std::vector<Parameter> out;
    for (std::uint32_t i = 0; i < range.count; ++i) {
        Parameter p;
        p.name = argument(range, i).name;
        p.dynamic = names_.is_dynamic(p.name);
        p.target = p.dynamic ? dynamic(p.name) : layout.slots++;
        out.push_back(p);
    }
    for (const NameId name : named_in_calls)
        if (std::none_of(out.begin(), out.end(), [name](const Parameter& p) { return p.name == name; })) layout.extras.push_back({name, layout.slots++});
    return out;
}

void Lowering::open_parameters(const std::vector<Parameter>& parameters, const Layout& layout, LexicalScope& scope) const {
    for (const Parameter& p : parameters)
        if (!p.dynamic) scope.locals[p.name] = {p.target, LexicalScope::kAlways, false};
    for (const Layout::Extra& e : layout.extras) scope.locals[e.name] = {e.slot, LexicalScope::kAlways, true};
}

void Lowering::lower_defaults(ast::ArgumentRange range, std::vector<Parameter>& parameters, LexicalScope& around) {
    LexicalScope outside = inner_scope(around, false, *around.layout);
    outside.deferred = true;
    const bool before = std::exchange(frames_for_all_, true);
    const std::uint32_t function = std::exchange(function_, code::kNone);
    for (std::uint32_t i = 0; i < range.count; ++i) {
        const ast::ExprId value = argument(range, i).value;
        if (value == ast::kNone) continue;
        parameters[i].value = lower(value, outside);
        parameters[i].constant = is_effectless(parameters[i].value);
    }
    frames_for_all_ = before;
    function_ = function;
}

void Lowering::lower_function(std::uint32_t index, const ast::Function& f, LexicalScope& around) {
    std::vector<Parameter> parameters = out_.functions[index].parameters;
    Layout layout = out_.functions[index].layout;
    lower_defaults(f.parameters, parameters, around);
    LexicalScope inside = inner_scope(around, true, layout);
    inside.deferred = true;
    open_parameters(parameters, layout, inside);
    const std::uint32_t before = std::exchange(function_, index);
    const bool frames = std::exchange(frames_for_all_, false);
    const TermId body = lower(f.body, inside, true);
    function_ = before;
    frames_for_all_ = frames;
    Function& made = out_.functions[index];
    made.parameters = std::move(parameters);
    made.layout = std::move(layout);
    made.body = body;
    made.depth = ast_->exprs[f.body].depth;
}

void Lowering::lower_module(std::uint32_t index, const ast::Module& m, LexicalScope& around) {
    std::vector<Parameter> parameters = out_.modules[index].parameters;
    Layout layout = out_.modules[index].layout;
    lower_defaults(m.parameters, parameters, around);
    LexicalScope inside = inner_scope(around, true, layout);
    inside.deferred = true;
    open_parameters(parameters, layout, inside);
    inside.locals[names_.intern("$children")] = {out_.modules[index].children_slot, LexicalScope::kAlways, false};
    const ast::Scope& body = ast_->scopes[m.body];
    for (const ast::Assignment& a : body.assignments) {
        const ast::ExprKind kind = ast_->exprs[a.value].kind;
        const bool literal = kind == ast::ExprKind::kNumber || kind == ast::ExprKind::kString || kind == ast::ExprKind::kTrue ||
                             kind == ast::ExprKind::kFalse || kind == ast::ExprKind::kUndef;
        const auto same = [&](const Parameter& p) { return p.name == a.name; };
        if (literal && std::any_of(parameters.begin(), parameters.end(), same)) out_.modules[index].overwritten.emplace_back(a.name, a.place);
    }
    const std::uint32_t before = std::exchange(function_, code::kNone);
    const bool frames = std::exchange(frames_for_all_, false);
    declare(body, inside);
    define(body, inside);
    const ScopeId lowered = lower_body(body, inside);
    function_ = before;
    frames_for_all_ = frames;
    Module& made = out_.modules[index];
    made.parameters = std::move(parameters);
    made.layout = std::move(layout);
    made.body = lowered;
}

LexicalScope Lowering::inner_scope(LexicalScope& around, bool own_frame, Layout& layout) {
    LexicalScope inner;
    inner.parent = &around;
    inner.layout = &layout;
    inner.own_frame = own_frame;
    inner.assigned = LexicalScope::kAlways;
    inner.file = around.file;
    return inner;
}

// Lexical scopes outwards, then the used files, the last one first.
std::optional<Lowering::Found> Lowering::find_definition(NameId name, const LexicalScope& from, bool module) const {
    std::uint32_t up = 0;
    for (const LexicalScope* s = &from; s; s = s->parent) {
        const auto& map = module ? s->modules : s->functions;
        if (const auto it = map.find(name); it != map.end()) return Found{it->second, {up, code::kNone}};
        if (s->own_frame) ++up;
    }
    const std::vector<std::uint32_t>& uses = files_[from.file]->uses;
    for (std::size_t i = uses.size(); i-- > 0;) {
        const auto& map = module ? file_modules_[uses[i]] : file_functions_[uses[i]];
        if (const auto it = map.find(name); it != map.end()) return Found{it->second, {0, uses[i]}};
    }
    return std::nullopt;
}

Matched Lowering::match(ast::ArgumentRange range, const std::vector<Parameter>& parameters, const Layout& layout, std::size_t positional,
                        LexicalScope& scope) {
    std::vector<NameId> given;
    for (std::uint32_t i = 0; i < range.count; ++i) given.push_back(argument(range, i).name);
    Matched out = match_arguments(given, {parameters, layout, positional}, names_, [this](NameId name) { return dynamic(name); });
    for (Passed& passed : out.passed) passed.value = lower(argument(range, passed.value).value, scope);
    return out;
}

// What each call of a function needs beyond its arguments, once all defaults are known.
void Lowering::prepare_calls() {
    for (Call& call : out_.calls) {
        note_plain(call.matched, out_.functions[call.function].parameters);
        call.plain = call.matched.plain && call.home.library == code::kNone;
    }
}

}  // namespace whittle
