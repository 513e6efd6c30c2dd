// json.cpp — see json.h.
#include "modeler/cli/json.h"

#include <cmath>

#include <fmt/compile.h>

namespace whittle::json {

namespace {

// Length of the well-formed UTF-8 sequence that `text` begins with; 0 where there is none.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80 ? 1 : first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : first >= 0xF0 && first < 0xF5 ? 4 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool surrogate = first == 0xED && byte(1) > 0x9F;
    const bool too_large = first == 0xF4 && byte(1) > 0x8F;
    return overlong || surrogate || too_large ? 0 : length;
}

}  // namespace

void number(Buffer& out, double value) {
    if (value == 0)
        out.push_back('0');  // -0 too
    else if (std::isfinite(value))
        fmt::format_to(fmt::appender(out), FMT_COMPILE("{}"), value);
    else
        raw(out, "null");
}

void triple(Buffer& out, Vec3 value) {
    out.push_back('[');
    number(out, value.x);
    out.push_back(',');
    number(out, value.y);
    out.push_back(',');
    number(out, value.z);
    out.push_back(']');
}

void string(Buffer& out, std::string_view text) {
    out.push_back('"');
    while (!text.empty()) {
        const char c = text.front();
        const std::size_t length = sequence_length(text);
        if (length == 0) {
            raw(out, "\xEF\xBF\xBD");
        } else if (c == '"' || c == '\\') {
            out.push_back('\\');
            out.push_back(c);
        } else if (c == '\n') {
            raw(out, "\\n");
        } else if (static_cast<unsigned char>(c) < 0x20) {
            fmt::format_to(fmt::appender(out), FMT_COMPILE("\\u{:04x}"), static_cast<unsigned>(c));
        } else {
            raw(out, text.substr(0, length));
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    out.push_back('"');
}

}  // namespace whittle::json
