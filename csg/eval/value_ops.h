// value_ops.h — the operators on values of any type. Numbers alone take a faster way in the evaluator.
#pragma once

#include <string>

#include "csg/eval/value.h"
#include "csg/lang/ast.h"

namespace whittle {

// Value of `left op right`; where undefined, undef, and `problem` says why in OpenSCAD's words. Not for && and ||.
Value binary_operation(Heap& heap, ast::Op op, const Value& left, const Value& right, std::string& problem);
Value unary_operation(Heap& heap, ast::Op op, const Value& operand, std::string& problem);

// fmod; whole numbers below 2^31 by the processor's division.
double remainder_of(double a, double b);

// Equality never fails: different types are unequal.
bool equal(const Value& left, const Value& right);

// value[index]; undef where there is none.
Value element_at(Heap& heap, const Value& value, const Value& index);

// Code point `index` of the string, as a string; undef when out of range.
Value character_at(Heap& heap, const StringObject& text, std::uint32_t index);

}  // namespace whittle
