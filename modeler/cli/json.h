// json.h — JSON as bytes, written straight into a buffer: spans answer a hundred thousand rays a second through it.
//
// Numbers are the shortest decimals that read back to the same double (17 digits at most); JSON has no infinity, so what is not finite is null.
#pragma once

#include <string_view>

#include <fmt/core.h>
#include <fmt/format.h>

#include "csg/base/vec.h"

namespace whittle::json {

using Buffer = fmt::memory_buffer;

void number(Buffer& out, double value);
void triple(Buffer& out, Vec3 value);
// Quoted and escaped. Bytes that are not UTF-8 come out as U+FFFD, so that the whole stays valid JSON.
void string(Buffer& out, std::string_view text);
inline void raw(Buffer& out, std::string_view text) { out.append(text.data(), text.data() + text.size()); }
inline void boolean(Buffer& out, bool value) { raw(out, value ? "true" : "false"); }

}  // namespace whittle::json
