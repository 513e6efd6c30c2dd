#include "csg/eval/value_ops.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <sleef.h>

#include "csg/lang/print_ast.h"

namespace whittle {

using ast::Op;

namespace {

// The same names with equal values, in any order.
bool equal_records(const RecordObject& left, const RecordObject& right) {
    if (left.size != right.size) return false;
    for (std::uint32_t i = 0; i < left.size; ++i) {
        const Value* other = right.find(left.names()[i].string());
        if (!other || !equal(left.values()[i], *other)) return false;
    }
    return true;
}

// -1, 0, 1, or 2 for unordered (nan).
int order_of_numbers(double x, double y) { return x < y ? -1 : x > y ? 1 : x == y ? 0 : 2; }

// As OpenSCAD orders them: those without elements are equal and come first.
int order_of_ranges(const RangeObject& x, const RangeObject& y) {
    const bool x_is_empty = range_count(x) == 0, y_is_empty = range_count(y) == 0;
    if (x_is_empty || y_is_empty) return y_is_empty - x_is_empty;
    if (const int c = order_of_numbers(x.begin, y.begin)) return c;
    if (const int c = order_of_numbers(x.step, y.step)) return c;
    return order_of_numbers(x.end, y.end);
}

}  // namespace

bool equal(const Value& left, const Value& right) {
    if (left.type() != right.type()) return left.is_undef() && right.is_undef();
    switch (left.type()) {
        case Type::kUnset:
        case Type::kUndef: return true;
        case Type::kBool:
        case Type::kNumber: return left.number() == right.number();
        case Type::kString: return left.string() == right.string();
        case Type::kVector: {
            if (left.size() != right.size()) return false;
            for (std::uint32_t i = 0; i < left.size(); ++i)
                if (!equal(left[i], right[i])) return false;
            return true;
        }
        case Type::kRecord: return equal_records(left.record(), right.record());
        case Type::kRange: return order_of_ranges(left.range(), right.range()) == 0;
        case Type::kFunction: {
            const FunctionObject &a = left.function(), &b = right.function();
            return &a == &b || (a.self && a.self == b.self && a.code == b.code && a.frame == b.frame);
        }
    }
    return false;
}

namespace {

Value undefined(Op op, const Value& a, const Value& b, std::string& problem) {
    problem = fmt::format("undefined operation ({} {} {})", type_name(a.type()), operator_text(op), type_name(b.type()));
    return {};
}

// OpenSCAD has "less" only between elements of lists: a >= b is !(a < b), a > b is b < a.
bool asks_for_swapped(Op op) { return op == Op::kGreater || op == Op::kLessEqual; }

// -1, 0, 1, or 2 for unordered (nan; between elements that is 0, neither is less); `problem` where the types have no order.
int compare(Op op, const Value& a, const Value& b, std::string& problem) {
    if (a.type() != b.type() && !(a.is_undef() && b.is_undef())) {
        undefined(op, a, b, problem);
        return 2;
    }
    switch (a.type()) {
        case Type::kBool:
        case Type::kNumber: return order_of_numbers(a.number(), b.number());
        case Type::kString: {
            const int c = a.string().compare(b.string());
            return c < 0 ? -1 : c > 0;
        }
        case Type::kVector: {
            const std::uint32_t shared = std::min(a.size(), b.size());
            const bool swapped = asks_for_swapped(op);
            for (std::uint32_t i = 0; i < shared; ++i) {
                int c = swapped ? compare(Op::kLess, b[i], a[i], problem) : compare(Op::kLess, a[i], b[i], problem);
                if (!problem.empty()) {
                    problem += fmt::format("\n\tin vector comparison at index {}", i);
                    return 2;
                }
                if (c == 2) c = 0;
                if (c != 0) return swapped ? -c : c;
            }
            return order_of_numbers(a.size(), b.size());
        }
        case Type::kRange: return order_of_ranges(a.range(), b.range());
        default: problem = fmt::format("operation undefined ({} {} {})", type_name(a.type()), operator_text(op), type_name(b.type())); return 2;
    }
}

Value ordered(Op op, const Value& a, const Value& b, std::string& problem) {
    const int c = compare(op, a, b, problem);
    if (!problem.empty()) return {};
    switch (op) {
        case Op::kLess: return Value(c == -1);
        case Op::kLessEqual: return Value(c == -1 || c == 0);
        case Op::kGreater: return Value(c == 1);
        default: return Value(c == 0 || c == 1);
    }
}

// A vector of f(0), f(1), ...
template <class F>
Value mapped(Heap& heap, std::uint32_t count, F f) {
    Value made = heap.blank_vector(count);
    Value* elements = elements_of_new(made);
    for (std::uint32_t i = 0; i < count; ++i) elements[i] = f(i);
    note_nesting(made);
    return made;
}

Value sum(Heap& heap, Op op, const Value& a, const Value& b, std::string& problem) {
    if (a.is_number() && b.is_number()) return Value(op == Op::kAdd ? a.number() + b.number() : a.number() - b.number());
    if (!a.is_vector() || !b.is_vector()) return undefined(op, a, b, problem);
    return mapped(heap, std::min(a.size(), b.size()), [&](std::uint32_t i) {
        if (a[i].is_number() && b[i].is_number()) return Value(op == Op::kAdd ? a[i].number() + b[i].number() : a[i].number() - b[i].number());
        std::string ignored;
        return sum(heap, op, a[i], b[i], ignored);
    });
}

Value matrix_times_vector(Heap& heap, const Value& m, const Value& v, std::string& problem) {
    if (m[0].size() != v.size()) {
        problem = fmt::format("matrix*vector requires matrix column count to match vector length ({} != {})", m[0].size(), v.size());
        return {};
    }
    Value made = heap.blank_vector(m.size());
    Value* out = elements_of_new(made);
    for (std::uint32_t row = 0; row < m.size(); ++row) {
        if (!m[row].is_vector() || m[row].size() != v.size()) {
            problem = fmt::format("Matrix must be rectangular. Problem at row {}", row);
            return {};
        }
        double total = 0;
        for (std::uint32_t i = 0; i < v.size(); ++i) {
            if (!m[row][i].is_number()) problem = fmt::format("Matrix must contain only numbers. Problem at row {}, col {}", row, i);
            else if (!v[i].is_number()) problem = fmt::format("Vector must contain only numbers. Problem at index {}", i);
            if (!problem.empty()) return {};
            total += m[row][i].number() * v[i].number();
        }
        out[row] = Value(total);
    }
    return made;
}

Value vector_times_matrix(Heap& heap, const Value& v, const Value& m, std::string& problem) {
    if (v.size() != m.size()) {
        problem = fmt::format("vector*matrix requires vector length to match matrix row count ({} != {})", v.size(), m.size());
        return {};
    }
    Value made = heap.blank_vector(m[0].size());
    Value* out = elements_of_new(made);
    for (std::uint32_t column = 0; column < m[0].size(); ++column) {
        double total = 0;
        for (std::uint32_t row = 0; row < m.size(); ++row) {
            if (!m[row].is_vector() || m[row].size() != m[0].size()) problem = fmt::format("Matrix must be rectangular. Problem at row {}", row);
            else if (!v[row].is_number()) problem = fmt::format("Vector must contain only numbers. Problem at index {}", row);
            else if (!m[row][column].is_number()) problem = fmt::format("Matrix must contain only numbers. Problem at row {}, col {}", row, column);
            if (!problem.empty()) return {};
            total += v[row].number() * m[row][column].number();
        }
        out[column] = Value(total);
    }
    return made;
}

Value matrix_times_matrix(Heap& heap, const Value& a, const Value& b, std::string& problem) {
    if (a[0].size() != b.size()) {
        problem = fmt::format("matrix*matrix requires left operand column count to match right operand row count ({} != {})", a[0].size(), b.size());
        return {};
    }
    std::vector<Value> rows;
    for (std::uint32_t row = 0; row < a.size(); ++row) {
        if (!a[row].is_vector() || a[row].size() != b.size()) {
            problem = fmt::format("matrix*matrix left operand row length does not match right operand row count ({} != {}) at row {}",
                                  a[row].is_vector() ? a[row].size() : 0, b.size(), row);
            return {};
        }
        rows.push_back(vector_times_matrix(heap, a[row], b, problem));
        if (!problem.empty()) {
            problem += fmt::format("\n\twhile processing left operand at row {}", row);
            return {};
        }
    }
    return heap.vector(std::move(rows));
}

Value vector_product(Heap& heap, const Value& a, const Value& b, std::string& problem) {
    if (a.size() == 0 || b.size() == 0) {
        problem = "Multiplication is undefined on empty vectors";
        return {};
    }
    const Type left = a[0].type(), right = b[0].type();
    if (left == Type::kNumber && right == Type::kNumber) {
        if (a.size() != b.size()) {
            problem = fmt::format("vector*vector requires matching lengths ({} != {})", a.size(), b.size());
            return {};
        }
        double total = 0;
        for (std::uint32_t i = 0; i < a.size(); ++i) {
            if (!a[i].is_number() || !b[i].is_number()) return undefined(Op::kMultiply, a[i], b[i], problem);
            total += a[i].number() * b[i].number();
        }
        return Value(total);
    }
    if (left == Type::kVector && right == Type::kNumber) return matrix_times_vector(heap, a, b, problem);
    if (left == Type::kNumber && right == Type::kVector) return vector_times_matrix(heap, a, b, problem);
    if (left == Type::kVector && right == Type::kVector) return matrix_times_matrix(heap, a, b, problem);
    problem = fmt::format("undefined vector*vector multiplication where first elements are types {} and {}", type_name(left), type_name(right));
    return {};
}

Value product(Heap& heap, const Value& a, const Value& b, std::string& problem) {
    if (a.is_number() && b.is_number()) return Value(a.number() * b.number());
    if (a.is_vector() && b.is_vector()) return vector_product(heap, a, b, problem);
    if (!(a.is_number() && b.is_vector()) && !(a.is_vector() && b.is_number())) return undefined(Op::kMultiply, a, b, problem);
    const Value& list = a.is_vector() ? a : b;
    const Value& factor = a.is_vector() ? b : a;
    return mapped(heap, list.size(), [&](std::uint32_t i) {
        if (list[i].is_number()) return Value(list[i].number() * factor.number());
        std::string ignored;
        return product(heap, list[i], factor, ignored);
    });
}

Value quotient(Heap& heap, const Value& a, const Value& b, std::string& problem) {
    if (a.is_number() && b.is_number()) return Value(a.number() / b.number());
    const bool by_number = a.is_vector() && b.is_number(), of_number = a.is_number() && b.is_vector();
    if (!by_number && !of_number) return undefined(Op::kDivide, a, b, problem);
    return mapped(heap, (by_number ? a : b).size(), [&](std::uint32_t i) {
        std::string ignored;
        return by_number ? quotient(heap, a[i], b, ignored) : quotient(heap, a, b[i], ignored);
    });
}

// Truncated; what does not fit in 64 bits saturates, nan is 0.
std::int64_t to_integer(double x) {
    if (std::isnan(x)) return 0;
    if (x >= 9223372036854775808.0) return INT64_MAX;
    if (x < -9223372036854775808.0) return INT64_MIN;
    return static_cast<std::int64_t>(x);
}

Value bits(Op op, const Value& a, const Value& b, std::string& problem) {
    if (!a.is_number() || !b.is_number()) return undefined(op, a, b, problem);
    const std::int64_t x = to_integer(a.number()), y = to_integer(b.number());
    switch (op) {
        case Op::kBitOr: return Value(static_cast<double>(x | y));
        case Op::kBitAnd: return Value(static_cast<double>(x & y));
        default: break;
    }
    if (y < 0) {
        problem = "negative shift";
        return {};
    }
    if (y > 63) {
        problem = "shift too large";
        return {};
    }
    if (op == Op::kShiftRight) return Value(static_cast<double>(x >> y));
    return Value(static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << y)));
}

}  // namespace

double remainder_of(double a, double b) {
    const auto whole = [](double x) { return std::fabs(x) < 0x1p31 && x == static_cast<double>(static_cast<std::int32_t>(x)); };
    if (!whole(a) || !whole(b) || b == 0) return std::fmod(a, b);
    return std::copysign(static_cast<double>(static_cast<std::int32_t>(a) % static_cast<std::int32_t>(b)), a);
}

Value binary_operation(Heap& heap, Op op, const Value& left, const Value& right, std::string& problem) {
    switch (op) {
        case Op::kEqual: return Value(equal(left, right));
        case Op::kNotEqual: return Value(!equal(left, right));
        case Op::kLess:
        case Op::kLessEqual:
        case Op::kGreater:
        case Op::kGreaterEqual: return ordered(op, left, right, problem);
        case Op::kAdd:
        case Op::kSubtract: return sum(heap, op, left, right, problem);
        case Op::kMultiply: return product(heap, left, right, problem);
        case Op::kDivide: return quotient(heap, left, right, problem);
        case Op::kModulo:
            if (left.is_number() && right.is_number()) return Value(remainder_of(left.number(), right.number()));
            return undefined(op, left, right, problem);
        case Op::kPower:
            if (left.is_number() && right.is_number()) return Value(Sleef_cinz_powd1_u10purec(left.number(), right.number()));
            return undefined(op, left, right, problem);
        default: return bits(op, left, right, problem);
    }
}

Value unary_operation(Heap& heap, Op op, const Value& operand, std::string& problem) {
    if (op == Op::kNot) return Value(!operand.truth());
    if (op == Op::kBitNot && operand.is_number()) return Value(static_cast<double>(~to_integer(operand.number())));
    if (op == Op::kNegate && operand.is_number()) return Value(-operand.number());
    if (op == Op::kNegate && operand.is_vector()) {
        return mapped(heap, operand.size(), [&](std::uint32_t i) {
            std::string ignored;
            return unary_operation(heap, op, operand[i], ignored);
        });
    }
    problem = fmt::format("undefined operation ({}{})", operator_text(op), type_name(operand.type()));
    return {};
}

Value character_at(Heap& heap, const StringObject& text, std::uint32_t index) {
    if (index >= text.points) return {};
    if (text.points == text.bytes) return heap.string(text.view().substr(index, 1));
    const std::string_view view = text.view();
    std::size_t at = 0;
    const auto next = [&view](std::size_t i) {
        do ++i;
        while (i < view.size() && (static_cast<unsigned char>(view[i]) & 0xC0) == 0x80);
        return i;
    };
    for (std::uint32_t i = 0; i < index; ++i) at = next(at);
    return heap.string(view.substr(at, next(at) - at));
}

Value element_at(Heap& heap, const Value& value, const Value& index) {
    if (!index.is_number() || !(index.number() > -1) || index.number() >= 4294967296.0) return {};
    const std::uint32_t i = static_cast<std::uint32_t>(index.number());
    if (value.is_vector()) return i < value.size() ? value[i] : Value();
    if (value.is_string()) return character_at(heap, value.string_object(), i);
    if (value.is_range() && i < 3) return Value(i == 0 ? value.range().begin : i == 1 ? value.range().step : value.range().end);
    return {};
}

}  // namespace whittle
