#include "csg/eval/parameters.h"

#include <cstdlib>
#include <optional>

namespace whittle {
namespace {

using namespace ast;

ExprId add(Ast& tree, Expr e) {
    tree.exprs.push_back(e);
    return static_cast<ExprId>(tree.exprs.size() - 1);
}

std::optional<double> whole_number(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    while (*end == ' ') ++end;
    if (text.empty() || *end != '\0') return std::nullopt;
    return number;
}

Expr number_at(SourcePlace place, double number) {
    Expr e;
    e.kind = ExprKind::kNumber;
    e.place = place;
    e.number = number;
    return e;
}

// "[1, 2, 3]"
std::optional<ExprId> number_list(Ast& tree, SourcePlace place, const std::string& text) {
    const std::size_t open = text.find('['), close = text.rfind(']');
    if (open == std::string::npos || close == std::string::npos || close < open) return std::nullopt;
    std::vector<ExprId> items;
    std::string rest = text.substr(open + 1, close - open - 1);
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::optional<double> number = whole_number(rest.substr(0, comma));
        if (!number) return std::nullopt;
        items.push_back(add(tree, number_at(place, *number)));
        rest.erase(0, std::min(comma + 1, rest.size()));
    }
    Expr e;
    e.kind = ExprKind::kVector;
    e.place = place;
    e.a = static_cast<std::uint32_t>(tree.items.size());
    e.b = static_cast<std::uint32_t>(items.size());
    e.depth = 2;
    tree.items.insert(tree.items.end(), items.begin(), items.end());
    return add(tree, e);
}

std::optional<ExprId> converted(Ast& tree, const Expr& old, const std::string& text) {
    Expr e;
    e.place = old.place;
    const bool numeric = old.kind == ExprKind::kNumber || old.kind == ExprKind::kUnary;
    if (numeric) {
        const std::optional<double> number = whole_number(text);
        if (number) return add(tree, number_at(old.place, *number));
        return std::nullopt;
    }
    if (old.kind == ExprKind::kTrue || old.kind == ExprKind::kFalse) {
        e.kind = text == "true" ? ExprKind::kTrue : ExprKind::kFalse;
        return add(tree, e);
    }
    if (old.kind == ExprKind::kVector) return number_list(tree, old.place, text);
    e.kind = ExprKind::kString;
    e.a = static_cast<std::uint32_t>(tree.strings.size());
    tree.strings.push_back(text);
    return add(tree, e);
}

}  // namespace

void set_parameters(FileSyntax& file, const Names& names, const std::vector<std::pair<std::string, std::string>>& parameters) {
    for (const auto& [name, text] : parameters)
        for (Assignment& a : file.ast.scopes[file.ast.root].assignments) {
            if (names.text(a.name) != name) continue;
            const Expr old = file.ast.exprs[a.value];
            if (const std::optional<ExprId> value = converted(file.ast, old, text)) a.value = *value;
        }
}

}  // namespace whittle
