// lower_state.h — what the parts of the lowering share. Internal to csg/eval.
#pragma once

#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "csg/eval/lower.h"

namespace whittle {

// One scope of the text while it is lowered.
struct LexicalScope {
    struct Local {
        std::uint32_t slot = 0;
        std::uint32_t order = 0;  // how many assignments of the scope come before; kAlways: set from the start
        bool maybe = false;       // may stay unset whatever happens
    };
    static constexpr std::uint32_t kAlways = 0xFFFFFFFF;

    LexicalScope* parent = nullptr;
    code::Layout* layout = nullptr;  // frame of the scope
    bool own_frame = false;          // its frame is not its parent's
    bool deferred = false;           // what stands inside runs later than the assignments of the scopes around it
    std::uint32_t assigned = 0;      // assignments lowered so far; kAlways: all done
    std::uint32_t file = 0;
    std::unordered_map<NameId, Local> locals;
    std::unordered_map<NameId, std::uint32_t> functions, modules;
};

class Lowering {
public:
    Lowering(const std::vector<std::unique_ptr<FileSyntax>>& files, Names& names, Heap& heap);
    code::Program run();

private:
    void scan_calls();
    void prepare_calls();
    void find_literals(const ast::Ast& ast);
    void lower_file(std::uint32_t file);
    void declare(const ast::Scope& scope, LexicalScope& into);
    void define(const ast::Scope& scope, LexicalScope& into);
    void lower_function(std::uint32_t index, const ast::Function& function, LexicalScope& around);
    void lower_module(std::uint32_t index, const ast::Module& module, LexicalScope& around);
    std::vector<code::Parameter> declare_parameters(ast::ArgumentRange range, code::Layout& layout, const std::set<NameId>& named_in_calls);
    void open_parameters(const std::vector<code::Parameter>& parameters, const code::Layout& layout, LexicalScope& scope) const;
    void lower_defaults(ast::ArgumentRange range, std::vector<code::Parameter>& parameters, LexicalScope& around);
    code::ScopeId lower_body(const ast::Scope& scope, LexicalScope& lexical);
    code::ScopeId lower_children(ast::ScopeId scope, LexicalScope& around);
    code::InstId lower_instantiation(const ast::Instantiation& inst, LexicalScope& scope);
    void lower_loop(const ast::Instantiation& inst, code::Inst& out, LexicalScope& scope);
    void lower_arguments(const ast::Instantiation& inst, code::Inst& out, LexicalScope& scope);
    void resolve_module(const ast::Instantiation& inst, code::Inst& out, LexicalScope& scope);

    // Expressions.
    code::TermId lower(ast::ExprId id, LexicalScope& scope, bool tail = false);
    code::TermId lower_name(NameId name, const LexicalScope* from, SourcePlace place, std::uint32_t frames_up = 0, bool deferred = false);
    code::TermId lower_binary(const ast::Expr& e, LexicalScope& scope);
    code::TermId lower_vector(const ast::Expr& e, LexicalScope& scope);
    code::TermId lower_call(const ast::Expr& e, LexicalScope& scope, bool tail);
    code::TermId lower_named_call(const ast::Expr& e, NameId name, LexicalScope& scope, bool tail);
    code::TermId lower_value_call(const ast::Expr& e, code::TermId callee, NameId name, LexicalScope& scope, bool tail);
    void silence(code::TermId id);
    code::TermId lower_literal(ast::ExprId id, LexicalScope& scope);
    code::TermId lower_let(const ast::Expr& e, LexicalScope& scope, bool tail, code::Op op);
    code::TermId lower_for_c(const ast::Expr& e, LexicalScope& scope);
    code::TermId lower_with_arguments(const ast::Expr& e, LexicalScope& scope, bool tail);
    std::vector<code::Bind> lower_binds(ast::ArgumentRange range, LexicalScope& inner, bool sequential);
    std::vector<code::Argument> lower_argument_list(ast::ArgumentRange range, LexicalScope& scope);
    code::Matched match(ast::ArgumentRange range, const std::vector<code::Parameter>& parameters, const code::Layout& layout, std::size_t positional,
                        LexicalScope& scope);
    bool any_literal(ast::ArgumentRange range) const;

    code::TermId node(code::Op op, SourcePlace place, std::uint32_t a = code::kNone, std::uint32_t b = 0, std::uint32_t c = 0);
    code::TermId constant(Value value, SourcePlace place);
    std::uint32_t dynamic(NameId name);
    bool is_effectless(code::TermId id) const;
    const ast::Argument& argument(ast::ArgumentRange range, std::uint32_t i) const { return ast_->arguments[range.first + i]; }
    LexicalScope inner_scope(LexicalScope& around, bool own_frame, code::Layout& layout);

    struct Found { std::uint32_t index; code::Home home; };
    std::optional<Found> find_definition(NameId name, const LexicalScope& from, bool module) const;

    const std::vector<std::unique_ptr<FileSyntax>>& files_;
    Names& names_;
    Heap& heap_;
    code::Program out_;
    const ast::Ast* ast_ = nullptr;
    std::vector<std::vector<char>> expr_has_literal_, scope_has_literal_;  // by file
    std::uint32_t file_ = 0;
    std::unordered_map<NameId, std::set<NameId>> function_arguments_, module_arguments_;  // names given in calls, by callee
    std::set<NameId> value_arguments_;  // names given in calls of function values
    std::unordered_map<NameId, std::uint32_t> builtin_functions_, builtin_modules_, dynamics_;
    std::vector<std::unordered_map<NameId, std::uint32_t>> file_functions_, file_modules_;
    std::uint32_t function_ = code::kNone;  // being lowered
    bool frames_for_all_ = false;  // inside a default: every scope gets its own frame, since the frame around may be in use
};

}  // namespace whittle
