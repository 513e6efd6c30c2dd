// file.h — files written whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "csg/base/result.h"

namespace whittle {

// Where write_file_atomically() writes before it renames: beside what `path` leads to, named after it and this process. Who ends the process in the
// middle of a write removes this name.
std::string temporary_name(const std::string& path);

// Puts `bytes` at `path`: into temporary_name(path), then renamed, so that any failure (a full disk too) leaves what was there before and
// no other file. A link is followed, the old file's permissions are kept; what is no regular file (a pipe, /dev/null) is written straight.
// Fails with kWorld and the system's reason.
Result<void> write_file_atomically(const std::string& path, std::string_view bytes);

// The whole of a file; kWorld with the system's reason. "-" is standard input.
Result<std::string> read_whole_file(const std::string& path);

}  // namespace whittle
