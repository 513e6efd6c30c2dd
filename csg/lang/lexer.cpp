#include "csg/lang/lexer.h"

#include <array>
#include <cstdlib>
#include <utility>

namespace whittle {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
int hex_value(char c) {
    if (is_digit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

void append_utf8(std::string& out, unsigned long code) {
    const auto put = [&out](unsigned long byte) { out.push_back(static_cast<char>(byte)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    } else if (code < 0x110000) {
        put(0xF0 | (code >> 18));
        put(0x80 | ((code >> 12) & 0x3F));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

constexpr std::array<std::pair<const char*, Tok>, 12> kKeywords{{{"module", Tok::kModule}, {"function", Tok::kFunction}, {"if", Tok::kIf},
    {"else", Tok::kElse}, {"let", Tok::kLet}, {"assert", Tok::kAssert}, {"echo", Tok::kEcho}, {"for", Tok::kFor}, {"each", Tok::kEach},
    {"true", Tok::kTrue}, {"false", Tok::kFalse}, {"undef", Tok::kUndef}}};

// Signs that keyboards, text processors and web pages put in place of those of the language.
std::string meant_by(std::string_view sign) {
    struct Likeness { std::string_view sign; char plain; };
    static constexpr Likeness kLikenesses[] = {{"'", '"'}, {"`", '"'}, {"\u201C", '"'}, {"\u201D", '"'}, {"\u201E", '"'}, {"\u2018", '"'}, {"\u2019", '"'}, {"\u00AB", '"'}, {"\u00BB", '"'},
        {"\u2212", '-'}, {"\u2013", '-'}, {"\u2014", '-'}, {"\u00D7", '*'}, {"\u22C5", '*'}, {"\u00B7", '*'}, {"\u00F7", '/'},
        {"\uFF1B", ';'}, {"\uFF0C", ','}, {"\uFF08", '('}, {"\uFF09", ')'}, {"\uFF1D", '='}};
    for (const Likeness& like : kLikenesses)
        if (like.sign == sign) return like.plain == '"' ? ": strings stand in plain double quotes, \"text\"" : std::string(": is a plain ") + like.plain + " meant?";
    return {};
}

class Lexer {
public:
    Lexer(const std::string& text, std::uint32_t file, Names& names, StringPool& strings)
        : text_(text), file_(file), names_(names), strings_(strings) {}

    std::vector<Token> run() {
        if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) skip(3);
        while (skip_blanks_and_comments()) read_token();
        if (tokens_.empty() || tokens_.back().kind != Tok::kEnd) add(Tok::kEnd, here());
        return std::move(tokens_);
    }

private:
    char at(std::size_t offset = 0) const { return position_ + offset < text_.size() ? text_[position_ + offset] : '\0'; }
    bool done() const { return position_ >= text_.size() || text_[position_] == '\x03'; }
    SourcePlace here() const { return {file_, line_, static_cast<std::uint32_t>(position_ - line_start_ + 1)}; }

    void skip(std::size_t count) {
        for (; count > 0 && position_ < text_.size(); --count, ++position_)
            if (text_[position_] == '\n') {
                ++line_;
                line_start_ = position_ + 1;
            }
    }
    void add(Tok kind, SourcePlace place, std::uint32_t text = 0, double number = 0) { tokens_.push_back({kind, place, text, number}); }
    void add_text(Tok kind, SourcePlace place, std::string text) {
        strings_.push_back(std::move(text));
        add(kind, place, static_cast<std::uint32_t>(strings_.size() - 1));
    }

    // False at the end of the input.
    bool skip_blanks_and_comments() {
        while (!done()) {
            const char c = at();
            if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
                skip(1);
            } else if (c == '\xC2' && at(1) == '\xA0') {
                skip(2);
            } else if (c == '/' && at(1) == '/') {
                while (!done() && at() != '\n') skip(1);
            } else if (c == '/' && at(1) == '*') {
                const SourcePlace start = here();
                const std::size_t end = text_.find("*/", position_ + 2);
                if (end == std::string::npos) {
                    skip(text_.size());
                    add_text(Tok::kBad, here(), "Unterminated comment|the comment starts in line " + std::to_string(start.line));
                    return false;
                }
                skip(end + 2 - position_);
            } else {
                return true;
            }
        }
        return false;
    }

    void read_token() {
        const char c = at();
        if (c == '"') return read_string();
        if (c == '$' ? is_word(at(1)) : is_word(c) || (c == '.' && is_digit(at(1)))) return read_word();
        read_sign();
    }

    std::size_t number_length() const {
        std::size_t n = 0, digits = 0;
        while (is_digit(at(n))) ++n, ++digits;
        if (at(n) == '.') {
            std::size_t after = n + 1;
            while (is_digit(at(after))) ++after, ++digits;
            if (digits > 0) n = after;
        }
        if (digits == 0) return 0;
        if (at(n) == 'e' || at(n) == 'E') {
            std::size_t e = n + 1;
            if (at(e) == '+' || at(e) == '-') ++e;
            if (is_digit(at(e))) {
                while (is_digit(at(e))) ++e;
                n = e;
            }
        }
        return n;
    }

    void read_word() {
        const SourcePlace place = here();
        const std::size_t number = number_length();
        std::size_t word = at() == '$' ? 1 : 0;
        while (is_word(at(word))) ++word;
        const std::string lexeme = text_.substr(position_, std::max(number, word));
        skip(lexeme.size());
        if (number >= word) return add(Tok::kNumber, place, 0, std::strtod(lexeme.c_str(), nullptr));
        if (double value = 0; is_hex(lexeme, value)) return add(Tok::kNumber, place, 0, value);
        const NameId name = names_.intern(lexeme);
        for (const auto& [keyword, kind] : kKeywords)
            if (lexeme == keyword) return add(kind, place, name);
        if (lexeme == "include" || lexeme == "use") {
            if (read_path(lexeme == "use" ? Tok::kUse : Tok::kInclude, place)) return;
        }
        add(Tok::kIdentifier, place, name);
    }

    static bool is_hex(const std::string& lexeme, double& value) {
        if (lexeme.size() < 3 || lexeme[0] != '0' || (lexeme[1] != 'x' && lexeme[1] != 'X')) return false;
        value = 0;
        for (std::size_t i = 2; i < lexeme.size(); ++i) {
            if (hex_value(lexeme[i]) < 0) return false;
            value = value * 16 + hex_value(lexeme[i]);
        }
        return true;
    }

    bool read_path(Tok kind, SourcePlace place) {
        std::size_t n = 0;
        while (at(n) == ' ' || at(n) == '\t' || at(n) == '\r' || at(n) == '\n') ++n;
        if (at(n) != '<') return false;
        skip(n + 1);
        std::size_t length = 0;
        while (position_ + length < text_.size() && at(length) != '>' && at(length) != '\n') ++length;
        if (at(length) != '>') {
            skip(length);
            add_text(Tok::kBad, here(), kind == Tok::kUse ? "Unterminated use statement|the path has no '>'" : "Unterminated include statement|the path has no '>'");
            return true;
        }
        std::string path = text_.substr(position_, length);
        skip(length + 1);
        add_text(kind, place, std::move(path));
        return true;
    }

    // Value of `count` hex digits at `offset`, or -1.
    long hex_digits(std::size_t offset, std::size_t count) const {
        long value = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const int digit = hex_value(at(offset + i));
            if (digit < 0) return -1;
            value = value * 16 + digit;
        }
        return value;
    }

    void read_escape(std::string& out) {
        const char c = at(1);
        std::size_t length = 2;
        if (c == 'n') {
            out.push_back('\n');
        } else if (c == 't') {
            out.push_back('\t');
        } else if (c == 'r') {
            out.push_back('\r');
        } else if (c == 'x' && at(2) >= '0' && at(2) <= '7' && hex_digits(2, 2) >= 0) {
            const long code = hex_digits(2, 2);
            out.push_back(code == 0 ? ' ' : static_cast<char>(code));
            length = 4;
        } else if (c == 'u' && hex_digits(2, 4) >= 0) {
            append_utf8(out, static_cast<unsigned long>(hex_digits(2, 4)));
            length = 6;
        } else if (c == 'U' && hex_digits(2, 6) >= 0) {
            append_utf8(out, static_cast<unsigned long>(hex_digits(2, 6)));
            length = 8;
        } else if (c != '\n') {
            out.push_back(c);
        }
        skip(length);
    }

    void read_string() {
        const SourcePlace place = here();
        std::string out;
        skip(1);
        while (!done() && at() != '"') {
            if (at() == '\\' && position_ + 1 < text_.size()) {
                read_escape(out);
                continue;
            }
            if (at() != '\n' && at() != '\r') out.push_back(at());
            skip(1);
        }
        if (done()) return add_text(Tok::kBad, here(), "Unterminated string|the string starts in line " + std::to_string(place.line));
        skip(1);
        add_text(Tok::kString, place, std::move(out));
    }

    void read_sign() {
        struct Sign { const char* text; Tok kind; };
        static constexpr Sign kPairs[] = {{"<=", Tok::kLessEqual}, {">=", Tok::kGreaterEqual}, {"==", Tok::kEqual}, {"!=", Tok::kNotEqual},
            {"&&", Tok::kAnd}, {"||", Tok::kOr}, {"<<", Tok::kShiftLeft}, {">>", Tok::kShiftRight}};
        static constexpr Sign kSingles[] = {{";", Tok::kSemicolon}, {",", Tok::kComma}, {".", Tok::kDot}, {":", Tok::kColon}, {"?", Tok::kQuestion},
            {"=", Tok::kAssign}, {"(", Tok::kOpenParen}, {")", Tok::kCloseParen}, {"[", Tok::kOpenBracket}, {"]", Tok::kCloseBracket},
            {"{", Tok::kOpenBrace}, {"}", Tok::kCloseBrace}, {"<", Tok::kLess}, {">", Tok::kGreater}, {"+", Tok::kPlus}, {"-", Tok::kMinus},
            {"*", Tok::kStar}, {"/", Tok::kSlash}, {"%", Tok::kPercent}, {"^", Tok::kCaret}, {"!", Tok::kNot}, {"#", Tok::kHash},
            {"|", Tok::kBitOr}, {"&", Tok::kBitAnd}, {"~", Tok::kBitNot}};
        const SourcePlace place = here();
        for (const Sign& s : kPairs)
            if (at() == s.text[0] && at(1) == s.text[1]) {
                skip(2);
                return add(s.kind, place);
            }
        for (const Sign& s : kSingles)
            if (at() == s.text[0]) {
                skip(1);
                return add(s.kind, place);
            }
        std::size_t length = 1;
        while ((static_cast<unsigned char>(at(length)) & 0xC0) == 0x80) ++length;
        const std::string sign = text_.substr(position_, length);
        add_text(Tok::kBad, place, "syntax error|the character '" + sign + "' has no meaning here" + meant_by(sign));
        skip(length);
    }

    const std::string& text_;
    std::uint32_t file_;
    Names& names_;
    StringPool& strings_;
    std::vector<Token> tokens_;
    std::size_t position_ = 0, line_start_ = 0;
    std::uint32_t line_ = 1;
};

}  // namespace

std::vector<Token> lex(const std::string& text, std::uint32_t file, Names& names, StringPool& strings) {
    return Lexer(text, file, names, strings).run();
}

const char* spelling(Tok kind) {
    switch (kind) {
        case Tok::kEnd: return "the end of the file";
        case Tok::kBad: return "an unreadable character";
        case Tok::kNumber: return "a number";
        case Tok::kString: return "a string";
        case Tok::kIdentifier: return "a name";
        case Tok::kUse: return "'use'";
        case Tok::kInclude: return "'include'";
        case Tok::kModule: return "'module'";
        case Tok::kFunction: return "'function'";
        case Tok::kIf: return "'if'";
        case Tok::kElse: return "'else'";
        case Tok::kLet: return "'let'";
        case Tok::kAssert: return "'assert'";
        case Tok::kEcho: return "'echo'";
        case Tok::kFor: return "'for'";
        case Tok::kEach: return "'each'";
        case Tok::kTrue: return "'true'";
        case Tok::kFalse: return "'false'";
        case Tok::kUndef: return "'undef'";
        case Tok::kSemicolon: return "';'";
        case Tok::kComma: return "','";
        case Tok::kDot: return "'.'";
        case Tok::kColon: return "':'";
        case Tok::kQuestion: return "'?'";
        case Tok::kAssign: return "'='";
        case Tok::kOpenParen: return "'('";
        case Tok::kCloseParen: return "')'";
        case Tok::kOpenBracket: return "'['";
        case Tok::kCloseBracket: return "']'";
        case Tok::kOpenBrace: return "'{'";
        case Tok::kCloseBrace: return "'}'";
        case Tok::kOr: return "'||'";
        case Tok::kAnd: return "'&&'";
        case Tok::kEqual: return "'=='";
        case Tok::kNotEqual: return "'!='";
        case Tok::kLess: return "'<'";
        case Tok::kLessEqual: return "'<='";
        case Tok::kGreater: return "'>'";
        case Tok::kGreaterEqual: return "'>='";
        case Tok::kPlus: return "'+'";
        case Tok::kMinus: return "'-'";
        case Tok::kStar: return "'*'";
        case Tok::kSlash: return "'/'";
        case Tok::kPercent: return "'%'";
        case Tok::kCaret: return "'^'";
        case Tok::kNot: return "'!'";
        case Tok::kHash: return "'#'";
        case Tok::kBitOr: return "'|'";
        case Tok::kBitAnd: return "'&'";
        case Tok::kShiftLeft: return "'<<'";
        case Tok::kShiftRight: return "'>>'";
        case Tok::kBitNot: return "'~'";
    }
    return "";
}

}  // namespace whittle
