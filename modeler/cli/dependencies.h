// dependencies.h — -d FILE: what the scene read, as a make rule.
#pragma once

#include <string>
#include <vector>

#include "csg/base/result.h"
#include "modeler/cli/request.h"

namespace whittle {

// One rule for all outputs; blanks, # and $ in names are escaped as make wants. Writes nothing where the request names no file.
Result<void> write_dependencies(const Request& request, const std::vector<std::string>& files_read);
std::string dependency_rule(const std::vector<std::string>& targets, const std::vector<std::string>& files_read);

}  // namespace whittle
