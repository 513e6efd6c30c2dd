// console.h — everything the program says on standard error, in OpenSCAD's grammar or as JSON lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "csg/lang/diagnostics.h"
#include "modeler/cli/request.h"

namespace whittle {

class Console {
public:
    Console(DiagnosticStyle style, bool quiet);

    // Those of `diagnostics` that were not told yet, from number `told` on; on a terminal with the source line and a caret. Errors are told even when quiet.
    void tell(const Diagnostics& diagnostics, const SourceTable& sources, std::size_t told = 0);
    // Whether what the scene echoes is told: not where it goes to a file.
    void tell_echoes(bool yes) { echoes_ = yes; }
    // Without a place in a text. What stands behind a first line is its hint.
    void error(std::string_view text) { say(Severity::kError, text); }
    void warning(std::string_view text) { say(Severity::kWarning, text); }
    // What a file that is written should not have, in OpenSCAD's words for it.
    void export_warning(std::string_view text);
    void note(std::string_view text) { say(Severity::kNote, text); }
    // A plain line ("Total rendering time ..."); silent when quiet.
    void line(std::string_view text);

    // Texts of all warnings so far, for the JSON answers.
    const std::vector<std::string>& warnings() const { return warnings_; }
    bool on_terminal() const { return terminal_; }
    bool quiet() const { return quiet_; }

private:
    void say(Severity severity, std::string_view text);
    static std::string json_of(const Diagnostic& diagnostic, const SourceTable& sources);

    DiagnosticStyle style_;
    bool quiet_;
    bool terminal_;
    bool echoes_ = true;
    std::vector<std::string> warnings_;
};

}  // namespace whittle
