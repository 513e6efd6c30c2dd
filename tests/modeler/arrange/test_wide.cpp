// test_wide.cpp — integers of fixed width against GMP.
#include <catch2/catch.hpp>

#include <random>

#include <gmpxx.h>

#include "modeler/arrange/wide.h"

using namespace whittle;

namespace {

template <int N>
mpz_class big(const Wide<N>& x) {
    const Wide<N> m = x.negative() ? -x : x;
    mpz_class out = 0;
    for (int i = N - 1; i >= 0; --i) {
        out <<= 64;
        out += mpz_class(std::to_string(m.limb(i)));
    }
    return x.negative() ? mpz_class(-out) : out;
}

Int128 random_int(std::mt19937_64& random) {
    const int bits = static_cast<int>(random() % 104);
    const UInt128 x = (static_cast<UInt128>(random()) << 64 | random()) >> (127 - bits);
    return (random() & 1) != 0 ? -static_cast<Int128>(x) : static_cast<Int128>(x);
}

}  // namespace

TEST_CASE("sums, differences and products are GMP's") {
    std::mt19937_64 random(7);
    for (int i = 0; i < 2000; ++i) {
        const Wide<2> a(random_int(random)), b(random_int(random)), c(random_int(random));
        const Wide<4> ab = a * b;
        CHECK(big(ab) == big(a) * big(b));
        const Wide<6> abc = ab * c;
        CHECK(big(abc) == big(a) * big(b) * big(c));
        CHECK(big(ab - (c * c)) == big(a) * big(b) - big(c) * big(c));
        CHECK((ab - ab).sign() == 0);
        CHECK(big(a.as<5>() << 13) == big(a) * 8192);
        CHECK(abc.sign() == sgn(big(abc)));
        const double exact = big(abc).get_d();
        CHECK(static_cast<double>(abc.value()) == Approx(exact).epsilon(1e-15));
    }
}
