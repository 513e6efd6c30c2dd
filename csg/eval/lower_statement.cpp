#include <algorithm>

#include "csg/eval/builtin.h"
#include "csg/eval/lower_state.h"

namespace whittle {

using namespace code;

namespace {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> known) { return std::find(known.begin(), known.end(), name) != known.end(); }

}  // namespace

// Assignments and instantiations of a file or a module's body, whose names are declared.
ScopeId Lowering::lower_body(const ast::Scope& scope, LexicalScope& lexical) {
    Scope out;
    lexical.assigned = 0;
    for (const ast::Assignment& a : scope.assignments) {
        Bind bind;
        bind.name = a.name;
        bind.place = a.place;
        bind.value = lower(a.value, lexical);
        ++lexical.assigned;
        bind.kind = names_.is_dynamic(a.name) ? BindKind::kDynamic : BindKind::kSlot;
        bind.target = bind.kind == BindKind::kDynamic ? dynamic(a.name) : lexical.locals.at(a.name).slot;
        out.binds.push_back(bind);
    }
    lexical.assigned = LexicalScope::kAlways;
    for (const ast::Instantiation& inst : scope.instantiations) out.insts.push_back(lower_instantiation(inst, lexical));
    out_.scopes.push_back(std::move(out));
    return static_cast<ScopeId>(out_.scopes.size() - 1);
}

// A block of children: its variables live in the frame around it unless a function literal could hold on to them.
ScopeId Lowering::lower_children(ast::ScopeId id, LexicalScope& around) {
    if (id == ast::kNone) return code::kNone;
    const ast::Scope& scope = ast_->scopes[id];
    if (scope.assignments.empty() || (!frames_for_all_ && !scope_has_literal_[file_][id])) {
        LexicalScope inside = inner_scope(around, false, *around.layout);
        declare(scope, inside);
        return lower_body(scope, inside);
    }
    Layout layout;
    LexicalScope inside = inner_scope(around, true, layout);
    declare(scope, inside);
    const ScopeId out = lower_body(scope, inside);
    out_.scopes[out].frame_size = static_cast<std::uint32_t>(out_.frame_sizes.size());
    out_.frame_sizes.push_back(layout.slots);
    return out;
}

void Lowering::resolve_module(const ast::Instantiation& inst, Inst& out, LexicalScope& scope) {
    if (const std::optional<Found> found = find_definition(inst.name, scope, true)) {
        out.kind = InstKind::kUser;
        out.target = found->index;
        out.home = found->home;
        return;
    }
    static constexpr std::pair<const char*, InstKind> kControl[] = {{"for", InstKind::kFor}, {"intersection_for", InstKind::kIntersectionFor},
        {"if", InstKind::kIf}, {"let", InstKind::kLet}, {"assign", InstKind::kAssign}, {"echo", InstKind::kEcho}, {"assert", InstKind::kAssert},
        {"each", InstKind::kEach}, {"children", InstKind::kChildren}, {"child", InstKind::kChildren}};
    for (const auto& [name, kind] : kControl)
        if (names_.text(inst.name) == name) {
            out.kind = kind;
            return;
        }
    if (const auto it = builtin_modules_.find(inst.name); it != builtin_modules_.end()) {
        out.kind = InstKind::kBuiltin;
        out.target = it->second;
    }
}

bool asks_placement(std::string_view name) { return is_one_of(name, {"light", "sun", "area_light", "environment", "camera"}); }

bool is_control_module(std::string_view name) {
    return is_one_of(name, {"for", "intersection_for", "if", "let", "assign", "echo", "assert", "each", "children", "child"});
}

InstId Lowering::lower_instantiation(const ast::Instantiation& inst, LexicalScope& scope) {
    Inst out;
    out.name = inst.name;
    out.place = inst.place;
    out.modifiers = inst.modifiers;
    out.has_else = inst.has_else;
    resolve_module(inst, out, scope);
    switch (out.kind) {
        case InstKind::kUser:
            out.matched = match(inst.arguments, out_.modules[out.target].parameters, out_.modules[out.target].layout,
                                out_.modules[out.target].parameters.size(), scope);
            break;
        case InstKind::kBuiltin: {
            const BuiltinModule& builtin = builtin_modules()[out.target];
            std::vector<Parameter> parameters;
            const auto add = [&](std::string_view list) {
                for (const std::string_view name : split_names(list)) {
                    Parameter p;
                    p.name = names_.intern(name);
                    p.target = static_cast<std::uint32_t>(parameters.size());
                    parameters.push_back(p);
                }
                return parameters.size();
            };
            const std::size_t positional = add(builtin.positional);
            out.parameters = static_cast<std::uint32_t>(add(builtin.named));
            out_.sees_lights |= asks_placement(builtin.name);
            out.refuses_children = !builtin.takes_children && !is_one_of(builtin.name, {"text", "import", "surface", "import_stl", "import_off", "import_dxf"});
            out.clamps_facets = is_one_of(builtin.name, {"cube", "sphere", "cylinder", "polyhedron", "square", "circle", "polygon"});
            // Their arguments mean nothing, and OpenSCAD does not look at them: not even $-variables are passed on.
            if (!is_one_of(builtin.name, {"union", "difference", "intersection", "group"})) out.matched = match(inst.arguments, parameters, {}, positional, scope);
            break;
        }
        case InstKind::kFor:
        case InstKind::kIntersectionFor:
        case InstKind::kLet:
        case InstKind::kAssign: lower_loop(inst, out, scope); break;
        default:
            out.arguments = lower_argument_list(inst.arguments, scope);
            break;
    }
    const bool loop = !out.binds.empty() || out.kind == InstKind::kFor || out.kind == InstKind::kIntersectionFor;
    if (!loop) {
        out.children = lower_children(inst.children, scope);
        out.otherwise = lower_children(inst.otherwise, scope);
    }
    out_.insts.push_back(std::move(out));
    return static_cast<InstId>(out_.insts.size() - 1);
}

// for, intersection_for, let: the variables and what stands under them, in a scope of their own.
void Lowering::lower_loop(const ast::Instantiation& inst, Inst& out, LexicalScope& scope) {
    const bool own = frames_for_all_ || any_literal(inst.arguments) || (inst.children != ast::kNone && scope_has_literal_[file_][inst.children]);
    Layout layout;
    LexicalScope inside = inner_scope(scope, own, own ? layout : *scope.layout);
    out.binds = lower_binds(inst.arguments, inside, out.kind != InstKind::kAssign);
    out.children = lower_children(inst.children, inside);
    if (!own) return;
    out.frame_size = static_cast<std::uint32_t>(out_.frame_sizes.size());
    out_.frame_sizes.push_back(layout.slots);
}

std::vector<Argument> Lowering::lower_argument_list(ast::ArgumentRange range, LexicalScope& scope) {
    std::vector<Argument> out;
    for (std::uint32_t i = 0; i < range.count; ++i) {
        const ast::Argument& a = argument(range, i);
        out.push_back({a.name, lower(a.value, scope), a.value, ast_});
    }
    return out;
}

bool Lowering::any_literal(ast::ArgumentRange range) const {
    for (std::uint32_t i = 0; i < range.count; ++i)
        if (const ast::ExprId value = argument(range, i).value; value != ast::kNone && expr_has_literal_[file_][value]) return true;
    return false;
}

}  // namespace whittle
