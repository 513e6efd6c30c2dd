// bounded.h — a double-double value that carries a bound of its own error: the middle tier of ordering.
//
// Law: |value - exact| <= error, through every operation. Each operation rounds with relative error at most kUnit of its result (Joldes, Muller,
// Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic, 2017: the worst constant there is 15/2 * 2^-106
// for these algorithms); kTiny covers results that underflow.
#pragma once

#include <cmath>

namespace whittle {

class Bounded {
public:
    static constexpr double kUnit = 0x1p-102;
    static constexpr double kTiny = 0x1p-960;

    Bounded() = default;
    Bounded(double v) : high_(v) {}  // NOLINT: exact

    // |exact - (high + low)| <= error. Requires: |low| is at most half a unit in the last place of high.
    static Bounded about(double high, double low, double error) { return make(high, low, error); }

    double high() const { return high_; }
    double low() const { return low_; }
    double error() const { return error_; }
    bool is_zero() const { return high_ == 0 && error_ == 0; }
    bool is_certain() const { return std::abs(high_) > 2 * error_ || (high_ == 0 && error_ == 0); }
    // Sign of the exact value. Requires: is_certain().
    int sign() const { return (high_ > 0) - (high_ < 0); }

    Bounded operator-() const { return make(-high_, -low_, error_); }
    friend Bounded operator+(const Bounded& a, const Bounded& b) {
        const auto [s, e] = two_sum(a.high_, b.high_);
        const auto [t, f] = two_sum(a.low_, b.low_);
        auto [v, w] = fast_two_sum(s, e + t);
        auto [x, y] = fast_two_sum(v, w + f);
        return rounded(x, y, a.error_ + b.error_);
    }
    friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + (-b); }
    friend Bounded operator*(const Bounded& a, const Bounded& b) {
        if (a.is_zero() || b.is_zero()) return {};
        const double p = a.high_ * b.high_;
        const double e = std::fma(a.high_, b.high_, -p) + (a.high_ * b.low_ + a.low_ * b.high_);
        const auto [x, y] = fast_two_sum(p, e);
        return rounded(x, y, kTiny + (a.magnitude() * b.error_ + b.magnitude() * a.error_ + a.error_ * b.error_) * (1 + 0x1p-40));
    }
    // Requires: b is certain and not zero.
    friend Bounded operator/(const Bounded& a, const Bounded& b) {
        const double q = a.high_ / b.high_;
        const Bounded rest = plain(a) - plain(b) * Bounded(q);
        const double correction = (rest.high_ + rest.low_) / b.high_;
        const auto [x, y] = fast_two_sum(q, correction);
        const double room = std::abs(b.high_) - 2 * b.error_ - std::abs(b.low_);
        const double inherited = (a.error_ + (std::abs(x) + std::abs(y)) * b.error_) / room;
        return rounded(x, y, inherited * (1 + 0x1p-40));
    }
    // Times a power of two that neither overflows nor underflows: exact.
    Bounded scaled(double power_of_two) const { return make(high_ * power_of_two, low_ * power_of_two, error_ * power_of_two); }
    // Requires: the value is certain and positive.
    friend Bounded square_root(const Bounded& a) {
        const double r = std::sqrt(a.high_);
        const Bounded rest = plain(a) - Bounded(r) * Bounded(r);
        const auto [x, y] = fast_two_sum(r, (rest.high_ + rest.low_) / (2 * r));
        return rounded(x, y, a.error_ / r * (1 + 0x1p-40));
    }

private:
    struct Pair {
        double a, b;
    };
    static Pair two_sum(double a, double b) {
        const double s = a + b, t = s - a;
        return {s, (a - (s - t)) + (b - t)};
    }
    static Pair fast_two_sum(double a, double b) {
        const double s = a + b;
        return {s, b - (s - a)};
    }
    static Bounded make(double h, double l, double e) {
        Bounded r;
        r.high_ = h;
        r.low_ = l;
        r.error_ = e;
        return r;
    }
    static Bounded plain(const Bounded& a) { return make(a.high_, a.low_, 0); }
    static Bounded rounded(double h, double l, double inherited) {
        if (h == 0 && l == 0 && inherited == 0) return make(0, 0, 0);
        return make(h, l, (inherited + std::abs(h) * kUnit) * (1 + 0x1p-40) + kTiny);
    }
    double magnitude() const { return std::abs(high_) + std::abs(low_); }

    double high_ = 0, low_ = 0, error_ = 0;
};

}  // namespace whittle
