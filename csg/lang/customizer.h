// customizer.h — what the author's comments say about the variables of a file: description, group, and which values they may take.
//
// OpenSCAD's customizer reads the comment behind an assignment (`x = 10; // [1:100]`), the one on the line above it, and `/* [Group] */` comments, as far as
// the first brace of the file. Facts: docs/language.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/lang/ast.h"
#include "csg/lang/names.h"

namespace whittle {

// One value of a list: a number or a text, perhaps under a label.
struct CustomChoice {
    std::optional<double> number;
    std::string text;  // where it is no number
    std::optional<std::string> label;
};

struct CustomValues {
    enum class Kind { kNone, kNumber, kText, kRange, kList } kind = Kind::kNone;
    double number = 0;                     // kNumber
    std::string text;                      // kText
    double least = 0, most = 0;            // kRange
    std::optional<double> step;
    std::vector<CustomChoice> choices;     // kList
};

struct CustomVariable {
    std::uint32_t assignment = 0;          // in the root scope
    std::optional<std::string> description, group;
    CustomValues values;
};

// The assignments of plain values in the main file's text, in order. A comment that is no list of values in brackets, number or words gives kNone.
std::vector<CustomVariable> custom_variables(const ast::Ast& tree, const std::string& text, std::uint32_t file);

// Is the expression a plain value (number, text, truth, undef, or a list or range of those)?
bool is_plain_value(const ast::Ast& tree, ast::ExprId id);

}  // namespace whittle
