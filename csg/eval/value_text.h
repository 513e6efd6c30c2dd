// value_text.h — values as text, digit for digit as OpenSCAD prints them.
#pragma once

#include <functional>
#include <string>

#include "csg/eval/value.h"

namespace whittle {

// Six significant digits, no trailing zeros; exponential from 1e6 and below 1e-5 ("1e+6", "1.5e-6"); -0 is "0".
void append_number(std::string& out, double number);
// As C++ streams print it ("1e+06"): the parameters of primitives in a .csg file.
void append_stream_number(std::string& out, double number);

// Text of a function value, which only the program knows.
using FunctionText = std::function<void(std::string&, std::uint32_t code)>;

// As echo shows it, and as a part of a list: strings in quotes, nothing escaped.
void append_value(std::string& out, const Value& value, const FunctionText& functions);
// As str() joins it: a string bare.
void append_bare(std::string& out, const Value& value, const FunctionText& functions);

}  // namespace whittle
