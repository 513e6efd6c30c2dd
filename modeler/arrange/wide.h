// wide.h — signed integers of a fixed number of 64-bit limbs, for signs of determinants.
//
// Every size is chosen where it is used, from the bound of grid_mesh.h, so nothing overflows; products of small values cost as little as they
// are small, because only the limbs in use are multiplied.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "modeler/arrange/grid_mesh.h"

namespace whittle {

__extension__ typedef unsigned __int128 UInt128;

template <int N>
class Wide {
public:
    Wide() = default;
    explicit Wide(std::int64_t x) {
        limb_.fill(x < 0 ? ~std::uint64_t{0} : 0);
        limb_[0] = static_cast<std::uint64_t>(x);
    }
    explicit Wide(Int128 x) requires(N >= 2) {
        limb_.fill(x < 0 ? ~std::uint64_t{0} : 0);
        limb_[0] = static_cast<std::uint64_t>(x);
        limb_[1] = static_cast<std::uint64_t>(static_cast<UInt128>(x) >> 64);
    }

    bool negative() const { return (limb_[N - 1] >> 63) != 0; }
    int sign() const {
        if (negative()) return -1;
        for (const std::uint64_t x : limb_)
            if (x != 0) return 1;
        return 0;
    }
    std::uint64_t limb(int i) const { return limb_[static_cast<std::size_t>(i)]; }

    // The same value in M limbs. Requires: it fits.
    template <int M>
    Wide<M> as() const {
        Wide<M> out(std::int64_t{negative() ? -1 : 0});
        for (int i = 0; i < (M < N ? M : N); ++i) out.set(i, limb(i));
        return out;
    }
    void set(int i, std::uint64_t x) { limb_[static_cast<std::size_t>(i)] = x; }

    Wide operator-() const {
        Wide out;
        std::uint64_t carry = 1;
        for (std::size_t i = 0; i < N; ++i) {
            out.limb_[i] = ~limb_[i] + carry;
            carry = carry != 0 && out.limb_[i] == 0 ? 1 : 0;
        }
        return out;
    }
    Wide operator+(const Wide& o) const {
        Wide out;
        UInt128 sum = 0;
        for (std::size_t i = 0; i < N; ++i) {
            sum += static_cast<UInt128>(limb_[i]) + o.limb_[i];
            out.limb_[i] = static_cast<std::uint64_t>(sum);
            sum >>= 64;
        }
        return out;
    }
    Wide operator-(const Wide& o) const { return *this + (-o); }
    Wide operator<<(int bits) const {  // 0 < bits < 64
        Wide out;
        for (std::size_t i = N; i-- > 0;) out.limb_[i] = limb_[i] << bits | (i > 0 ? limb_[i - 1] >> (64 - bits) : 0);
        return out;
    }
    bool operator==(const Wide&) const = default;

    // Limbs up to the highest that is not zero; for magnitudes.
    int used() const {
        int n = N;
        while (n > 0 && limb_[static_cast<std::size_t>(n - 1)] == 0) --n;
        return n;
    }

    // Nearest up to two units in the last of 64 bits.
    long double value() const {
        const Wide m = negative() ? -*this : *this;
        long double out = 0;
        const int top = m.used();
        for (int i = top - 1; i >= 0 && i >= top - 3; --i) out += std::ldexp(static_cast<long double>(m.limb(i)), 64 * i);
        return negative() ? -out : out;
    }

private:
    std::array<std::uint64_t, N> limb_{};
};

template <int A, int B>
Wide<A + B> operator*(const Wide<A>& a, const Wide<B>& b) {
    const Wide<A> x = a.negative() ? -a : a;
    const Wide<B> y = b.negative() ? -b : b;
    const int nx = x.used(), ny = y.used();
    Wide<A + B> out;
    for (int i = 0; i < nx; ++i) {
        std::uint64_t carry = 0;
        for (int j = 0; j < ny; ++j) {
            const UInt128 t = static_cast<UInt128>(x.limb(i)) * y.limb(j) + out.limb(i + j) + carry;
            out.set(i + j, static_cast<std::uint64_t>(t));
            carry = static_cast<std::uint64_t>(t >> 64);
        }
        out.set(i + ny, carry);
    }
    return a.negative() != b.negative() ? -out : out;
}

}  // namespace whittle
