#include "csg/lang/print_program.h"

#include "csg/lang/print_ast.h"

namespace whittle {

using namespace ast;

namespace {

class ProgramPrinter {
public:
    ProgramPrinter(const Ast& tree, const Names& names, NumberText number) : tree_(tree), names_(names), number_(number) {}

    std::string run(const std::vector<CustomVariable>& variables) {
        scope(tree_.root, 0, variables);
        return std::move(out_);
    }

private:
    void indent(int level) { out_.append(static_cast<std::size_t>(level), '\t'); }
    void arguments(ArgumentRange range) {
        out_ += '(';
        print_arguments(out_, tree_, range, names_, number_);
        out_ += ')';
    }
    void expression(ExprId id) { print_expression(out_, tree_, id, names_, number_); }

    void scope(ScopeId id, int level, const std::vector<CustomVariable>& variables) {
        const Scope& scope = tree_.scopes[id];
        for (const Function& f : scope.functions) {
            indent(level);
            out_ += "function " + names_.text(f.name);
            arguments(f.parameters);
            out_ += " = ";
            expression(f.body);
            out_ += ";\n";
        }
        for (const Module& m : scope.modules) {
            indent(level);
            out_ += "module " + names_.text(m.name);
            arguments(m.parameters);
            out_ += " {\n";
            this->scope(m.body, level + 1, {});
            indent(level);
            out_ += "}\n";
        }
        for (std::uint32_t i = 0; i < scope.assignments.size(); ++i) {
            for (const CustomVariable& v : variables)
                if (v.assignment == i) annotations(v);
            indent(level);
            out_ += names_.text(scope.assignments[i].name) + " = ";
            expression(scope.assignments[i].value);
            out_ += ";\n";
        }
        for (const Instantiation& inst : scope.instantiations) instantiation(inst, level, true);
    }

    void instantiation(const Instantiation& inst, int level, bool indented) {
        if (indented) indent(level);
        if (inst.modifiers & kModRoot) out_ += '!';
        if (inst.modifiers & kModHighlight) out_ += '#';
        if (inst.modifiers & kModBackground) out_ += '%';
        out_ += names_.text(inst.name);
        arguments(inst.arguments);
        block(inst.children, level);
        if (!inst.has_else) return;
        indent(level);
        out_ += "else";
        block(inst.otherwise, level);
    }

    // The children of an instantiation: none, one on the same line, or braces.
    void block(ScopeId id, int level) {
        const Scope* children = id == kNone ? nullptr : &tree_.scopes[id];
        if (!children || (children->assignments.empty() && children->instantiations.empty())) {
            out_ += ";\n";
        } else if (children->assignments.empty() && children->instantiations.size() == 1) {
            out_ += ' ';
            instantiation(children->instantiations[0], level, false);
        } else {
            out_ += " {\n";
            scope(id, level + 1, {});
            indent(level);
            out_ += "}\n";
        }
    }

    void annotations(const CustomVariable& v) {
        const auto text = [this](const char* head, const std::string& value) { out_ += head + quoted(value) + ")\n"; };
        if (v.group) text("//Group(", *v.group);
        if (v.description) text("//Description(", *v.description);
        out_ += "//Parameter(";
        values(v.values);
        out_ += ")\n";
    }

    void values(const CustomValues& v) {
        switch (v.kind) {
            case CustomValues::Kind::kNone: out_ += "\"\""; return;
            case CustomValues::Kind::kNumber: number_(out_, v.number); return;
            case CustomValues::Kind::kText: out_ += quoted(v.text); return;
            case CustomValues::Kind::kRange:
                out_ += '[';
                number_(out_, v.least);
                if (v.step) out_ += " : ", number_(out_, *v.step);
                out_ += " : ";
                number_(out_, v.most);
                out_ += ']';
                return;
            case CustomValues::Kind::kList: break;
        }
        out_ += '[';
        for (std::size_t i = 0; i < v.choices.size(); ++i) {
            const CustomChoice& c = v.choices[i];
            if (i > 0) out_ += ", ";
            if (c.label) out_ += '[';
            if (c.number) number_(out_, *c.number);
            else out_ += quoted(c.text);
            if (c.label) out_ += ", " + quoted(*c.label) + "]";
        }
        out_ += ']';
    }

    const Ast& tree_;
    const Names& names_;
    NumberText number_;
    std::string out_;
};

}  // namespace

std::string print_program(const Ast& tree, const Names& names, const std::vector<CustomVariable>& variables, NumberText number) {
    return ProgramPrinter(tree, names, number).run(variables);
}

}  // namespace whittle
