#include "csg/eval/value_text.h"

#include <cmath>

#include <fmt/format.h>

namespace whittle {

void append_stream_number(std::string& out, double number) { fmt::format_to(std::back_inserter(out), "{:g}", number); }

namespace {

constexpr int kDigits = 6;

// The six significant digits of a positive number, halves rounded up as double-conversion does, and the exponent of the first.
int six_digits(double number, char (&digits)[kDigits]) {
    const auto write = [&](int decimals, char (&text)[40]) {
        *fmt::format_to(text, "{:.{}e}", number, decimals) = '\0';
        int exponent = 0;
        for (const char* c = text + decimals + 4; *c; ++c) exponent = exponent * 10 + (*c - '0');
        return text[decimals + 3] == '-' ? -exponent : exponent;
    };
    // Thirteen digits decide unless they look like a half; then a true half has zeros as far as doubles reach.
    char text[40];
    int exponent = write(12, text);
    const auto zeros_from = [&](int at, int end) {
        while (at < end && text[at] == '0') ++at;
        return at == end;
    };
    if (text[7] == '5' && zeros_from(8, 14)) exponent = write(24, text);
    digits[0] = text[0];
    for (int i = 1; i < kDigits; ++i) digits[i] = text[i + 1];
    if (text[7] < '5') return exponent;
    int i = kDigits - 1;
    while (i >= 0 && digits[i] == '9') digits[i--] = '0';
    if (i >= 0) {
        ++digits[i];
        return exponent;
    }
    digits[0] = '1';
    return exponent + 1;
}

}  // namespace

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
    if (number < 0) out.push_back('-');
    char digits[kDigits];
    const int exponent = six_digits(std::fabs(number), digits);
    int count = kDigits;
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
