// parameters.h — customizer sets: values for assignments of the main file, as strings of a JSON file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "csg/eval/lower.h"

namespace whittle {

// Replaces the values of top-level assignments of that name. A value is read as the kind of value it replaces: a number, true or false, a list of
// numbers, else a string. Unknown names are ignored.
void set_parameters(FileSyntax& file, const Names& names, const std::vector<std::pair<std::string, std::string>>& parameters);

}  // namespace whittle
