// polynomial.cpp — arithmetic of polynomial.h; the roots are in roots.cpp.
#include "tests/reference/polynomial.h"

#include <algorithm>
#include <cassert>

namespace whittle::reference {

Polynomial::Polynomial(std::vector<Dyadic> coefficients) : c_(std::move(coefficients)) {
    while (!c_.empty() && c_.back().is_zero()) c_.pop_back();
}

Dyadic Polynomial::at(const Dyadic& t) const {
    Dyadic value;
    for (auto c = c_.rbegin(); c != c_.rend(); ++c) value = value * t + *c;
    return value;
}

Polynomial Polynomial::derivative() const {
    std::vector<Dyadic> d;
    for (int i = 1; i <= degree(); ++i) d.push_back(Dyadic(double(i)) * (*this)[i]);
    return Polynomial(std::move(d));
}

Polynomial Polynomial::primitive() const {
    if (is_zero()) return {};
    long lowest = c_.back().exponent();
    mpz_class content = 0;
    for (const Dyadic& c : c_) {
        if (c.is_zero()) continue;
        lowest = std::min(lowest, c.exponent());
        content = gcd(content, c.mantissa());
    }
    std::vector<Dyadic> r;
    for (const Dyadic& c : c_) r.push_back(Dyadic(c.mantissa() / content, c.exponent()).scaled(-lowest));
    return Polynomial(std::move(r));
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    std::vector<Dyadic> r(std::max(a.c_.size(), b.c_.size()));
    for (std::size_t i = 0; i < r.size(); ++i) {
        if (i < a.c_.size()) r[i] += a.c_[i];
        if (i < b.c_.size()) r[i] += b.c_[i];
    }
    return Polynomial(std::move(r));
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    if (a.is_zero() || b.is_zero()) return {};
    std::vector<Dyadic> r(a.c_.size() + b.c_.size() - 1);
    for (std::size_t i = 0; i < a.c_.size(); ++i)
        for (std::size_t j = 0; j < b.c_.size(); ++j) r[i + j] += a.c_[i] * b.c_[j];
    return Polynomial(std::move(r));
}

Polynomial operator*(const Dyadic& a, const Polynomial& b) {
    std::vector<Dyadic> r;
    for (const Dyadic& c : b.c_) r.push_back(a * c);
    return Polynomial(std::move(r));
}

Polynomial remainder(const Polynomial& a, const Polynomial& b) {
    assert(!b.is_zero());
    Polynomial r = a;
    const Dyadic& lead = b[b.degree()];
    while (r.degree() >= b.degree()) {
        std::vector<Dyadic> c;  // |lead| * r - (+-r's lead) t^k b
        const int k = r.degree() - b.degree();
        const Dyadic top = lead.sign() < 0 ? -r[r.degree()] : r[r.degree()];
        for (int i = 0; i < r.degree(); ++i) {
            Dyadic v = abs(lead) * r[i];
            if (i >= k) v -= top * b[i - k];
            c.push_back(v);
        }
        r = Polynomial(std::move(c));
    }
    return r.primitive();
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
    while (!b.is_zero()) {
        Polynomial r = remainder(a, b);
        a = std::move(b);
        b = std::move(r);
    }
    return a.primitive();
}

Polynomial square_free(const Polynomial& p) {
    const Polynomial g = common_divisor(p, p.derivative());
    if (g.degree() <= 0) return p.primitive();
    std::vector<Dyadic> quotient(static_cast<std::size_t>(p.degree() - g.degree() + 1));
    Polynomial r = p;  // long division that multiplies the quotient so far by |lead| at each step
    const Dyadic& lead = g[g.degree()];
    for (int k = p.degree() - g.degree(); k >= 0; --k) {
        const Dyadic top = r.degree() == g.degree() + k ? r[r.degree()] : Dyadic();
        for (Dyadic& q : quotient) q = lead * q;
        quotient[static_cast<std::size_t>(k)] += top;
        std::vector<Dyadic> shifted(static_cast<std::size_t>(k));
        for (int i = 0; i <= g.degree(); ++i) shifted.push_back(-(top * g[i]));
        r = lead * r + Polynomial(std::move(shifted));
    }
    assert(r.is_zero());
    return Polynomial(std::move(quotient)).primitive();
}

}  // namespace whittle::reference
