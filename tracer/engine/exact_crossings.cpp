// exact_crossings.cpp — the double-double and the exact tier.
#include "tracer/engine/exact_crossings.h"

#include <algorithm>
#include <cmath>

#include "tracer/engine/bounded.h"
#include "tracer/engine/fine_quartic.h"
#include "tracer/engine/nudged.h"
#include "tracer/engine/turned.h"
#include "tracer/engine/turned_function.h"

namespace whittle {

namespace {

using exact::Dyadic;
using exact::Nudged;
using exact::Polynomial;

template <class N>
LinePolynomial<N> polynomial_of(const Support& s, const Frame& frame, const std::array<N, 3>& origin, const Vec3& direction) {
    const FrameLine<N> line = line_in_frame<N>(frame, origin, direction);
    return is_turned(s.kind) ? turned::polynomial(s, *frame.twist, line) : support_polynomial(s, line);
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

namespace {

// Of turned sides only what lies between counts.
void keep_within(const TurnedWindow& window, std::vector<exact::RealRoot>& roots, std::int8_t& first_sign) {
    const auto is_at_most = [](const exact::RealRoot& root, double t) { return exact::RealRoot::compare(root, exact::RealRoot::at(Dyadic(t))) <= 0; };
    while (!roots.empty() && !is_at_most(roots.back(), window.to)) roots.pop_back();
    while (!roots.empty() && is_at_most(roots.front(), window.from)) {
        roots.erase(roots.begin());
        first_sign = static_cast<std::int8_t>(-first_sign);
    }
}

}  // namespace

std::vector<exact::RealRoot> exact_crossings(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out) {
    TurnedWindow window;
    const bool windowed = is_turned(support.kind) && turned_window(*frame.twist, ray_in_frame(frame, ray), window);
    if (window.empty) {
        out.count = 0;
        out.first_sign = static_cast<std::int8_t>(sign_out_of_reach(support, *frame.twist));
        return {};
    }
    const Polynomial p = exact_polynomial(support, frame, ray, leaving && !(windowed && !window.holds_origin()));
    auto roots = exact::sign_changes(p);
    out.first_sign = static_cast<std::int8_t>(p.empty() ? 1 : exact::sign_at_minus_infinity(p));
    if (windowed) keep_within(window, roots, out.first_sign);
    out.count = static_cast<std::int8_t>(roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) roots[i].approximate(out.t[i], out.error[i]);
    return roots;
}

namespace {

struct FineRoots {
    std::array<Bounded, 4> t;
    int count = 0, first_sign = 1;
};

bool certain_nonzero(const Bounded& x) { return x.is_certain() && x.sign() != 0; }

// The torus seen from near its closest approach; from the origin where the ray leaves it.
bool fine_torus(const Support& s, const Frame& frame, const Ray& ray, bool leaving, FineRoots& out) {
    auto origin = origin_of<Bounded>(ray);
    FrameLine<Bounded> line = line_in_frame<Bounded>(frame, origin, ray.direction);
    double along = 0, dd = 0, away = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        along += (s.p[i] * line.w.high() - line.o[i].high()) * line.d[i].high();
        dd += line.d[i].high() * line.d[i].high();
    }
    if (!(dd > 0)) return false;  // square to the plane of a section
    const double t0 = leaving ? 0 : along / dd;
    if (t0 != 0) {
        for (int i = 0; i < 3; ++i) origin[static_cast<std::size_t>(i)] = Bounded(ray.origin[i]) + Bounded(t0) * Bounded(ray.direction[i]);
        line = line_in_frame<Bounded>(frame, origin, ray.direction);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = line.o[i].high() - s.p[i] * line.w.high();
        away += x * x;
    }
    // Roots lie in the torus's ball.
    const double reach = (std::sqrt(away) + (s.p[3] + s.p[4]) * line.w.high()) / std::sqrt(dd);
    auto p = support_polynomial(s, line);
    if (leaving) p.c = {p.c[1], p.c[2], p.c[3], p.c[4], Bounded()};
    if (!fine_quartic_roots(p.c, reach, out.t, out.count) || out.count % 2 != (leaving ? 1 : 0)) return false;
    for (std::size_t i = 0; i < 4 && t0 != 0; ++i) out.t[i] = Bounded(t0) + out.t[i];
    out.first_sign = 1;
    if (!leaving) return true;
    std::size_t at = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(out.count); ++i) {
        if (!certain_nonzero(out.t[i])) return false;
        if (out.t[i].sign() < 0) at = i + 1;
    }
    std::move_backward(out.t.begin() + at, out.t.begin() + out.count, out.t.begin() + out.count + 1);
    out.t[at] = Bounded();
    ++out.count;
    return true;
}

bool fine_roots(const Support& support, const Frame& frame, const Ray& ray, bool leaving, FineRoots& out) {
    if (support.kind == SupportKind::kTorus) return fine_torus(support, frame, ray, leaving, out);
    auto p = polynomial_of<Bounded>(support, frame, origin_of<Bounded>(ray), ray.direction);
    if (leaving) p.c[0] = Bounded();
    const Bounded &c = p.c[0], &b = p.c[1], &a = p.c[2];
    if (p.degree == 1 || a.is_zero()) {
        if (b.is_zero()) {
            out.first_sign = c.sign();
            return certain_nonzero(c);
        }
        if (!certain_nonzero(b)) return false;
        out.first_sign = -b.sign();
        out.count = 1;
        out.t[0] = -c / b;
        return true;
    }
    if (!certain_nonzero(a)) return false;
    const Bounded disc = b * b - Bounded(4.0) * a * c;
    if (!certain_nonzero(disc)) return false;
    out.first_sign = a.sign();
    if (disc.sign() < 0) return true;
    if (!b.is_certain()) return false;
    const Bounded h = square_root(disc);
    const Bounded m = b.sign() >= 0 ? -(b + h) : h - b;
    if (!certain_nonzero(m)) return false;
    // The roots are m / 2a and 2c / m; which is the lesser follows from the signs alone.
    const std::size_t at = (b.sign() >= 0) == (a.sign() > 0) ? 0 : 1;
    out.count = 2;
    out.t[at] = m / (Bounded(2.0) * a);
    out.t[1 - at] = Bounded(2.0) * c / m;
    return true;
}

}  // namespace

bool fine_crossings(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out) {
    FineRoots roots;
    if (!fine_roots(support, frame, ray, leaving, roots)) return false;
    out.first_sign = static_cast<std::int8_t>(roots.first_sign);
    out.count = static_cast<std::int8_t>(roots.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(roots.count); ++i) {
        const Bounded& t = roots.t[i];
        out.t[i] = t.high();
        out.error[i] = t.error() + kUnitRoundoff * std::abs(t.high()) * (1 + 0x1p-40);
        if (!std::isfinite(t.high()) || !std::isfinite(out.error[i])) return false;
    }
    return true;
}

bool fine_crossing(const Support& support, const Frame& frame, const Ray& ray, bool leaving, int index, double& high, double& low, double& error) {
    FineRoots roots;
    if (!fine_roots(support, frame, ray, leaving, roots) || index >= roots.count) return false;
    const Bounded& t = roots.t[static_cast<std::size_t>(index)];
    high = t.high();
    low = t.low();
    error = t.error();
    return std::isfinite(high) && std::isfinite(error);
}

}  // namespace whittle
