// print_ast.h — an expression back as text, as OpenSCAD prints function values and the condition of a failed assert.
#pragma once

#include <string>

#include "csg/lang/ast.h"
#include "csg/lang/names.h"

namespace whittle {

// The operator as the author writes it.
const char* operator_text(ast::Op op);

// Every operation of two or three operands in parentheses; numbers to six digits by `number`.
void print_expression(std::string& out, const ast::Ast& tree, ast::ExprId id, const Names& names, void (*number)(std::string&, double));
// `name = value, value`
void print_arguments(std::string& out, const ast::Ast& tree, ast::ArgumentRange range, const Names& names, void (*number)(std::string&, double));
// In quotes, with escapes.
std::string quoted(const std::string& text);

}  // namespace whittle
