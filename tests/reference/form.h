// form.h — polynomials in x, y, z with exact coefficients, and numbers A + B rho over them, rho the distance from the z axis.
//
// The supports of a solid are such polynomials in the root frame. A revolution's profile lives in (rho, z): what it compares are numbers A + B rho,
// whose sign follows from the signs of A, B and A^2 - B^2 rho^2.
#pragma once

#include <array>
#include <map>

#include "csg/base/vec.h"
#include "tests/reference/dyadic.h"

namespace whittle::reference {

// Exponents of x, y, z, and of e: positive, and less than any number. A section is the solid at the height e.
using Monomial = std::array<int, 4>;

class Form {
public:
    Form() = default;
    Form(Dyadic constant) { add({}, constant); }
    Form(double constant) : Form(Dyadic(constant)) {}
    static Form variable(int axis);
    static Form infinitesimal() { return variable(3); }

    const std::map<Monomial, Dyadic>& terms() const { return terms_; }
    void add(const Monomial& monomial, const Dyadic& coefficient);
    bool is_zero() const { return terms_.empty(); }
    bool is_constant() const { return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first == Monomial{}); }
    int degree() const;
    // A form without e that has the same sign wherever it is not zero: the terms of the lowest power of e.
    Form leading() const;
    Form operator-() const { return Form() - *this; }
    friend Form operator+(Form a, const Form& b);
    friend Form operator-(Form a, const Form& b);
    friend Form operator*(const Form& a, const Form& b);

private:
    std::map<Monomial, Dyadic> terms_;  // no zero coefficient
};

// a + b rho with rho >= 0 and rho^2 = rho2.
struct Surd {
    Form a, b;
    Form rho2;

    friend Surd operator+(const Surd& p, const Surd& q) { return {p.a + q.a, p.b + q.b, p.rho2}; }
    friend Surd operator-(const Surd& p, const Surd& q) { return {p.a - q.a, p.b - q.b, p.rho2}; }
    friend Surd operator*(const Surd& p, const Surd& q) { return {p.a * q.a + p.b * q.b * p.rho2, p.a * q.b + p.b * q.a, p.rho2}; }
    friend Surd operator*(const Dyadic& p, const Surd& q) { return {Form(p) * q.a, Form(p) * q.b, q.rho2}; }
};

inline Form operator*(const Dyadic& p, const Form& q) { return Form(p) * q; }

// A point x/w, y/w, z/w with w > 0.
struct FormPoint {
    Form x, y, z, w;
};
inline FormPoint root_frame_point() { return {Form::variable(0), Form::variable(1), Form::variable(2), Form(1.0)}; }

template <class Number>
struct FlatPoint {
    Number x, y, w;
};

// An affine map with exact entries, rows of (linear | offset).
using Matrix = std::array<Dyadic, 12>;

Matrix exact(const Placement& placement);
Matrix operator*(const Matrix& outer, const Matrix& inner);
// Each entry to the nearest double, ties to even.
Matrix rounded(const Matrix& m);
Dyadic determinant(const Matrix& m);
// The point in the frame that `m` places. Requires a determinant other than 0.
FormPoint pulled_back(const FormPoint& p, const Matrix& m);

// The same in the plane: rows and columns x, y of `m`. Zero determinant must not happen.
template <class Number>
FlatPoint<Number> pulled_back(const FlatPoint<Number>& p, const Matrix& m) {
    const Dyadic det = m[0] * m[5] - m[1] * m[4];
    const Number x = p.x - m[3] * p.w, y = p.y - m[7] * p.w;
    const Dyadic s = det.sign() < 0 ? Dyadic(-1.0) : Dyadic(1.0);
    return {(s * m[5]) * x - (s * m[1]) * y, (s * m[0]) * y - (s * m[4]) * x, (s * det) * p.w};
}

}  // namespace whittle::reference
