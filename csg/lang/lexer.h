// lexer.h — text → tokens of one file.
//
// The rules are OpenSCAD's (docs/language.md): an identifier may start with a digit, so the longer of a number and an identifier wins;
// a raw newline in a string vanishes; byte 3 ends the input.
#pragma once

#include <string>
#include <vector>

#include "csg/lang/names.h"
#include "csg/lang/source.h"
#include "csg/lang/token.h"

namespace whittle {

// Texts of string tokens, paths and complaints.
using StringPool = std::vector<std::string>;

// Tokens of `text`, the last one kEnd. Never fails: what is no word is a kBad token. `file` goes into every place.
// `include <p>` and `use <p>` are one token each (kInclude, kUse) with the path as text.
std::vector<Token> lex(const std::string& text, std::uint32_t file, Names& names, StringPool& strings);

}  // namespace whittle
