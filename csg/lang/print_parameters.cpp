// print_parameters.cpp — what a customizer shows, as JSON: member by member as later versions of OpenSCAD write it.
#include <algorithm>

#include <fmt/format.h>

#include "csg/lang/print_program.h"

namespace whittle {

using namespace ast;

namespace {

// A number as JSON, with a point or exponent; what is not finite has no form there.
std::string json_number(double x) {
    const std::string text = fmt::format("{}", x);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string json_text(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') (out += '\\') += c;
        else if (c == '\n') out += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else out += c;
    }
    return out + "\"";
}

// A value that a customizer can show.
struct Shown {
    const char* type = "";
    std::vector<double> numbers;  // one, or those of a list
    bool is_list = false;
    std::string json;
};

std::optional<double> number_of(const Ast& tree, ExprId id) {
    const Expr& e = tree.exprs[id];
    if (e.kind == ExprKind::kNumber) return e.number;
    if (e.kind == ExprKind::kUnary && e.op == Op::kNegate && tree.exprs[e.a].kind == ExprKind::kNumber) return -tree.exprs[e.a].number;
    return std::nullopt;
}

std::optional<Shown> shown(const Ast& tree, ExprId id) {
    constexpr std::uint32_t kMostNumbers = 4;
    const Expr& e = tree.exprs[id];
    if (e.kind == ExprKind::kTrue || e.kind == ExprKind::kFalse) return Shown{"boolean", {}, false, e.kind == ExprKind::kTrue ? "true" : "false"};
    if (e.kind == ExprKind::kString) return Shown{"string", {}, false, json_text(tree.strings[e.a])};
    if (const auto number = number_of(tree, id)) return Shown{"number", {*number}, false, json_number(*number)};
    if (e.kind != ExprKind::kVector || e.b == 0 || e.b > kMostNumbers) return std::nullopt;
    Shown out{"number", {}, true, "["};
    for (std::uint32_t i = 0; i < e.b; ++i) {
        const auto number = number_of(tree, tree.items[e.a + i]);
        if (!number) return std::nullopt;
        out.numbers.push_back(*number);
        out.json += (i > 0 ? "," : "") + json_number(*number);
    }
    out.json += "]";
    return out;
}

// The range or greatest number that the comment gives, widened to hold the value.
void add_limits(std::vector<std::string>& members, const CustomValues& v, const Shown& value) {
    const bool greatest = v.kind == CustomValues::Kind::kList && v.choices.size() == 1 && v.choices[0].number && !v.choices[0].label;
    if (v.kind != CustomValues::Kind::kRange && !greatest) return;
    double least = greatest ? 0 : v.least, most = greatest ? *v.choices[0].number : v.most;
    for (const double x : value.numbers) {
        least = std::min(least, x);
        most = std::max(most, x);
    }
    members.push_back("\"max\":" + json_number(most));
    members.push_back("\"min\":" + json_number(least));
    members.push_back("\"step\":" + json_number(v.step.value_or(1)));
}

// A list of two and more values, or of texts; the variable's own value stands first where it is not among them.
void add_options(std::vector<std::string>& members, const CustomValues& v, const Shown& value) {
    if (v.kind != CustomValues::Kind::kList || value.is_list || std::string_view(value.type) == "boolean") return;
    const bool texts = std::string_view(value.type) == "string";
    if (v.choices.size() == 1 && v.choices[0].number && !v.choices[0].label) return;
    std::vector<std::string> options;
    bool own = false;
    for (const CustomChoice& c : v.choices) {
        const std::string plain = c.number ? fmt::format("{:g}", *c.number) : c.text;
        const std::string json = texts || !c.number ? json_text(plain) : json_number(*c.number);
        own |= json == value.json;
        options.push_back(fmt::format("{{\"name\":{},\"value\":{}}}", json_text(c.label.value_or(plain)), json));
    }
    if (!own) {
        const std::string name = texts ? value.json : json_text(fmt::format("{:g}", value.numbers[0]));
        options.insert(options.begin(), fmt::format("{{\"name\":{},\"value\":{}}}", name, value.json));
    }
    members.push_back(fmt::format("\"options\":[{}]", fmt::join(options, ",")));
}

}  // namespace

std::string print_parameters(const Ast& tree, const Names& names, const std::vector<CustomVariable>& variables, const std::string& title) {
    std::vector<std::string> out;
    for (const CustomVariable& v : variables) {
        const Assignment& a = tree.scopes[tree.root].assignments[v.assignment];
        const std::optional<Shown> value = shown(tree, a.value);
        if (!value || v.group == "Hidden") continue;
        std::vector<std::string> members;
        if (v.description) members.push_back("\"caption\":" + json_text(*v.description));
        if (!v.group || !v.group->empty()) members.push_back("\"group\":" + json_text(v.group.value_or("Parameters")));
        members.push_back("\"initial\":" + value->json);
        if (!value->numbers.empty()) add_limits(members, v.values, *value);
        add_options(members, v.values, *value);
        const bool bounded = std::string_view(value->type) == "string" && v.values.kind == CustomValues::Kind::kNumber;
        if (bounded) members.push_back(fmt::format("\"maxLength\":{:.0f}", v.values.number));
        members.push_back("\"name\":" + json_text(names.text(a.name)));
        members.push_back(fmt::format("\"type\":\"{}\"", value->type));
        std::sort(members.begin(), members.end());
        out.push_back(fmt::format("{{{}}}", fmt::join(members, ",")));
    }
    return fmt::format("{{\"parameters\":[{}],\"title\":{}}}\n", fmt::join(out, ","), json_text(title));
}

}  // namespace whittle
