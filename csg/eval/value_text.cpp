#include "csg/eval/value_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

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
    constexpr int kLog2 = 78913, kLog2Bits = 18;  // a little less than log10(2): the exponent is right or one too small
    const int binary = static_cast<int>(std::bit_cast<std::uint64_t>(number) >> 52) - 1023;
    exponent = (binary * kLog2 >> kLog2Bits) - 1;
    double scaled = 1e6;
    while (scaled >= 999999.25) {
        const int shift = kDigits - 1 - ++exponent;
        if (shift > kMostTens || -shift > kMostTens) return false;
        scaled = shift >= 0 ? number * kTens[shift] : number / kTens[-shift];
    }
    if (!(scaled >= 1e5 && scaled < 999999.25)) return false;
    digits = static_cast<std::uint32_t>(scaled);
    const double rest = scaled - digits;
    if (std::fabs(rest - 0.5) < 0x1p-30) return false;  // an ulp of 1e6 is 2^-33
    digits += rest > 0.5 ? 1 : 0;
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

// "00" to "99".
constexpr auto kPairs = [] {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) pairs[2 * i] = static_cast<char>('0' + i / 10), pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    return pairs;
}();

void write_pair(char* to, std::uint32_t below_100) { std::memcpy(to, &kPairs[2 * below_100], 2); }

int six_digits(double number, char (&digits)[kDigits]) {
    std::uint32_t value = 0;
    int exponent = 0;
    if (!quick_six_digits(number, value, exponent)) exponent = sure_six_digits(number, value);
    write_pair(digits, value / 10000);
    write_pair(digits + 2, value / 100 % 100);
    write_pair(digits + 4, value % 100);
    return exponent;
}

char* write_integer(char* to, std::uint32_t number) {
    char text[10];
    int at = 10;
    for (; number >= 100; number /= 100) write_pair(text + (at -= 2), number % 100);
    if (number >= 10) write_pair(text + (at -= 2), number);
    else text[--at] = static_cast<char>('0' + number);
    return std::copy(text + at, text + 10, to);
}

// A positive number by its six digits; gives the end of the text.
char* write_digits(char* to, double number) {
    char digits[kDigits];
    const int exponent = six_digits(number, digits);
    int count = kDigits;
    while (count > 1 && digits[count - 1] == '0') --count;
    if (exponent >= 6 || exponent < -5) {
        *to++ = digits[0];
        if (count > 1) *to++ = '.';
        to = std::copy(digits + 1, digits + count, to);
        *to++ = 'e';
        *to++ = exponent < 0 ? '-' : '+';
        return write_integer(to, static_cast<std::uint32_t>(std::abs(exponent)));
    }
    if (exponent < 0) {
        *to++ = '0';
        *to++ = '.';
        to = std::fill_n(to, -exponent - 1, '0');
        return std::copy(digits, digits + count, to);
    }
    const int whole = exponent + 1;
    to = std::copy(digits, digits + whole, to);
    if (count <= whole) return to;
    *to++ = '.';
    return std::copy(digits + whole, digits + count, to);
}

}  // namespace

void append_number(std::string& out, double number) {
    if (std::isnan(number)) {
        out += "nan";
        return;
    }
    char text[24];
    char* end = text;
    if (number < 0) *end++ = '-';
    number = std::fabs(number);
    if (number < 100000 && number == static_cast<double>(static_cast<std::uint32_t>(number))) {
        end = write_integer(end, static_cast<std::uint32_t>(number));
    } else if (std::isinf(number)) {
        end = std::copy_n("inf", 3, end);
    } else {
        end = write_digits(end, number);
    }
    out.append(text, static_cast<std::size_t>(end - text));
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
