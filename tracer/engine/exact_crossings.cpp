// exact_crossings.cpp — the double-double and the exact tier.
#include "tracer/engine/exact_crossings.h"

#include "tracer/engine/bounded.h"
#include "tracer/engine/nudged.h"

namespace whittle {

namespace {

using exact::Dyadic;
using exact::Nudged;
using exact::Polynomial;

template <class N>
LinePolynomial<N> polynomial_of(const Support& s, const Frame& frame, const std::array<N, 3>& origin, const Vec3& direction) {
    return support_polynomial(s, line_in_frame<N>(frame, origin, direction));
}

template <class N>
std::array<N, 3> origin_of(const Ray& ray) {
    return {N(ray.origin.x), N(ray.origin.y), N(ray.origin.z)};
}

Polynomial nudged_polynomial(const Support& support, const Frame& frame, const Ray& ray) {
    const auto p = polynomial_of<Nudged>(support, frame, exact::nudged_origin(ray), ray.direction);
    std::size_t most = 0;
    for (const Nudged& c : p.c) most = std::max(most, c.size());
    for (std::size_t power = 0; power < most; ++power) {
        Polynomial r;
        for (int k = 0; k <= p.degree; ++k) r.push_back(p.c[static_cast<std::size_t>(k)].at(power));
        exact::normalise(r);
        if (!r.empty()) return r;
    }
    return {};
}

}  // namespace

Polynomial exact_polynomial(const Support& support, const Frame& frame, const Ray& ray, bool leaving) {
    const auto p = polynomial_of<Dyadic>(support, frame, origin_of<Dyadic>(ray), ray.direction);
    Polynomial r(p.c.begin(), p.c.begin() + p.degree + 1);
    if (leaving) r[0] = Dyadic();
    exact::normalise(r);
    return r.empty() ? nudged_polynomial(support, frame, ray) : r;
}

std::vector<exact::RealRoot> exact_crossings(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out) {
    const Polynomial p = exact_polynomial(support, frame, ray, leaving);
    auto roots = exact::sign_changes(p);
    out.first_sign = static_cast<std::int8_t>(p.empty() ? 1 : exact::sign_at_minus_infinity(p));
    out.count = static_cast<std::int8_t>(roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) roots[i].approximate(out.t[i], out.error[i]);
    return roots;
}

bool fine_crossing(const Support& support, const Frame& frame, const Ray& ray, bool leaving, int index, double& high, double& low, double& error) {
    if (degree_of(support.kind) > 2) return false;
    auto p = polynomial_of<Bounded>(support, frame, origin_of<Bounded>(ray), ray.direction);
    if (leaving) p.c[0] = Bounded();
    const Bounded &c = p.c[0], &b = p.c[1], &a = p.c[2];
    const auto give = [&](const Bounded& t) {
        high = t.high();
        low = t.low();
        error = t.error();
        return std::isfinite(high) && std::isfinite(error);
    };
    if (p.degree == 1) return b.is_certain() && b.sign() != 0 && index == 0 && give(-c / b);
    if (!a.is_certain() || a.sign() == 0) return false;
    const Bounded disc = b * b - Bounded(4.0) * a * c;
    if (!disc.is_certain() || disc.sign() <= 0 || !b.is_certain()) return false;
    const Bounded h = square_root(disc);
    const Bounded m = b.sign() >= 0 ? -(b + h) : h - b;
    // The roots are m / 2a and 2c / m; which is the lesser follows from the signs alone.
    const bool m_is_lesser = (b.sign() >= 0) == (a.sign() > 0);
    if ((index == 0) == m_is_lesser) return give(m / (Bounded(2.0) * a));
    return m.is_certain() && m.sign() != 0 && give(Bounded(2.0) * c / m);
}

}  // namespace whittle
