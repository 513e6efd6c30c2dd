#include "csg/eval/value_text.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

namespace whittle {

void append_stream_number(std::string& out, double number) { fmt::format_to(std::back_inserter(out), "{:g}", number); }

namespace {

constexpr int kDigits = 6;

// Ten to that power, exact where it can be.
constexpr double kTens[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kMostTens = 22;

// The six significant digits of a positive number, halves rounded up as double-conversion does, and the exponent of the first: where the product with an exact
// power of ten, off by half an ulp of itself, leaves no doubt. Nothing near a half or a border of two exponents is answered.
bool quick_six_digits(double number, std::uint32_t& digits, int& exponent) {
    if (!(number >= 1e-15 && number < 1e20)) return false;
    constexpr double kLog2 = 0.30102;  // a little less than log10(2): the exponent is right or one too small
    exponent = static_cast<int>(std::floor(std::ilogb(number) * kLog2)) - 1;
    double scaled = 1e6;
    while (scaled >= 999999.25) {
        const int shift = kDigits - 1 - ++exponent;
        if (shift > kMostTens || -shift > kMostTens) return false;
        scaled = shift >= 0 ? number * kTens[shift] : number / kTens[-shift];
    }
    if (!(scaled >= 1e5 && scaled < 999999.25)) return false;
    const double below = std::floor(scaled), rest = scaled - below;
    if (std::fabs(rest - 0.5) < 0x1p-30) return false;  // an ulp of 1e6 is 2^-33
    digits = static_cast<std::uint32_t>(below) + (rest > 0.5 ? 1 : 0);
    return true;
}

// Likewise, always: by all the digits it takes.
int sure_six_digits(double number, std::uint32_t& value) {
    char digits[kDigits];
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
    value = 0;
    for (const char digit : digits) value = value * 10 + static_cast<std::uint32_t>(digit - '0');
    if (text[7] >= '5' && ++value == 1000000) {
        value = 100000;
        ++exponent;
    }
    return exponent;
}

int six_digits(double number, char (&digits)[kDigits]) {
    std::uint32_t value = 0;
    int exponent = 0;
    if (!quick_six_digits(number, value, exponent)) exponent = sure_six_digits(number, value);
    for (int i = kDigits; i-- > 0; value /= 10) digits[i] = static_cast<char>('0' + value % 10);
    return exponent;
}

void append_integer(std::string& out, std::uint32_t number) {
    char text[10];
    int at = 10;
    do text[--at] = static_cast<char>('0' + number % 10);
    while ((number /= 10) > 0);
    out.append(text + at, static_cast<std::size_t>(10 - at));
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
        if (number < 0) out.push_back('-');
        return append_integer(out, static_cast<std::uint32_t>(std::fabs(number)));
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
        out += exponent < 0 ? "e-" : "e+";
        append_integer(out, static_cast<std::uint32_t>(std::abs(exponent)));
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
        case Type::kRecord: {
            const RecordObject& record = value.record();
            out += "{ ";
            for (std::uint32_t i = 0; i < record.size; ++i) {
                out += record.names()[i].string();
                out += " = ";
                append_value(out, record.values()[i], functions);
                out += "; ";
            }
            out.push_back('}');
            return;
        }
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
