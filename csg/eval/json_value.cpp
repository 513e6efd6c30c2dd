#include "csg/eval/json_value.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "csg/eval/record_builder.h"

namespace whittle {
namespace {

// Appends a code point as UTF-8.
void append_utf8(std::string& out, std::uint32_t c) {
    const auto put = [&out](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
    if (c < 0x80) return put(c);
    if (c < 0x800) {
        put(0xC0 | c >> 6);
    } else {
        if (c < 0x10000) {
            put(0xE0 | c >> 12);
        } else {
            put(0xF0 | c >> 18);
            put(0x80 | (c >> 12 & 0x3F));
        }
        put(0x80 | (c >> 6 & 0x3F));
    }
    put(0x80 | (c & 0x3F));
}

class JsonReader {
public:
    JsonReader(Heap& heap, std::string_view text) : heap_(heap), text_(text) {}

    Result<Value> run() {
        if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
        Value out;
        if (value(out, 0)) {
            skip_blanks();
            if (at_ == text_.size()) return out;
            problem_ = "more text behind the value";
        }
        const std::size_t lines = static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
        const std::size_t start = at_ == 0 ? std::string_view::npos : text_.rfind('\n', at_ - 1);
        const std::size_t column = start == std::string_view::npos ? at_ + 1 : at_ - start;
        return fail(Fault::kWorld, fmt::format("line {}, column {}: {}", lines + 1, column, problem_));
    }

private:
    bool refuse(std::string problem) {
        problem_ = std::move(problem);
        return false;
    }
    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
    }
    char next() {
        skip_blanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char wanted) {
        if (next() != wanted) return false;
        ++at_;
        return true;
    }
    bool word(std::string_view wanted) {
        if (text_.substr(at_, wanted.size()) != wanted) return false;
        at_ += wanted.size();
        return true;
    }

    bool value(Value& out, int depth) {
        if (depth > kMaxJsonNesting) return refuse(fmt::format("nested more than {} deep", kMaxJsonNesting));
        switch (next()) {
            case '{': return object(out, depth);
            case '[': return list(out, depth);
            case '"': {
                std::string text;
                if (!string(text)) return false;
                out = heap_.string(text);
                return true;
            }
            case 't': return word("true") ? (out = Value(true), true) : refuse("expected a value");
            case 'f': return word("false") ? (out = Value(false), true) : refuse("expected a value");
            case 'n': return word("null") ? (out = Value(), true) : refuse("expected a value");
            default: return number(out);
        }
    }

    bool object(Value& out, int depth) {
        take('{');
        std::vector<std::pair<std::string, Value>> members;
        if (!take('}')) {
            do {
                std::string name;
                if (next() != '"') return refuse("expected a name in quotes");
                if (!string(name)) return false;
                if (!take(':')) return refuse("expected ':' after the name");
                Value member;
                if (!value(member, depth + 1)) return false;
                members.emplace_back(std::move(name), std::move(member));
            } while (take(','));
            if (!take('}')) return refuse("expected ',' or '}'");
        }
        std::stable_sort(members.begin(), members.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        RecordBuilder builder(heap_);
        for (auto& [name, member] : members) builder.set(name, std::move(member));
        out = builder.finish();
        return true;
    }

    bool list(Value& out, int depth) {
        take('[');
        std::vector<Value> elements;
        if (!take(']')) {
            do {
                if (!value(elements.emplace_back(), depth + 1)) return false;
            } while (take(','));
            if (!take(']')) return refuse("expected ',' or ']'");
        }
        out = heap_.vector(std::move(elements));
        return true;
    }

    bool number(Value& out) {
        const std::size_t start = at_;
        std::size_t end = at_;
        const auto digits = [&] {
            const std::size_t first = end;
            while (end < text_.size() && text_[end] >= '0' && text_[end] <= '9') ++end;
            return end > first;
        };
        const auto is = [&](char c) { return end < text_.size() && text_[end] == c; };
        if (is('-')) ++end;
        const bool zero = is('0');
        const std::size_t whole = end;
        if (!digits() || (zero && end > whole + 1)) return refuse("expected a value");
        if (is('.') && (++end, !digits())) return refuse("expected digits after '.'");
        if (is('e') || is('E')) {
            ++end;
            if (is('+') || is('-')) ++end;
            if (!digits()) return refuse("expected digits of an exponent");
        }
        double read = 0;
        const auto [stop, fault] = std::from_chars(text_.data() + start, text_.data() + end, read);
        if (fault == std::errc::result_out_of_range) return refuse("a number too large or too small");
        at_ = end;
        out = Value(read);
        return true;
    }

    bool hex(std::uint32_t& out) {
        const char* first = text_.data() + at_;
        if (text_.size() - at_ < 4 || std::from_chars(first, first + 4, out, 16).ptr != first + 4) return refuse("expected four hexadecimal digits");
        at_ += 4;
        return true;
    }

    // \uXXXX, or two of them for what lies beyond 16 bits.
    bool code_point(std::string& out) {
        std::uint32_t c = 0;
        if (!hex(c)) return false;
        if (c >= 0xD800 && c < 0xDC00 && word("\\u")) {
            std::uint32_t low = 0;
            if (!hex(low)) return false;
            if (low < 0xDC00 || low > 0xDFFF) return refuse("half of a surrogate pair");
            c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
        } else if (c >= 0xD800 && c <= 0xDFFF) {
            return refuse("half of a surrogate pair");
        }
        append_utf8(out, c);
        return true;
    }

    bool string(std::string& out) {
        constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
        ++at_;
        while (at_ < text_.size() && text_[at_] != '"') {
            const char c = text_[at_];
            if (static_cast<unsigned char>(c) < 0x20) return refuse("a control character in a string");
            ++at_;
            if (c != '\\') {
                out.push_back(c);
                continue;
            }
            const char escape = at_ < text_.size() ? text_[at_] : '\0';
            ++at_;
            if (escape == 'u') {
                if (!code_point(out)) return false;
            } else if (const std::size_t which = kLetters.find(escape); which != std::string_view::npos) {
                out.push_back(kMeanings[which]);
            } else {
                at_ = std::min(at_, text_.size());
                return refuse("unknown escape in a string");
            }
        }
        if (at_ >= text_.size()) return refuse("a string without end");
        ++at_;
        return true;
    }

    Heap& heap_;
    std::string_view text_;
    std::size_t at_ = 0;
    std::string problem_;
};

}  // namespace

Result<Value> json_value(Heap& heap, std::string_view text) { return JsonReader(heap, text).run(); }

}  // namespace whittle
