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

std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
}

// What other languages and other people call it.
std::string said_otherwise(std::string_view name) {
    struct Word { std::string_view other, meant; };
    static constexpr Word kWords[] = {{"elseif", "'else if' is two words"}, {"elif", "'else if' is two words"}, {"elsif", "'else if' is two words"},
        {"while", "nothing is counted up here: for (i = [0 : 9]), or a function that calls itself"}, {"print", "did you mean 'echo'?"}, {"println", "did you mean 'echo'?"},
        {"printf", "did you mean 'echo'?"}, {"null", "did you mean 'undef'?"}, {"none", "did you mean 'undef'?"}, {"nil", "did you mean 'undef'?"}, {"box", "did you mean 'cube'?"},
        {"ball", "did you mean 'sphere'?"}, {"cone", "did you mean 'cylinder'?"}, {"move", "did you mean 'translate'?"}, {"subtract", "did you mean 'difference'?"},
        {"intersect", "did you mean 'intersection'?"}, {"extrude", "did you mean 'linear_extrude'?"}, {"revolve", "did you mean 'rotate_extrude'?"}, {"rectangle", "did you mean 'square'?"},
        {"rect", "did you mean 'square'?"}, {"length", "did you mean 'len'?"}, {"size", "did you mean 'len'?"}, {"append", "did you mean 'concat'?"}, {"random", "did you mean 'rands'?"}};
    const std::string small = lower_case(name);
    for (const Word& word : kWords)
        if (word.other == small) return std::string(word.meant);
    return {};
}

// The shortest that begins with the name, from three letters on: diff for difference.
std::optional<std::string> shortened(std::string_view name, const std::vector<std::string>& known) {
    std::optional<std::string> found;
    if (name.size() < 3) return found;
    for (const std::string& candidate : known)
        if (candidate.size() > name.size() && candidate.starts_with(name) && (!found || candidate.size() < found->size())) found = candidate;
    return found;
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& known) {
    if (name.size() > 64) return std::nullopt;
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    std::optional<std::string> found;
    for (const std::string& candidate : known) {
        if (candidate == name || candidate.empty() || candidate.size() > name.size() + 8) continue;
        const std::size_t d = lower_case(name) == lower_case(candidate) ? 0 : distance(name, candidate);
        if (d >= best || d >= candidate.size()) continue;
        best = d;
        found = candidate;
    }
    return found ? found : shortened(name, known);
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

namespace {

std::string hint_among(const std::string& name, const std::vector<std::string>& known) {
    const std::string other = said_otherwise(name);
    return other.empty() ? suggestion(name, known) : other;
}

bool is_module(const code::Program& program, const Names& names, const std::string& name) {
    return is_control_module(name) || std::any_of(program.modules.begin(), program.modules.end(), [&](const code::Module& m) { return names.text(m.name) == name; }) ||
           std::any_of(builtin_modules().begin(), builtin_modules().end(), [&](const BuiltinModule& m) { return m.name == name; });
}

bool is_function(const code::Program& program, const Names& names, const std::string& name) {
    return std::any_of(program.functions.begin(), program.functions.end(), [&](const code::Function& f) { return names.text(f.name) == name; }) ||
           std::any_of(builtin_functions().begin(), builtin_functions().end(), [&](const BuiltinFunction& f) { return f.name == name; });
}

}  // namespace

std::string hint_for_variable(const code::Program& program, const Names& names, NameId name) {
    const std::string& text = names.text(name);
    if (text[0] >= '0' && text[0] <= '9') return "numbers have no units: '" + text + "' is read as a name";
    std::vector<std::string> known{"PI", "true", "false", "undef"};
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
    return hint_among(text, known);
}

std::string hint_for_function(const code::Program& program, const Names& names, NameId name) {
    std::vector<std::string> known;
    for (const code::Function& f : program.functions) known.push_back(names.text(f.name));
    for (const BuiltinFunction& f : builtin_functions()) known.emplace_back(f.name);
    const std::string& text = names.text(name);
    if (is_module(program, names, text)) return '\'' + text + "' is a module: it makes a body, which is no value";
    return hint_among(text, known);
}

std::string hint_for_module(const code::Program& program, const Names& names, NameId name) {
    std::vector<std::string> known{"for", "intersection_for", "if", "let", "echo", "assert", "children"};
    for (const code::Module& m : program.modules) known.push_back(names.text(m.name));
    for (const BuiltinModule& m : builtin_modules()) known.emplace_back(m.name);
    const std::string& text = names.text(name);
    if (is_function(program, names, text)) return '\'' + text + "' is a function: it makes a value, not a body";
    return hint_among(text, known);
}

namespace {

std::string hint_for_argument(const std::string& name, const std::vector<std::string>& known) {
    for (const auto& [word, meant] : {std::pair{"fn", "$fn"}, {"fa", "$fa"}, {"fs", "$fs"}, {"radius", "r"}, {"diameter", "d"}, {"height", "h"}, {"thickness", "h"}, {"length", "h"}, {"angle", "a"}})
        if (name == word && (meant[0] == '$' || std::find(known.begin(), known.end(), meant) != known.end())) return std::string("did you mean '") + meant + "'?";
    return suggestion(name, known);
}

// "did you mean 'near'? expected signature", as far as there is something to say.
std::string joined_hint(const Names& names, const code::Complaint& complaint, const std::vector<std::string>& known, const std::string& expected) {
    std::string out = complaint.unknown == kNoName ? std::string() : hint_for_argument(names.text(complaint.unknown), known);
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
