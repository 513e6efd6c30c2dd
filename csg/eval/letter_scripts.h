// letter_scripts.h — the script that the letters of a text are of, as text() finds it and .csg tells it.
#pragma once

#include <string>
#include <string_view>

namespace whittle {

// ISO 15924 code ("Latn") of the one script of all letters of a text in UTF-8; "Zzzz" where they are of several, empty where none has any: digits, blanks
// and marks belong to all scripts.
// Source: Unicode Standard Annex 24.
std::string script_of_letters(std::string_view text);

// Are texts of this script written from right to left?
bool is_written_leftwards(std::string_view script);

}  // namespace whittle
