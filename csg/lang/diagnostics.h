// diagnostics.h — what the program tells the author about the text: collected here, printed by modeler/cli only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/lang/source.h"

namespace whittle {

enum class Severity { kEcho, kNote, kTrace, kDeprecated, kWarning, kError };

// `text` is OpenSCAD's wording first ("Ignoring unknown variable 'a'"); the printer adds "WARNING: " and " in file F, line N".
// `hint` is Whittle's addition ("did you mean 'b'?"), printed on a line of its own; may be empty.
struct Diagnostic {
    Severity severity = Severity::kWarning;
    SourcePlace place;
    std::string text;
    std::string hint;
};

class Diagnostics {
public:
    void add(Severity severity, SourcePlace place, std::string text, std::string hint = {});
    const std::vector<Diagnostic>& all() const { return all_; }
    bool has_errors() const { return errors_ > 0; }
    int count(Severity severity) const;

private:
    std::vector<Diagnostic> all_;
    int errors_ = 0;
};

// One diagnostic in OpenSCAD's grammar: `WARNING: text in file F, line N` (no place: no suffix; ECHO: text as it is).
std::string format_line(const Diagnostic& diagnostic, const SourceTable& sources);
// The source line and a caret under the place, two lines; empty when there is no place.
std::string format_caret(const Diagnostic& diagnostic, const SourceTable& sources);

}  // namespace whittle
