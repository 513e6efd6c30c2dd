// polynomial.h — polynomials in t with exact coefficients, and their real roots: isolated, refined to any precision and compared exactly.
//
// Degree 1 and 2 by formula, higher by Sturm's sequence and bisection. Two roots are equal when the greatest common divisor of their
// polynomials has a root where they overlap.
//
// Source: Sturm (1829); Abbott, Quadratic interval refinement for real roots (2006).
#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "tests/reference/dyadic.h"

namespace whittle::reference {

// c[0] + c[1] t + ...; no leading zero; the zero polynomial is empty.
class Polynomial {
public:
    Polynomial() = default;
    explicit Polynomial(std::vector<Dyadic> coefficients);

    int degree() const { return static_cast<int>(c_.size()) - 1; }
    bool is_zero() const { return c_.empty(); }
    const Dyadic& operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }
    Dyadic at(const Dyadic& t) const;
    int sign_at(const Dyadic& t) const { return at(t).sign(); }
    Polynomial derivative() const;
    // A positive multiple with coprime integer coefficients: the same roots and signs, the smallest numbers.
    Polynomial primitive() const;

    friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator*(const Dyadic& a, const Polynomial& b);
    bool operator==(const Polynomial&) const = default;

private:
    std::vector<Dyadic> c_;
};

// A positive multiple of the remainder of a by b. Requires b != 0.
Polynomial remainder(const Polynomial& a, const Polynomial& b);
// Up to a constant factor; `b` may be zero.
Polynomial common_divisor(Polynomial a, Polynomial b);
// The same roots, each once; up to a constant factor.
Polynomial square_free(const Polynomial& p);

// A real root of a square-free polynomial: exactly lo == hi, or the only root in the open interval (lo, hi), where the signs at the ends differ.
struct Root {
    std::shared_ptr<const Polynomial> of;
    Dyadic lo, hi;

    bool is_known() const { return lo == hi; }
    bool is_zero() const { return is_known() && lo.is_zero(); }
    void halve();
};

// All distinct real roots in ascending order, their intervals disjoint, each at most 2^-bits of its |t| wide. Requires p != 0. A root at 0 is known.
std::vector<Root> real_roots(const Polynomial& p, long bits);

// Exact order; refines where it must.
std::strong_ordering compare(Root& a, Root& b);

}  // namespace whittle::reference
