// nearest.h — "did you mean": the known name that an unknown one most likely was meant to be.
#pragma once

#include <string>

#include "csg/eval/builtin.h"
#include "csg/eval/code.h"

namespace whittle {

// Hints for a message, or empty where no name is near.
std::string hint_for_variable(const code::Program& program, const Names& names, NameId name);
std::string hint_for_function(const code::Program& program, const Names& names, NameId name);
std::string hint_for_module(const code::Program& program, const Names& names, NameId name);

// How a function or module is called, behind the parameter that an unknown name may mean: "did you mean 'width'? expected wheel(r, width)".
std::string hint_of_complaint(const Names& names, const code::Complaint& complaint, NameId callee, const std::vector<code::Parameter>& parameters);
std::string hint_of_complaint(const Names& names, const code::Complaint& complaint, const BuiltinModule& callee);

}  // namespace whittle
