// numbers.cpp — from_chars with what people also write: blanks, a leading +.
#include "modeler/cli/numbers.h"

#include <charconv>
#include <cmath>

namespace whittle {

namespace {

bool is_gap(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; }

}  // namespace

bool take_number(std::string_view& text, double& number) {
    while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || !std::isfinite(number)) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return text.empty() || is_gap(text.front());
}

std::optional<double> number_in(std::string_view text) {
    double number = 0;
    if (text.find(',') != std::string_view::npos || !take_number(text, number)) return std::nullopt;
    while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
    if (!text.empty()) return std::nullopt;
    return number;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
    std::vector<double> numbers;
    while (true) {
        const auto comma = text.find(',');
        const auto number = number_in(text.substr(0, comma));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        if (comma == std::string_view::npos) return numbers;
        text.remove_prefix(comma + 1);
    }
}

}  // namespace whittle
