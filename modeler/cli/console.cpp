// console.cpp — see console.h. A write holds whole lines, and no more than a pipe takes at once, so that lines of two processes do not mix.
#include "modeler/cli/console.h"

#include <algorithm>
#include <cstdio>

#include <fmt/core.h>
#include <unistd.h>

#include "modeler/cli/json.h"

namespace whittle {

namespace {

const char* name_of(Severity severity) {
    switch (severity) {
        case Severity::kEcho: return "echo";
        case Severity::kNote: return "note";
        case Severity::kTrace: return "trace";
        case Severity::kDeprecated: return "deprecated";
        case Severity::kWarning: return "warning";
        case Severity::kError: return "error";
    }
    return "error";
}

void write_out(std::string& lines) {
    std::fwrite(lines.data(), 1, lines.size(), stderr);
    lines.clear();
}

// Adds a line to those that wait to be written.
void put(std::string& lines, std::string_view text) {
    constexpr std::size_t kPipeTakes = 4096;  // POSIX has 512 at least, Linux this
    if (lines.size() + text.size() + 1 > kPipeTakes) write_out(lines);
    lines += text;
    lines += '\n';
}

void put(std::string text) {
    text += '\n';
    write_out(text);
}

}  // namespace

Console::Console(DiagnosticStyle style, bool quiet) : style_(style), quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void Console::tell(const Diagnostics& diagnostics, const SourceTable& sources, std::size_t told) {
    const auto& all = diagnostics.all();
    std::string lines;
    for (std::size_t i = told; i < all.size(); ++i) {
        if (all[i].severity == Severity::kWarning) warnings_.push_back(all[i].text);
        if (quiet_ && all[i].severity != Severity::kError) continue;
        if (all[i].severity == Severity::kEcho && !echoes_) continue;
        if (style_ == DiagnosticStyle::kJson) {
            put(lines, json_of(all[i], sources));
            continue;
        }
        std::string text = format_line(all[i], sources);
        if (terminal_)
            if (const auto caret = format_caret(all[i], sources); !caret.empty()) text += '\n' + caret;
        if (!all[i].hint.empty()) text += '\n' + all[i].hint;
        while (!text.empty() && text.back() == '\n') text.pop_back();
        put(lines, text);
    }
    write_out(lines);
}

std::string Console::json_of(const Diagnostic& diagnostic, const SourceTable& sources) {
    json::Buffer out;
    json::raw(out, R"({"severity":)");
    json::string(out, name_of(diagnostic.severity));
    json::raw(out, R"(,"text":)");
    json::string(out, diagnostic.text);
    const bool placed = diagnostic.place.line != 0 && diagnostic.place.file < sources.files.size();
    if (placed) {
        json::raw(out, R"(,"file":)");
        json::string(out, sources.files[diagnostic.place.file].name);
        fmt::format_to(fmt::appender(out), R"(,"line":{},"column":{})", diagnostic.place.line, diagnostic.place.column);
    }
    if (!diagnostic.hint.empty()) {
        json::raw(out, R"(,"hint":)");
        json::string(out, diagnostic.hint);
    }
    json::raw(out, "}");
    return fmt::to_string(out);
}

void Console::say(Severity severity, std::string_view text) {
    Diagnostics one;
    const std::size_t end = std::min(text.find('\n'), text.size());
    one.add(severity, {}, std::string(text.substr(0, end)), std::string(text.substr(std::min(end + 1, text.size()))));
    tell(one, {});
}

void Console::export_warning(std::string_view text) {
    warnings_.emplace_back(text);
    if (quiet_) return;
    if (style_ == DiagnosticStyle::kText) return put(fmt::format("EXPORT-WARNING: {}", text));
    json::Buffer out;
    json::raw(out, R"({"severity":"export-warning","text":)");
    json::string(out, text);
    json::raw(out, "}");
    put(fmt::to_string(out));
}

void Console::line(std::string_view text) {
    if (!quiet_ && style_ == DiagnosticStyle::kText) put(std::string(text));
}

}  // namespace whittle
