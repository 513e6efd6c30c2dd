#include "csg/eval/nearest.h"

#include <algorithm>

#include "csg/eval/builtin.h"

namespace whittle {
namespace {

// Damerau-Levenshtein distance with adjacent swaps. Source: Boytsov, Indexing methods for approximate dictionary searching (2011), 2.1.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known) {
    const std::optional<std::string> near = nearest_name(name, known);
    return near ? "did you mean '" + *near + "'?" : std::string();
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& known) {
    if (name.size() > 64) return std::nullopt;
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    std::optional<std::string> found;
    for (const std::string& candidate : known) {
        if (candidate == name || candidate.empty() || candidate.size() > name.size() + 8) continue;
        const std::size_t d = distance(name, candidate);
        if (d >= best || d >= candidate.size()) continue;
        best = d;
        found = candidate;
    }
    return found;
}

std::vector<std::string_view> split_names(std::string_view list) {
    std::vector<std::string_view> out;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (end > 0) out.push_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return out;
}

std::string hint_for_variable(const code::Program& program, const Names& names, NameId name) {
    std::vector<std::string> known{"PI"};
    const auto add = [&](NameId id) { known.push_back(names.text(id)); };
    for (const code::Scope& s : program.scopes)
        for (const code::Bind& b : s.binds) add(b.name);
    for (const code::Bind& b : program.binds) add(b.name);
    for (const code::Inst& i : program.insts)
        for (const code::Bind& b : i.binds) add(b.name);
    for (const code::Function& f : program.functions)
        for (const code::Parameter& p : f.parameters) add(p.name);
    for (const code::Module& m : program.modules)
        for (const code::Parameter& p : m.parameters) add(p.name);
    for (std::size_t i = 0; i < code::kWellKnown; ++i) add(program.dynamics[i]);
    return suggestion(names.text(name), known);
}

std::string hint_for_function(const code::Program& program, const Names& names, NameId name) {
    std::vector<std::string> known;
    for (const code::Function& f : program.functions) known.push_back(names.text(f.name));
    for (const BuiltinFunction& f : builtin_functions()) known.emplace_back(f.name);
    return suggestion(names.text(name), known);
}

std::string hint_for_module(const code::Program& program, const Names& names, NameId name) {
    std::vector<std::string> known{"for", "intersection_for", "if", "let", "echo", "assert", "children"};
    for (const code::Module& m : program.modules) known.push_back(names.text(m.name));
    for (const BuiltinModule& m : builtin_modules()) known.emplace_back(m.name);
    return suggestion(names.text(name), known);
}

namespace {

// "did you mean 'near'? expected signature", as far as there is something to say.
std::string joined_hint(const Names& names, const code::Complaint& complaint, const std::vector<std::string>& known, const std::string& expected) {
    std::string out = complaint.unknown == kNoName ? std::string() : suggestion(names.text(complaint.unknown), known);
    if (!out.empty() && !expected.empty()) out += " ";
    return out + expected;
}

}  // namespace

std::string hint_of_complaint(const Names& names, const code::Complaint& complaint, const BuiltinModule& callee) {
    std::vector<std::string> known;
    for (const std::string_view list : {callee.positional, callee.named})
        for (const std::string_view name : split_names(list)) known.emplace_back(name);
    return joined_hint(names, complaint, known, callee.signature.empty() ? std::string() : "expected " + std::string(callee.signature));
}

std::string hint_of_complaint(const Names& names, const code::Complaint& complaint, NameId callee, const std::vector<code::Parameter>& parameters) {
    std::vector<std::string> known;
    for (const code::Parameter& p : parameters) known.push_back(names.text(p.name));
    std::string out = "expected " + (callee == kNoName ? std::string("function") : names.text(callee)) + "(";
    for (std::size_t i = 0; i < parameters.size(); ++i) out += (i > 0 ? ", " : "") + names.text(parameters[i].name);
    return joined_hint(names, complaint, known, out + ")");
}

}  // namespace whittle
