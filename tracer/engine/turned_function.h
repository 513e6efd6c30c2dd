// turned_function.h — the function of a turned side along a line, over any numbers. Private to the engine.
//
// At height z the profile is turned by an angle and scaled, both linear in z. A point is inside the swept curve where the point, turned back and divided by the
// scale, is inside the curve; times a power of the scale that is a polynomial in the coordinates and in the sine and cosine of the angle. Written once: over
// double with a bound and over double-double for values and slopes, over magnitudes for a bound of the second derivative.
#pragma once

#include <array>
#include <cmath>

#include "tracer/engine/bounded.h"
#include "tracer/engine/support.h"

namespace whittle {

// A double with a bound of its error; what the filter computes in. The interface is that of Bounded.
class Near {
public:
    static constexpr double kUnit = 0x1p-53;

    Near() = default;
    Near(double v) : v_(v) {}  // NOLINT: exact
    static Near about(double high, double low, double error) { return {high + low, (error + kUnit * std::abs(high)) * kRoom}; }
    static Near within(double v, double error) { return {v, error}; }

    double high() const { return v_; }
    double low() const { return 0; }
    double error() const { return e_; }
    bool is_zero() const { return v_ == 0 && e_ == 0; }
    bool is_certain() const { return std::abs(v_) > e_ || is_zero(); }
    int sign() const { return (v_ > 0) - (v_ < 0); }

    Near operator-() const { return {-v_, e_}; }
    friend Near operator+(const Near& a, const Near& b) {
        const double v = a.v_ + b.v_;
        return {v, (a.e_ + b.e_ + kUnit * std::abs(v)) * kRoom};
    }
    friend Near operator-(const Near& a, const Near& b) { return a + (-b); }
    friend Near operator*(const Near& a, const Near& b) {
        const double v = a.v_ * b.v_;
        return {v, (std::abs(a.v_) * b.e_ + std::abs(b.v_) * a.e_ + a.e_ * b.e_ + kUnit * std::abs(v)) * kRoom + kTiny};
    }
    // Requires: b is certain and not zero.
    friend Near operator/(const Near& a, const Near& b) {
        const double v = a.v_ / b.v_;
        return {v, ((a.e_ + std::abs(v) * b.e_) / (std::abs(b.v_) - b.e_) + kUnit * std::abs(v)) * kRoom + kTiny};
    }

private:
    static constexpr double kRoom = 1 + 16 * kUnit, kTiny = 0x1p-1060;
    Near(double v, double e) : v_(v), e_(e) {}
    double v_ = 0, e_ = 0;
};

inline Near without_error(const Near& x) { return Near(x.high()); }
inline Bounded without_error(const Bounded& x) { return Bounded::about(x.high(), x.low(), 0); }

// Magnitudes: sums and differences alike are bounded by sums.
struct Size {
    double v = 0;
    Size() = default;
    Size(double x) : v(std::abs(x)) {}  // NOLINT
    friend Size operator+(Size a, Size b) { return a.v + b.v; }
    friend Size operator-(Size a, Size b) { return a.v + b.v; }
    friend Size operator*(Size a, Size b) { return a.v * b.v; }
};

// The first K + 1 coefficients in powers of t - m; over magnitudes, bounds of them wherever m lies.
template <class N, std::size_t K>
struct Taylor {
    using Number = N;
    std::array<N, K + 1> c{};
    Taylor() = default;
    Taylor(const N& constant) { c[0] = constant; }  // NOLINT
    Taylor(const N& value, const N& slope) {
        c[0] = value;
        c[1] = slope;
    }
    friend Taylor operator+(Taylor a, const Taylor& b) {
        for (std::size_t i = 0; i <= K; ++i) a.c[i] = a.c[i] + b.c[i];
        return a;
    }
    friend Taylor operator-(Taylor a, const Taylor& b) {
        for (std::size_t i = 0; i <= K; ++i) a.c[i] = a.c[i] - b.c[i];
        return a;
    }
    friend Taylor operator*(const Taylor& a, const Taylor& b) {
        Taylor r;
        for (std::size_t i = 0; i <= K; ++i)
            for (std::size_t j = 0; i + j <= K; ++j) r.c[i + j] = r.c[i + j] + a.c[i] * b.c[j];
        return r;
    }
    friend Taylor operator*(const N& k, Taylor a) {
        for (N& x : a.c) x = k * x;
        return a;
    }
};

namespace turned {

template <class T>
T square(const T& a) { return a * a; }

// The curve, in homogeneous coordinates of the profile: the point is (x, y) / unit.
template <class T>
T curve(const Support& s, const T& x, const T& y, const T& unit) {
    using K = typename T::Number;
    const auto& p = s.p;
    const T u = x - K(p[0]) * unit, v = y - K(p[1]) * unit;
    if (s.kind == SupportKind::kTurnedSide) return (K(p[3]) - K(p[1])) * u + (K(p[0]) - K(p[2])) * v;
    if (s.kind == SupportKind::kTurnedEllipse) {
        const T a = K(p[5]) * u - K(p[3]) * v, b = K(p[2]) * v - K(p[4]) * u;
        return square(a) + square(b) - square((K(p[2]) * K(p[5]) - K(p[3]) * K(p[4])) * unit);
    }
    // As polynomial::parabola.
    const K ex = K(p[4]) - K(p[0]), ey = K(p[5]) - K(p[1]), fx = K(p[2]) - K(p[0]), fy = K(p[3]) - K(p[1]);
    const K gx = (fx + fx) - ex, gy = (fy + fy) - ey, whole = ex * fy - ey * fx;
    const T across = whole * unit + (gx * v - gy * u);
    const T along = K(2.0) * (ex * v - ey * u) - whole * unit;
    return square(across) + whole * (unit * along);
}

// A point in homogeneous coordinates of the profile.
template <class T>
struct InProfile {
    T x, y, unit;
};

// Of the point x of the frame, where cosine and sine are those of the angle at its height; in homogeneous coordinates `weighted` multiplies by the last of them.
template <class T, class Weighted>
InProfile<T> in_profile(const Twist& w, const std::array<T, 3>& x, const T& cosine, const T& sine, const Weighted& weighted) {
    using K = typename T::Number;
    T u = x[0], v = x[1], unit = weighted(K(1.0));
    if (w.scale_x != 1 || w.scale_y != 1) {
        const K height = K(w.z1) - K(w.z0);
        const T up = x[2] - weighted(K(w.z0)), kx = (K(w.scale_x) - K(1.0)) * up + weighted(height);
        if (w.scale_x == w.scale_y) {
            u = height * u;
            v = height * v;
            unit = kx;
        } else {
            const T ky = (K(w.scale_y) - K(1.0)) * up + weighted(height);
            u = height * (u * ky);
            v = height * (v * kx);
            unit = kx * ky;
        }
    }
    if (w.degrees == 0) return {u, v, unit};
    return {cosine * u - sine * v, sine * u + cosine * v, unit};
}

template <class T, class Weighted>
T function(const Support& s, const Twist& w, const std::array<T, 3>& x, const T& cosine, const T& sine, const Weighted& weighted) {
    const InProfile<T> at = in_profile(w, x, cosine, sine, weighted);
    return curve(s, at.x, at.y, at.unit);
}

template <class T>
T function(const Support& s, const Twist& w, const std::array<T, 3>& x, const T& cosine, const T& sine) {
    return function(s, w, x, cosine, sine, [](const typename T::Number& k) { return T(k); });
}

// Along a line of the frame. Requires: no twist, then it is a polynomial.
template <class N>
LinePolynomial<N> polynomial(const Support& s, const Twist& w, const FrameLine<N>& line) {
    using T = Taylor<N, 4>;
    std::array<T, 3> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = {line.o[i], line.d[i]};
    return {function(s, w, x, T(N(1.0)), T(), [&](const N& k) { return T(k * line.w); }).c, 4};
}

}  // namespace turned

}  // namespace whittle
