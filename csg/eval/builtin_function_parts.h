// builtin_function_parts.h — the longer built-in functions, for the table in builtin_functions.cpp. Internal to csg/eval.
#pragma once

#include "csg/eval/builtin.h"
#include "csg/eval/value_ops.h"

namespace whittle {

// The two complaints that most functions share; both give undef.
Value wrong_count(FunctionCall& call);
Value wrong_type(FunctionCall& call);
std::string signature_hint(std::string_view name);

Value function_rands(FunctionCall& call);
Value function_len(FunctionCall& call);
Value function_str(FunctionCall& call);
Value function_chr(FunctionCall& call);
Value function_ord(FunctionCall& call);
Value function_concat(FunctionCall& call);
Value function_lookup(FunctionCall& call);
Value function_search(FunctionCall& call);
Value function_norm(FunctionCall& call);
Value function_cross(FunctionCall& call);
Value function_dxf_dim(FunctionCall& call);
Value function_dxf_cross(FunctionCall& call);
Value function_object(FunctionCall& call);
Value function_has_key(FunctionCall& call);
Value function_is_object(FunctionCall& call);
Value function_import(FunctionCall& call);
Value function_textmetrics(FunctionCall& call);
Value function_fontmetrics(FunctionCall& call);

// Warns of what builtin_arguments.h found wrong with the arguments: lines of a string, or undef.
void tell_complaints(FunctionCall& call, const Value& complaints);

// Code points of UTF-8 text, as substrings.
std::vector<std::string_view> code_points(std::string_view text);
// Number of the first code point. Requires: some text.
std::uint32_t first_code_point(std::string_view text);

}  // namespace whittle
