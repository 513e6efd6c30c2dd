// parameter_set.h — OpenSCAD's customizer files: named sets of values for a scene's top-level variables.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "csg/base/result.h"

namespace whittle {

// The set's values as the file holds them (strings, converted later by the type of each default), by name; empty where the file has no such set.
// Fails with kWorld where the file cannot be read, with kScene where it is not a customizer file.
Result<std::vector<std::pair<std::string, std::string>>> read_parameter_set(const std::string& path, const std::string& set);

}  // namespace whittle
