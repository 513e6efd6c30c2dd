// turned_series.cpp — arithmetic of series, isolation by the bounds of their parts, Newton's method, certificates by signs.
#include "tracer/engine/turned_series.h"

#include <algorithm>

#include "tracer/engine/turned_angle.h"

namespace whittle {

namespace {

constexpr double u = kUnitRoundoff;
constexpr double kRoom = 1 + 0x1p-40;
constexpr std::size_t kTurningTerms = 14;   // of sine and cosine, at most: times a polynomial of degree two they fit
constexpr double kMostSwing = 0.5;          // of the angle, in radians
constexpr std::size_t kMostParts = 64;
constexpr double kLeastPart = 0x1p-36;      // of the window
constexpr double kEvaluation = 34 * u;      // what Horner's rule rounds, of the size
constexpr double kTiny = 0x1p-1060;         // what a product may lose that underflows

// Sets the rounding of a sum of `terms` products whose magnitudes add up to `size`, and whose derivatives' do to `steep`.
void add_rounding(Series& r, double terms, double size, double steep) {
    r.error = (r.error + terms * u * size) * kRoom + kTiny;
    r.slope_error = (r.slope_error + terms * u * steep) * kRoom + kTiny;
}

template <class Join>
Series joined(const Series& a, const Series& b, Join join) {
    Series r;
    r.degree = std::max(a.degree, b.degree);
    for (std::size_t k = 0; k < Series::kTerms; ++k) r.c[k] = join(a.c[k], b.c[k]);
    r.error = a.error + b.error;
    r.slope_error = a.slope_error + b.slope_error;
    add_rounding(r, 1, r.size(), r.steepness());
    return r;
}

}  // namespace

namespace {

// Sums of magnitudes in four lanes, which the machine adds together.
template <class Term>
double sum_in_lanes(std::size_t degree, Term term) {
    std::array<double, 4> lanes{};
    for (std::size_t k = 0; k <= degree; k += lanes.size())
        for (std::size_t j = 0; j < lanes.size(); ++j) lanes[j] += term(k + j);
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

constexpr std::array<double, Series::kTerms> kPowers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

}  // namespace

double Series::size() const {
    return sum_in_lanes(degree, [&](std::size_t k) { return std::abs(c[k]); });
}

double Series::steepness() const {
    return sum_in_lanes(degree, [&](std::size_t k) { return kPowers[k] * std::abs(c[k]); });
}

Series operator+(const Series& a, const Series& b) { return joined(a, b, [](double x, double y) { return x + y; }); }
Series operator-(const Series& a, const Series& b) { return joined(a, b, [](double x, double y) { return x - y; }); }

Series operator*(const Series& a, const Series& b) {
    Series r;
    r.degree = std::min(a.degree + b.degree, Series::kTerms - 1);
    double dropped = 0;
    for (std::size_t i = 0; i <= a.degree; ++i) {
        const std::size_t fits = std::min(b.degree + 1, Series::kTerms - i);
        for (std::size_t j = 0; j < fits; ++j) r.c[i + j] += a.c[i] * b.c[j];
        for (std::size_t j = fits; j <= b.degree; ++j) dropped += std::abs(a.c[i] * b.c[j]);
    }
    const double m = a.size(), n = b.size(), p = a.steepness(), q = b.steepness();
    r.error = m * b.error + n * a.error + a.error * b.error + dropped;
    r.slope_error = p * b.error + m * b.slope_error + q * a.error + n * a.slope_error + a.error * b.slope_error + b.error * a.slope_error +
                    static_cast<double>(a.degree + b.degree) * dropped;
    add_rounding(r, Series::kTerms + 1, m * n, p * n + m * q);
    return r;
}

Series operator*(const Near& k, const Series& a) {
    Series r;
    r.degree = a.degree;
    for (std::size_t i = 0; i < Series::kTerms; ++i) r.c[i] = k.high() * a.c[i];
    const double size = a.size(), steep = a.steepness(), v = std::abs(k.high());
    r.error = v * a.error + k.error() * (size + a.error);
    r.slope_error = v * a.slope_error + k.error() * (steep + a.slope_error);
    add_rounding(r, 1, v * size, v * steep);
    return r;
}

namespace {

// Cosine and sine of an angle with these at the middle, that swings by `swing` to either side. Requires: |swing| <= kMostSwing.
void turning(const Near& c, const Near& s, const Near& swing, Series& cosine, Series& sine) {
    const std::array<double, 4> round{c.high(), -s.high(), -c.high(), s.high()};
    const double x = swing.high();
    double power = 1;
    std::size_t k = 0;
    for (; k < kTurningTerms && (k < 4 || std::abs(power) > 0x1p-60); ++k) {
        cosine.c[k] = power * round[k % 4];
        sine.c[k] = power * round[(k + 3) % 4];
        power *= x / static_cast<double>(k + 1);
    }
    cosine.degree = sine.degree = x == 0 ? 0 : k - 1;
    // Sums of |x|^k / k! and of k |x|^k / k! are at most 1.65 and 0.83; those of the terms left out, from the fourth or later, 1.15 and 1.15 k times the first.
    const double left_out = 1.5 * 1.15 * std::abs(power), given = 1.65 * (c.error() + s.error()) + 1.65 * 1.5 * swing.error(), rounded = x == 0 ? 0 : 16 * u;
    cosine.error = sine.error = given + rounded + left_out;
    cosine.slope_error = sine.slope_error = 2 * (given + rounded) + static_cast<double>(k) * left_out;
}

}  // namespace

bool turned_series(const Twist& twist, const FrameRay& ray, TurnedSeries& out) {
    if (!turned_window(twist, ray, out.window)) return false;
    if (out.window.empty) return true;
    const double from = out.window.from, to = out.window.to;
    out.middle = from + 0.5 * (to - from);
    out.half = std::max(to - out.middle, out.middle - from) * kRoom;
    if (!std::isfinite(out.half)) return false;
    std::array<Series, 3> x;
    for (std::size_t i = 0; i < 3; ++i) {
        const Near d = Near::within(ray.d[i], ray.ed[i]);
        x[i] = {Near::within(ray.o[i], ray.eo[i]) + Near(out.middle) * d, Near(out.half) * d};
    }
    Series cosine(Near(1.0)), sine;
    if (twist.degrees != 0) {
        const Near rate = out.rate = turned::rate<Near>(twist), swing = rate * Near::within(x[2].c[1], x[2].slope_error);
        Near c, s;
        if (!(std::abs(swing.high()) <= kMostSwing) || !turned::turn(rate * (Near::within(x[2].c[0], x[2].error) - Near(twist.z0)), c, s)) return false;
        turning(c, s, swing, cosine, sine);
    }
    const auto at = turned::in_profile(twist, x, cosine, sine, [](const Near& k) { return Series(k); });
    out.x = at.x;
    out.y = at.y;
    out.unit = at.unit;
    return true;
}

namespace {

// A part of the window: s = at + half q for q in [-1, 1], with the series in q and the function's signs at the ends.
struct Part {
    Series f;
    double at = 0, half = 1;
    int before = 0, behind = 0;
    int cuts = 0;  // that led to it, each of which may round its place
};

struct Value {
    double v, slope;
};

Value value_at(const Series& f, double q) {
    double v = f.c[f.degree], slope = 0;
    for (std::size_t k = f.degree; k-- > 0;) {
        slope = slope * q + v;
        v = v * q + f.c[k];
    }
    return {v, slope};
}

double plain_value_at(const Series& f, double q) {
    double v = f.c[f.degree];
    for (std::size_t k = f.degree; k-- > 0;) v = v * q + f.c[k];
    return v;
}

// A side on a ray of its frame, place by place.
struct SideOnRay {
    const Support& support;
    const Twist& twist;
    const FrameRay& ray;
    const Near& rate;

    Near at(double t) const {
        std::array<Near, 3> o, d;
        for (std::size_t i = 0; i < 3; ++i) {
            o[i] = Near::within(ray.o[i], ray.eo[i]);
            d[i] = Near::within(ray.d[i], ray.ed[i]);
        }
        return turned::on_line<0>(support, twist, rate, o, d, Near(t)).c[0];
    }
};

class SeriesRoots {
public:
    SeriesRoots(const TurnedSeries& window, SideOnRay side, Crossings& out) : window_(window), side_(side), out_(out) {}

    // `leaving`: t = 0 is a root.
    bool find(Series f, bool leaving) {
        if (leaving && window_.window.holds_origin()) {
            // A rounded place has a value beside the constant that is taken away.
            const double s = -window_.middle / window_.half, size = f.size();
            f.c[0] -= plain_value_at(f, s);
            f.error = (2 * f.error + 2 * kEvaluation * size + 4 * u * f.steepness()) * kRoom;
            origin_ = s;
        }
        out_.count = 0;
        out_.first_sign = f.c[0] > 0 ? 1 : -1;
        if (origin_ == kNowhere && keeps_sign(f)) return true;
        const Part whole{f, 0, 1, sign_at(f, -1), sign_at(f, 1), 0};
        if (whole.before == 0 || whole.behind == 0) return false;
        out_.first_sign = static_cast<std::int8_t>(whole.before);
        return isolate(whole);
    }

private:
    static constexpr double kNowhere = 2;

    static double uncertainty(const Series& f) { return f.error + kEvaluation * f.size(); }

    static int sign_at(const Series& f, double q) {
        const double v = plain_value_at(f, q);
        return std::abs(v) > uncertainty(f) ? (v > 0 ? 1 : -1) : 0;
    }

    // Is the constant more than all the rest?
    static bool keeps_sign(const Series& f) { return 2 * std::abs(f.c[0]) > (f.size() + f.error) * kRoom; }

    // Is the root at the origin in the part? The cuts keep away from it.
    bool holds_origin(const Part& p) const { return std::abs(origin_ - p.at) < p.half; }

    bool isolate(const Part& p) {
        if (++parts_ > kMostParts) return false;
        const Series& f = p.f;
        const bool holds = holds_origin(p);
        if (!holds && keeps_sign(f)) return true;
        if (2 * std::abs(f.c[1]) > (f.steepness() + f.slope_error) * kRoom) {
            if (p.before == p.behind) return !holds;
            if (out_.count == Crossings::kMost) return false;
            const auto i = static_cast<std::size_t>(out_.count++);
            if (!holds) return refine(p, out_.t[i], out_.error[i]);
            out_.t[i] = out_.error[i] = 0;
            return true;
        }
        if (p.half < kLeastPart) return false;
        for (const double cut : {0.0, -0.125, 0.1875, -0.3125, 0.40625}) {
            if (std::abs(origin_ - (p.at + cut * p.half)) < 0x1p-6 * p.half) continue;
            const int sign = sign_at(f, cut);
            if (sign != 0) return isolate(part(p, -1, cut, p.before, sign)) && isolate(part(p, cut, 1, sign, p.behind));
        }
        return false;
    }

    // The part of the part between two q.
    static Part part(const Part& p, double from, double to, int before, int behind) {
        const double half = 0.5 * (to - from), centre = 0.5 * (from + to);
        Part r{p.f, p.at + p.half * centre, p.half * half, before, behind, p.cuts + 1};
        Series& f = r.f;
        for (std::size_t i = 0; i < f.degree; ++i)
            for (std::size_t k = f.degree; k-- > i;) f.c[k] += centre * f.c[k + 1];
        double power = 1;
        for (std::size_t k = 1; k <= f.degree; ++k) f.c[k] *= power *= half;
        // Shifting makes coefficients out of others that are larger: of those it rounds.
        const double size = p.f.size();
        f.error = (f.error + 2 * kEvaluation * size) * kRoom;
        f.slope_error = (half * f.slope_error + 2 * static_cast<double>(Series::kTerms) * kEvaluation * size) * kRoom;
        return r;
    }

    // The root in the part, in which the function is monotone and changes its sign.
    bool refine(const Part& p, double& t, double& error) const {
        double a = -1, b = 1, q = std::clamp(-p.f.c[0] / p.f.c[1], -1.0, 1.0);
        Value f{};
        for (int i = 0; i < 60; ++i) {
            f = value_at(p.f, q);
            if (f.v == 0 || f.slope == 0) break;
            ((f.v > 0) == (p.before > 0) ? a : b) = q;
            const double newton = q - f.v / f.slope, next = newton > a && newton < b ? newton : 0.5 * (a + b);
            if (next == q || std::abs(next - q) <= 2 * u) break;
            q = next;
        }
        double room = 2 * ((std::abs(f.v) + uncertainty(p.f)) / std::abs(f.slope) + u);
        for (int i = 0; i < 12 && std::isfinite(room); ++i, room *= 2) {
            if ((q - room > -1 && sign_at(p.f, q - room) != p.before) || (q + room < 1 && sign_at(p.f, q + room) != p.behind)) continue;
            const double s = p.at + p.half * q;
            t = window_.middle + window_.half * s;
            error = (window_.half * (p.half * room + 2 * u * (1 + p.cuts)) + 2 * u * (std::abs(window_.middle) + window_.half)) * kRoom;
            if (!std::isfinite(t) || !std::isfinite(error)) return false;
            sharpen(p, q, t, error);
            return true;
        }
        return false;
    }

    // One step of Newton's method from the function's value at t itself: the series bounds what is rounded in the whole window, this what is at one place. With
    // the root r, f(t) = f'(x) (t - r) for an x between, and the series bounds the slope there.
    void sharpen(const Part& p, double q, double& t, double& error) const {
        const double unit = window_.half * p.half, size = p.f.steepness(), slope = value_at(p.f, q).slope;
        const double unsure = p.f.slope_error + (2 * kEvaluation + Series::kTerms * error / unit + 0x1p-44) * size, least = std::abs(slope) - unsure;
        Near f = side_.at(t);
        if (origin_ != kNowhere) f = f - side_.at(0);
        if (!(least > 0) || f.is_zero()) return;
        const double step = f.high() / slope * unit, next = t - step;
        const double sharp = (f.error() / least * unit + std::abs(step) * (unsure / least + 4 * u) + u * std::abs(next)) * kRoom;
        if (!(sharp < error) || !(std::abs(step) <= error)) return;
        t = next;
        error = sharp;
    }

    const TurnedSeries& window_;
    const SideOnRay side_;
    Crossings& out_;
    double origin_ = kNowhere;
    std::size_t parts_ = 0;
};

}  // namespace

bool series_crossings(const Support& support, const Twist& twist, const TurnedSeries& series, const FrameRay& ray, bool leaving, Crossings& out) {
    if (series.window.empty) {
        out.count = 0;
        out.first_sign = static_cast<std::int8_t>(sign_out_of_reach(support, twist));
        return true;
    }
    return SeriesRoots(series, {support, twist, ray, series.rate}, out).find(turned::curve(support, series.x, series.y, series.unit), leaving);
}

}  // namespace whittle
