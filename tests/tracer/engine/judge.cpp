// judge.cpp — see judge.h.
#include "tests/tracer/engine/judge.h"

#include <fmt/format.h>

namespace whittle::testing {

namespace {

reference::Dyadic converted(const Wide& x) {
    mpz_class m;
    if (!x.is_zero()) mpz_import(m.get_mpz_t(), x.size(), -1, sizeof(mp_limb_t), 0, 0, x.limbs());
    if (x.sign() < 0) m = -m;
    return reference::Dyadic(m, 64 * x.exponent());
}

Wide horner(const Judgement& j, const Wide& t) {
    Wide value = j.p.c[static_cast<std::size_t>(j.degree)];
    for (int k = j.degree; k-- > 0;) value = value * t + j.p.c[static_cast<std::size_t>(k)];
    return value;
}

int slope_sign(const Judgement& j, const Wide& t) {
    Wide value;
    for (int k = j.degree; k > 0; --k) value = value * t + j.p.c[static_cast<std::size_t>(k)] * Wide(static_cast<double>(k));
    return value.sign();
}

// Is |a| <= 2^-50 |b|?
bool is_small(const Wide& a, const Wide& b) {
    if (a.is_zero()) return true;
    long ea = 0, eb = 0;
    const double fa = std::abs(a.parts(ea)), fb = std::abs(b.parts(eb));
    return ea - eb < -49 && std::ldexp(fa, static_cast<int>(std::max(-2000L, ea - eb))) <= 0x1p-50 * fb;
}

void judge_quadratic(Judgement& j) {
    const Wide bb = j.p.c[1] * j.p.c[1], disc = bb - Wide(4.0) * j.p.c[2] * j.p.c[0];
    j.count = disc.sign() > 0 ? 2 : 0;
    j.simple = disc.sign() != 0;
    j.tangent = is_small(disc, bb);
}

// Real roots of a quartic by the signs of its invariants (Rees, Graphical discussion of the roots of a quartic equation, 1922).
void judge_quartic(Judgement& j) {
    const auto& [e, d, c, b, a] = j.p.c;
    const Wide bd = b * d, ae = a * e, cc = c * c, bb = b * b;
    const Wide delta0 = cc - Wide(3.0) * bd + Wide(12.0) * ae;
    const Wide delta1 = Wide(2.0) * cc * c - Wide(9.0) * bd * c + Wide(27.0) * (bb * e + a * d * d) - Wide(72.0) * ae * c;
    const Wide square = delta1 * delta1, difference = Wide(4.0) * delta0 * delta0 * delta0 - square;
    const int sign = difference.sign();
    j.simple = sign != 0;
    j.tangent = is_small(difference, square);
    j.count = 2;
    if (sign <= 0) return;
    const Wide aa = a * a, ac = a * c;
    const Wide p = Wide(8.0) * ac - Wide(3.0) * bb;
    const Wide q = Wide(64.0) * aa * ae - Wide(16.0) * aa * cc + Wide(16.0) * ac * bb - Wide(16.0) * aa * bd - Wide(3.0) * bb * bb;
    j.count = p.sign() < 0 && q.sign() < 0 ? 4 : 0;
}

std::string slow_fault(const Judgement& truth, const Crossings& claimed) {
    const auto roots = exact_roots(truth);
    if (static_cast<int>(roots.size()) != claimed.count) return fmt::format("{} crossings instead of {}", claimed.count, roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const reference::Dyadic t(claimed.t[i]), e(claimed.error[i]);
        if (!(roots[i].lo <= t + e && t - e <= roots[i].hi))
            return fmt::format("crossing {} at {:.17g} is off by {:.3g}, error {:.3g}", i, claimed.t[i], (t - roots[i].lo).to_double(), claimed.error[i]);
    }
    return {};
}

// Does each interval t -+ error hold the change of sign that is its turn, and lie behind the one before? Then one root each, since there are no more.
bool intervals_prove(const Judgement& truth, const Crossings& claimed) {
    int before = truth.first_sign;
    for (std::size_t i = 0; i < static_cast<std::size_t>(claimed.count); ++i, before = -before) {
        const double t = claimed.t[i], e = claimed.error[i];
        if (!std::isfinite(t) || !std::isfinite(e) || e < 0) return false;
        const Wide lo = Wide(t) - Wide(e), hi = Wide(t) + Wide(e);
        if (e == 0) {
            if (horner(truth, lo).sign() != 0 || slope_sign(truth, lo) != -before) return false;
        } else if (horner(truth, lo).sign() != before || horner(truth, hi).sign() != -before) {
            return false;
        }
        if (i > 0 && (lo - (Wide(claimed.t[i - 1]) + Wide(claimed.error[i - 1]))).sign() <= 0) return false;
    }
    return true;
}

}  // namespace

Judgement judged(const Support& support, const Frame& frame, const Ray& ray, bool leaving) {
    Judgement j;
    const std::array<Wide, 3> origin{Wide(ray.origin.x), Wide(ray.origin.y), Wide(ray.origin.z)};
    j.p = support_polynomial(support, line_in_frame<Wide>(frame, origin, ray.direction));
    if (leaving) j.p.c[0] = Wide();
    j.degree = j.p.degree;
    while (j.degree >= 0 && j.p.c[static_cast<std::size_t>(j.degree)].is_zero()) --j.degree;
    if (j.degree < 0) return j;
    j.first_sign = j.p.c[static_cast<std::size_t>(j.degree)].sign() * (j.degree % 2 == 0 ? 1 : -1);
    if (j.degree == 1) j.count = 1;
    if (j.degree == 2) judge_quadratic(j);
    if (j.degree == 4) judge_quartic(j);
    if (j.degree == 3 || (!j.simple && j.degree == 4)) {
        j.simple = false;
        j.count = static_cast<int>(exact_roots(j).size());
    }
    return j;
}

std::vector<reference::Root> exact_roots(const Judgement& truth) {
    std::vector<reference::Dyadic> c;
    for (int k = 0; k <= truth.degree; ++k) c.push_back(converted(truth.p.c[static_cast<std::size_t>(k)]));
    const reference::Polynomial p(std::move(c));
    std::vector<reference::Root> odd;
    if (p.degree() < 1) return odd;
    const auto all = reference::real_roots(p, 200);
    int before = truth.first_sign;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto behind = i + 1 < all.size() ? reference::middle(all[i].hi, all[i + 1].lo) : all[i].hi + reference::abs(all[i].hi) + reference::Dyadic(1.0);
        const int after = p.sign_at(behind);
        if (after != before) odd.push_back(all[i]);
        before = after;
    }
    return odd;
}

std::string fault_of(const Judgement& truth, const Crossings& claimed) {
    if (truth.degree < 0) return {};
    if (claimed.first_sign != truth.first_sign) return "another first sign";
    if (claimed.count != truth.count) return fmt::format("{} crossings instead of {}", claimed.count, truth.count);
    if (truth.simple && intervals_prove(truth, claimed)) return {};
    return slow_fault(truth, claimed);
}

double error_share(reference::Root root, double t, double error) {
    const double off = std::abs((reference::Dyadic(t) - root.lo).to_double());
    return off / error;
}

}  // namespace whittle::testing
