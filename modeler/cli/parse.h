// parse.h — command line → Request. The only door to CLI11, which stands in parse.cpp.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "csg/base/result.h"
#include "modeler/cli/request.h"

namespace whittle {

// Text for standard output and nothing more to do: --help, --version.
struct Say { std::string text; };

// Either what to do, what to say, or a kCommand fault whose message names the option and what it wants.
// `arguments` without the program's name. Every option of docs/command-line is read; one whose function does not exist yet is a fault.
Result<std::variant<Request, Say>> parse_command_line(std::vector<std::string> arguments);

// Every long and short option of a verb ("render", ... or "" for OpenSCAD's own form), as --help names them: completions are held against it.
std::vector<std::string> option_names(const std::string& verb);
std::vector<std::string> verb_names();

}  // namespace whittle
