// formula.h — boolean formulas over the signs of supports: what a shape, and a whole solid, is.
//
// A support is a polynomial in the root frame, kept once however many faces lie on it. A formula's atom is "the support is negative here".
// Nothing is decided about points where a support vanishes: membership is only ever asked strictly between the roots on a ray.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tests/reference/form.h"

namespace whittle::reference {

using ExpressionId = std::uint32_t;

struct Expression {
    enum class Kind { kFalse, kTrue, kNegative, kPositive, kAll, kAny, kOdd, kNot } kind = Kind::kFalse;
    std::uint32_t support = 0;           // of kNegative, kPositive
    std::vector<ExpressionId> operands;  // of the others; kOdd: an odd number of them
};

class Formulas {
public:
    Formulas();
    ExpressionId never() const { return 0; }
    ExpressionId always() const { return 1; }
    // Where f is negative; with e in it, for every e small enough.
    ExpressionId negative(const Form& f);
    // The support of f; `flipped` where f is negative on its positive side. Requires: f is not constant.
    std::uint32_t support(const Form& f, bool& flipped);
    ExpressionId negative(const Surd& s);
    ExpressionId positive(const Form& f) { return negative(-f); }
    ExpressionId positive(const Surd& s) { return negative(Surd{-s.a, -s.b, s.rho2}); }
    ExpressionId all(std::vector<ExpressionId> operands) { return add({Expression::Kind::kAll, 0, std::move(operands)}); }
    ExpressionId any(std::vector<ExpressionId> operands) { return add({Expression::Kind::kAny, 0, std::move(operands)}); }
    ExpressionId odd(std::vector<ExpressionId> operands) { return add({Expression::Kind::kOdd, 0, std::move(operands)}); }
    ExpressionId none(ExpressionId operand) { return add({Expression::Kind::kNot, 0, {operand}}); }

    const std::vector<Form>& supports() const { return supports_; }
    // Supports that agree in every coefficient, the largest scaled to 1, to within `relative` become the first of them. Returns how many were fused.
    int fuse(double relative);
    // The supports a formula reads, ascending, each once.
    std::vector<std::uint32_t> reads(ExpressionId e) const;
    // `signs` are the supports' signs: never 0 for a support that is read.
    bool holds(ExpressionId e, const std::vector<int>& signs) const;

private:
    ExpressionId add(Expression e);

    std::vector<Expression> expressions_;
    std::vector<Form> supports_;
    std::map<std::vector<std::pair<Monomial, std::pair<mpz_class, long>>>, std::uint32_t> by_terms_;
};

}  // namespace whittle::reference
