// dyadic.h — exact numbers m * 2^e. Every double is one; sums, differences and products of them stay one, so the reference never rounds.
//
// Division is not needed: shapes are written homogeneously (x : y : z : w) and the roots of polynomials are kept as isolating intervals.
#pragma once

#include <gmpxx.h>

namespace whittle::reference {

class Dyadic {
public:
    Dyadic() = default;
    Dyadic(double value);  // exact; requires a finite value
    Dyadic(mpz_class mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) { normalise(); }

    const mpz_class& mantissa() const { return mantissa_; }
    long exponent() const { return exponent_; }
    int sign() const { return sgn(mantissa_); }
    bool is_zero() const { return sign() == 0; }
    // Position above the leading bit: 2^(top-1) <= |value| < 2^top. Requires a nonzero value.
    long top() const { return static_cast<long>(mpz_sizeinbase(mantissa_.get_mpz_t(), 2)) + exponent_; }
    // value * 2^shift.
    Dyadic scaled(long shift) const { return is_zero() ? Dyadic() : raw(mantissa_, exponent_ + shift); }
    // Towards zero, to 53 bits; infinite or 0 beyond double's range.
    double to_double() const;

    Dyadic operator-() const { return raw(-mantissa_, exponent_); }
    Dyadic operator+(const Dyadic& o) const;
    Dyadic operator-(const Dyadic& o) const { return *this + -o; }
    Dyadic operator*(const Dyadic& o) const { return raw(mantissa_ * o.mantissa_, exponent_ + o.exponent_); }
    Dyadic& operator+=(const Dyadic& o) { return *this = *this + o; }
    Dyadic& operator-=(const Dyadic& o) { return *this = *this - o; }
    bool operator==(const Dyadic& o) const { return exponent_ == o.exponent_ && mantissa_ == o.mantissa_; }
    bool operator<(const Dyadic& o) const { return (*this - o).sign() < 0; }
    bool operator<=(const Dyadic& o) const { return (*this - o).sign() <= 0; }

private:
    static Dyadic raw(mpz_class mantissa, long exponent);
    void normalise();  // odd mantissa, or 0 * 2^0: one form for each value

    mpz_class mantissa_ = 0;
    long exponent_ = 0;
};

inline Dyadic abs(const Dyadic& a) { return a.sign() < 0 ? -a : a; }
inline Dyadic middle(const Dyadic& a, const Dyadic& b) { return (a + b).scaled(-1); }

// A dyadic q with q <= n/d < q + 2^k at the k that gives at least `bits` leading bits. Requires d != 0 and n != 0. `exact` says q == n/d.
Dyadic quotient_floor(const Dyadic& n, const Dyadic& d, long bits, Dyadic& ulp, bool& exact);

// s with s <= sqrt(a) <= s + ulp, ulp <= 2^-bits * sqrt(a). Requires a > 0.
Dyadic sqrt_floor(const Dyadic& a, long bits, Dyadic& ulp);

}  // namespace whittle::reference
