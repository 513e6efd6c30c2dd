// real_root.h — real algebraic numbers: the places where a polynomial with dyadic coefficients changes sign, isolated and compared exactly.
//
// Isolation by Sturm sequences of the square-free part, comparison by bisection with a greatest common divisor to recognise equality.
// Source: Yap, Fundamental Problems in Algorithmic Algebra (2000), chapters 6 and 7.
#pragma once

#include <utility>
#include <vector>

#include "tracer/engine/dyadic.h"

namespace whittle::exact {

// Coefficients of 1, t, t^2 ...; no trailing zeros. Empty: the zero polynomial.
using Polynomial = std::vector<Dyadic>;

void normalise(Polynomial& p);
int sign_at(const Polynomial& p, const Dyadic& t);
// Sign for t -> -infinity.
int sign_at_minus_infinity(const Polynomial& p);
// Greatest common divisor up to a factor.
Polynomial common_divisor(Polynomial a, Polynomial b);

// The only root of the square-free `p` in (lo, hi].
class RealRoot {
public:
    RealRoot(Polynomial square_free, Dyadic lo, Dyadic hi) : p_(std::move(square_free)), lo_(std::move(lo)), hi_(std::move(hi)) {}
    // A number that is no root of anything else: of x - t.
    static RealRoot at(const Dyadic& t) { return {{-t, Dyadic(1.0)}, t - Dyadic(1.0), t}; }
    // -1, 0, 1 as a is before, at, behind b.
    static int compare(RealRoot a, RealRoot b);
    // Sign of the number.
    int sign() const;
    // Nearest doubles: |t - root| <= error; error is at most two units in the last place of t.
    void approximate(double& t, double& error) const;
    const Polynomial& polynomial() const { return p_; }
    std::pair<Dyadic, Dyadic> interval() const { return {lo_, hi_}; }

private:
    void bisect();
    Polynomial p_;
    Dyadic lo_, hi_;
};

// Roots at which p changes sign, ascending.
std::vector<RealRoot> sign_changes(const Polynomial& p);

}  // namespace whittle::exact
