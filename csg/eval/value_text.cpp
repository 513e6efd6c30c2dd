#include "csg/eval/value_text.h"

#include <cmath>

#include <fmt/format.h>

namespace whittle {

void append_stream_number(std::string& out, double number) { fmt::format_to(std::back_inserter(out), "{:g}", number); }

void append_number(std::string& out, double number) {
    if (std::isnan(number)) {
        out += "nan";
        return;
    }
    if (std::isinf(number)) {
        out += number > 0 ? "inf" : "-inf";
        return;
    }
    if (std::fabs(number) < 100000 && number == std::trunc(number)) {
        fmt::format_to(std::back_inserter(out), "{}", static_cast<int>(number));
        return;
    }
    // d.ddddde±xx, correctly rounded.
    char text[32];
    const std::size_t length = static_cast<std::size_t>(fmt::format_to(text, "{:.5e}", number) - text);
    std::size_t at = 0;
    if (text[0] == '-') out.push_back(text[at++]);
    char digits[6] = {text[at], text[at + 2], text[at + 3], text[at + 4], text[at + 5], text[at + 6]};
    int exponent = 0;
    for (std::size_t i = at + 9; i < length; ++i) exponent = exponent * 10 + (text[i] - '0');
    if (text[at + 8] == '-') exponent = -exponent;
    int count = 6;
    while (count > 1 && digits[count - 1] == '0') --count;
    if (exponent >= 6 || exponent < -5) {
        out.push_back(digits[0]);
        if (count > 1) out.push_back('.');
        out.append(digits + 1, static_cast<std::size_t>(count - 1));
        fmt::format_to(std::back_inserter(out), "e{:+}", exponent);
    } else if (exponent < 0) {
        out += "0.";
        out.append(static_cast<std::size_t>(-exponent - 1), '0');
        out.append(digits, static_cast<std::size_t>(count));
    } else {
        const int whole = exponent + 1;
        for (int i = 0; i < whole; ++i) out.push_back(i < count ? digits[i] : '0');
        if (count > whole) {
            out.push_back('.');
            out.append(digits + whole, static_cast<std::size_t>(count - whole));
        }
    }
}

void append_value(std::string& out, const Value& value, const FunctionText& functions) {
    switch (value.type()) {
        case Type::kUnset:
        case Type::kUndef: out += "undef"; return;
        case Type::kBool: out += value.boolean() ? "true" : "false"; return;
        case Type::kNumber: append_number(out, value.number()); return;
        case Type::kString:
            out.push_back('"');
            out += value.string();
            out.push_back('"');
            return;
        case Type::kVector:
            out.push_back('[');
            for (std::uint32_t i = 0; i < value.size(); ++i) {
                if (i > 0) out += ", ";
                append_value(out, value[i], functions);
            }
            out.push_back(']');
            return;
        case Type::kRange:
            out.push_back('[');
            append_number(out, value.range().begin);
            out += " : ";
            append_number(out, value.range().step);
            out += " : ";
            append_number(out, value.range().end);
            out.push_back(']');
            return;
        case Type::kFunction: functions(out, value.function().code); return;
    }
}

void append_bare(std::string& out, const Value& value, const FunctionText& functions) {
    if (value.is_string()) out += value.string();
    else append_value(out, value, functions);
}

}  // namespace whittle
