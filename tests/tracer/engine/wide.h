// wide.h — exact numbers m·2^(64 e) of fixed capacity: what a test needs to judge ten million rays without one allocation.
//
// A ring that support_polynomial takes. Every double is such a number, and so are sums and products; a number that outgrows the capacity throws, so no
// answer is ever rounded. Written on GMP's low-level integers, apart from the engine's own exact numbers (tracer/engine/dyadic.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <gmp.h>

namespace whittle::testing {

class Wide {
public:
    static constexpr long kLimbs = 320;

    Wide() {}  // NOLINT: written out, so that {} does not clear the limbs
    // Exact. Requires: v is finite.
    Wide(double v) {  // NOLINT: a double is such a number
        if (v == 0) return;
        negative_ = v < 0;
        int e = 0;
        const auto mantissa = static_cast<mp_limb_t>(std::ldexp(std::frexp(std::abs(v), &e), 53));
        const long low = e - 53;
        exponent_ = low >= 0 ? low / 64 : -((63 - low) / 64);
        const auto shift = static_cast<unsigned>(low - 64 * exponent_);
        limbs_[0] = mantissa << shift;
        limbs_[1] = shift == 0 ? 0 : mantissa >> (64 - shift);
        size_ = 2;
        normalise();
    }
    Wide(const Wide& o) { assign(o); }
    Wide& operator=(const Wide& o) {
        assign(o);
        return *this;
    }

    int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }
    bool is_zero() const { return size_ == 0; }
    // |m|, least limb first.
    const mp_limb_t* limbs() const { return limbs_.data(); }
    std::size_t size() const { return static_cast<std::size_t>(size_); }
    long exponent() const { return exponent_; }
    // Towards zero, as f * 2^e with 1/2 <= |f| < 1; 0 for zero.
    double parts(long& e) const {
        e = 0;
        if (size_ == 0) return 0;
        double f = 0;
        for (long i = size_ - 1; i >= std::max(0L, size_ - 3); --i) f = f * 0x1p64 + static_cast<double>(limbs_[static_cast<std::size_t>(i)]);
        int small = 0;
        f = std::frexp(f, &small);
        e = small + 64 * (exponent_ + std::max(0L, size_ - 3));
        return negative_ ? -f : f;
    }
    double to_double() const {
        long e = 0;
        const double f = parts(e);
        return std::ldexp(f, static_cast<int>(std::clamp(e, -3000L, 3000L)));
    }

    Wide operator-() const {
        Wide r(*this);
        r.negative_ = !r.negative_;
        return r;
    }
    friend Wide operator*(const Wide& a, const Wide& b) {
        Wide r;
        if (a.is_zero() || b.is_zero()) return r;
        require(a.size_ + b.size_);
        if (a.size_ >= b.size_) {
            mpn_mul(r.limbs_.data(), a.limbs_.data(), a.size_, b.limbs_.data(), b.size_);
        } else {
            mpn_mul(r.limbs_.data(), b.limbs_.data(), b.size_, a.limbs_.data(), a.size_);
        }
        r.size_ = a.size_ + b.size_;
        r.exponent_ = a.exponent_ + b.exponent_;
        r.negative_ = a.negative_ != b.negative_;
        r.normalise();
        return r;
    }
    friend Wide operator+(const Wide& a, const Wide& b) { return sum(a, b, b.negative_); }
    friend Wide operator-(const Wide& a, const Wide& b) { return sum(a, b, !b.negative_); }

private:
    static void require(long limbs) {
        if (limbs > kLimbs) throw std::length_error("an exact number outgrew its capacity");
    }
    void assign(const Wide& o) {
        size_ = o.size_;
        exponent_ = o.exponent_;
        negative_ = o.negative_;
        std::memcpy(limbs_.data(), o.limbs_.data(), static_cast<std::size_t>(size_) * sizeof(mp_limb_t));
    }
    // No zero limb at either end.
    void normalise() {
        while (size_ > 0 && limbs_[static_cast<std::size_t>(size_ - 1)] == 0) --size_;
        long zeros = 0;
        while (zeros < size_ && limbs_[static_cast<std::size_t>(zeros)] == 0) ++zeros;
        if (zeros > 0) {
            size_ -= zeros;
            exponent_ += zeros;
            std::memmove(limbs_.data(), limbs_.data() + zeros, static_cast<std::size_t>(size_) * sizeof(mp_limb_t));
        }
        if (size_ == 0) exponent_ = 0, negative_ = false;
    }
    // The magnitude, with limbs from 2^(64 low) on.
    long aligned(long low, mp_limb_t* to) const {
        const long shift = exponent_ - low;
        require(size_ + shift + 1);
        std::memset(to, 0, static_cast<std::size_t>(shift) * sizeof(mp_limb_t));
        std::memcpy(to + shift, limbs_.data(), static_cast<std::size_t>(size_) * sizeof(mp_limb_t));
        return size_ + shift;
    }
    static Wide sum(const Wide& a, const Wide& b, bool b_negative) {
        if (b.is_zero()) return a;
        if (a.is_zero()) {
            Wide r(b);
            r.negative_ = b_negative;
            return r;
        }
        const long low = std::min(a.exponent_, b.exponent_);
        std::array<mp_limb_t, kLimbs> x, y;
        long nx = a.aligned(low, x.data()), ny = b.aligned(low, y.data());
        bool sx = a.negative_;
        const bool same = sx == b_negative;
        mp_limb_t *p = x.data(), *q = y.data();
        if (nx < ny || (nx == ny && mpn_cmp(p, q, nx) < 0)) {
            std::swap(p, q);
            std::swap(nx, ny);
            sx = b_negative;
        }
        Wide r;
        r.size_ = nx;
        if (same) {
            const mp_limb_t carry = mpn_add(r.limbs_.data(), p, nx, q, ny);
            if (carry != 0) {
                require(nx + 1);
                r.limbs_[static_cast<std::size_t>(nx)] = carry;
                r.size_ = nx + 1;
            }
        } else {
            mpn_sub(r.limbs_.data(), p, nx, q, ny);
        }
        r.exponent_ = low;
        r.negative_ = sx;
        r.normalise();
        return r;
    }

    long size_ = 0, exponent_ = 0;
    bool negative_ = false;
    std::array<mp_limb_t, kLimbs> limbs_;
};

}  // namespace whittle::testing
