// interval_set_test.cpp — the laws of set algebra on random sets whose borders often coincide.
#include <algorithm>
#include <random>
#include <set>

#include <catch2/catch.hpp>

#include "csg/span/interval_set.h"

using namespace whittle;

namespace {

using Set = IntervalSet<int>;

const auto order = [](int a, int b) { return (a > b) - (a < b); };

// Up to eight borders among sixteen places: ties are the rule.
Set random_set(std::mt19937_64& random) {
    std::set<int> at;
    const auto n = random() % 9;
    for (std::uint64_t i = 0; i < n; ++i) at.insert(static_cast<int>(random() % 16));
    return {random() % 2 == 1, {at.begin(), at.end()}};
}

bool holds(const Set& s, double x) {
    return s.inside_before != (std::count_if(s.borders.begin(), s.borders.end(), [&](int b) { return b < x; }) % 2 == 1);
}

}  // namespace

TEST_CASE("set operations on intervals mean what they mean on points") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const Set a = random_set(random), b = random_set(random);
        for (double x = -0.5; x < 17; ++x) {
            REQUIRE(holds(unite(a, b, order), x) == (holds(a, x) || holds(b, x)));
            REQUIRE(holds(intersect(a, b, order), x) == (holds(a, x) && holds(b, x)));
            REQUIRE(holds(subtract(a, b, order), x) == (holds(a, x) && !holds(b, x)));
            REQUIRE(holds(complement(a), x) != holds(a, x));
        }
    }
}

TEST_CASE("the algebra of interval sets keeps the laws of sets") {
    std::mt19937_64 random(2);
    const Set none, all{true, {}};
    for (int i = 0; i < 20000; ++i) {
        const Set a = random_set(random), b = random_set(random), c = random_set(random);
        REQUIRE(unite(a, a, order) == a);
        REQUIRE(intersect(a, a, order) == a);
        REQUIRE(subtract(a, a, order).empty());
        REQUIRE(unite(a, complement(a), order).everything());
        REQUIRE(subtract(a, none, order) == a);
        REQUIRE(intersect(a, all, order) == a);
        REQUIRE(unite(a, b, order) == unite(b, a, order));
        REQUIRE(unite(a, unite(b, c, order), order) == unite(unite(a, b, order), c, order));
        REQUIRE(intersect(a, intersect(b, c, order), order) == intersect(intersect(a, b, order), c, order));
        REQUIRE(intersect(a, unite(b, c, order), order) == unite(intersect(a, b, order), intersect(a, c, order), order));
        REQUIRE(complement(unite(a, b, order)) == intersect(complement(a), complement(b), order));
        REQUIRE(subtract(a, subtract(a, b, order), order) == intersect(a, b, order));
        REQUIRE(unite(subtract(a, b, order), intersect(a, b, order), order) == a);
    }
}

TEST_CASE("no operation makes more borders than its operands have, nor any out of order") {
    std::mt19937_64 random(3);
    for (int i = 0; i < 20000; ++i) {
        const Set a = random_set(random), b = random_set(random);
        for (const Set& r : {unite(a, b, order), intersect(a, b, order), subtract(a, b, order)}) {
            REQUIRE(r.borders.size() <= a.borders.size() + b.borders.size());
            REQUIRE(std::adjacent_find(r.borders.begin(), r.borders.end(), std::greater_equal<>()) == r.borders.end());
        }
    }
}
