// evaluate.h — text → scene: reads a program with everything it includes and uses, and runs it.
//
// Two steps that can be timed apart: parse() reads files and makes the syntax, evaluate() resolves names to slots and runs. Neither
// prints, throws nor depends on the C stack of the caller (both run on a stack of their own); what is wrong with the text is a diagnostic.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/base/result.h"
#include "csg/eval/scene.h"
#include "csg/lang/diagnostics.h"
#include "csg/lang/source.h"
#include "csg/solid/outside.h"

namespace whittle {

// 0: no limit. `seconds` is wall time of evaluate(); `memory_bytes` bounds what values, frames and scene nodes hold, about.
struct EvaluateLimits {
    double seconds = 0;
    std::uint64_t memory_bytes = 0;
};

struct EvaluateInput {
    std::string path;                         // main file as the user gave it; includes are searched beside it; may be "-" with `text`
    std::optional<std::string> text;          // unset: read through Outside
    std::vector<std::string> definitions;     // -D, each appended as `text;` after the main file
    std::vector<std::pair<std::string, std::string>> parameters;  // customizer set: name, value as the JSON file holds it; beats -D
    std::vector<std::string> library_paths;   // searched in order after the folder of the including file
    bool preview = false;                     // $preview
    double time = 0;                          // $t
    bool check_parameters = true;             // warn on unknown and surplus arguments
    bool hard_warnings = false;               // the first warning stops the run
    EvaluateLimits limits;
    const std::atomic<bool>* cancel = nullptr;
};

// The syntax of all files of a run. Holds no reference to the input.
struct ProgramText;

struct Parsed {
    std::shared_ptr<const ProgramText> program;  // null when the text is not a program: the diagnostics say why
    SourceTable sources;                         // main file first
    Diagnostics diagnostics;
    std::vector<std::string> files_read;         // paths as opened, in order, each once (for -d)
};

enum class Stop {
    kNone,       // ran to its end
    kSyntax,     // a syntax error: nothing was run
    kScene,      // failed assert, endless recursion, hard warning, too many iterations
    kTime, kMemory,
    kCancelled
};

struct Evaluated {
    Scene scene;  // an empty group when the run stopped early
    SourceTable sources;
    Diagnostics diagnostics;  // of both steps, in order
    std::vector<std::string> files_read;
    Stop stop = Stop::kNone;
    bool stopped() const { return stop != Stop::kNone; }
};

// Fails (kWorld) only when the main file cannot be read.
Result<Parsed> parse(const EvaluateInput& input, Outside& outside);

// Runs what parse() made of the same input.
Evaluated evaluate(Parsed parsed, const EvaluateInput& input, Outside& outside);

// Both steps.
Result<Evaluated> evaluate(const EvaluateInput& input, Outside& outside);

// What parse() read, back as text (`-o x.ast`), and the parameters that its comments declare as JSON (`-o x.param`). The walks need the stack of parse().
// Requires: parsed.program.
Result<std::string> ast_text(const Parsed& parsed);
Result<std::string> parameters_text(const Parsed& parsed);

// The text that `-o x.echo` writes: every message a line, as OpenSCAD formats it.
std::string echo_text(const Diagnostics& diagnostics, const SourceTable& sources);

}  // namespace whittle
