// json_value.h — the text of a JSON file as a value of the language: objects, lists, strings, numbers, true, false; null is undef. Internal to csg/eval.
//
// Source: RFC 8259. Members are sorted by name, as later versions of OpenSCAD hold them; of a name given twice the last value counts.
#pragma once

#include <string_view>

#include "csg/base/result.h"
#include "csg/eval/value.h"

namespace whittle {

// Lists and objects may nest this deep.
inline constexpr int kMaxJsonNesting = 1000;

// Fault kWorld with line and column where the text is no JSON.
Result<Value> json_value(Heap& heap, std::string_view text);

}  // namespace whittle
