#include "csg/lang/print_ast.h"

namespace whittle {

using namespace ast;

const char* operator_text(Op op) {
    switch (op) {
        case Op::kNot: return "!";
        case Op::kNegate: return "-";
        case Op::kPlus: return "+";
        case Op::kBitNot: return "~";
        case Op::kOr: return "||";
        case Op::kAnd: return "&&";
        case Op::kEqual: return "==";
        case Op::kNotEqual: return "!=";
        case Op::kLess: return "<";
        case Op::kLessEqual: return "<=";
        case Op::kGreater: return ">";
        case Op::kGreaterEqual: return ">=";
        case Op::kBitOr: return "|";
        case Op::kBitAnd: return "&";
        case Op::kShiftLeft: return "<<";
        case Op::kShiftRight: return ">>";
        case Op::kAdd: return "+";
        case Op::kSubtract: return "-";
        case Op::kMultiply: return "*";
        case Op::kDivide: return "/";
        case Op::kModulo: return "%";
        case Op::kPower: return "^";
    }
    return "";
}

namespace {

class Printer {
public:
    Printer(std::string& out, const Ast& tree, const Names& names, void (*number)(std::string&, double))
        : out_(out), tree_(tree), names_(names), number_(number) {}

    void print(ExprId id) {
        const Expr& e = tree_.exprs[id];
        switch (e.kind) {
            case ExprKind::kUndef: out_ += "undef"; return;
            case ExprKind::kTrue: out_ += "true"; return;
            case ExprKind::kFalse: out_ += "false"; return;
            case ExprKind::kNumber: number_(out_, e.number); return;
            case ExprKind::kString: out_ += quoted(tree_.strings[e.a]); return;
            case ExprKind::kName: out_ += names_.text(e.a); return;
            case ExprKind::kUnary: parts({operator_text(e.op)}), print(e.a); return;
            case ExprKind::kBinary: print_infix(e); return;
            case ExprKind::kTernary: parts({"("}), print(e.a), parts({" ? "}), print(e.b), parts({" : "}), print(e.c), parts({")"}); return;
            case ExprKind::kCall: print_callee(e.a), parts({"("}), arguments({e.b, e.c}), parts({")"}); return;
            case ExprKind::kIndex: print(e.a), parts({"["}), print(e.b), parts({"]"}); return;
            case ExprKind::kMember: print(e.a), parts({".", names_.text(e.b)}); return;
            case ExprKind::kVector: print_vector(e); return;
            case ExprKind::kRange: print_range(e); return;
            case ExprKind::kLet: headed("let(", e, ") "); return;
            case ExprKind::kAssert: headed("assert(", e, ")"); return;
            case ExprKind::kEcho: headed("echo(", e, ")"); return;
            case ExprKind::kFunction: parts({"function("}), arguments({e.b, e.c}), parts({") "}), print(e.a); return;
            case ExprKind::kFor: print_for(e); return;
            case ExprKind::kForC: print_for_c(tree_.for_c[e.a]); return;
            case ExprKind::kIfElement: print_if(e); return;
            case ExprKind::kEach: parts({"each ("}), print(e.a), parts({")"}); return;
            case ExprKind::kLetElement: headed("let(", e, ") ("), parts({")"}); return;
        }
    }

    void arguments(ArgumentRange range) {
        for (std::uint32_t i = 0; i < range.count; ++i) {
            const Argument& a = tree_.arguments[range.first + i];
            if (i > 0) out_ += ", ";
            out_ += names_.text(a.name);
            if (a.name != kNoName && a.value != kNone) out_ += " = ";
            if (a.value != kNone) print(a.value);
        }
    }

private:
    void parts(std::initializer_list<std::string_view> texts) {
        for (const std::string_view t : texts) out_ += t;
    }
    // head arguments tail body
    void headed(const char* head, const Expr& e, const char* tail) {
        out_ += head;
        arguments({e.b, e.c});
        out_ += tail;
        if (e.a == kNone) return;
        if (e.kind == ExprKind::kAssert || e.kind == ExprKind::kEcho) out_ += " ";
        print(e.a);
    }
    void print_callee(ExprId id) {
        const bool named = tree_.exprs[id].kind == ExprKind::kName;
        if (!named) out_ += "(";
        print(id);
        if (!named) out_ += ")";
    }
    void print_infix(const Expr& e) {
        out_ += "(";
        print(e.a);
        parts({" ", operator_text(e.op), " "});
        print(e.b);
        out_ += ")";
    }
    void print_vector(const Expr& e) {
        out_ += "[";
        for (std::uint32_t i = 0; i < e.b; ++i) {
            if (i > 0) out_ += ", ";
            print(tree_.items[e.a + i]);
        }
        out_ += "]";
    }
    void print_range(const Expr& e) {
        out_ += "[";
        print(e.a);
        if (e.c != kNone) parts({" : "}), print(e.c);
        out_ += " : ";
        print(e.b);
        out_ += "]";
    }
    void print_if(const Expr& e) {
        out_ += "if(";
        print(e.a);
        out_ += ") (";
        print(e.b);
        out_ += ")";
        if (e.c != kNone) parts({" else ("}), print(e.c), parts({")"});
    }
    // Several variables are loops in each other.
    void print_for(const Expr& e) {
        for (std::uint32_t i = 0; i < e.c; ++i) parts({"for("}), arguments({e.b + i, 1}), parts({") ("});
        print(e.a);
        out_.append(e.c, ')');
    }
    void print_for_c(const ForC& loop) {
        out_ += "for(";
        arguments(loop.init);
        out_ += ";";
        print(loop.condition);
        out_ += ";";
        arguments(loop.step);
        out_ += ") ";
        print(loop.body);
    }

    std::string& out_;
    const Ast& tree_;
    const Names& names_;
    void (*number_)(std::string&, double);
};

}  // namespace

void print_expression(std::string& out, const Ast& tree, ExprId id, const Names& names, void (*number)(std::string&, double)) {
    Printer(out, tree, names, number).print(id);
}

void print_arguments(std::string& out, const Ast& tree, ArgumentRange range, const Names& names, void (*number)(std::string&, double)) {
    Printer(out, tree, names, number).arguments(range);
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '\n') out += "\\n";
        else if (c == '\t') out += "\\t";
        else if (c == '\r') out += "\\r";
        else if (c == '"' || c == '\\') (out += '\\') += c;
        else out += c;
    }
    return out + "\"";
}

}  // namespace whittle
