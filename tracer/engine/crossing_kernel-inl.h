// crossing_kernel-inl.h — where lines meet planes, balls and cylinders: the one definition, for a single ray and for packets of rays.
//
// Written over N: a double, or a vector of doubles of whatever length a processor has. Only + - * / and square roots, each rounded once, no fused
// operations, so a ray gets the same bits alone, in a packet, and on every processor. Errors are running forward bounds; docs/numerics.md derives them.
// Included once by the single-ray engine and once per instruction set by the packets (Highway's way of compiling one text for several targets).
#if defined(WHITTLE_CROSSING_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WHITTLE_CROSSING_KERNEL_INL_H
#undef WHITTLE_CROSSING_KERNEL_INL_H
#else
#define WHITTLE_CROSSING_KERNEL_INL_H
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tracer/engine/support.h"

#ifdef HWY_NAMESPACE
#define WHITTLE_KERNEL_NAMESPACE HWY_NAMESPACE
#define WHITTLE_KERNEL_INLINE HWY_INLINE
HWY_BEFORE_NAMESPACE();
#else
#define WHITTLE_KERNEL_NAMESPACE single
#define WHITTLE_KERNEL_INLINE inline
#endif

namespace whittle::WHITTLE_KERNEL_NAMESPACE {

#ifdef HWY_NAMESPACE
namespace hn = hwy::HWY_NAMESPACE;
template <class N>
using MaskOf = hn::Mask<hn::DFromV<N>>;
template <class N>
WHITTLE_KERNEL_INLINE N lift(double x) { return hn::Set(hn::DFromV<N>(), x); }
template <class N>
WHITTLE_KERNEL_INLINE N magnitude(N x) { return hn::Abs(x); }
template <class N>
WHITTLE_KERNEL_INLINE N square_root(N x) { return hn::Sqrt(x); }
template <class N>
WHITTLE_KERNEL_INLINE N minus(N x) { return hn::Neg(x); }
template <class N, class M>
WHITTLE_KERNEL_INLINE N choose(M m, N yes, N no) { return hn::IfThenElse(m, yes, no); }
template <class M>
WHITTLE_KERNEL_INLINE M both(M a, M b) { return hn::And(a, b); }
template <class M>
WHITTLE_KERNEL_INLINE M either(M a, M b) { return hn::Or(a, b); }
template <class N, class M>
WHITTLE_KERNEL_INLINE bool all(M m) { return hn::AllTrue(hn::DFromV<N>(), m); }
#else
template <class N>
using MaskOf = bool;
template <class N>
WHITTLE_KERNEL_INLINE double lift(double x) { return x; }
WHITTLE_KERNEL_INLINE double magnitude(double x) { return std::abs(x); }
WHITTLE_KERNEL_INLINE double square_root(double x) { return std::sqrt(x); }
WHITTLE_KERNEL_INLINE double minus(double x) { return -x; }
WHITTLE_KERNEL_INLINE double choose(bool m, double yes, double no) { return m ? yes : no; }
WHITTLE_KERNEL_INLINE bool both(bool a, bool b) { return a && b; }
WHITTLE_KERNEL_INLINE bool either(bool a, bool b) { return a || b; }
template <class N>
WHITTLE_KERNEL_INLINE bool all(bool m) { return m; }
#endif

// u times k, as a constant of the kernel.
template <class N>
WHITTLE_KERNEL_INLINE N units(double k) { return lift<N>(k * 0x1p-53); }

// A line in a frame: |o - exact| <= eo, |d - exact| <= ed, by coordinate.
template <class N>
struct LocalLine {
    std::array<N, 3> o, d, eo, ed;
};

template <class N>
WHITTLE_KERNEL_INLINE LocalLine<N> line_in(const Frame& frame, const std::array<N, 3>& origin, const std::array<N, 3>& direction) {
    LocalLine<N> r;
    if (frame.identity) {
        r.o = origin;
        r.d = direction;
        r.eo = r.ed = {lift<N>(0), lift<N>(0), lift<N>(0)};
        return r;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        N o = lift<N>(0), d = lift<N>(0), so = lift<N>(0), sd = lift<N>(0);
        for (std::size_t j = 0; j < 3; ++j) {
            const N k = lift<N>(frame.inverse[3 * i + j]), from = origin[j] - lift<N>(frame.placement.offset(static_cast<int>(j)));
            const N x = k * from, y = k * direction[j];
            o = o + x;
            d = d + y;
            so = so + magnitude(x);
            sd = sd + magnitude(y);
        }
        r.o[i] = o;
        r.d[i] = d;
        // Inverse 4u, difference u, product u, two sums 2u, to first order; the rest is room.
        r.eo[i] = units<N>(12) * so;
        r.ed[i] = units<N>(12) * sd;
    }
    return r;
}

// A linear form along the ray: value v at its origin, slope s, with bounds.
template <class N>
struct LinearForm {
    N v, ev, s, es;
};

// The sum of n_i (x_i - a_i) - d, where n_i carries the error en_i.
template <class N, class Line>
WHITTLE_KERNEL_INLINE LinearForm<N> form_of(const std::array<double, 3>& n, const std::array<double, 3>& en, const std::array<double, 3>& a, double d,
                                            const Line& ray) {
    LinearForm<N> f{lift<N>(-d), lift<N>(0), lift<N>(0), lift<N>(0)};
    N size = lift<N>(std::abs(d)), slope_size = lift<N>(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const N q = ray.o[i] - lift<N>(a[i]), term = lift<N>(n[i]) * q, slope = lift<N>(n[i]) * ray.d[i];
        const N e = lift<N>(en[i]), most = lift<N>(std::abs(n[i]) + en[i]);
        f.v = f.v + term;
        f.s = f.s + slope;
        size = size + magnitude(term);
        slope_size = slope_size + magnitude(slope);
        f.ev = f.ev + (e * magnitude(q) + most * ray.eo[i]);
        f.es = f.es + (e * magnitude(ray.d[i]) + most * ray.ed[i]);
    }
    f.ev = f.ev * lift<N>(1 + 16 * 0x1p-53) + units<N>(6) * size;
    f.es = f.es * lift<N>(1 + 16 * 0x1p-53) + units<N>(4) * slope_size;
    return f;
}

// Requires: is_plane(s.kind).
template <class N, class Line>
WHITTLE_KERNEL_INLINE LinearForm<N> plane_form(const Support& s, const Line& ray) {
    constexpr double u = 0x1p-53;
    const auto& p = s.p;
    if (s.kind == SupportKind::kAxisPlane) {
        const N v = ray.o[s.axis] - lift<N>(p[0]);
        return {v, units<N>(1) * magnitude(v) + ray.eo[s.axis], ray.d[s.axis], ray.ed[s.axis]};
    }
    if (s.kind == SupportKind::kPlane) return form_of<N>({p[0], p[1], p[2]}, {0, 0, 0}, {0, 0, 0}, p[3], ray);
    std::array<double, 3> n{}, en{}, a{};
    if (s.kind == SupportKind::kEdgePlane) {
        const std::size_t i = (s.axis + 1u) % 3, j = (s.axis + 2u) % 3;
        n[i] = p[3] - p[1];
        n[j] = p[0] - p[2];
        a[i] = p[0];
        a[j] = p[1];
        en[i] = u * std::abs(n[i]);
        en[j] = u * std::abs(n[j]);
        return form_of<N>(n, en, a, 0, ray);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double aj = p[3 + j] - p[j], ak = p[3 + k] - p[k], bj = p[6 + j] - p[j], bk = p[6 + k] - p[k];
        const double x = aj * bk, y = ak * bj;
        n[i] = x - y;
        en[i] = 5 * u * (std::abs(x) + std::abs(y));
        a[i] = p[i];
    }
    return form_of<N>(n, en, a, 0, ray);
}

// One crossing (`met`), certainly none (`missed`), or neither: not decidable in double. `outside`: the sign before it, or all along, is positive.
template <class N>
struct PlaneCrossing {
    N t, error;
    MaskOf<N> met, missed, outside;
};

template <class N>
WHITTLE_KERNEL_INLINE PlaneCrossing<N> plane_crossing(const LinearForm<N>& f) {
    const N zero = lift<N>(0), size = magnitude(f.s);
    PlaneCrossing<N> r;
    r.t = minus(f.v) / f.s;
    r.error = (f.ev + magnitude(r.t) * f.es) / (size - f.es) * lift<N>(1 + 8 * 0x1p-53) + units<N>(2) * magnitude(r.t);
    r.met = both(size > f.es, magnitude(r.t) <= lift<N>(std::numeric_limits<double>::max()));
    r.missed = both(both(f.s == zero, f.es == zero), magnitude(f.v) > f.ev);
    r.outside = either(both(r.met, f.s < zero), both(r.missed, f.v > zero));
    return r;
}

// An axis plane met by the ray itself (no frame between): one subtraction, one product with the rounded inverse of d. Requires: inverse is finite.
template <class N>
WHITTLE_KERNEL_INLINE void axis_plane_crossing(N value, N o, N inverse, N& t, N& error) {
    t = (value - o) * inverse;
    error = units<N>(4) * magnitude(t);
}

// What balls (n = 3) and cylinders (n = 2) need of a direction.
template <class N, std::size_t n>
struct RoundDirection {
    std::array<N, n> d, ed;
    N a, ea, inverse;
};

template <class N, std::size_t n>
WHITTLE_KERNEL_INLINE RoundDirection<N, n> round_direction(const std::array<N, n>& d, const std::array<N, n>& ed) {
    RoundDirection<N, n> r{d, ed, lift<N>(0), lift<N>(0), lift<N>(0)};
    for (std::size_t i = 0; i < n; ++i) {
        r.a = r.a + d[i] * d[i];
        r.ea = r.ea + (lift<N>(2) * magnitude(d[i]) * ed[i] + ed[i] * ed[i]);
    }
    r.ea = r.ea + units<N>(4) * r.a;
    r.inverse = choose(r.a > lift<N>(0), lift<N>(1) / r.a, lift<N>(0));
    return r;
}

// Two crossings (`met`), certainly none (`missed`: outside all along, unless `within`), or neither: not decidable.
template <class N>
struct RoundCrossing {
    N t0, t1, error0, error1;
    MaskOf<N> met, missed, within;
};

// `o` is measured from the centre rounded once: o = origin - centre; |origin - exact| <= eo.
// Seen from the closest approach, so the two roots are -b/a -+ h/a without cancellation: b is rounding alone.
template <class N, std::size_t n>
WHITTLE_KERNEL_INLINE RoundCrossing<N> round_crossing(const std::array<N, n>& o, const std::array<N, n>& eo, const RoundDirection<N, n>& way, double r) {
    const N zero = lift<N>(0), two = lift<N>(2);
    N along = zero;
    for (std::size_t i = 0; i < n; ++i) along = along + o[i] * way.d[i];
    const N t0 = minus(along) * way.inverse, reach = magnitude(t0);
    N b = zero, c = lift<N>(-(r * r)), eb = zero, ec = zero, bb = zero;
    for (std::size_t i = 0; i < n; ++i) {
        const N step = t0 * way.d[i], p = o[i] + step, pd = p * way.d[i], ap = magnitude(p);
        const N ep = eo[i] + reach * way.ed[i] + units<N>(3) * (magnitude(o[i]) + magnitude(step));
        b = b + pd;
        c = c + p * p;
        bb = bb + magnitude(pd);
        eb = eb + (magnitude(way.d[i]) * ep + ap * way.ed[i] + ep * way.ed[i]);
        ec = ec + (two * ap + ep) * ep;
    }
    eb = eb + units<N>(4) * bb;
    ec = ec + units<N>(4) * (c + lift<N>(2 * (r * r)));
    const N ac = magnitude(c), ab = magnitude(b);
    RoundCrossing<N> out;
    const auto still = both(way.a == zero, way.ea == zero), regular = way.a > two * way.ea;
    const N square = b * b, product = way.a * c, disc = square - product;
    const N edisc = two * ab * eb + eb * eb + way.a * ec + ac * way.ea + way.ea * ec + units<N>(4) * (square + magnitude(product));
    out.missed = either(both(still, ac > ec), both(regular, disc < minus(edisc)));
    out.within = both(still, c < zero);
    out.met = both(regular, disc > edisc);
    out.t0 = out.t1 = out.error0 = out.error1 = zero;
    if (all<N>(out.missed)) return out;
    const N h = square_root(disc), shift = minus(b) * way.inverse, half = h * way.inverse, ashift = magnitude(shift);
    const N spread = (eb + edisc / h + units<N>(2) * h + (ashift + half) * way.ea) * way.inverse * lift<N>((1 + 8 * 0x1p-53) * 2) + units<N>(4) * (ashift + half);
    out.t0 = t0 + (shift - half);
    out.t1 = t0 + (shift + half);
    out.error0 = spread + units<N>(1) * magnitude(out.t0);
    out.error1 = spread + units<N>(1) * magnitude(out.t1);
    const N most = lift<N>(std::numeric_limits<double>::max());
    out.met = both(out.met, both(magnitude(out.t0) <= most, magnitude(out.t1) <= most));
    return out;
}

}  // namespace whittle::WHITTLE_KERNEL_NAMESPACE

#undef WHITTLE_KERNEL_NAMESPACE
#undef WHITTLE_KERNEL_INLINE
#ifdef HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif  // include guard of one target
