// print_program.h — a program back as text (`-o x.ast`), and the parameters that it declares as JSON (`-o x.param`).
#pragma once

#include <string>

#include "csg/lang/ast.h"
#include "csg/lang/customizer.h"
#include "csg/lang/names.h"

namespace whittle {

// How numbers are written.
using NumberText = void (*)(std::string&, double);

// Functions, modules, assignments with what the customizer reads in their comments, instantiations: OpenSCAD's order and wording.
std::string print_program(const ast::Ast& tree, const Names& names, const std::vector<CustomVariable>& variables, NumberText number);

// The variables outside the group "Hidden" whose values a customizer can show: numbers, texts, truths, lists of up to four numbers.
std::string print_parameters(const ast::Ast& tree, const Names& names, const std::vector<CustomVariable>& variables, const std::string& title);

}  // namespace whittle
