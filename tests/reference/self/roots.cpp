// roots.cpp — the reference's arithmetic against numbers known in advance.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/reference/polynomial.h"

using namespace whittle::reference;

namespace {

Polynomial with_roots(const std::vector<double>& roots) {
    Polynomial p({Dyadic(1.0)});
    for (const double r : roots) p = p * Polynomial({Dyadic(-r), Dyadic(1.0)});
    return p;
}

bool is_equal(Root a, Root b) { return compare(a, b) == 0; }
bool is_less(Root a, Root b) { return compare(a, b) < 0; }

bool holds(const Root& r, const Dyadic& t) { return r.is_known() ? r.lo == t : r.lo < t && t < r.hi; }

}  // namespace

TEST_CASE("dyadic arithmetic is exact") {
    const Dyadic tiny(0x1p-1000), one(1.0);
    CHECK(((one + tiny) - one) == tiny);
    CHECK((one + tiny) * (one - tiny) == one - tiny * tiny);
    CHECK(Dyadic(0.1).to_double() == 0.1);
    CHECK(Dyadic(-3.5).top() == 2);
    CHECK(Dyadic(5e-324).to_double() == 5e-324);
}

TEST_CASE("quotients and square roots are bracketed to the bits asked for") {
    Dyadic ulp;
    bool exact = false;
    const Dyadic q = quotient_floor(Dyadic(1.0), Dyadic(3.0), 200, ulp, exact);
    CHECK_FALSE(exact);
    CHECK(q * Dyadic(3.0) < Dyadic(1.0));
    CHECK(Dyadic(1.0) < (q + ulp) * Dyadic(3.0));
    CHECK(ulp.top() <= -198);
    const Dyadic s = sqrt_floor(Dyadic(2.0), 200, ulp);
    CHECK(s * s < Dyadic(2.0));
    CHECK(Dyadic(2.0) < (s + ulp) * (s + ulp));
    CHECK(ulp.top() <= -198);
}

TEST_CASE("polynomials give back the roots they were made of") {
    std::mt19937_64 random(Catch::rngSeed());
    std::uniform_real_distribution<double> uniform(-10, 10);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> roots;
        for (int i = 0; i <= round % 4; ++i) roots.push_back(round % 5 == 0 && i > 0 ? std::nextafter(roots.back(), 1e9) : uniform(random));
        if (round % 7 == 0) roots[0] = 0;
        std::sort(roots.begin(), roots.end());
        std::vector<Root> found = real_roots(with_roots(roots), 200);
        roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
        REQUIRE(found.size() == roots.size());
        for (std::size_t i = 0; i < roots.size(); ++i) {
            CHECK(holds(found[i], Dyadic(roots[i])));
            CHECK((found[i].hi - found[i].lo).scaled(199) <= abs(Dyadic(roots[i])));
        }
    }
}

TEST_CASE("double roots are found once and roots 2^-300 apart are told apart") {
    CHECK(real_roots(with_roots({1, 1, 3, 3}), 200).size() == 2);
    CHECK(real_roots(with_roots({2, 2, 2, 2}), 200).size() == 1);
    CHECK(real_roots(with_roots({2, 2}), 200).size() == 1);
    const Dyadic gap(0x1p-300);
    const Polynomial close = Polynomial({Dyadic(-1.0), Dyadic(1.0)}) * Polynomial({-(Dyadic(1.0) + gap), Dyadic(1.0)});
    std::vector<Root> two = real_roots(close, 200);
    REQUIRE(two.size() == 2);
    CHECK(is_less(two[0], two[1]));
    std::vector<Root> four = real_roots(close * with_roots({-1, 5}), 200);
    REQUIRE(four.size() == 4);
    CHECK(is_equal(four[1], two[0]));
    CHECK(is_less(four[1], two[1]));
    CHECK(is_equal(four[2], two[1]));
}

TEST_CASE("a polynomial without real roots has none, one grazed by 2^-400 has two") {
    const Polynomial square = with_roots({1, 1});
    const Dyadic film(0x1p-400);
    CHECK(real_roots(square + Polynomial({film}), 200).empty());
    CHECK(real_roots(square + Polynomial({-film}), 200).size() == 2);
    const Polynomial quartic = square * Polynomial({Dyadic(3.0), Dyadic(0.0), Dyadic(1.0)});
    CHECK(real_roots(quartic, 200).size() == 1);
    CHECK(real_roots(quartic + Polynomial({film}), 200).empty());
    CHECK(real_roots(quartic + Polynomial({-film}), 200).size() == 2);
}

TEST_CASE("equal irrational roots of different polynomials compare equal") {
    const Polynomial root_two({Dyadic(-2.0), Dyadic(), Dyadic(1.0)});
    std::vector<Root> a = real_roots(root_two, 200);
    std::vector<Root> b = real_roots(root_two * Polynomial({Dyadic(-7.0), Dyadic(1.0), Dyadic(1.0)}), 200);
    REQUIRE(a.size() == 2);
    REQUIRE(b.size() == 4);
    CHECK(is_equal(a[0], b[1]));
    CHECK(is_equal(a[1], b[2]));
    CHECK(is_less(a[1], b[3]));
    CHECK(is_less(b[0], a[0]));
    CHECK(a[1].lo.to_double() == Approx(std::sqrt(2)));
}
