// ordered_set_test.cpp — the set of numbers that is walked in order.
#include <random>
#include <set>

#include <catch2/catch.hpp>

#include "tracer/engine/ordered_set.h"

using namespace whittle;

TEST_CASE("an ordered set finds the next member as std::set does") {
    std::mt19937_64 random(5);
    for (const std::size_t bound : {1ul, 63ul, 64ul, 65ul, 4096ul, 4097ul, 300000ul}) {
        OrderedSet set(bound);
        std::set<std::size_t> expected;
        CHECK(set.next(0) == bound);
        for (int k = 0; k < 200; ++k) {
            const std::size_t x = k == 0 ? bound - 1 : random() % bound;
            set.insert(x);
            expected.insert(x);
            for (const std::size_t from : {std::size_t{0}, x, x + 1, std::size_t{random() % bound}, bound - 1, bound}) {
                const auto at = expected.lower_bound(from);
                CHECK(set.next(from) == (at == expected.end() ? bound : *at));
            }
        }
    }
}
