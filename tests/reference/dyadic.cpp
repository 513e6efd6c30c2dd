// dyadic.cpp — see dyadic.h.
#include "tests/reference/dyadic.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace whittle::reference {

Dyadic::Dyadic(double value) {
    assert(std::isfinite(value));
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    mantissa_ = std::ldexp(fraction, 53);
    exponent_ = exponent - 53;
    normalise();
}

Dyadic Dyadic::raw(mpz_class mantissa, long exponent) {
    Dyadic r;
    r.mantissa_ = std::move(mantissa);
    r.exponent_ = sgn(r.mantissa_) == 0 ? 0 : exponent;
    return r;
}

void Dyadic::normalise() {
    if (is_zero()) {
        exponent_ = 0;
        return;
    }
    const auto zeros = mpz_scan1(mantissa_.get_mpz_t(), 0);
    if (zeros == 0) return;
    mpz_tdiv_q_2exp(mantissa_.get_mpz_t(), mantissa_.get_mpz_t(), zeros);
    exponent_ += static_cast<long>(zeros);
}

double Dyadic::to_double() const {
    long exponent = 0;
    const double fraction = mpz_get_d_2exp(&exponent, mantissa_.get_mpz_t());
    return std::ldexp(fraction, static_cast<int>(std::clamp(exponent + exponent_, -5000L, 5000L)));
}

Dyadic Dyadic::operator+(const Dyadic& o) const {
    if (is_zero()) return o;
    if (o.is_zero()) return *this;
    const Dyadic& high = exponent_ >= o.exponent_ ? *this : o;
    const Dyadic& low = exponent_ >= o.exponent_ ? o : *this;
    mpz_class sum;
    mpz_mul_2exp(sum.get_mpz_t(), high.mantissa_.get_mpz_t(), static_cast<mp_bitcnt_t>(high.exponent_ - low.exponent_));
    sum += low.mantissa_;
    return {std::move(sum), low.exponent_};
}

Dyadic quotient_floor(const Dyadic& n, const Dyadic& d, long bits, Dyadic& ulp, bool& exact) {
    const auto width = [](const mpz_class& v) { return static_cast<long>(mpz_sizeinbase(v.get_mpz_t(), 2)); };
    const long shift = std::max(0L, bits + 1 + width(d.mantissa()) - width(n.mantissa()));
    mpz_class scaled, q, r;
    mpz_mul_2exp(scaled.get_mpz_t(), n.mantissa().get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    mpz_fdiv_qr(q.get_mpz_t(), r.get_mpz_t(), scaled.get_mpz_t(), d.mantissa().get_mpz_t());
    const long exponent = n.exponent() - d.exponent() - shift;
    ulp = Dyadic(mpz_class(1), exponent);
    exact = sgn(r) == 0;
    return {std::move(q), exponent};
}

Dyadic sqrt_floor(const Dyadic& a, long bits, Dyadic& ulp) {
    const long width = static_cast<long>(mpz_sizeinbase(a.mantissa().get_mpz_t(), 2));
    long shift = std::max(0L, 2 * bits + 2 - width);
    if ((a.exponent() - shift) % 2 != 0) ++shift;
    mpz_class scaled, root;
    mpz_mul_2exp(scaled.get_mpz_t(), a.mantissa().get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    mpz_sqrt(root.get_mpz_t(), scaled.get_mpz_t());
    const long exponent = (a.exponent() - shift) / 2;
    ulp = Dyadic(mpz_class(1), exponent);
    return {std::move(root), exponent};
}

}  // namespace whittle::reference
