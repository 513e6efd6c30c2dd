// real_root.cpp — isolation, refinement and comparison of the roots of dyadic polynomials.
#include "tracer/engine/real_root.h"

#include <algorithm>

namespace whittle::exact {

void normalise(Polynomial& p) {
    while (!p.empty() && p.back().is_zero()) p.pop_back();
    for (Dyadic& c : p) c.trim();
}

int sign_at(const Polynomial& p, const Dyadic& t) {
    Dyadic value;
    for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
    return value.sign();
}

int sign_at_minus_infinity(const Polynomial& p) {
    if (p.empty()) return 0;
    const int s = p.back().sign();
    return p.size() % 2 == 1 ? s : -s;
}

namespace {

Polynomial derivative(const Polynomial& p) {
    Polynomial r;
    for (std::size_t i = 1; i < p.size(); ++i) r.push_back(p[i] * Dyadic(static_cast<double>(i)));
    return r;
}

// The remainder of a by b times a positive number.
Polynomial positive_remainder(Polynomial a, const Polynomial& b) {
    const Dyadic lead = b.back();
    const bool negative = lead.sign() < 0;
    while (a.size() >= b.size()) {
        const Dyadic top = a.back();
        const std::size_t shift = a.size() - b.size();
        for (Dyadic& c : a) c = negative ? -(c * lead) : c * lead;
        for (std::size_t i = 0; i < b.size(); ++i) {
            const Dyadic part = top * b[i];
            a[shift + i] = negative ? a[shift + i] + part : a[shift + i] - part;
        }
        a.pop_back();
        normalise(a);
        if (a.empty()) break;
    }
    return a;
}

// a divided by b up to a positive factor. Requires: b divides a.
Polynomial quotient(Polynomial a, const Polynomial& b) {
    const Dyadic lead = b.back();
    Polynomial q(a.size() - b.size() + 1);
    while (a.size() >= b.size()) {
        const Dyadic top = a.back();
        const std::size_t shift = a.size() - b.size();
        for (Dyadic& c : a) c = c * lead;
        for (Dyadic& c : q) c = c * lead;
        q[shift] = top;
        for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] = a[shift + i] - top * b[i];
        a.pop_back();
        normalise(a);
        if (a.empty()) break;
    }
    normalise(q);
    return q;
}

std::vector<Polynomial> sturm_chain(const Polynomial& p) {
    std::vector<Polynomial> chain{p, derivative(p)};
    while (chain.back().size() > 1) {
        Polynomial r = positive_remainder(chain[chain.size() - 2], chain.back());
        if (r.empty()) break;
        for (Dyadic& c : r) c = -c;
        chain.push_back(std::move(r));
    }
    return chain;
}

int variations(const std::vector<Polynomial>& chain, const Dyadic& t) {
    int count = 0, last = 0;
    for (const Polynomial& p : chain) {
        const int s = sign_at(p, t);
        if (s != 0 && last != 0 && s != last) ++count;
        if (s != 0) last = s;
    }
    return count;
}

int roots_between(const std::vector<Polynomial>& chain, const Dyadic& lo, const Dyadic& hi) { return variations(chain, lo) - variations(chain, hi); }

Dyadic middle(const Dyadic& a, const Dyadic& b) {
    Dyadic m = (a + b).scaled(-1);
    m.trim();
    return m;
}

// A power of two beyond all roots (Cauchy).
Dyadic root_bound(const Polynomial& p) {
    long most = -1000000;
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        if (!p[i].is_zero()) most = std::max(most, p[i].bit_exponent() - p.back().bit_exponent() + 1);
    return Dyadic(1.0).scaled(std::max(most, 0L) + 1);
}

void isolate(const Polynomial& p, const std::vector<Polynomial>& chain, const Dyadic& lo, const Dyadic& hi, int count, std::vector<RealRoot>& out) {
    if (count == 0) return;
    if (count == 1) {
        out.emplace_back(p, lo, hi);
        return;
    }
    const Dyadic m = middle(lo, hi);
    const int left = roots_between(chain, lo, m);
    isolate(p, chain, lo, m, left, out);
    isolate(p, chain, m, hi, count - left, out);
}

// How often the root of `root` is a root of p. Requires: it is one of the square-free part of p.
int multiplicity(const RealRoot& root, Polynomial p, const Dyadic& lo, const Dyadic& hi) {
    int m = 1;
    while (true) {
        p = common_divisor(p, derivative(p));
        if (p.size() < 2) return m;
        const Polynomial shared = common_divisor(p, root.polynomial());
        if (shared.size() < 2 || roots_between(sturm_chain(shared), lo, hi) == 0) return m;
        ++m;
    }
}

}  // namespace

Polynomial common_divisor(Polynomial a, Polynomial b) {
    normalise(a);
    normalise(b);
    while (!b.empty()) {
        if (a.size() < b.size()) std::swap(a, b);
        Polynomial r = positive_remainder(std::move(a), b);
        a = std::move(b);
        b = std::move(r);
    }
    return a;
}

void RealRoot::bisect() {
    const Dyadic m = middle(lo_, hi_);
    const int at = sign_at(p_, m);
    if (at == 0) {
        // Exactly there: (m - w, m] with a width that keeps halving.
        lo_ = middle(lo_, m);
        hi_ = m;
        return;
    }
    const int high = sign_at(p_, hi_);
    if (high == 0 || high != at) {
        lo_ = m;
    } else {
        hi_ = m;
    }
}

int RealRoot::compare(RealRoot a, RealRoot b) {
    constexpr int kStepsBeforeEqualityTest = 24;  // what double-double leaves is mostly equal; a few bits settle the rest
    for (int step = 0;; ++step) {
        if (a.hi_ <= b.lo_) return -1;
        if (b.hi_ <= a.lo_) return 1;
        if (step == kStepsBeforeEqualityTest) {
            const Polynomial shared = common_divisor(a.p_, b.p_);
            const Dyadic lo = a.lo_ < b.lo_ ? b.lo_ : a.lo_, hi = a.hi_ < b.hi_ ? a.hi_ : b.hi_;
            if (shared.size() >= 2 && roots_between(sturm_chain(shared), lo, hi) > 0) return 0;
        }
        a.bisect();
        b.bisect();
    }
}

int RealRoot::sign() const {
    RealRoot r = *this;
    if (r.p_[0].is_zero() && r.lo_.sign() < 0 && r.hi_.sign() >= 0) return 0;
    while (r.lo_.sign() < 0 && r.hi_.sign() > 0) r.bisect();
    return r.lo_.sign() >= 0 ? 1 : -1;
}

void RealRoot::approximate(double& t, double& error) const {
    constexpr long kBits = 58;
    RealRoot r = *this;
    while (true) {
        const Dyadic width = r.hi_ - r.lo_;
        if (r.hi_.is_zero() || r.lo_.is_zero() || r.lo_.sign() != r.hi_.sign()) {
            if (r.p_[0].is_zero() && r.lo_.sign() < 0 && r.hi_.sign() >= 0) {
                t = error = 0;
                return;
            }
        } else if (width.bit_exponent() + kBits < r.hi_.bit_exponent()) {
            break;
        }
        r.bisect();
    }
    t = r.hi_.approximate();
    error = std::abs(t) * 0x1.1p-52;
}

std::vector<RealRoot> sign_changes(const Polynomial& given) {
    Polynomial p = given;
    normalise(p);
    std::vector<RealRoot> all;
    if (p.size() < 2) return all;
    const Polynomial repeated = common_divisor(p, derivative(p));
    const bool simple = repeated.size() < 2;
    const Polynomial square_free = simple ? p : quotient(p, repeated);
    const auto chain = sturm_chain(square_free);
    const Dyadic bound = root_bound(square_free);
    isolate(square_free, chain, -bound, bound, roots_between(chain, -bound, bound), all);
    if (simple) return all;
    std::vector<RealRoot> odd;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [lo, hi] = all[i].interval();
        if (multiplicity(all[i], p, lo, hi) % 2 == 1) odd.push_back(all[i]);
    }
    return odd;
}

}  // namespace whittle::exact
