// module_file.h — parts of the program that stand in modules of their own and are opened when first needed (docs/architecture.md).
#pragma once

#include <string>
#include <string_view>

#include "csg/base/result.h"

namespace whittle {

// The address of `entry` in the module `name` ("whittle_font.so"), which stays open until the program ends: what it made may outlive any close. Looked
// for beside the program, a folder above, and in lib/whittle beside or above it. kWorld fault where it is not there or belongs to another version;
// `purpose` says in the message what is missing then ("the part that reads fonts").
Result<void*> module_entry(const std::string& name, const std::string& entry, std::string_view purpose);

}  // namespace whittle
