// turned.cpp — isolation by bounds of derivatives, Newton's method, certificates by signs.
//
// Source: Moore, Interval Analysis (1966), the mean value forms; Kalra and Barr, Guaranteed Ray Intersections with Implicit Surfaces (1989), whose bounds of
// f and f' isolate roots likewise.
#include "tracer/engine/turned.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/base/degrees.h"
#include "csg/span/perturbation.h"
#include "tracer/engine/turned_angle.h"
#include "tracer/engine/turned_series.h"

namespace whittle {

namespace {

constexpr double kMargin = 0x1p-10;  // by which the window is larger than the piece, as a share of its size
constexpr double kPlain = 0x1p-14;   // entering the frame must round less than this share
constexpr double kRoom = 1 + 0x1p-40;

template <class N>
struct TurnedRoots {
    std::array<N, Crossings::kMost> t;
    int count = 0, first_sign = 1;
};

// One side on one line of its frame.
template <class N>
class TurnedLine {
public:
    TurnedLine(const Support& support, const Twist& twist, const std::array<N, 3>& o, const std::array<N, 3>& d) : support_(support), twist_(twist), o_(o), d_(d) {
        if (twist.degrees != 0) rate_ = turned::rate<N>(twist);
    }

    template <std::size_t K = 1>
    Taylor<N, K> at(const N& t) const {
        Taylor<N, K> r = turned::on_line<K>(support_, twist_, rate_, o_, d_, t);
        if (leaving_) r.c[0] = r.c[0] - constant_;
        return r;
    }

    // `leaving`: t = 0 is a root.
    bool roots(const TurnedWindow& window, bool leaving, TurnedRoots<N>& out) {
        leaving_ = leaving && window.holds_origin();
        if (leaving_) {
            leaving_ = false;
            constant_ = at(N(0.0)).c[0];
            leaving_ = true;
        }
        out.count = 0;
        out.first_sign = window.empty ? sign_out_of_reach(support_, twist_) : sign_at(window.from);
        if (window.empty) return true;
        const int before = out.first_sign;
        if (before == 0) return false;
        const int behind = sign_at(window.to);
        if (behind == 0) return false;
        rest_ = rest_of(window);
        left_ = kMostParts;
        least_ = (window.to - window.from) * kLeast;
        return std::isfinite(rest_) && isolate(window.from, window.to, before, behind, out);
    }

private:
    // A ray that nearly lies in the side has tiny derivatives of every order, which bounds by magnitudes do not see: enough of them are taken that of what
    // only tapers, a polynomial, nothing is left out.
    static constexpr std::size_t kTerms = 5;
    static constexpr double kLeast = 0x1p-70;
    static constexpr int kMostParts = 600;

    int sign_at(double t) const {
        const N v = at(N(t)).c[0];
        return v.is_certain() ? v.sign() : 0;
    }

    // A bound over the window of the first coefficient that is left out.
    double rest_of(const TurnedWindow& window) const {
        using T = Taylor<Size, kTerms + 1>;
        const double far = std::max(std::abs(window.from), std::abs(window.to));
        std::array<T, 3> x;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = std::abs(d_[i].high()) + d_[i].error();
            const double o = i == 2 ? std::max(std::abs(twist_.from), std::abs(twist_.to)) + (twist_.to - twist_.from) : 2 * twist_.reach;
            x[i] = {Size(std::min(o, std::abs(o_[i].high()) + o_[i].error() + far * d)), Size(d)};
        }
        const double speed = (std::abs(rate_.high()) + rate_.error()) * x[2].c[1].v;
        T round;
        double power = 1;
        for (std::size_t k = 0; k <= kTerms + 1; ++k, power *= speed / static_cast<double>(k)) round.c[k] = Size(power);
        return turned::function(support_, twist_, x, round, round).c[kTerms + 1].v * kRoom;
    }

    bool isolate(double lo, double hi, int at_lo, int at_hi, TurnedRoots<N>& out) {
        const double middle = lo + 0.5 * (hi - lo), r = std::max(hi - middle, middle - lo) * kRoom;
        if (--left_ < 0) return false;
        const Taylor<N, kTerms> f = at<kTerms>(N(middle));
        double swing = rest_, bend = rest_ * static_cast<double>(kTerms + 1);  // of the value and of the slope, at most, over the part
        for (std::size_t k = kTerms; k >= 1; --k) {
            const double most = std::abs(f.c[k].high()) * kRoom + f.c[k].error();
            swing = swing * r + most;
            if (k > 1) bend = bend * r + most * static_cast<double>(k);
        }
        const auto least = [](const N& v) { return std::abs(v.high()) * (1 - 0x1p-40) - v.error(); };
        const bool holds_origin = leaving_ && lo < 0 && hi > 0;
        if (!holds_origin && least(f.c[0]) > swing * r * kRoom) return true;
        if (least(f.c[1]) > bend * r * kRoom) {
            if (at_lo == at_hi) return !holds_origin;
            if (out.count == Crossings::kMost) return false;
            N& root = out.t[static_cast<std::size_t>(out.count++)];
            if (holds_origin) {
                root = N(0.0);
                return true;
            }
            return refine(lo, hi, at_lo, root);
        }
        if (hi - lo < least_) return false;
        for (const double share : {0.5, 0.4375, 0.59375, 0.34375, 0.703125}) {
            const double cut = lo + share * (hi - lo);
            if (!(cut > lo && cut < hi)) return false;
            const int sign = sign_at(cut);
            if (sign != 0) return isolate(lo, cut, at_lo, sign, out) && isolate(cut, hi, sign, at_hi, out);
        }
        return false;
    }

    // The root between, where the function is monotone and has certain signs at the ends.
    bool refine(double lo, double hi, int at_lo, N& root) const {
        double a = lo, b = hi;
        N t(lo + 0.5 * (hi - lo));
        Taylor<N, 1> f;
        for (int i = 0; i < 80; ++i) {
            f = at(t);
            if (!f.c[0].is_certain() || f.c[0].is_zero() || f.c[1].high() == 0) break;
            (f.c[0].sign() == at_lo ? a : b) = t.high();
            const N step = without_error(f.c[0]) / without_error(f.c[1]);
            const N next = without_error(t - step);
            if (!(next.high() > a && next.high() < b)) {
                const double middle = a + 0.5 * (b - a);
                if (!(middle > a && middle < b)) break;
                t = N(middle);
                continue;
            }
            t = next;
            if (std::abs(step.high()) <= 2 * N::kUnit * std::abs(t.high())) break;
        }
        f = at(t);
        double error = (2 * (std::abs(f.c[0].high()) + f.c[0].error()) / std::abs(f.c[1].high()) + 2 * N::kUnit * std::abs(t.high())) * kRoom;
        for (int i = 0; i < 24 && std::isfinite(error); ++i, error *= 2) {
            if (sign_beside(t - N(error), lo, hi, at_lo) == at_lo && sign_beside(t + N(error), lo, hi, at_lo) == -at_lo) {
                root = N::about(t.high(), t.low(), error * kRoom + 2 * N::kUnit * std::abs(t.high()));
                return true;
            }
        }
        return false;
    }

    int sign_beside(const N& t, double lo, double hi, int at_lo) const {
        if (t.high() <= lo) return at_lo;
        if (t.high() >= hi) return -at_lo;
        const N v = at(t).c[0];
        return v.is_certain() ? v.sign() : 0;
    }

    const Support& support_;
    const Twist& twist_;
    std::array<N, 3> o_, d_;
    N rate_{0.0}, constant_{0.0};
    bool leaving_ = false;
    double rest_ = 0, least_ = 0;
    int left_ = 0;
};

bool fine_line(const Frame& frame, const std::array<Bounded, 3>& origin, const Vec3& direction, std::array<Bounded, 3>& o, std::array<Bounded, 3>& d) {
    const FrameLine<Bounded> line = line_in_frame<Bounded>(frame, origin, direction);
    if (!line.w.is_certain() || line.w.sign() <= 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        o[i] = frame.identity ? line.o[i] : line.o[i] / line.w;
        d[i] = frame.identity ? line.d[i] : line.d[i] / line.w;
    }
    return true;
}

// `moved`: by that many times the vectors of the perturbation.
bool fine_roots(const Support& support, const Frame& frame, const Ray& ray, bool leaving, double moved, TurnedRoots<Bounded>& roots) {
    TurnedWindow window;
    if (!turned_window(*frame.twist, ray_in_frame(frame, ray), window)) return false;
    std::array<Bounded, 3> origin, o, d;
    for (int i = 0; i < 3; ++i) origin[static_cast<std::size_t>(i)] = Bounded(ray.origin[i]) + Bounded(moved * kPerturbation[0][i]);
    if (!fine_line(frame, origin, ray.direction, o, d)) return false;
    return TurnedLine<Bounded>(support, *frame.twist, o, d).roots(window, leaving, roots);
}

bool as_crossings(const TurnedRoots<Bounded>& roots, Crossings& out) {
    out.first_sign = static_cast<std::int8_t>(roots.first_sign);
    out.count = static_cast<std::int8_t>(roots.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(roots.count); ++i) {
        const Bounded& t = roots.t[i];
        out.t[i] = t.high();
        out.error[i] = t.is_zero() ? 0 : t.error() + kUnitRoundoff * std::abs(t.high()) * kRoom;
        if (!std::isfinite(t.high()) || !std::isfinite(out.error[i])) return false;
    }
    return true;
}

}  // namespace

namespace {

constexpr double kSlow = 0x1p-400, kFaster = 0x1p500;

bool is_slow(const FrameRay& ray) {
    return std::abs(ray.d[0]) + std::abs(ray.d[1]) + std::abs(ray.d[2]) < kSlow && ray.d != std::array<double, 3>{};
}

// Of a ray whose squares would be lost.
bool slow_window(const Twist& w, FrameRay ray, TurnedWindow& out) {
    for (std::size_t i = 0; i < 3; ++i) ray.d[i] *= kFaster, ray.ed[i] *= kFaster;
    if (!turned_window(w, ray, out)) return false;
    out.from *= kFaster;
    out.to *= kFaster;
    return out.empty || (std::isfinite(out.from) && std::isfinite(out.to));
}

}  // namespace

bool turned_window(const Twist& w, const FrameRay& ray, TurnedWindow& out) {
    if (is_slow(ray)) return slow_window(w, ray, out);
    const double height = w.to - w.from, room = kMargin * height, reach = w.reach * (1 + kMargin);
    const double dd = ray.d[0] * ray.d[0] + ray.d[1] * ray.d[1];
    double from = -HUGE_VAL, to = HUGE_VAL;
    if (dd > 0) {
        const double closest = -(ray.o[0] * ray.d[0] + ray.o[1] * ray.d[1]) / dd;
        const double x = ray.o[0] + closest * ray.d[0], y = ray.o[1] + closest * ray.d[1], rest = reach * reach - (x * x + y * y);
        if (!std::isfinite(x + y)) return false;
        const double half = rest < 0 ? -1 : std::sqrt(rest / dd);
        from = closest - half;
        to = closest + half;
    } else if (std::hypot(ray.o[0], ray.o[1]) > reach) {
        to = -HUGE_VAL;
    }
    if (ray.d[2] != 0) {
        const double a = (w.from - room - ray.o[2]) / ray.d[2], b = (w.to + room - ray.o[2]) / ray.d[2];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    } else if (ray.o[2] < w.from - room || ray.o[2] > w.to + room) {
        to = -HUGE_VAL;
    }
    if (!(from < to)) {
        out = {0, 0, true};
        return !std::isnan(from) && !std::isnan(to);
    }
    if (ray.d == std::array<double, 3>{}) from = -1, to = 1;  // square to the plane of a section: one place, whatever t is
    if (!std::isfinite(from) || !std::isfinite(to)) return false;
    const double far = std::max(std::abs(from), std::abs(to));
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = i == 2 ? height : w.reach;
        const double rounding = ray.eo[i] + far * ray.ed[i] + 4 * kUnitRoundoff * (std::abs(ray.o[i]) + far * std::abs(ray.d[i]));
        if (!(rounding < kPlain * size)) return false;
    }
    out = {from, to, false};
    return true;
}

int sign_out_of_reach(const Support& support, const Twist& twist) {
    // No symmetry favours this place.
    const Near x = Near(3.6180339887 * twist.reach), y = Near(2.7320508076 * twist.reach);
    return turned::curve(support, Taylor<Near, 1>(x), Taylor<Near, 1>(y), Taylor<Near, 1>(Near(1.0))).c[0].sign() < 0 ? -1 : 1;
}

bool fine_turned(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out) {
    TurnedRoots<Bounded> roots;
    return fine_roots(support, frame, ray, leaving, 0, roots) && as_crossings(roots, out);
}

bool fine_turned(const Support& support, const Frame& frame, const Ray& ray, bool leaving, int index, double& high, double& low, double& error) {
    TurnedRoots<Bounded> roots;
    if (!fine_roots(support, frame, ray, leaving, 0, roots) || index >= roots.count) return false;
    const Bounded& t = roots.t[static_cast<std::size_t>(index)];
    high = t.high();
    low = t.low();
    error = t.error();
    return std::isfinite(high) && std::isfinite(error);
}

void unsettled_turned(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out) {
    double size = frame.twist->reach + (frame.twist->to - frame.twist->from);
    for (int i = 0; i < 3; ++i) size = std::max(size, std::abs(ray.origin[i]) * 0x1p-20);
    TurnedRoots<Bounded> roots;
    for (const double share : {0x1p-50, 0x1p-44, 0x1p-38, 0x1p-32})
        if (fine_roots(support, frame, ray, leaving, share * size, roots) && as_crossings(roots, out)) return;
    out.count = 0;
    out.first_sign = 1;
}

Vec3 turned_gradient(const Support& support, const Twist& twist, const Vec3& point) {
    Vec3 n;
    for (int i = 0; i < 3; ++i) {
        std::array<Near, 3> d;
        d[static_cast<std::size_t>(i)] = Near(1.0);
        n[i] = TurnedLine<Near>(support, twist, {Near(point.x), Near(point.y), Near(point.z)}, d).at(Near(0.0)).c[1].high();
    }
    return n;
}

namespace {

// A place of the swept curve: `along` in [0, 1] on it, `up` in [0, 1] of the piece.
Vec3 turned_point(const Support& s, const Twist& w, double along, double up) {
    const auto& p = s.p;
    Vec2 q;
    if (s.kind == SupportKind::kTurnedSide) {
        q = {p[0] + along * (p[2] - p[0]), p[1] + along * (p[3] - p[1])};
    } else if (s.kind == SupportKind::kTurnedEllipse) {
        const double c = cosd(360 * along), n = sind(360 * along);
        q = {p[0] + p[2] * c + p[3] * n, p[1] + p[4] * c + p[5] * n};
    } else {
        const double a = (1 - along) * (1 - along), c = 2 * along * (1 - along), b = along * along;
        q = {a * p[0] + c * p[2] + b * p[4], a * p[1] + c * p[3] + b * p[5]};
    }
    const double z = w.from + up * (w.to - w.from), share = (z - w.z0) / (w.z1 - w.z0), c = cosd(w.degrees * share), n = sind(w.degrees * share);
    return {(1 + (w.scale_x - 1) * share) * (c * q.x + n * q.y), (1 + (w.scale_y - 1) * share) * (c * q.y - n * q.x), z};
}

}  // namespace

Vec3 turned_middle(const Frame& frame) { return apply_to_point(frame.placement, {0, 0, 0.5 * (frame.twist->from + frame.twist->to)}); }

double turned_distance(const Support& a, const Frame& in_a, const Support& b, const Frame& in_b, bool& flipped) {
    const Twist &v = *in_a.twist, &w = *in_b.twist;
    const auto on_axis = [](const Frame& f, double z) { return apply_to_point(f.placement, {0, 0, z}); };
    const auto apart = [&](double x, double y) { return std::max(glm::distance(on_axis(in_a, v.from), on_axis(in_b, x)), glm::distance(on_axis(in_a, v.to), on_axis(in_b, y))); };
    double worst = std::min(apart(w.from, w.to), apart(w.to, w.from));
    // The windows must be the same but for their margins.
    const double reach = glm::length(point_in_frame(in_b, apply_to_point(in_a.placement, {v.reach, 0, v.from})) - point_in_frame(in_b, on_axis(in_a, v.from)));
    if (!(std::abs(reach - w.reach) <= 0x1p-16 * w.reach) || a.kind != b.kind) return HUGE_VAL;
    constexpr int kPoints = 5;
    for (int i = 0; i < kPoints; ++i)
        for (int j = 0; j < kPoints; ++j) {
            const Vec3 p = turned_point(a, v, (i + 0.125) / kPoints, (j + 0.375) / kPoints), root = apply_to_point(in_a.placement, p), q = point_in_frame(in_b, root);
            std::array<Near, 3> still, from{Near(q.x), Near(q.y), Near(q.z)};
            const double value = TurnedLine<Near>(b, w, from, still).at(Near(0.0)).c[0].high();
            const Vec3 n = gradient_in_root(in_a, turned_gradient(a, v, p)), m = gradient_in_root(in_b, turned_gradient(b, w, q));
            const double slope = glm::length(m);
            if (!(slope > 0)) return HUGE_VAL;
            const bool against = glm::dot(n, m) < 0;
            if (i + j > 0 && against != flipped) return HUGE_VAL;
            flipped = against;
            worst = std::max(worst, std::abs(value) / slope);
        }
    return worst;
}

}  // namespace whittle
