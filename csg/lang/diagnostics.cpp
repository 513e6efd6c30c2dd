#include "csg/lang/diagnostics.h"

#include <algorithm>

namespace whittle {

void Diagnostics::add(Severity severity, SourcePlace place, std::string text, std::string hint) {
    if (severity == Severity::kError) ++errors_;
    if (all_.size() == all_.capacity()) all_.reserve(std::max<std::size_t>(16, 4 * all_.size()));  // moving tens of thousands twice costs more than room
    all_.push_back({severity, place, std::move(text), std::move(hint)});
}

int Diagnostics::count(Severity severity) const {
    return static_cast<int>(std::count_if(all_.begin(), all_.end(), [severity](const Diagnostic& d) { return d.severity == severity; }));
}

namespace {

const char* prefix(Severity severity) {
    switch (severity) {
        case Severity::kEcho: return "ECHO: ";
        case Severity::kNote: return "NOTE: ";
        case Severity::kTrace: return "TRACE: ";
        case Severity::kDeprecated: return "DEPRECATED: ";
        case Severity::kWarning: return "WARNING: ";
        case Severity::kError: return "ERROR: ";
    }
    return "";
}

// Line `line` (from 1) of `text`, without its end.
std::string_view line_of(std::string_view text, std::uint32_t line) {
    std::size_t start = 0;
    for (std::uint32_t i = 1; i < line; ++i) {
        start = text.find('\n', start);
        if (start == std::string_view::npos) return {};
        ++start;
    }
    std::string_view rest = text.substr(start);
    rest = rest.substr(0, rest.find('\n'));
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    return rest;
}

}  // namespace

std::string format_line(const Diagnostic& diagnostic, const SourceTable& sources) {
    std::string out = prefix(diagnostic.severity) + diagnostic.text;
    if (diagnostic.place.line == 0 || diagnostic.place.file >= sources.files.size() || diagnostic.severity == Severity::kEcho) return out;
    return out + " in file " + sources.files[diagnostic.place.file].name + ", line " + std::to_string(diagnostic.place.line);
}

std::string format_caret(const Diagnostic& diagnostic, const SourceTable& sources) {
    const SourcePlace& place = diagnostic.place;
    if (place.line == 0 || place.column == 0 || place.file >= sources.files.size()) return {};
    const std::string_view whole = line_of(sources.files[place.file].text, place.line);
    // Long lines are shown from 60 bytes before the place.
    const std::size_t column = std::min<std::size_t>(place.column - 1, whole.size());
    std::size_t from = column > 100 ? column - 60 : 0;
    while (from > 0 && (static_cast<unsigned char>(whole[from]) & 0xC0) == 0x80) --from;
    const std::string_view shown = whole.substr(from, column - from + 100);
    std::string under;
    for (char c : shown.substr(0, column - from)) {
        if (c == '\t') under.push_back('\t');
        else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) under.push_back(' ');
    }
    return std::string(shown) + "\n" + under + "^";
}

}  // namespace whittle
