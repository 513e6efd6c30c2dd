#include "csg/lang/customizer.h"

#include <charconv>
#include <string_view>

namespace whittle {

using namespace ast;

namespace {

std::string_view trimmed(std::string_view s) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = s.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view() : s.substr(first, s.find_last_not_of(kBlank) - first + 1);
}

std::optional<double> number_of(std::string_view s) {
    double out = 0;
    if (!s.empty() && s[0] == '+') s.remove_prefix(1);
    const auto [end, fault] = std::from_chars(s.data(), s.data() + s.size(), out);
    if (s.empty() || fault != std::errc() || end != s.data() + s.size()) return std::nullopt;
    return out;
}

// The parts between separators outside quotes.
std::vector<std::string_view> split(std::string_view s, char separator) {
    std::vector<std::string_view> out;
    bool quoted = false;
    std::size_t start = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (s[i] == '"') quoted = !quoted;
        if (quoted || s[i] != separator) continue;
        out.push_back(trimmed(s.substr(start, i - start)));
        start = i + 1;
    }
    out.push_back(trimmed(s.substr(start)));
    return out;
}

std::string unquoted(std::string_view s) {
    const bool quoted = s.size() >= 2 && s.front() == '"' && s.back() == '"';
    return std::string(quoted ? s.substr(1, s.size() - 2) : s);
}

bool range_of(const std::vector<std::string_view>& parts, CustomValues& out) {
    if (parts.size() < 2 || parts.size() > 3) return false;
    std::vector<double> numbers;
    for (const std::string_view part : parts)
        if (const auto n = number_of(part)) numbers.push_back(*n);
    if (numbers.size() != parts.size()) return false;
    out.kind = CustomValues::Kind::kRange;
    out.least = numbers.front();
    out.most = numbers.back();
    if (numbers.size() == 3) out.step = numbers[1];
    return true;
}

// What stands between brackets.
CustomValues listed(std::string_view inside) {
    CustomValues out;
    const std::vector<std::string_view> items = split(inside, ',');
    if (items.size() == 1 && range_of(split(items[0], ':'), out)) return out;
    for (const std::string_view item : items) {
        const std::vector<std::string_view> parts = split(item, ':');
        if (parts.size() > 2 || parts[0].empty() || parts.back().empty() || item.find_first_of("[]") != std::string_view::npos) return {};
        CustomChoice choice;
        choice.number = number_of(parts[0]);
        if (!choice.number) choice.text = unquoted(parts[0]);
        if (parts.size() == 2) choice.label = unquoted(parts[1]);
        out.choices.push_back(std::move(choice));
    }
    out.kind = CustomValues::Kind::kList;
    return out;
}

CustomValues values_of(std::string_view comment) {
    CustomValues out;
    const std::string_view s = trimmed(comment);
    if (s.empty()) return out;
    if (s.front() == '[') return s.back() == ']' ? listed(s.substr(1, s.size() - 2)) : out;
    if (const auto number = number_of(s)) {
        out.kind = CustomValues::Kind::kNumber;
        out.number = *number;
    } else if (s.find_first_of("[]:,") == std::string_view::npos) {
        out.kind = CustomValues::Kind::kText;
        out.text = unquoted(s);
    }
    return out;
}

// A file as the customizer sees it: its lines up to the first brace, and the groups that its comments open.
class Commented {
public:
    explicit Commented(std::string_view text) { read(text); }

    std::size_t end_line() const { return end_line_; }
    // The comment behind the first semicolon of the line.
    std::string_view behind(std::size_t line) const {
        const std::string_view s = lines_[line - 1];
        bool quoted = false;
        for (std::size_t i = 0; i < s.size(); ++i) {
            if (s[i] == '"') quoted = !quoted;
            if (quoted && s[i] == '\\') ++i;
            if (quoted || s[i] != ';') continue;
            const std::string_view rest = trimmed(s.substr(i + 1));
            return rest.substr(0, 2) == "//" ? rest.substr(2) : std::string_view();
        }
        return {};
    }
    std::optional<std::string> above(std::size_t line) const {
        if (line < 2) return std::nullopt;
        const std::string_view s = trimmed(lines_[line - 2]);
        if (s.substr(0, 2) != "//" || trimmed(s.substr(2)).empty()) return std::nullopt;
        return std::string(trimmed(s.substr(2)));
    }
    std::optional<std::string> group_at(std::size_t line) const {
        std::optional<std::string> out;
        for (const auto& [from, name] : groups_)
            if (from < line) out = name;
        return out;
    }

private:
    void read(std::string_view text) {
        std::size_t start = 0, line = 1;
        const auto end_of_line = [&](std::size_t i) {
            lines_.push_back(text.substr(start, i - start));
            start = i + 1;
            ++line;
        };
        bool quoted = false, braced = false;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char c = text[i];
            const std::string_view two = text.substr(i, 2);
            if (c == '\n') end_of_line(i);
            else if (quoted && c == '\\') ++i;
            else if (c == '"') quoted = !quoted;
            else if (quoted || braced) continue;
            else if (two == "//") i = std::min(text.find('\n', i), text.size()) - 1;
            else if (two == "/*") i = group(text, i, line, end_of_line);
            else if (c == '{') braced = true, end_line_ = line;
        }
        end_of_line(text.size());
        if (!braced) end_line_ = line;
    }
    // A comment of its own opens the group that its brackets name, from the next line on. Returns its last place.
    template <class EndOfLine>
    std::size_t group(std::string_view text, std::size_t at, std::size_t line, EndOfLine end_of_line) {
        const std::size_t close = text.find("*/", at + 2);
        const std::size_t last = close == std::string_view::npos ? text.size() : close;
        std::string name;
        for (std::size_t open = text.find('[', at); open < last; open = text.find('[', open + 1)) {
            const std::size_t end = text.find(']', open);
            if (end >= last) break;
            if (!name.empty()) name += '-';
            name += trimmed(text.substr(open + 1, end - open - 1));
        }
        groups_.emplace_back(line, name);
        for (std::size_t i = text.find('\n', at); i < last; i = text.find('\n', i + 1)) end_of_line(i);
        return last == text.size() ? last - 1 : last + 1;
    }

    std::vector<std::string_view> lines_;
    std::vector<std::pair<std::size_t, std::string>> groups_;
    std::size_t end_line_ = 0;
};

}  // namespace

bool is_plain_value(const Ast& tree, ExprId id) {
    const Expr& e = tree.exprs[id];
    switch (e.kind) {
        case ExprKind::kUndef: case ExprKind::kTrue: case ExprKind::kFalse: case ExprKind::kNumber: case ExprKind::kString: return true;
        case ExprKind::kUnary: return e.op == Op::kNegate && tree.exprs[e.a].kind == ExprKind::kNumber;
        case ExprKind::kVector:
            for (std::uint32_t i = 0; i < e.b; ++i)
                if (!is_plain_value(tree, tree.items[e.a + i])) return false;
            return true;
        case ExprKind::kRange: return is_plain_value(tree, e.a) && is_plain_value(tree, e.b) && (e.c == kNone || is_plain_value(tree, e.c));
        default: return false;
    }
}

std::vector<CustomVariable> custom_variables(const Ast& tree, const std::string& text, std::uint32_t file) {
    const Commented comments(text);
    std::vector<CustomVariable> out;
    const std::vector<Assignment>& assignments = tree.scopes[tree.root].assignments;
    for (std::uint32_t i = 0; i < assignments.size(); ++i) {
        const Assignment& a = assignments[i];
        if (a.place.file != file || a.place.line == 0 || a.place.line >= comments.end_line() || !is_plain_value(tree, a.value)) continue;
        out.push_back({i, comments.above(a.place.line), comments.group_at(a.place.line), values_of(comments.behind(a.place.line))});
    }
    return out;
}

}  // namespace whittle
