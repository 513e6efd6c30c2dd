// roots.cpp — real roots of exact polynomials (polynomial.h).
#include <algorithm>
#include <cassert>

#include "tests/reference/polynomial.h"

namespace whittle::reference {

namespace {

using Shared = std::shared_ptr<const Polynomial>;

// n/d as a root of `of`, at most 2^-bits wide.
Root quotient_root(Shared of, const Dyadic& n, const Dyadic& d, long bits) {
    if (n.is_zero()) return {std::move(of), {}, {}};
    Dyadic ulp;
    bool exact = false;
    const Dyadic q = quotient_floor(n, d, bits, ulp, exact);
    return {std::move(of), q, exact ? q : q + ulp};
}

Root linear_root(const Polynomial& p, long bits) {
    return quotient_root(std::make_shared<Polynomial>(p), -p[0], p[1], bits);
}

// n/d for n in [n_lo, n_hi] and d in [d_lo, d_hi], neither holding 0.
Root interval_quotient(Shared of, const Dyadic n[2], const Dyadic d[2], long bits) {
    Root r{of, {}, {}};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const Root q = quotient_root(of, n[i], d[j], bits);
            if (i + j == 0 || q.lo < r.lo) r.lo = q.lo;
            if (i + j == 0 || r.hi < q.hi) r.hi = q.hi;
        }
    if (of->sign_at(r.lo) == 0) r.hi = r.lo;
    else if (of->sign_at(r.hi) == 0) r.lo = r.hi;
    return r;
}

std::vector<Root> quadratic_roots(const Polynomial& p, long bits) {
    const Dyadic &c = p[0], &b = p[1], &a = p[2];
    const Dyadic discriminant = b * b - (a * c).scaled(2);
    if (discriminant.sign() < 0) return {};
    if (discriminant.is_zero()) return {linear_root(p.derivative().primitive(), bits)};
    const auto shared = std::make_shared<const Polynomial>(p);
    std::vector<Root> roots;
    if (c.is_zero()) {
        roots = {Root{shared, {}, {}}, linear_root(Polynomial({b, a}), bits)};
    } else {
        // q = -(b + sign(b) sqrt D) / 2 has no cancellation; the roots are q/a and c/q. The gap is sqrt(D)/a: resolve it to `bits` as well.
        const long gap = b.is_zero() ? 0 : std::max(0L, b.top() - discriminant.top() / 2);
        const long precision = bits + gap + 8;
        Dyadic ulp;
        const Dyadic root = sqrt_floor(discriminant, precision, ulp);
        const Dyadic far = abs(b) + root;
        const bool negative = b.sign() >= 0;
        Dyadic q[2] = {far.scaled(-1), (far + ulp).scaled(-1)};
        if (negative) q[0] = -q[0], q[1] = -q[1];
        const Dyadic aa[2] = {a, a}, cc[2] = {c, c};
        roots = {interval_quotient(shared, q, aa, precision), interval_quotient(shared, cc, q, precision)};
    }
    if (roots[1].lo < roots[0].lo) std::swap(roots[0], roots[1]);
    assert(roots[0].hi < roots[1].lo);
    return roots;
}

class Sturm {
public:
    explicit Sturm(const Polynomial& p) {
        sequence_ = {p, p.derivative().primitive()};
        while (sequence_.back().degree() > 0) {
            const Polynomial r = remainder(sequence_[sequence_.size() - 2], sequence_.back());
            sequence_.push_back(Dyadic(-1.0) * r);
        }
    }
    int variations(const Dyadic& t) const {
        int count = 0, last = 0;
        for (const Polynomial& p : sequence_) {
            const int s = p.sign_at(t);
            if (s != 0 && last != 0 && s != last) ++count;
            if (s != 0) last = s;
        }
        return count;
    }

private:
    std::vector<Polynomial> sequence_;
};

// A point strictly between, near the middle, where p does not vanish.
Dyadic split(const Polynomial& p, const Dyadic& lo, const Dyadic& hi) {
    Dyadic at = middle(lo, hi);
    for (Dyadic step = (hi - lo).scaled(-4); p.sign_at(at) == 0; step = step.scaled(-1)) at += step;
    return at;
}

void isolate(const Shared& p, const Sturm& sturm, const Dyadic& lo, const Dyadic& hi, int at_lo, int at_hi, std::vector<Root>& out) {
    if (at_lo == at_hi) return;
    if (at_lo - at_hi == 1) {
        out.push_back({p, lo, hi});
        return;
    }
    const Dyadic m = split(*p, lo, hi);
    const int at_m = sturm.variations(m);
    isolate(p, sturm, lo, m, at_lo, at_m, out);
    isolate(p, sturm, m, hi, at_m, at_hi, out);
}

bool is_narrow(const Root& r, long bits) {
    if (r.is_known()) return true;
    if (r.lo.sign() * r.hi.sign() <= 0) return false;
    const Dyadic& nearer = r.lo.sign() > 0 ? r.lo : r.hi;
    return (r.hi - r.lo).scaled(bits) <= abs(nearer);
}

// Abbott's step: the cell of 2^-k of the interval in which the secant through the ends expects the root; false if it is not there.
bool secant_step(Root& r, long k) {
    const Dyadic at_lo = abs(r.of->at(r.lo)), at_hi = abs(r.of->at(r.hi));
    Dyadic ulp;
    bool exact = false;
    const Dyadic share = quotient_floor(at_lo, at_lo + at_hi, k + 64, ulp, exact).scaled(k);
    mpz_class index;
    if (share.exponent() >= 0) mpz_mul_2exp(index.get_mpz_t(), share.mantissa().get_mpz_t(), static_cast<mp_bitcnt_t>(share.exponent()));
    else mpz_fdiv_q_2exp(index.get_mpz_t(), share.mantissa().get_mpz_t(), static_cast<mp_bitcnt_t>(-share.exponent()));
    const Dyadic width = (r.hi - r.lo).scaled(-k);
    Dyadic lo = r.lo + Dyadic(index, 0) * width;
    for (int i = 0; i < 2; ++i) {
        const Dyadic hi = lo + width;
        const int s_lo = r.of->sign_at(lo), s_hi = r.of->sign_at(hi);
        if (s_lo * s_hi < 0 && r.lo <= lo && hi <= r.hi) {
            r.lo = lo, r.hi = hi;
            return true;
        }
        lo = lo - width;
    }
    return false;
}

void narrow(Root& r, long bits) {
    long k = 2;
    while (!is_narrow(r, bits)) {
        if (r.lo.sign() * r.hi.sign() > 0 && secant_step(r, k)) {
            k = std::min(2 * k, bits);
        } else {
            r.halve();
            k = std::max(2L, k / 2);
        }
    }
}

std::vector<Root> sturm_roots(const Polynomial& p, long bits) {
    const auto shared = std::make_shared<const Polynomial>(p);
    const Sturm sturm(p);
    long bound = 1;  // Cauchy: every root is below 1 + max |c_i / c_n|
    for (int i = 0; i < p.degree(); ++i)
        if (!p[i].is_zero()) bound = std::max(bound, p[i].top() - p[p.degree()].top() + 3);
    const Dyadic limit(mpz_class(1), bound);
    std::vector<Root> roots;
    isolate(shared, sturm, -limit, limit, sturm.variations(-limit), sturm.variations(limit), roots);
    for (Root& r : roots) narrow(r, bits);
    return roots;
}

// True if a and b, whose intervals overlap, are one number.
bool is_common(const Root& a, const Root& b) {
    const Polynomial g = common_divisor(*a.of, *b.of);
    if (g.degree() <= 0) return false;
    const Dyadic& lo = a.lo < b.lo ? b.lo : a.lo;
    const Dyadic& hi = a.hi < b.hi ? a.hi : b.hi;
    return g.sign_at(lo) * g.sign_at(hi) < 0;
}

}  // namespace

void Root::halve() {
    if (is_known()) return;
    const Dyadic m = middle(lo, hi);
    const int s = of->sign_at(m);
    if (s == 0) lo = hi = m;
    else if (s == of->sign_at(lo)) lo = m;
    else hi = m;
}

std::vector<Root> real_roots(const Polynomial& p, long bits) {
    if (p.degree() <= 0) return {};
    if (p.degree() == 1) return {linear_root(p, bits)};
    if (p.degree() == 2) return quadratic_roots(p.primitive(), bits);
    const Polynomial reduced = square_free(p);
    if (reduced.degree() < 3) return real_roots(reduced, bits);
    if (!reduced[0].is_zero()) return sturm_roots(reduced, bits);
    std::vector<Dyadic> rest;
    for (int i = 1; i <= reduced.degree(); ++i) rest.push_back(reduced[i]);
    std::vector<Root> roots = real_roots(Polynomial(std::move(rest)), bits);
    const auto after = std::find_if(roots.begin(), roots.end(), [](const Root& r) { return r.lo.sign() > 0; });
    roots.insert(after, Root{std::make_shared<Polynomial>(reduced), {}, {}});
    return roots;
}

std::strong_ordering compare(Root& a, Root& b) {
    bool may_be_equal = true;
    while (true) {
        if (a.is_known() && b.is_known()) return (a.lo - b.lo).sign() <=> 0;
        if (a.hi <= b.lo) return std::strong_ordering::less;
        if (b.hi <= a.lo) return std::strong_ordering::greater;
        if (a.is_known() && b.of->sign_at(a.lo) == 0) return std::strong_ordering::equal;
        if (b.is_known() && a.of->sign_at(b.lo) == 0) return std::strong_ordering::equal;
        if (may_be_equal && !a.is_known() && !b.is_known() && is_common(a, b)) return std::strong_ordering::equal;
        may_be_equal = false;
        a.halve();
        b.halve();
    }
}

}  // namespace whittle::reference
