// type_names.h — the types that a file defines, as text. Two types of one name in one namespace are undefined behaviour even where no file sees both: the
// linker keeps one of what templates made of each, as std::vector does when it grows.
#pragma once

#include <string>
#include <vector>

// Names with their namespaces ("whittle::Ray") of the structs, classes, unions and enums that stand at the beginning of a line, in order. What an unnamed
// namespace holds belongs to its file alone and is left out, and so are declarations.
std::vector<std::string> types_defined_in(const std::string& text);
