// dyadic.h — exact numbers m·2^e: the ring that six doubles of a ray and twelve of a placement generate. The last tier of ordering.
//
// Only + - * and signs are needed: world coefficients come by the adjugate, orders by Sturm sequences, so nothing is ever divided.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include <gmpxx.h>

namespace whittle::exact {

class Dyadic {
public:
    Dyadic() = default;
    // Exact. Requires: v is finite.
    Dyadic(double v) {  // NOLINT: a double is a dyadic number
        if (v == 0) return;
        int e = 0;
        const double f = std::frexp(v, &e);
        mantissa_ = static_cast<long>(std::ldexp(f, 53));
        exponent_ = e - 53;
    }

    int sign() const { return sgn(mantissa_); }
    bool is_zero() const { return sign() == 0; }
    // Half of the number, or the number times 2^k.
    Dyadic scaled(long k) const {
        Dyadic r = *this;
        if (!is_zero()) r.exponent_ += k;
        return r;
    }
    // Nearest double up to one unit in the last place; may overflow to infinity.
    double approximate() const {
        if (is_zero()) return 0;
        long e = 0;
        const double f = mpz_get_d_2exp(&e, mantissa_.get_mpz_t());
        const long total = e + exponent_;
        if (total > 1100) return f > 0 ? HUGE_VAL : -HUGE_VAL;
        return std::ldexp(f, static_cast<int>(total < -1200 ? -1200 : total));
    }
    // floor(log2|x|) + 1. Requires: not zero.
    long bit_exponent() const { return static_cast<long>(mpz_sizeinbase(mantissa_.get_mpz_t(), 2)) + exponent_; }

    Dyadic operator-() const {
        Dyadic r = *this;
        r.mantissa_ = -r.mantissa_;
        return r;
    }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
        Dyadic r;
        r.mantissa_ = a.mantissa_ * b.mantissa_;
        r.exponent_ = a.exponent_ + b.exponent_;
        if (r.is_zero()) r.exponent_ = 0;
        return r;
    }
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, false); }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, true); }
    friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).is_zero(); }
    friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }
    friend bool operator<=(const Dyadic& a, const Dyadic& b) { return (a - b).sign() <= 0; }

    // Drops trailing zero bits, so that long chains of sums do not drag them along.
    void trim() {
        if (is_zero()) return;
        const auto zeros = mpz_scan1(mantissa_.get_mpz_t(), 0);
        if (zeros > 0) {
            mpz_tdiv_q_2exp(mantissa_.get_mpz_t(), mantissa_.get_mpz_t(), zeros);
            exponent_ += static_cast<long>(zeros);
        }
    }

private:
    static Dyadic sum(const Dyadic& a, const Dyadic& b, bool negate_b) {
        if (b.is_zero()) return a;
        if (a.is_zero()) return negate_b ? -b : b;
        const bool a_lower = a.exponent_ <= b.exponent_;
        const long low = a_lower ? a.exponent_ : b.exponent_;
        mpz_class x = a.mantissa_, y = b.mantissa_;
        if (a_lower) {
            y <<= static_cast<unsigned long>(b.exponent_ - low);
        } else {
            x <<= static_cast<unsigned long>(a.exponent_ - low);
        }
        Dyadic r;
        r.mantissa_ = negate_b ? mpz_class(x - y) : mpz_class(x + y);
        r.exponent_ = r.is_zero() ? 0 : low;
        return r;
    }

    mpz_class mantissa_;
    long exponent_ = 0;
};

}  // namespace whittle::exact
