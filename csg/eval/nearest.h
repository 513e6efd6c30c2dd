// nearest.h — "did you mean": the known name that an unknown one most likely was meant to be.
#pragma once

#include <string>

#include "csg/eval/code.h"

namespace whittle {

// Hints for a message, or empty where no name is near.
std::string hint_for_variable(const code::Program& program, const Names& names, NameId name);
std::string hint_for_function(const code::Program& program, const Names& names, NameId name);
std::string hint_for_module(const code::Program& program, const Names& names, NameId name);

// How a function or module of the author's is called: "expected wheel(r, width)".
std::string hint_of_signature(const Names& names, NameId callee, const std::vector<code::Parameter>& parameters);

}  // namespace whittle
